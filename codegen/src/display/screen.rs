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
    names(&mut out, sheet);
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

/// What the names mean: definitions in a row, then lumps with values of their own.
fn names(out: &mut String, sheet: &Sheet) {
    let mut column = 0;
    for (i, line) in sheet.names.iter().enumerate() {
        let piece = format!("{} = {}", text(&line.left), text(&Tree::sum(line.right.clone())));
        let start = if i == 0 {
            "  with "
        } else if column + piece.chars().count() + 2 > WIDTH {
            "\n       "
        } else {
            ",  "
        };
        column = if start.starts_with(',') { column + 3 } else { 7 } + piece.chars().count();
        out.push_str(&format!("{start}{piece}"));
    }
    if !sheet.names.is_empty() {
        out.push('\n');
    }
    let values: Vec<String> = sheet.valued.iter().map(|v| format!("{} = {}", text(&v.0.left), Number::of(v.1).decimal_text())).collect();
    let width = values.iter().map(|v| v.chars().count()).max().unwrap_or(0);
    for (i, ((line, _, defined), value)) in sheet.valued.iter().zip(values).enumerate() {
        let start = if i == 0 && sheet.names.is_empty() { "  with " } else { "       " };
        let defined = format!("{} = {}", text(&Tree::sum(line.right.clone())), four_digits(*defined));
        out.push_str(&format!("{start}{value:width$}   (by definition {defined})\n"));
    }
}

fn four_digits(x: f64) -> String {
    Number::of(format!("{x:.3e}").parse().unwrap_or(x)).decimal_text()
}

/// One line, continued below its equals sign where it is too long.
fn wrapped(out: &mut String, indent: &str, width: usize, line: &Line) {
    let left = text(&line.left);
    let padding = " ".repeat(width.saturating_sub(left.chars().count()));
    let pieces = pieces(&line.right, WIDTH - 40, &Style { write: text, open: "(", close: ")" });
    let length: usize = pieces.iter().map(|p| p.1.chars().count() + 1).sum();
    let mut start = format!("{indent}{left}{padding} = ");
    if start.chars().count() > 42 && start.chars().count() + length > WIDTH {
        out.push_str(&format!("{indent}{left}\n"));
        start = format!("{indent}    = ");
    }
    out.push_str(&start);
    let hanging = start.chars().count();
    let mut column = hanging;
    let pieces: Vec<(usize, String)> = pieces.into_iter().flat_map(|p| cut(p, WIDTH - hanging)).collect();
    for (i, (depth, piece)) in pieces.iter().enumerate() {
        if i > 0 {
            if column + piece.chars().count() + 1 > WIDTH {
                column = hanging + 4 * depth;
                out.push_str(&format!("\n{}", " ".repeat(column)));
            } else {
                out.push(' ');
                column += 1;
            }
        }
        column += piece.chars().count();
        out.push_str(piece);
    }
    out.push('\n');
}

/// A piece that is still too long for a line, cut before signs wherever they stand.
fn cut(piece: (usize, String), longest: usize) -> Vec<(usize, String)> {
    if piece.1.chars().count() <= longest {
        return vec![piece];
    }
    let mut out: Vec<(usize, String)> = vec![(piece.0, String::new())];
    for (i, word) in piece.1.split(' ').enumerate() {
        if i > 0 && matches!(word, "+" | "-") && !out.last().is_none_or(|p| p.1.is_empty()) {
            out.push((1, String::new()));
        }
        if let Some(last) = out.last_mut() {
            if !last.1.is_empty() {
                last.1.push(' ');
            }
            last.1.push_str(word);
        }
    }
    out
}

/// How a printer writes a term and its brackets across lines.
struct Style {
    write: fn(&Tree) -> String,
    open: &'static str,
    close: &'static str,
}

/// Terms with their signs, as pieces between which a line may break; a product with a long bracket breaks within
/// the bracket too (depth 1).
fn pieces(terms: &[(bool, Tree)], longest: usize, style: &Style) -> Vec<(usize, String)> {
    let sign = |i: usize, minus: bool| match (i, minus) {
        (0, true) => "-",
        (0, false) => "",
        (_, true) => "- ",
        (_, false) => "+ ",
    };
    let mut out = Vec::new();
    for (i, (minus, term)) in terms.iter().enumerate() {
        let long = match term {
            Tree::Product(factors) if text(term).chars().count() > longest => {
                factors.iter().position(|f| matches!(f, Tree::Sum(_))).map(|at| (factors, at))
            }
            _ => None,
        };
        let Some((factors, at)) = long else {
            // as part of a sum, so that brackets stand where they must
            let whole = (style.write)(&Tree::Product(vec![term.clone()]));
            out.push((0, format!("{}{whole}", sign(i, *minus))));
            continue;
        };
        let side = |factors: &[Tree]| if factors.is_empty() { String::new() } else { (style.write)(&Tree::Product(factors.to_vec())) };
        let (before, after) = (side(&factors[..at]), side(&factors[at + 1..]));
        let Tree::Sum(inner) = &factors[at] else { continue };
        for (k, (minus_inner, part)) in inner.iter().enumerate() {
            let mut piece = format!("{}{}", sign(k, *minus_inner), (style.write)(&Tree::Product(vec![part.clone()])));
            if k == 0 {
                let space = if before.is_empty() { "" } else { " " };
                piece = format!("{}{before}{space}{}{piece}", sign(i, *minus), style.open);
            }
            if k + 1 == inner.len() {
                let space = if after.is_empty() { "" } else { " " };
                piece = format!("{piece}{}{space}{after}", style.close);
            }
            out.push((usize::from(k > 0), piece));
        }
    }
    if out.is_empty() {
        out.push((0, "0".to_owned()));
    }
    out
}

/// Letters on one line of a formula.
const LATEX_WIDTH: usize = 72;

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
        let mut column = 0;
        for (i, (depth, piece)) in
            pieces(&line.right, LATEX_WIDTH, &Style { write: latex, open: "\\bigl(", close: "\\bigr)" }).iter().enumerate()
        {
            let length = visible(piece);
            if i > 0 && column + length > LATEX_WIDTH {
                out.push_str(&format!(" \\notag \\\\\n    &{} {{}}", if *depth > 0 { "\\qquad" } else { "\\quad" }));
                column = 0;
            }
            column += length;
            out.push_str(&format!(" {piece}"));
        }
    }
    out.push_str("\n\\end{align}\n");
}

/// About how many letters wide a formula is: commands count as one, braces and sub- and superscript marks as none.
fn visible(formula: &str) -> usize {
    let mut width = 0;
    let mut command = false;
    for c in formula.chars() {
        match c {
            '\\' => {
                command = true;
                width += 1;
            }
            c if command && c.is_ascii_alphabetic() => {}
            '{' | '}' | '_' | '^' | ' ' => command = false,
            _ => {
                command = false;
                width += 1;
            }
        }
    }
    width
}
