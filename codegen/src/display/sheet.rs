//! The equations of a rig as a sheet of lines: what stands on the left and on the right of each equation, what
//! is spelled out in a table, and what the names mean. Printers turn the lines into text or LaTeX.

use super::entries::{Entries, entries};
use super::number::Number;
use super::text::text;
use super::tree::Tree;
use crate::equations::{CrossCheck, Equations};
use crate::expr::{Graph, SymbolKind};
use crate::lower::{Lowering, Lumps};
use model_dsl::rig::{Expr, Rig};

/// An entry of M that is spelled out in its equation; longer ones stand in a table.
const SHORT_ENTRY: usize = 30;
/// A left-hand side that is spelled out.
const SHORT_LEFT: usize = 64;
/// Velocity products that are spelled out in their equation.
const SHORT_PRODUCTS: usize = 80;

/// left = right
pub struct Line {
    /// Left-hand side.
    pub left: Tree,
    /// Terms of the right-hand side.
    pub right: Vec<(bool, Tree)>,
}

/// Everything on the sheet.
pub struct Sheet {
    /// Title.
    pub title: String,
    /// Names of coordinates and signals.
    pub q: Vec<String>,
    /// Names of inputs and exogenous signals.
    pub u: Vec<String>,
    /// Assumptions in words.
    pub assumptions: Vec<String>,
    /// Equations of motion and of actuator states.
    pub equations: Vec<Line>,
    /// Entries of M and velocity products that are too long for their equation.
    pub table: Vec<Line>,
    /// Named parts of long entries.
    pub parts: Vec<Line>,
    /// Lumps and mixed inputs that occur.
    pub names: Vec<Line>,
    /// Lumps with a value of their own: definition, value, the definition's value.
    pub valued: Vec<(Line, f64, f64)>,
    /// Outputs that are not just a coordinate.
    pub outputs: Vec<Line>,
    /// Sentences about delays, prescribed motion, checks.
    pub notes: Vec<String>,
}

/// Puts the sheet together.
pub fn sheet(rig: &Rig, e: &Equations) -> Sheet {
    let entries = entries(rig, e);
    let mut table = Vec::new();
    let mut equations = Vec::new();
    let n = rig.coordinates.len();
    let name = |i: usize| rig.coordinates[i].name.clone();
    let mut listed: Vec<(usize, usize)> = Vec::new();
    for i in 0..n {
        if rig.coordinates[i].prescribed {
            continue;
        }
        let spelled = spelled_out(&entries.mass_matrix[i]);
        let mut left = Vec::new();
        for (j, (entry, spelled)) in entries.mass_matrix[i].iter().zip(spelled).enumerate() {
            if entry.is_zero() {
                continue;
            }
            let factor = if spelled {
                entry.clone()
            } else {
                // M is symmetric unless it was written directly
                let place = if *entry == entries.mass_matrix[j][i] { (i.min(j), i.max(j)) } else { (i, j) };
                if !listed.contains(&place) {
                    listed.push(place);
                }
                Tree::Entry("M", vec![name(place.0), name(place.1)])
            };
            left.push(times(factor, Tree::Name(format!("{}.ddot", name(j)))));
        }
        let mut right = Vec::new();
        let products = &entries.coriolis[i];
        if text(products).len() > SHORT_PRODUCTS || over_parts(products, &entries) {
            let entry = Tree::Entry("h", vec![name(i)]);
            left.push((false, entry.clone()));
            table.push(Line { left: entry, right: products.clone().into_terms() });
        } else {
            push(&mut right, true, products);
        }
        push(&mut right, true, &entries.gravity[i]);
        push(&mut right, true, &entries.springs[i]);
        push(&mut right, false, &entries.force[i]);
        push(&mut right, true, &entries.dissipation[i]);
        equations.push(Line { left: Tree::sum(left), right });
    }
    listed.sort_unstable();
    let mut lines: Vec<Line> = listed
        .into_iter()
        .map(|(i, j)| Line { left: Tree::Entry("M", vec![name(i), name(j)]), right: entries.mass_matrix[i][j].clone().into_terms() })
        .collect();
    lines.extend(table);
    for (z, rate) in e.layout.z.iter().zip(&entries.lag_rates) {
        equations.push(Line { left: Tree::Name(format!("{}.dot", z.name)), right: rate.clone().into_terms() });
    }
    let parts: Vec<Line> =
        entries.parts.iter().map(|(name, tree)| Line { left: Tree::Name(name.clone()), right: tree.clone().into_terms() }).collect();
    let outputs = outputs(rig, &entries);
    let mut sheet = Sheet {
        title: title(rig),
        q: e.layout.q.iter().map(|v| v.name.clone()).collect(),
        u: e.layout.u.iter().map(|v| v.name.clone()).collect(),
        assumptions: e.assumptions.clone(),
        equations,
        table: lines,
        parts,
        names: Vec::new(),
        valued: Vec::new(),
        outputs,
        notes: notes(rig, e),
    };
    explain_names(rig, e, &mut sheet);
    sheet
}

/// First line of the documentation, or the rig's name.
fn title(rig: &Rig) -> String {
    rig.doc.lines().map(str::trim).find(|l| !l.is_empty()).unwrap_or(&rig.name).to_owned()
}

/// Entries of a row of M that stand in the equation itself: the short ones, all of them if the row stays short.
fn spelled_out(row: &[Tree]) -> Vec<bool> {
    let lengths: Vec<usize> = row.iter().map(|t| if t.is_zero() { 0 } else { text(t).len() }).collect();
    let alone = lengths.iter().filter(|&&l| l > 0).count() == 1;
    let most = if alone { SHORT_LEFT } else { SHORT_ENTRY };
    let total: usize = lengths.iter().filter(|&&l| l <= most).sum();
    // a long row keeps only what is no longer than its name
    let most = if total <= SHORT_LEFT { most } else { 8 };
    lengths.iter().map(|&l| l <= most).collect()
}

/// M q'', without a 1 in front and with the sign outside.
fn times(entry: Tree, acceleration: Tree) -> (bool, Tree) {
    match entry {
        Tree::Minus(inner) => (true, Tree::product(vec![*inner, acceleration])),
        other => (false, Tree::product(vec![other, acceleration])),
    }
}

fn push(right: &mut Vec<(bool, Tree)>, minus: bool, tree: &Tree) {
    right.extend(tree.clone().into_terms().into_iter().map(|(m, t)| (m != minus, t)));
}

/// Outputs that say more than a coordinate's name.
fn outputs(rig: &Rig, entries: &Entries) -> Vec<Line> {
    rig.outputs
        .iter()
        .zip(&entries.outputs)
        .filter(|(o, tree)| **tree != Tree::Name(o.name.clone()))
        .map(|(o, tree)| {
            // an output that has a coordinate's name is not that coordinate
            let same = rig.coordinates.iter().any(|c| c.name == o.name);
            let left = if same { Tree::Entry("y", vec![o.name.clone()]) } else { Tree::Name(o.name.clone()) };
            Line { left, right: tree.clone().into_terms() }
        })
        .collect()
}

fn notes(rig: &Rig, e: &Equations) -> Vec<String> {
    let mut notes = Vec::new();
    let seconds = |expr: &Expr| match expr {
        Expr::Number(x) => format!("{x} s"),
        other => text(&Tree::of_expr(rig, other)),
    };
    for c in rig.coordinates.iter().filter(|c| c.prescribed) {
        notes.push(match &c.trajectory {
            Some(trajectory) => format!("{} is prescribed: {} = {}", c.name, c.name, text(&Tree::of_expr(rig, trajectory))),
            None => format!("{} is moved from outside: {}'' is given", c.name, c.name),
        });
    }
    for actuator in &rig.actuators {
        if let Some(delay) = &actuator.delay {
            notes.push(format!("{} acts {} late", actuator.name, seconds(delay)));
        }
    }
    for output in &rig.outputs {
        if let Some(delay) = &output.delay {
            notes.push(format!("{} is measured {} late", output.name, seconds(delay)));
        }
        if let Some(play) = &output.play {
            let width = match play {
                Expr::Number(x) => format!("{} {}", Number::of(x / output.unit.factor).decimal_text(), output.unit.text),
                other => text(&Tree::of_expr(rig, other)),
            };
            notes.push(format!("{} is read with a play of {width}", output.name));
        }
    }
    let forward = e.forward_operations();
    let operations = if e.linear.a.is_empty() {
        format!("{forward} operations forward.")
    } else {
        format!("{forward} operations forward, {} with A and B.", e.jacobian_operations())
    };
    notes.push(match e.cross_check {
        CrossCheck::Agree { .. } => format!(
            "{operations}   derived twice, agree.   energy balance holds{}.",
            if e.assumptions.is_empty() { "" } else { " before the assumptions" }
        ),
        CrossCheck::NotApplicable => format!("{operations}   written directly: no second derivation and no energy to compare with."),
    });
    notes
}

/// Definitions of the lumps and mixed inputs that occur on the sheet.
fn explain_names(rig: &Rig, e: &Equations, sheet: &mut Sheet) {
    let mut used: Vec<String> = Vec::new();
    for line in sheet.equations.iter().chain(&sheet.table).chain(&sheet.parts).chain(&sheet.outputs) {
        names_in(&line.left, &mut used);
        line.right.iter().for_each(|(_, t)| names_in(t, &mut used));
    }
    // a lump may stand in another lump's definition
    for d in rig.definitions.iter().rev() {
        if used.contains(&d.name) {
            names_in(&Tree::of_expr(rig, &d.value), &mut used);
        }
    }
    let mut graph = Graph::new();
    let lowering = Lowering::new(rig, e.lumps, true, &mut graph);
    for d in rig.definitions.iter().filter(|d| d.is_lump && used.contains(&d.name)) {
        let line = Line { left: Tree::Name(d.name.clone()), right: Tree::of_expr(rig, &d.value).into_terms() };
        match d.parameter {
            Some(p) if e.lumps == Lumps::AsParameters => {
                let id = lowering.expr(&mut graph, &d.value);
                let defined = graph.evaluate(&[id], |s| match graph.symbol_info(s).kind {
                    SymbolKind::Parameter(i) => e.layout.nominal[i],
                    _ => 0.0,
                });
                sheet.valued.push((line, e.layout.nominal[p], defined[0]));
            }
            _ => sheet.names.push(line),
        }
    }
    for mix in &rig.mixes {
        for (row, name) in mix.names.iter().enumerate().filter(|(_, name)| used.contains(name)) {
            let terms = mix.inputs.iter().zip(&mix.rows[row]).filter(|(_, k)| **k != 0.0).map(|(&i, &k)| {
                let k = Number::of(k);
                (k.is_negative(), Tree::product(vec![Tree::Number(k.abs()), Tree::Name(rig.inputs[i].name.clone())]))
            });
            sheet.names.push(Line { left: Tree::Name(name.clone()), right: Tree::sum(terms.collect()).into_terms() });
        }
    }
}

/// Written over named parts.
fn over_parts(tree: &Tree, entries: &Entries) -> bool {
    let mut names = Vec::new();
    names_in(tree, &mut names);
    entries.parts.iter().any(|p| names.contains(&p.0))
}

/// Names in a written expression, each once.
fn names_in(tree: &Tree, used: &mut Vec<String>) {
    match tree {
        Tree::Number(_) | Tree::Entry(..) => {}
        Tree::Name(name) => {
            if !used.contains(name) {
                used.push(name.clone());
            }
        }
        Tree::Call(_, args) | Tree::Product(args) => args.iter().for_each(|a| names_in(a, used)),
        Tree::Power(a, b) | Tree::Quotient(a, b) => {
            names_in(a, used);
            names_in(b, used);
        }
        Tree::Minus(a) => names_in(a, used),
        Tree::Sum(terms) => terms.iter().for_each(|(_, t)| names_in(t, used)),
    }
}
