//! What a set of roots needs: reachable nodes, operation counts, dependence, substitution.

use super::graph::{Graph, Id, Node, SymbolId};
use rustc_hash::FxHashMap;

impl Graph {
    /// All nodes that `roots` need, in ascending order (an evaluation order).
    #[must_use]
    pub fn reachable(&self, roots: &[Id]) -> Vec<Id> {
        let Some(top) = roots.iter().max() else { return Vec::new() };
        let mut seen = vec![false; top.index() + 1];
        for root in roots {
            seen[root.index()] = true;
        }
        for i in (0..=top.index()).rev() {
            if seen[i] {
                for operand in self.nodes[i].operands().into_iter().flatten() {
                    seen[operand.index()] = true;
                }
            }
        }
        seen.iter().enumerate().filter(|(_, s)| **s).map(|(i, _)| Id(i as u32)).collect()
    }

    /// Scalar operations after common subexpressions are shared.
    #[must_use]
    pub fn operations(&self, roots: &[Id]) -> usize {
        self.reachable(roots).into_iter().filter(|&id| !self.node(id).is_leaf()).count()
    }

    /// For each node of the graph up to the newest root, whether it depends on a symbol that `chosen` accepts.
    #[must_use]
    pub fn dependence(&self, roots: &[Id], chosen: impl Fn(SymbolId) -> bool) -> FxHashMap<Id, bool> {
        let mut depends = FxHashMap::default();
        for id in self.reachable(roots) {
            let value = match self.node(id) {
                Node::Symbol(s) => chosen(s),
                node => node.operands().into_iter().flatten().any(|a| depends[&a]),
            };
            depends.insert(id, value);
        }
        depends
    }

    /// Whether `root` depends on a symbol that `chosen` accepts.
    #[must_use]
    pub fn depends(&self, root: Id, chosen: impl Fn(SymbolId) -> bool) -> bool {
        self.reachable(&[root]).into_iter().any(|id| self.symbol_of(id).is_some_and(&chosen))
    }

    /// Symbols that `roots` need, in order of creation.
    #[must_use]
    pub fn symbols_of(&self, roots: &[Id]) -> Vec<SymbolId> {
        let mut symbols: Vec<SymbolId> = self.reachable(roots).into_iter().filter_map(|id| self.symbol_of(id)).collect();
        symbols.sort_unstable();
        symbols
    }

    /// Rebuilds `roots` with symbols replaced.
    pub fn substitute(&mut self, roots: &[Id], replacement: impl Fn(SymbolId) -> Option<Id>) -> Vec<Id> {
        let order = self.reachable(roots);
        let highest = order.last().map_or(0, |id| id.index() + 1);
        let mut image: Vec<Id> = (0..highest as u32).map(Id).collect();
        for id in order {
            let of = |x: Id| image[x.index()];
            let new = match self.node(id) {
                Node::Number(_) => id,
                Node::Symbol(s) => replacement(s).unwrap_or(id),
                Node::Add(a, b) => self.add(of(a), of(b)),
                Node::Sub(a, b) => self.sub(of(a), of(b)),
                Node::Mul(a, b) => self.mul(of(a), of(b)),
                Node::Div(a, b) => self.div(of(a), of(b)),
                Node::Neg(a) => self.neg(of(a)),
                Node::Powi(a, n) => self.powi(of(a), n),
                Node::Call(f, a) => self.call(f, of(a)),
                Node::Call2(f, a, b) => self.call2(f, of(a), of(b)),
            };
            image[id.index()] = new;
        }
        roots.iter().map(|id| image[id.index()]).collect()
    }

    /// Additive terms of an expression with their signs: a - (b + c) gives a, -b, -c.
    #[must_use]
    pub fn terms(&self, root: Id) -> Vec<(bool, Id)> {
        let mut terms = Vec::new();
        let mut stack = vec![(false, root)];
        while let Some((negative, id)) = stack.pop() {
            match self.node(id) {
                Node::Add(a, b) => {
                    stack.push((negative, b));
                    stack.push((negative, a));
                }
                Node::Sub(a, b) => {
                    stack.push((!negative, b));
                    stack.push((negative, a));
                }
                Node::Neg(a) => stack.push((!negative, a)),
                _ => terms.push((negative, id)),
            }
        }
        terms
    }
}
