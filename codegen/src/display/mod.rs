//! Equations as a person writes them, in text and LaTeX, and the difference of two models.
//!
//! The road: graph -> `read` -> normal form (`form`, `number`) -> `shorten` -> `arrange` -> `tree` -> `text` |
//! `latex`; `entries`, `sheet` and `screen` put whole models together, `difference` compares two.

mod arrange;
mod difference;
mod entries;
mod form;
mod latex;
mod number;
mod read;
mod screen;
mod sheet;
mod shorten;
mod text;
mod torque_form;
mod tree;

#[cfg(test)]
mod tests;

pub use difference::{Diff, DiffTerm, diff};
pub use torque_form::{TorqueForm, torque_form};

use crate::equations::Equations;
use crate::expr::{Graph, Id};
use entries::entries;
use model_dsl::rig::{Expr, Rig};
use tree::Tree;

/// The quantities of a model, each as text with one entry a line; entries that are zero are left out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Strings {
    /// `M[eps, theta] = ..`, the upper half where M is symmetric.
    pub mass_matrix: String,
    /// Velocity products, gravity and springs: `bias[eps] = ..`.
    pub bias: String,
    /// `gravity[eps] = ..`
    pub gravity: String,
    /// dQ/du: `dQ[eps]/df_1 = ..`
    pub input_map: String,
    /// `dissipation[eps] = ..`
    pub dissipation: String,
}

/// Text of a checked expression with the rig's names, as it was written.
#[must_use]
pub fn plain(rig: &Rig, expr: &Expr) -> String {
    text::text(&Tree::of_expr(rig, expr))
}

/// Text of a value on a graph over the rig's names, multiplied out and cancelled; `None` where it is too long for that.
#[must_use]
pub fn value(rig: &Rig, graph: &Graph, id: Id) -> Option<String> {
    let mut forms = form::Forms::new();
    read::register(rig, &mut forms);
    let sum = read::Reader::new(rig, graph).read(&mut forms, &[id]).pop().flatten()?;
    Some(text::text(&arrange::written(&mut forms, &arrange::Knowledge::default(), &sum)))
}

/// The quantities of a model as text.
#[must_use]
pub fn strings(rig: &Rig, equations: &Equations) -> Strings {
    let e = entries(rig, equations);
    let n = rig.coordinates.len();
    let name = |i: usize| rig.coordinates[i].name.as_str();
    let join = |lines: Vec<(String, &Tree)>| {
        let shown: Vec<String> =
            lines.iter().filter(|(_, t)| !t.is_zero()).map(|(left, t)| format!("{left} = {}", text::text(t))).collect();
        if shown.is_empty() { "0".to_owned() } else { shown.join("\n") }
    };
    let vector = |what: &str, list: &[Tree]| join(list.iter().enumerate().map(|(i, t)| (format!("{what}[{}]", name(i)), t)).collect());
    let symmetric = (0..n).all(|i| (0..i).all(|j| e.mass_matrix[i][j] == e.mass_matrix[j][i]));
    let mut mass = Vec::new();
    let mut map = Vec::new();
    for i in 0..n {
        for j in if symmetric { i } else { 0 }..n {
            mass.push((format!("M[{}, {}]", name(i), name(j)), &e.mass_matrix[i][j]));
        }
        for (u, tree) in equations.layout.u.iter().zip(&e.input_map[i]) {
            map.push((format!("dQ[{}]/d{}", name(i), text::name_text(&u.name)), tree));
        }
    }
    let parts: String = e.parts.iter().map(|(name, tree)| format!("\n{} = {}", text::name_text(name), text::text(tree))).collect();
    let with_parts = |text: String| if parts.is_empty() || text == "0" { text } else { format!("{text}{parts}") };
    Strings {
        mass_matrix: with_parts(join(mass)),
        bias: with_parts(vector("bias", &e.bias)),
        gravity: with_parts(vector("gravity", &e.gravity)),
        input_map: with_parts(join(map)),
        dissipation: with_parts(vector("dissipation", &e.dissipation)),
    }
}

/// The screen of `rig show`: title, assumptions, one equation for each coordinate, what the names mean, operation
/// counts and how the derivation was checked.
#[must_use]
pub fn text(rig: &Rig, equations: &Equations) -> String {
    screen::screen(&sheet::sheet(rig, equations))
}

/// The same equations as a LaTeX fragment (amsmath).
#[must_use]
pub fn latex(rig: &Rig, equations: &Equations) -> String {
    screen::fragment(&sheet::sheet(rig, equations))
}
