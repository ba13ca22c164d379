//! What one model has and another one lacks, term by term, with sizes.
//!
//! Both models are read into one table of forms, coordinates and inputs matched by name. What both have
//! is taken away first; the rest is shortened and paired: a term that differs by a factor only is changed,
//! not removed and added.

use super::arrange::{Knowledge, shortened, written};
use super::entries::mixes;
use super::form::{Class, Forms, Monomial, Sum, content};
use super::number::Number;
use super::read::{Reader, register};
use super::shorten;
use super::text::{name_text, text};
use super::tree::Tree;
use crate::equations::Equations;
use crate::expr::{Id, SymbolId};
use model_dsl::rig::Rig;
use rustc_hash::FxHashMap;
use std::fmt;

/// Terms of two models that are not the same.
#[non_exhaustive]
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Diff {
    /// Terms that only the second model has.
    pub added: Vec<DiffTerm>,
    /// Terms that only the first model has.
    pub removed: Vec<DiffTerm>,
    /// Terms that both have in different form: `old -> new`.
    pub changed: Vec<DiffTerm>,
    /// Parameters of both with different values: `m_h: 1.8 -> 2`.
    pub values: Vec<String>,
    /// The state at which sizes were taken.
    pub at: String,
    /// Kinds of quantities that the second model lacks altogether.
    dropped: Vec<Kind>,
    /// Kinds of quantities that the first model lacks altogether.
    new: Vec<Kind>,
}

/// One term.
#[non_exhaustive]
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DiffTerm {
    /// Where it stands: `M[eps, theta]`, `gravity in eps`.
    pub quantity: String,
    /// The term; for a changed one `old -> new`.
    pub term: String,
    /// Its size: for M relative to the entry, otherwise the magnitude at the state `Diff::at`.
    pub size: String,
    kind: Kind,
    magnitude: Magnitude,
}

/// A magnitude for sorting, compared by its bits.
#[derive(Clone, Copy, Debug)]
struct Magnitude(f64);

impl PartialEq for Magnitude {
    fn eq(&self, other: &Self) -> bool {
        self.0.to_bits() == other.0.to_bits()
    }
}

impl Eq for Magnitude {}

/// What a quantity is, in the order of the screen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    MassMatrix,
    VelocityProducts,
    Gravity,
    Springs,
    Position,
    Force,
    Dissipation,
    Velocity,
    Actuator,
    Output,
}

impl Kind {
    const ALL: [Self; 10] = [
        Self::MassMatrix,
        Self::VelocityProducts,
        Self::Gravity,
        Self::Springs,
        Self::Position,
        Self::Force,
        Self::Dissipation,
        Self::Velocity,
        Self::Actuator,
        Self::Output,
    ];

    fn title(self) -> &'static str {
        match self {
            Self::MassMatrix => "mass matrix",
            Self::VelocityProducts => "velocity products",
            Self::Gravity => "gravity",
            Self::Springs => "springs",
            Self::Position => "gravity and springs",
            Self::Force => "forces",
            Self::Dissipation => "dissipation",
            Self::Velocity => "velocity products and dissipation",
            Self::Actuator => "actuators",
            Self::Output => "outputs",
        }
    }
}

/// One quantity of one model: a sum of graph nodes, with signs all plus.
struct Quantity {
    kind: Kind,
    name: String,
    /// Units of the row in either model.
    units: [String; 2],
    first: Vec<Id>,
    second: Vec<Id>,
}

/// Compares two models. Both should be derived with lumps expanded, so that a lump and its definition are the same.
#[must_use]
pub fn diff(first: (&Rig, &Equations), second: (&Rig, &Equations)) -> Diff {
    let mut forms = Forms::new();
    register(first.0, &mut forms);
    register(second.0, &mut forms);
    let mut mixed = mixes(first.0, &mut forms);
    for mix in mixes(second.0, &mut forms) {
        // one name for one combination of inputs is enough
        if mixed.iter().all(|m| m.old.iter().all(|a| !mix.old.contains(a))) {
            mixed.push(mix);
        }
    }
    let knowledge = Knowledge::new(Vec::new(), mixed, Vec::new());
    let states = [State::new(first.0, first.1), State::new(second.0, second.1)];
    let mut comparison = Comparison {
        forms,
        knowledge,
        readers: [Reader::new(first.0, &first.1.graph), Reader::new(second.0, &second.1.graph)],
        equations: [first.1, second.1],
        states,
        diff: Diff { values: values(first, second), ..Diff::default() },
    };
    let quantities = quantities(first, second);
    for quantity in &quantities {
        comparison.compare(quantity);
    }
    let mut diff = comparison.diff;
    for kind in Kind::ALL {
        let mut of_kind = quantities.iter().filter(|q| q.kind == kind).peekable();
        let zero = |e: &Equations, ids: &[Id]| ids.iter().all(|&id| e.graph.is_zero(id));
        if of_kind.peek().is_none() {
            continue;
        }
        let (mut dropped, mut new) = (true, true);
        for q in of_kind {
            dropped &= zero(second.1, &q.second);
            new &= zero(first.1, &q.first);
        }
        if dropped {
            diff.dropped.push(kind);
        } else if new {
            diff.new.push(kind);
        }
    }
    if [&diff.added, &diff.removed, &diff.changed].iter().any(|list| !list.is_empty()) {
        diff.at = State::new(first.0, first.1).in_words();
    }
    diff
}

/// Parameters of both models that have different values.
fn values(first: (&Rig, &Equations), second: (&Rig, &Equations)) -> Vec<String> {
    let pairs = first.0.parameters.iter().filter_map(|p| second.0.parameters.iter().find(|q| q.name == p.name).map(|q| (p, q)));
    pairs
        .filter(|(p, q)| p.value != q.value)
        .map(|(p, q)| format!("{}: {} -> {}", name_text(&p.name), Number::of(p.value).decimal_text(), Number::of(q.value).decimal_text()))
        .collect()
}

/// All quantities of both models, matched by the names of their rows.
fn quantities(first: (&Rig, &Equations), second: (&Rig, &Equations)) -> Vec<Quantity> {
    let mut rows: Vec<(String, Option<usize>, Option<usize>)> = Vec::new();
    let place = |rig: &Rig, name: &str| rig.coordinates.iter().position(|c| c.name == name);
    for rig in [first.0, second.0] {
        for c in &rig.coordinates {
            if rows.iter().all(|r| r.0 != c.name) {
                rows.push((c.name.clone(), place(first.0, &c.name), place(second.0, &c.name)));
            }
        }
    }
    let direct = first.1.coriolis.is_none() || second.1.coriolis.is_none();
    let mut out = Vec::new();
    let entry =
        |e: &Equations, i: Option<usize>, j: Option<usize>| i.zip(j).map(|(i, j)| e.mass_matrix[i][j]).into_iter().collect::<Vec<Id>>();
    let symmetric =
        |e: &Equations| e.mass_matrix.iter().enumerate().all(|(i, row)| row.iter().enumerate().all(|(j, &x)| x == e.mass_matrix[j][i]));
    let half = symmetric(first.1) && symmetric(second.1);
    for (k, r) in rows.iter().enumerate() {
        for s in rows.iter().skip(if half { k } else { 0 }) {
            let (a, b) = (entry(first.1, r.1, s.1), entry(second.1, r.2, s.2));
            out.push(Quantity {
                kind: Kind::MassMatrix,
                name: format!("M[{}, {}]", r.0, s.0),
                units: [String::new(), String::new()],
                first: a,
                second: b,
            });
        }
    }
    type Rows = Box<dyn Fn(&Equations, usize) -> Vec<Id>>;
    let coriolis = |e: &Equations, i: usize| e.coriolis.as_ref().map(|c| c[i]);
    let kinds: Vec<(Kind, Rows)> = if direct {
        vec![
            (Kind::Position, Box::new(|e, i| vec![e.gravity[i], e.springs[i]])),
            (Kind::Force, Box::new(|e, i| vec![e.force[i]])),
            (Kind::Velocity, Box::new(move |e, i| coriolis(e, i).into_iter().chain([e.dissipation[i]]).collect())),
        ]
    } else {
        vec![
            (Kind::VelocityProducts, Box::new(move |e, i| coriolis(e, i).into_iter().collect())),
            (Kind::Gravity, Box::new(|e, i| vec![e.gravity[i]])),
            (Kind::Springs, Box::new(|e, i| vec![e.springs[i]])),
            (Kind::Force, Box::new(|e, i| vec![e.force[i]])),
            (Kind::Dissipation, Box::new(|e, i| vec![e.dissipation[i]])),
        ]
    };
    for (kind, of) in kinds {
        for (name, i, j) in &rows {
            let side = |e: &Equations, row: Option<usize>| row.map_or_else(Vec::new, |i| of(e, i));
            let unit = |rig: &Rig, row: Option<usize>| row.map_or_else(String::new, |i| row_unit(rig, i));
            out.push(Quantity {
                kind,
                name: format!("{} in {name}", kind.title()),
                units: [unit(first.0, *i), unit(second.0, *j)],
                first: side(first.1, *i),
                second: side(second.1, *j),
            });
        }
    }
    by_name(
        &mut out,
        Kind::Actuator,
        |e| e.layout.z.iter().map(|z| (format!("{}'", z.name), z.unit.clone() + "/s")).zip(e.lag_rates.iter().copied()).collect(),
        first.1,
        second.1,
    );
    by_name(
        &mut out,
        Kind::Output,
        |e| e.layout.outputs.iter().map(|y| (format!("output {}", y.name), y.unit.clone())).zip(e.outputs.iter().copied()).collect(),
        first.1,
        second.1,
    );
    out
}

type Named = Vec<((String, String), Id)>;

/// Quantities with names of their own: actuator states, outputs.
fn by_name(out: &mut Vec<Quantity>, kind: Kind, list: impl Fn(&Equations) -> Named, first: &Equations, second: &Equations) {
    let (a, b) = (list(first), list(second));
    for (label, id) in &a {
        let other = b.iter().filter(|x| x.0.0 == label.0).map(|x| x.1).collect();
        out.push(Quantity { kind, name: label.0.clone(), units: [label.1.clone(), label.1.clone()], first: vec![*id], second: other });
    }
    for (label, id) in b.iter().filter(|x| a.iter().all(|y| y.0.0 != x.0.0)) {
        out.push(Quantity { kind, name: label.0.clone(), units: [label.1.clone(), label.1.clone()], first: Vec::new(), second: vec![*id] });
    }
}

/// Unit of the equation of a coordinate.
fn row_unit(rig: &Rig, row: usize) -> String {
    match rig.equations.iter().find(|e| e.coordinate == row) {
        Some(equation) => equation.unit.text.replace('*', " "),
        None if rig.coordinates.get(row).is_some_and(|c| c.unit.text == "m") => "N".to_owned(),
        None => "N m".to_owned(),
    }
}

/// The state at which sizes are taken: coordinates at three quarters of their range (0.5 without one), rates 1,
/// inputs at three quarters and half of their range in turn (1 without one).
struct State {
    values: FxHashMap<String, f64>,
    places: Vec<(String, f64)>,
    inputs: Vec<(String, f64)>,
}

impl State {
    fn new(rig: &Rig, e: &Equations) -> Self {
        let mut values: FxHashMap<String, f64> = FxHashMap::default();
        for (p, &x) in e.layout.p.iter().zip(&e.layout.nominal) {
            values.insert(p.name.clone(), x);
        }
        let within = |range: Option<(f64, f64)>, part: f64, otherwise: f64| range.map_or(otherwise, |(lo, hi)| lo + part * (hi - lo));
        // three digits are enough to say where
        let rounded = |x: f64| format!("{x:.2e}").parse::<f64>().unwrap_or(x);
        let places: Vec<(String, f64)> = rig.coordinates.iter().map(|c| (c.name.clone(), rounded(within(c.range, 0.75, 0.5)))).collect();
        let inputs: Vec<(String, f64)> = rig
            .inputs
            .iter()
            .enumerate()
            .map(|(k, i)| (i.name.clone(), rounded(within(i.limits, if k % 2 == 0 { 0.75 } else { 0.5 }, 1.0))))
            .collect();
        values.extend(places.iter().cloned());
        values.extend(inputs.iter().cloned());
        for mix in &rig.mixes {
            for (name, row) in mix.names.iter().zip(&mix.rows) {
                values.insert(name.clone(), mix.inputs.iter().zip(row).map(|(&i, k)| k * inputs[i].1).sum());
            }
        }
        Self { values, places, inputs }
    }

    /// A name's value; rates, actuator states, accelerations and time are 1.
    fn value(&self, name: &str) -> f64 {
        self.values.get(name).copied().unwrap_or(1.0)
    }

    fn in_words(&self) -> String {
        let list =
            |l: &[(String, f64)]| l.iter().map(|(n, x)| format!("{n} = {}", Number::of(*x).decimal_text())).collect::<Vec<_>>().join(", ");
        let mut words = format!("{}; rates 1", list(&self.places));
        if !self.inputs.is_empty() {
            words.push_str(&format!("; {}", list(&self.inputs)));
        }
        words
    }
}

struct Comparison<'a> {
    forms: Forms,
    knowledge: Knowledge,
    readers: [Reader<'a>; 2],
    equations: [&'a Equations; 2],
    states: [State; 2],
    diff: Diff,
}

/// What multiplies one product of moving factors.
type Group = (Monomial, Sum);

impl Comparison<'_> {
    fn compare(&mut self, quantity: &Quantity) {
        let (Some(a), Some(b)) = (self.form(0, &quantity.first), self.form(1, &quantity.second)) else {
            self.compare_numbers(quantity);
            return;
        };
        if a == b {
            return;
        }
        let (a, b) = (self.prepared(&a), self.prepared(&b));
        let same = |x: &Sum, y: &Sum| Sum(x.0.iter().filter(|(m, k)| y.coefficient(m) != *k).cloned().collect());
        let (only_a, only_b) = (same(&a, &b), same(&b, &a));
        if only_a.is_zero() && only_b.is_zero() {
            return;
        }
        // an entry of M that was replaced as a whole is one change
        let replaced = quantity.kind == Kind::MassMatrix && only_a == a && only_b == b && !a.is_zero() && !b.is_zero();
        let (mut removed, mut added) = (self.groups(&only_a), self.groups(&only_b));
        if replaced && (removed.len() > 1 || added.len() > 1) {
            let (old, new) = (self.written(&a), self.written(&b));
            self.change(quantity, old, new, &a, &b);
            return;
        }
        let mut notes = Vec::new();
        if quantity.kind == Kind::MassMatrix {
            notes = self.renamed(&mut removed, &mut added);
        }
        // first what multiplies the same thing, then what differs by a factor
        for by_factor in [false, true] {
            let mut i = 0;
            while i < removed.len() {
                let partner = added.iter().position(|g| if by_factor { differ_by_factor(&removed[i], g) } else { removed[i].0 == g.0 });
                match partner {
                    Some(j) => {
                        let (old, new) = (removed.remove(i), added.remove(j));
                        let (old, new) = (old.1.shifted(&old.0), new.1.shifted(&new.0));
                        let texts = (self.written(&old), self.written(&new));
                        self.change(quantity, texts.0, texts.1, &old, &new);
                    }
                    None => i += 1,
                }
            }
        }
        for (side, groups) in [(0, removed), (1, added)] {
            for (place, coefficient) in groups {
                let term = coefficient.shifted(&place);
                let shown = text(&self.written(&term));
                let x = self.value(side, &term);
                let mut size = self.size(quantity, side, x);
                if !notes.is_empty() {
                    size = format!("{size}; {}", notes.join(", "));
                }
                let term =
                    DiffTerm { quantity: quantity.name.clone(), term: shown, size, kind: quantity.kind, magnitude: Magnitude(x.abs()) };
                if side == 0 { self.diff.removed.push(term) } else { self.diff.added.push(term) }
            }
        }
    }

    /// Sum of the nodes as a form.
    fn form(&mut self, side: usize, ids: &[Id]) -> Option<Sum> {
        self.forms.work = 600_000;
        let mut total = Sum::zero();
        for form in self.readers[side].read(&mut self.forms, ids) {
            total = total.plus(form?.as_ref(), Number::ONE);
        }
        Some(total)
    }

    /// Denominators and mixed inputs dealt with alike in both models.
    fn prepared(&self, sum: &Sum) -> Sum {
        let mut sum = shorten::cancelled(&self.forms, sum);
        for mix in &self.knowledge.mixes {
            sum = shorten::mixed_inputs(&sum, mix);
        }
        sum
    }

    /// Shortened, by moving factors.
    fn groups(&mut self, sum: &Sum) -> Vec<Group> {
        let short = shortened(&mut self.forms, &self.knowledge, sum);
        let mut groups: Vec<(Monomial, Vec<(Monomial, Number)>)> = Vec::new();
        for (m, k) in &short.0 {
            let (fixed, moving) = m.split(|a| self.forms.depends(a).is_static());
            match groups.iter_mut().find(|g| g.0 == moving) {
                Some(group) => group.1.push((fixed, *k)),
                None => groups.push((moving, vec![(fixed, *k)])),
            }
        }
        groups.into_iter().map(|(m, terms)| (m, Sum::collect(terms))).collect()
    }

    fn written(&mut self, sum: &Sum) -> Tree {
        written(&mut self.forms, &self.knowledge, sum)
    }

    fn value(&self, side: usize, sum: &Sum) -> f64 {
        self.forms.evaluate(sum, &|name, _: Class| self.states[side].value(name))
    }

    /// Parameters with equal numbers that stand in each other's place are not terms that come or go.
    fn renamed(&mut self, removed: &mut Vec<Group>, added: &mut Vec<Group>) -> Vec<String> {
        let mut notes = Vec::new();
        let (mut gone, mut new) = (Vec::new(), Vec::new());
        for (place, old) in removed.iter() {
            let Some((_, other)) = added.iter().find(|g| g.0 == *place) else { continue };
            for (m, k) in &old.0 {
                let x = self.value(0, &Sum::term(m.clone(), *k));
                let equal = other
                    .0
                    .iter()
                    .find(|(n, j)| self.value(1, &Sum::term(n.clone(), *j)) == x && x != 0.0 && !new.contains(&(place.clone(), n.clone())));
                let Some((n, j)) = equal.cloned() else { continue };
                let (a, b) = (self.written(&Sum::term(m.clone(), *k)), self.written(&Sum::term(n.clone(), j)));
                notes.push(format!("{} stands for {}", text(&b), text(&a)));
                gone.push((place.clone(), m.clone()));
                new.push((place.clone(), n));
            }
        }
        // only where something is left to say, else it is a change
        let left: usize = removed.iter().chain(added.iter()).map(|g| g.1.len()).sum();
        if gone.is_empty() || left == gone.len() + new.len() {
            return Vec::new();
        }
        for (groups, taken) in [(removed, gone), (added, new)] {
            for (place, sum) in groups.iter_mut() {
                sum.0.retain(|(m, _)| !taken.contains(&(place.clone(), m.clone())));
            }
            groups.retain(|g| !g.1.is_zero());
        }
        notes
    }

    fn change(&mut self, quantity: &Quantity, old: Tree, new: Tree, a: &Sum, b: &Sum) {
        let (x, y) = (self.value(0, a), self.value(1, b));
        let size = if quantity.kind == Kind::MassMatrix && x != 0.0 {
            format!("{} -> {}, {}{} %", digits(x), digits(y), if y < x { "-" } else { "+" }, percent((y - x) / x))
        } else {
            from_to(quantity, x, y)
        };
        let term = format!("{} -> {}", text(&old), text(&new));
        self.diff.changed.push(DiffTerm {
            quantity: quantity.name.clone(),
            term,
            size,
            kind: quantity.kind,
            magnitude: Magnitude((y - x).abs()),
        });
    }

    /// Size of a term: its share of an entry of M, or its magnitude.
    fn size(&mut self, quantity: &Quantity, side: usize, x: f64) -> String {
        if quantity.kind != Kind::MassMatrix {
            return format!("{} {}", digits(x.abs()), quantity.units[side]).trim_end().to_owned();
        }
        let ids = if side == 0 { &quantity.first } else { &quantity.second };
        let whole: f64 = self.numbers(side, ids, None).iter().sum();
        // where the term is the entry, it is measured against the diagonal
        let e = self.equations[side];
        let place = e.mass_matrix.iter().enumerate().find_map(|(i, row)| row.iter().position(|id| ids.contains(id)).map(|j| (i, j)));
        match place {
            Some((i, j)) if i != j => {
                let diagonal = self.numbers(side, &[e.mass_matrix[i][i], e.mass_matrix[j][j]], None);
                let name = |k: usize| e.layout.q[k].name.as_str();
                let scale = (diagonal[0] * diagonal[1]).abs().sqrt();
                format!("{} % of sqrt(M[{i}, {i}] M[{j}, {j}])", percent(x / scale), i = name(i), j = name(j))
            }
            _ if whole != 0.0 => format!("{} % of it with these numbers", percent(x / whole)),
            _ => digits(x),
        }
    }

    /// Values of nodes at the state of sizes, or at a random one.
    fn numbers(&self, side: usize, ids: &[Id], random: Option<u64>) -> Vec<f64> {
        let e = self.equations[side];
        let state = &self.states[side];
        e.graph.evaluate(ids, |s: SymbolId| {
            let info = e.graph.symbol_info(s);
            let x = state.value(&info.name);
            match random {
                Some(seed) if !matches!(info.kind, crate::expr::SymbolKind::Parameter(_)) => x * noise(&info.name, seed),
                _ => x,
            }
        })
    }

    /// Entries that are too long for terms: are they equal, and if not, how much do they differ?
    fn compare_numbers(&mut self, quantity: &Quantity) {
        let sides = |random: Option<u64>| {
            let sum = |side: usize, ids: &[Id]| self.numbers(side, ids, random).iter().sum::<f64>();
            (sum(0, &quantity.first), sum(1, &quantity.second))
        };
        let differs = (0..4).map(|seed| sides(Some(seed))).any(|(a, b)| (a - b).abs() > 1e-11 * a.abs().max(b.abs()));
        if !differs {
            return;
        }
        let (a, b) = sides(None);
        let size = from_to(quantity, a, b);
        let term = "too long to be written out -> differs in value".to_owned();
        self.diff.changed.push(DiffTerm {
            quantity: quantity.name.clone(),
            term,
            size,
            kind: quantity.kind,
            magnitude: Magnitude((a - b).abs()),
        });
    }
}

/// `0.7 -> 0.5 N m`, with both units where they differ.
fn from_to(quantity: &Quantity, a: f64, b: f64) -> String {
    let [old, new] = &quantity.units;
    let first = if old == new { digits(a) } else { format!("{} {old}", digits(a)) };
    format!("{} -> {} {new}", first.trim_end(), digits(b)).trim_end().to_owned()
}

/// One group is the other one times a number or a product.
fn differ_by_factor(a: &Group, b: &Group) -> bool {
    let ((m, _, r), (n, _, s)) = (content(&a.1), content(&b.1));
    if r != s {
        return false;
    }
    let ratio = m.times(&a.0).times(&n.times(&b.0).powi(-1));
    ratio.0.iter().all(|f| f.1 > 0) || ratio.0.iter().all(|f| f.1 < 0)
}

/// A repeatable number in 0.3..1.7 for a name, the same in both models.
fn noise(name: &str, seed: u64) -> f64 {
    let mut z = name.bytes().fold(seed.wrapping_add(0x9E37_79B9_7F4A_7C15), |z, b| (z ^ u64::from(b)).wrapping_mul(0x0100_0000_01B3));
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^= z >> 31;
    0.3 + 1.4 * (z >> 11) as f64 / (1_u64 << 53) as f64
}

/// Three significant digits.
fn digits(x: f64) -> String {
    let x: f64 = format!("{x:.2e}").parse().unwrap_or(x);
    if x != 0.0 && !(1e-3..1e6).contains(&x.abs()) { format!("{x:e}") } else { format!("{x}") }
}

/// Two significant digits of a share in percent.
fn percent(share: f64) -> String {
    digits(format!("{:.1e}", 100.0 * share.abs()).parse().unwrap_or(share))
}

/// Longest line of a screen.
const WIDTH: usize = 110;

impl fmt::Display for Diff {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let all: Vec<(char, &DiffTerm)> = self
            .removed
            .iter()
            .map(|t| ('-', t))
            .chain(self.changed.iter().map(|t| ('~', t)))
            .chain(self.added.iter().map(|t| ('+', t)))
            .collect();
        if all.is_empty() {
            writeln!(f, "the equations are the same")?;
        }
        for kind in Kind::ALL {
            let of_kind: Vec<(char, &DiffTerm)> = all.iter().filter(|x| x.1.kind == kind).copied().collect();
            if of_kind.is_empty() {
                continue;
            }
            writeln!(f, "{}", kind.title())?;
            let whole =
                [(&self.dropped, '-', "dropped"), (&self.new, '+', "new")].into_iter().find(|w| w.0.contains(&kind) && of_kind.len() > 3);
            if let Some((_, sign, what)) = whole {
                let largest = of_kind.iter().max_by(|a, b| a.1.magnitude.0.total_cmp(&b.1.magnitude.0).then(b.1.term.cmp(&a.1.term)));
                if let Some((_, t)) = largest {
                    writeln!(f, "  {sign} all {} terms {what}; the largest, in {}:", of_kind.len(), row_of(t))?;
                    folded(f, "      ", &t.term, &t.size)?;
                }
                continue;
            }
            for (sign, t) in of_kind {
                let place = row_of(t);
                let verb = match (sign, kind) {
                    ('-', Kind::MassMatrix) => "loses ",
                    ('+', Kind::MassMatrix) => "gains ",
                    _ => "",
                };
                match t.term.split_once(" -> ") {
                    Some((old, new)) if sign == '~' => {
                        folded(f, &format!("  ~ {place}  was  "), old, "")?;
                        folded(f, &format!("    {}  is   ", " ".repeat(place.chars().count())), new, &t.size)?;
                    }
                    _ => folded(f, &format!("  {sign} {place}  {verb}"), &t.term, &t.size)?,
                }
            }
        }
        match (self.added.is_empty(), self.removed.is_empty()) {
            (true, false) => writeln!(f, "nothing added")?,
            (false, true) => writeln!(f, "nothing removed")?,
            _ => {}
        }
        if !self.at.is_empty() {
            writeln!(f, "sizes at {}", self.at)?;
        }
        if !self.values.is_empty() {
            folded(f, "other values: ", &self.values.join(", "), "")?;
        }
        Ok(())
    }
}

/// A line, continued below its beginning where it is too long: before a sign outside of brackets, or before the note.
fn folded(f: &mut fmt::Formatter<'_>, start: &str, text: &str, note: &str) -> fmt::Result {
    let indent = start.chars().count();
    let mut pieces: Vec<String> = Vec::new();
    let mut depth = 0_i32;
    for word in text.split(' ') {
        let new = depth == 0 && matches!(word, "+" | "-") || pieces.last().is_some_and(|p| p.ends_with(','));
        match pieces.last_mut() {
            Some(last) if !new && !matches!(last.as_str(), "") => {
                last.push(' ');
                last.push_str(word);
            }
            _ => pieces.push(word.to_owned()),
        }
        depth += word.chars().map(|c| i32::from(c == '(') - i32::from(c == ')')).sum::<i32>();
    }
    if !note.is_empty() {
        pieces.push(format!(" ({note})"));
    }
    write!(f, "{start}")?;
    let mut column = indent;
    for (i, piece) in pieces.iter().enumerate() {
        let length = piece.chars().count() + 1;
        if i > 0 && column + length > WIDTH {
            write!(f, "\n{}", " ".repeat(indent))?;
            column = indent;
        } else if i > 0 {
            write!(f, " ")?;
        }
        write!(f, "{}", if column == indent { piece.trim_start() } else { piece })?;
        column += length;
    }
    writeln!(f)
}

/// The row of a term without the kind, which stands in the title.
fn row_of(term: &DiffTerm) -> &str {
    term.quantity.rsplit_once(" in ").map_or(term.quantity.as_str(), |x| x.1)
}
