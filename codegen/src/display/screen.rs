//! The sheet as a screen of text and as a LaTeX fragment.

use super::latex::{latex, name_latex};
use super::number::Number;
use super::sheet::{Line, Sheet};
use super::text::{name_text, text};
use super::tree::Tree;

/// Longest line of a screen.
const WIDTH: usize = 110;

/// As a screen of text.
pub fn screen(sheet: &Sheet) -> String {
    let list = |names: &[String]| names.iter().map(|n| name_text(n)).collect::<Vec<_>>().join(", ");
    let mut out = sheet.title.clone();
    let q = format!("q = ({})", list(&sheet.q));
    let u = if sheet.u.is_empty() { String::new() } else { format!("     u = ({})", list(&sheet.u)) };
    out.push_str(if out.len() + q.len() + u.len() + 8 > WIDTH { "\n  " } else { "          " });
    out.push_str(&format!("{q}{u}\n"));
    if !sheet.assumptions.is_empty() {
        out.push_str(&format!("  assumed: {}\n", sheet.assumptions.join("; ")));
    }
    out.push('\n');
    block(&mut out, "", &sheet.equations);
    for (i, line) in sheet.names.iter().enumerate() {
        wrapped(&mut out, if i == 0 { "  with " } else { "       " }, 0, line);
    }
    for (line, value) in &sheet.valued {
        let defined = text(&Tree::sum(line.right.clone()));
        out.push_str(&format!("  with {} = {}, defined as {defined}\n", text(&line.left), Number::of(*value).decimal_text()));
    }
    section(&mut out, "where", &sheet.table);
    section(&mut out, "parts", &sheet.parts);
    section(&mut out, "outputs", &sheet.outputs);
    out.push('\n');
    for note in &sheet.notes {
        out.push_str(&format!("  {note}\n"));
    }
    out
}

fn section(out: &mut String, title: &str, lines: &[Line]) {
    if !lines.is_empty() {
        out.push_str(&format!("\n  {title}\n"));
        block(out, "  ", lines);
    }
}

/// Lines with their equals signs below each other, unless a left-hand side is long.
fn block(out: &mut String, indent: &str, lines: &[Line]) {
    let width = lines.iter().map(|l| text(&l.left).chars().count()).filter(|&w| w <= 30).max().unwrap_or(0);
    for line in lines {
        wrapped(out, &format!("  {indent}"), width, line);
    }
}

/// One line, continued below its equals sign where it is too long.
fn wrapped(out: &mut String, indent: &str, width: usize, line: &Line) {
    let left = text(&line.left);
    let padding = " ".repeat(width.saturating_sub(left.chars().count()));
    let start = format!("{indent}{left}{padding} = ");
    out.push_str(&start);
    let hanging = start.chars().count().min(40);
    let mut column = start.chars().count();
    if line.right.is_empty() {
        out.push('0');
    }
    for (i, (minus, term)) in line.right.iter().enumerate() {
        let single = text(&Tree::sum(vec![(false, term.clone())]));
        let body = if matches!(term, Tree::Sum(_)) { format!("({single})") } else { single };
        let sign = match (i, minus) {
            (0, true) => "-",
            (0, false) => "",
            (_, true) => "- ",
            (_, false) => "+ ",
        };
        let piece = format!("{sign}{body}");
        if i > 0 {
            if column + piece.chars().count() + 1 > WIDTH {
                out.push_str(&format!("\n{}", " ".repeat(hanging)));
                column = hanging;
            } else {
                out.push(' ');
                column += 1;
            }
        }
        column += piece.chars().count();
        out.push_str(&piece);
    }
    out.push('\n');
}

/// Terms on one line of a formula, by the length of their text.
const LATEX_WIDTH: usize = 84;

/// As a LaTeX fragment for amsmath.
pub fn fragment(sheet: &Sheet) -> String {
    let list = |names: &[String]| names.iter().map(|n| name_latex(n)).collect::<Vec<_>>().join(", ");
    let mut out = format!("% {}\n% \\usepackage{{amsmath}}\n", sheet.title);
    out.push_str(&format!("% q = ({}), u = ({})\n", sheet.q.join(", "), sheet.u.join(", ")));
    for assumption in &sheet.assumptions {
        out.push_str(&format!("% assumed: {assumption}\n"));
    }
    let vector = |name: &str, names: &[String]| {
        if names.is_empty() { String::new() } else { format!("\\mathbf{{{name}}} = \\left({}\\right)", list(names)) }
    };
    let both =
        [vector("q", &sheet.q), vector("u", &sheet.u)].iter().filter(|s| !s.is_empty()).cloned().collect::<Vec<_>>().join(", \\quad ");
    out.push_str(&format!("\\[\n  {both}\n\\]\n"));
    align(&mut out, &sheet.equations);
    let mut where_ = Vec::new();
    where_.extend(&sheet.names);
    where_.extend(sheet.valued.iter().map(|v| &v.0));
    where_.extend(sheet.table.iter().chain(&sheet.parts));
    if !where_.is_empty() {
        out.push_str("where\n");
        align(&mut out, where_);
    }
    if !sheet.outputs.is_empty() {
        out.push_str("and measured are\n");
        align(&mut out, &sheet.outputs);
    }
    out
}

fn align<'a>(out: &mut String, lines: impl IntoIterator<Item = &'a Line>) {
    out.push_str("\\begin{align}\n");
    let mut first = true;
    for line in lines {
        if !first {
            out.push_str(" \\\\\n");
        }
        first = false;
        out.push_str(&format!("  {} &=", latex(&line.left)));
        if line.right.is_empty() {
            out.push_str(" 0");
        }
        let mut column = 0;
        for (i, (minus, term)) in line.right.iter().enumerate() {
            let length = text(term).chars().count();
            if i > 0 && column + length > LATEX_WIDTH {
                out.push_str(" \\notag \\\\\n    &\\quad {}");
                column = 0;
            }
            column += length;
            out.push_str(match (i, minus) {
                (0, true) => " -",
                (0, false) => " ",
                (_, true) => " - ",
                (_, false) => " + ",
            });
            let body = latex(term);
            out.push_str(&if matches!(term, Tree::Sum(_)) { format!("\\left({body}\\right)") } else { body });
        }
    }
    out.push_str("\n\\end{align}\n");
}
