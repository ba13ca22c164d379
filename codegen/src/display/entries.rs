//! All equations of one rig as written expressions, entry by entry; what a screen, a LaTeX fragment and the
//! JSON of `show` are put together from.

use super::arrange::{Knowledge, argument, written};
use super::form::{Atom, AtomId, Class, Forms, Sum};
use super::number::Number;
use super::read::{Reader, lump_atom, register};
use super::shorten::{Known, MixAtoms, as_factor};
use super::tree::Tree;
use crate::equations::Equations;
use crate::expr::{Graph, Id, Node};
use crate::lower::{Lowering, Lumps};
use model_dsl::rig::{Mix, Rig};
use std::rc::Rc;

/// Sums that may be looked for as factors.
const MOST_FACTORS: usize = 30;
/// Terms of an entry that is written out; longer ones are written over named parts.
const LONGEST: usize = 48;
/// Work left for each entry, so that one long entry does not take all.
const WORK: u64 = 600_000;

/// Written entries.
pub struct Entries {
    /// M, all entries.
    pub mass_matrix: Vec<Vec<Tree>>,
    /// Velocity products; zeros for equations written directly.
    pub coriolis: Vec<Tree>,
    /// Gravity.
    pub gravity: Vec<Tree>,
    /// Springs and potentials.
    pub springs: Vec<Tree>,
    /// Velocity products, gravity and springs together.
    pub bias: Vec<Tree>,
    /// Dissipation.
    pub dissipation: Vec<Tree>,
    /// Generalized forces.
    pub force: Vec<Tree>,
    /// dQ/du.
    pub input_map: Vec<Vec<Tree>>,
    /// Rates of actuator states.
    pub lag_rates: Vec<Tree>,
    /// Outputs.
    pub outputs: Vec<Tree>,
    /// Named parts of what is too long to be written out, in order.
    pub parts: Vec<(String, Tree)>,
}

/// Reads, shortens and arranges everything.
pub fn entries(rig: &Rig, e: &Equations) -> Entries {
    let mut forms = Forms::new();
    register(rig, &mut forms);
    let mut reader = Reader::new(rig, &e.graph);
    let n = rig.coordinates.len();
    let zeros = |list: &Option<Vec<Id>>| list.clone().unwrap_or_default();
    let coriolis = zeros(&e.coriolis);
    let blocks: [Vec<Id>; 9] = [
        e.mass_matrix.concat(),
        coriolis,
        e.gravity.clone(),
        e.springs.clone(),
        e.dissipation.clone(),
        e.force.clone(),
        e.input_map.concat(),
        e.lag_rates.clone(),
        e.outputs.clone(),
    ];
    let roots: Vec<Id> = blocks.concat();
    reader.names_parts = true;
    let sums = read_all(&mut reader, &mut forms, &roots);
    let knowledge = knowledge(rig, e, &mut reader, &mut forms, &roots);
    let parts: Vec<(String, Tree)> = reader
        .parts
        .iter()
        .map(|part| {
            let name = match forms.atom(part.atom) {
                Atom::Name(i) => forms.name(*i).0.to_owned(),
                _ => String::new(),
            };
            (name, written(&mut forms, &knowledge, &part.value))
        })
        .collect();
    let inner = sums.len() - e.outputs.len();
    let mut trees: Vec<Tree> = sums[..inner].iter().map(|s| written(&mut forms, &knowledge, s)).collect();
    trees.extend(sums[inner..].iter().map(|s| argument(&mut forms, &knowledge, s)));
    let mut rest = trees.into_iter();
    let mut take = |k: usize| rest.by_ref().take(k).collect::<Vec<Tree>>();
    let mut square = |columns: usize| (0..n).map(|_| take(columns)).collect::<Vec<_>>();
    let mass_matrix = square(n);
    let mut coriolis = take(blocks[1].len());
    coriolis.resize(n, Tree::integer(0));
    let (gravity, springs, dissipation, force) = (take(n), take(n), take(n), take(n));
    let input_map = (0..n).map(|_| take(e.layout.u.len())).collect();
    let (lag_rates, outputs) = (take(e.lag_rates.len()), take(e.outputs.len()));
    let bias =
        (0..n).map(|i| Tree::sum(vec![(false, coriolis[i].clone()), (false, gravity[i].clone()), (false, springs[i].clone())])).collect();
    Entries { mass_matrix, coriolis, gravity, springs, bias, dissipation, force, input_map, lag_rates, outputs, parts }
}

/// Forms of all roots, those that grow too long over named parts.
pub fn read_all(reader: &mut Reader, forms: &mut Forms, roots: &[Id]) -> Vec<Sum> {
    forms.work = WORK;
    let full: Vec<Option<Rc<Sum>>> = reader.read(forms, roots);
    let long: Vec<Id> = roots.iter().zip(&full).filter(|(_, f)| too_long(f.as_deref())).map(|(id, _)| *id).collect();
    forms.work = WORK;
    let mut by_parts = reader.read_in_parts(forms, &long).into_iter();
    full.iter()
        .map(|f| if too_long(f.as_deref()) { by_parts.next().unwrap_or_default() } else { f.as_deref().cloned().unwrap_or_default() })
        .collect()
}

/// More than anyone reads in one entry.
fn too_long(form: Option<&Sum>) -> bool {
    form.is_none_or(|s| s.len() > LONGEST)
}

/// What can be recognized in the equations of a rig.
pub fn knowledge(rig: &Rig, e: &Equations, reader: &mut Reader, forms: &mut Forms, roots: &[Id]) -> Knowledge {
    let lumps = if e.lumps == Lumps::AsParameters { lumps(rig, forms) } else { Vec::new() };
    let factors = factors(e, reader, forms, roots);
    Knowledge::new(lumps, mixes(rig, forms), factors)
}

/// Lumps without a value of their own, longest first.
fn lumps(rig: &Rig, forms: &mut Forms) -> Vec<Known> {
    let mut graph = Graph::new();
    let lowering = Lowering::new(rig, Lumps::AsParameters, true, &mut graph);
    let shown: Vec<usize> =
        (0..rig.definitions.len()).filter(|&i| rig.definitions[i].is_lump && rig.definitions[i].parameter.is_none()).collect();
    let ids: Vec<Id> = shown.iter().map(|&i| lowering.expr(&mut graph, &rig.definitions[i].value)).collect();
    let values = Reader::new(rig, &graph).read(forms, &ids);
    let size = |s: &Sum| (s.len(), s.0.iter().map(|t| t.0.0.len()).sum::<usize>());
    let mut known: Vec<Known> = shown
        .iter()
        .zip(values)
        .filter_map(|(&i, value)| Some(Known { value: value?.as_ref().clone(), atom: lump_atom(rig, i, forms) }))
        .filter(|k| size(&k.value).1 > 1)
        .collect();
    known.sort_by_key(|k| std::cmp::Reverse(size(&k.value)));
    known
}

/// Mixed inputs of a rig whose matrices can be turned over.
pub fn mixes(rig: &Rig, forms: &mut Forms) -> Vec<MixAtoms> {
    let mut signal = |name: &str| forms.named(name, Class::Signal, super::form::Depends::default());
    rig.mixes
        .iter()
        .filter_map(|mix| {
            let old: Vec<AtomId> = mix.inputs.iter().map(|&i| signal(&rig.inputs[i].name)).collect();
            let new: Vec<AtomId> = mix.names.iter().map(|n| signal(n)).collect();
            Some(MixAtoms { old, new, inverse: inverse(mix)? })
        })
        .collect()
}

/// Inverse of a mix's matrix by elimination, exact where its numbers are.
fn inverse(mix: &Mix) -> Option<Vec<Vec<Number>>> {
    let n = mix.rows.len();
    let mut rows: Vec<Vec<Number>> = (0..n)
        .map(|i| {
            mix.rows[i].iter().map(|&x| Number::of(x)).chain((0..n).map(|j| if i == j { Number::ONE } else { Number::ZERO })).collect()
        })
        .collect();
    for k in 0..n {
        let pivot = (k..n).max_by(|&a, &b| rows[a][k].abs().cmp(&rows[b][k].abs()))?;
        if rows[pivot].get(k)?.is_zero() {
            return None;
        }
        rows.swap(k, pivot);
        let scale = rows[k][k].inverse();
        rows[k] = rows[k].iter().map(|x| x.mul(scale)).collect();
        let row = rows[k].clone();
        for (i, other) in rows.iter_mut().enumerate() {
            let factor = other[k].neg();
            if i != k {
                *other = other.iter().zip(&row).map(|(x, y)| x.add(factor.mul(*y))).collect();
            }
        }
    }
    Some(rows.into_iter().map(|row| row[n..].to_vec()).collect())
}

/// Sums of coordinates, rates or signals that are multiplied or raised somewhere in the graph.
fn factors(e: &Equations, reader: &mut Reader, forms: &mut Forms, roots: &[Id]) -> Vec<Known> {
    let g = &e.graph;
    let mut known: Vec<Known> = Vec::new();
    for id in g.reachable(roots) {
        let operands = match g.node(id) {
            Node::Mul(a, b) => [Some(a), Some(b)],
            Node::Powi(a, _) | Node::Div(a, _) => [Some(a), None],
            _ => continue,
        };
        for operand in operands.into_iter().flatten().filter(|&x| matches!(g.node(x), Node::Add(..) | Node::Sub(..))) {
            if known.len() >= MOST_FACTORS {
                return known;
            }
            let Some(form) = reader.read(forms, &[operand]).pop().flatten() else { continue };
            if let Some(factor) = as_factor(forms, &form)
                && known.iter().all(|k| k.atom != factor.atom)
            {
                known.push(factor);
            }
        }
    }
    known
}
