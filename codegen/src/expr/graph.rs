//! Nodes, symbols, labels and the arena that holds them.

use hashbrown::HashTable;
use hashbrown::hash_table::Entry;
use indexmap::{IndexMap, IndexSet};
use rustc_hash::FxBuildHasher;
use std::hash::BuildHasher;

/// A node of a [`Graph`].
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct Id(pub(crate) u32);

impl Id {
    /// Position in the arena.
    #[must_use]
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// A symbol of a [`Graph`].
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct SymbolId(pub(crate) u32);

impl SymbolId {
    /// Position in the table of symbols.
    #[must_use]
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// What a symbol stands for in a model.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum SymbolKind {
    /// Time [s].
    Time,
    /// Coordinate `q[i]`.
    Coordinate(usize),
    /// Rate `v[i]`.
    Rate(usize),
    /// Actuator state `z[i]`.
    Lag(usize),
    /// Signal `u[i]`: inputs, then accelerations of prescribed coordinates.
    Signal(usize),
    /// Parameter `p[i]`.
    Parameter(usize),
    /// Acceleration `a[i]`: argument of inverse dynamics.
    Acceleration(usize),
    /// A definition (lump) kept by its name in display forms.
    Definition(usize),
    /// Inertial parameter of a regressor.
    Inertial(usize),
}

/// Name and meaning of a symbol.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct SymbolInfo {
    /// Name as in the rig: `eps`, `eps.dot`, `m_h`.
    pub name: String,
    /// Meaning.
    pub kind: SymbolKind,
}

/// Functions of one argument.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum F1 {
    /// sin
    Sin,
    /// cos
    Cos,
    /// tan
    Tan,
    /// asin
    Asin,
    /// acos
    Acos,
    /// atan
    Atan,
    /// sinh
    Sinh,
    /// cosh
    Cosh,
    /// tanh
    Tanh,
    /// exp
    Exp,
    /// natural logarithm
    Ln,
    /// square root
    Sqrt,
    /// absolute value
    Abs,
    /// -1, 0, 1
    Sign,
    /// 1 for x > 0, else 0
    Step,
    /// tanh as the regularized sign of Coulomb friction: its slope may be left out of derivatives.
    SmoothSign,
}

/// Functions of two arguments.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum F2 {
    /// atan2(y, x)
    Atan2,
    /// min(a, b)
    Min,
    /// max(a, b)
    Max,
    /// a^b with a real exponent
    Pow,
}

/// One operation over older nodes.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Node {
    /// Number, by its bits (never -0.0, never NaN from construction of finite numbers).
    Number(u64),
    /// Symbol.
    Symbol(SymbolId),
    /// a + b, a <= b
    Add(Id, Id),
    /// a - b
    Sub(Id, Id),
    /// a * b, a <= b
    Mul(Id, Id),
    /// a / b
    Div(Id, Id),
    /// -a
    Neg(Id),
    /// a^n, n not 0, 1, 2
    Powi(Id, i32),
    /// f(a)
    Call(F1, Id),
    /// f(a, b)
    Call2(F2, Id, Id),
}

impl Node {
    /// Operands.
    #[must_use]
    pub fn operands(self) -> [Option<Id>; 2] {
        match self {
            Node::Number(_) | Node::Symbol(_) => [None, None],
            Node::Add(a, b) | Node::Sub(a, b) | Node::Mul(a, b) | Node::Div(a, b) | Node::Call2(_, a, b) => [Some(a), Some(b)],
            Node::Neg(a) | Node::Powi(a, _) | Node::Call(_, a) => [Some(a), None],
        }
    }

    /// No operation: number or symbol.
    #[must_use]
    pub fn is_leaf(self) -> bool {
        matches!(self, Node::Number(_) | Node::Symbol(_))
    }
}

/// Hash-consed arena of expressions.
#[derive(Clone, Default, Debug)]
pub struct Graph {
    pub(super) nodes: Vec<Node>,
    /// Ids by the hash of their nodes. Large models live from few pages and cache misses: nothing stands beside the ids, and the table is
    /// built anew in the order of the nodes when it is full.
    ids: HashTable<Id>,
    pub(super) symbols: IndexSet<SymbolInfo, FxBuildHasher>,
    labels: IndexMap<Id, (String, bool), FxBuildHasher>,
    scope: String,
    /// Place of `scope` in `scope_names`, once a node of it was made.
    scope_index: Option<u32>,
    /// First node of each stretch of nodes that were made in one scope, and the scope.
    scopes: Vec<(u32, u32)>,
    scope_names: IndexSet<String, FxBuildHasher>,
}

impl Graph {
    /// Empty graph.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Number of nodes ever made.
    #[must_use]
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// No node yet.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// The operation of a node.
    #[must_use]
    pub fn node(&self, id: Id) -> Node {
        self.nodes[id.index()]
    }

    /// The number, if the node is one.
    #[must_use]
    pub fn number_of(&self, id: Id) -> Option<f64> {
        match self.node(id) {
            Node::Number(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }

    /// The symbol, if the node is one.
    #[must_use]
    pub fn symbol_of(&self, id: Id) -> Option<SymbolId> {
        match self.node(id) {
            Node::Symbol(s) => Some(s),
            _ => None,
        }
    }

    /// Name and meaning of a symbol.
    #[must_use]
    pub fn symbol_info(&self, symbol: SymbolId) -> &SymbolInfo {
        &self.symbols[symbol.index()]
    }

    /// Symbols in the order in which they were made.
    pub fn symbols(&self) -> impl Iterator<Item = (SymbolId, &SymbolInfo)> {
        self.symbols.iter().enumerate().map(|(i, s)| (SymbolId(i as u32), s))
    }

    /// The node of the symbol of this name and meaning, made if it is new.
    pub fn symbol(&mut self, name: &str, kind: SymbolKind) -> Id {
        let (index, _) = self.symbols.insert_full(SymbolInfo { name: name.to_owned(), kind });
        self.insert(Node::Symbol(SymbolId(index as u32)))
    }

    /// The node of a symbol that was made before.
    #[must_use]
    pub fn node_of_symbol(&self, symbol: SymbolId) -> Id {
        let node = Node::Symbol(symbol);
        // every symbol was inserted as a node when it was made
        self.ids.find(hash(&node), |id| self.nodes[id.index()] == node).map_or(Id(0), |id| *id)
    }

    /// Looks a symbol up by its meaning.
    #[must_use]
    pub fn find_symbol(&self, kind: SymbolKind) -> Option<SymbolId> {
        self.symbols.iter().position(|s| s.kind == kind).map(|i| SymbolId(i as u32))
    }

    /// Names a node for emitted code (`omega_arm_y`). The first name stays; leaves keep their own.
    pub fn label(&mut self, id: Id, name: impl Into<String>) {
        if self.node(id).is_leaf() {
            return;
        }
        // the label goes with the value without its sign, since signs move through rewrites
        let (id, negative) = match self.node(id) {
            Node::Neg(a) if !self.node(a).is_leaf() => (a, true),
            _ => (id, false),
        };
        self.labels.entry(id).or_insert_with(|| (name.into(), negative));
    }

    /// Name given to a node.
    #[must_use]
    pub fn label_of(&self, id: Id) -> Option<&str> {
        self.labels.get(&id).map(|l| l.0.as_str())
    }

    /// The name of [`Graph::label_of`] was given to the negative of this node.
    #[must_use]
    pub fn label_is_of_negative(&self, id: Id) -> bool {
        self.labels.get(&id).is_some_and(|l| l.1)
    }

    /// Sets what the nodes made from now on are about (`heli`, `M`, `force on heli`).
    pub fn set_scope(&mut self, scope: impl Into<String>) {
        self.scope = scope.into();
        self.scope_index = None;
    }

    /// What was being derived when a node was made first.
    #[must_use]
    pub fn scope_of(&self, id: Id) -> &str {
        let stretch = self.scopes.partition_point(|(first, _)| *first <= id.0);
        let scope = stretch.checked_sub(1).map(|k| self.scopes[k].1 as usize);
        scope.and_then(|scope| self.scope_names.get_index(scope)).map_or("", String::as_str)
    }

    pub(super) fn insert(&mut self, node: Node) -> Id {
        if self.ids.len() == self.ids.capacity() {
            self.grow();
        }
        let nodes = &self.nodes;
        let entry = self.ids.entry(hash(&node), |id| nodes[id.index()] == node, |id| hash(&nodes[id.index()]));
        let place = match entry {
            Entry::Occupied(known) => return *known.get(),
            Entry::Vacant(place) => place,
        };
        let id = Id(self.nodes.len() as u32);
        place.insert(id);
        self.nodes.push(node);
        let scope = match self.scope_index {
            Some(scope) => scope,
            None => self.scope_names.insert_full(self.scope.clone()).0 as u32,
        };
        self.scope_index = Some(scope);
        if self.scopes.last().is_none_or(|(_, last)| *last != scope) {
            self.scopes.push((id.0, scope));
        }
        id
    }

    /// Twice the room for ids.
    fn grow(&mut self) {
        let nodes = &self.nodes;
        let mut ids = HashTable::with_capacity((2 * nodes.len()).max(1 << 10));
        for (i, node) in nodes.iter().enumerate() {
            ids.insert_unique(hash(node), Id(i as u32), |id: &Id| hash(&nodes[id.index()]));
        }
        self.ids = ids;
    }
}

/// The table takes a place from the low bits and a tag from the high bits.
fn hash(node: &Node) -> u64 {
    (FxBuildHasher.hash_one(node) >> 32).wrapping_mul(0x9E37_79B9_7F4A_7C15)
}
