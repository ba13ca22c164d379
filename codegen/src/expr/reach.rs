//! What a set of roots needs: reachable nodes, operation counts, dependence, substitution.

use super::graph::{Graph, Id, Node, SymbolId};
use rustc_hash::FxHashMap;

/// A set of nodes, closed under operands: one bit a node of the graph.
#[derive(Clone, Debug)]
pub struct Reach {
    words: Vec<u64>,
    /// How many nodes of the set stand in earlier words.
    before: Vec<u32>,
}

impl Reach {
    /// Nodes in ascending order (an evaluation order).
    pub fn ids(&self) -> impl Iterator<Item = Id> + '_ {
        self.words.iter().enumerate().flat_map(|(w, &word)| {
            let clear_lowest = |word: &u64| Some(word & (word - 1)).filter(|rest| *rest != 0);
            std::iter::successors(Some(word).filter(|word| *word != 0), clear_lowest)
                .map(move |word| Id((w * 64) as u32 + word.trailing_zeros()))
        })
    }

    /// Place of a node of the set in the order of [`Reach::ids`].
    #[must_use]
    pub fn place(&self, id: Id) -> usize {
        let older = (1_u64 << (id.index() % 64)) - 1;
        self.before[id.index() / 64] as usize + (self.words[id.index() / 64] & older).count_ones() as usize
    }
}

impl Graph {
    /// The set of nodes that `roots` need.
    #[must_use]
    pub fn reach(&self, roots: &[Id]) -> Reach {
        let highest = roots.iter().max().map_or(0, |top| top.index() + 1);
        let mut words = vec![0_u64; highest.div_ceil(64)];
        for root in roots {
            words[root.index() / 64] |= 1 << (root.index() % 64);
        }
        for w in (0..words.len()).rev() {
            // from the newest node down: an operand in the same word is one of the bits still to come
            let mut below = u64::MAX;
            while words[w] & below != 0 {
                let bit = 63 - (words[w] & below).leading_zeros() as usize;
                below = (1 << bit) - 1;
                for operand in self.nodes[w * 64 + bit].operands().into_iter().flatten() {
                    words[operand.index() / 64] |= 1 << (operand.index() % 64);
                }
            }
        }
        let mut before = Vec::with_capacity(words.len());
        let mut count = 0;
        for word in &words {
            before.push(count);
            count += word.count_ones();
        }
        Reach { words, before }
    }

    /// All nodes that `roots` need, in ascending order (an evaluation order).
    #[must_use]
    pub fn reachable(&self, roots: &[Id]) -> Vec<Id> {
        self.reach(roots).ids().collect()
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
        let reach = self.reach(roots);
        let mut image: Vec<Id> = Vec::new();
        for id in reach.ids() {
            let of = |x: Id| image[reach.place(x)];
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
            image.push(new);
        }
        roots.iter().map(|&id| image[reach.place(id)]).collect()
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
