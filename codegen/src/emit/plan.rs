//! From roots on the graph to statements: which values get a name, which, in what order, and what
//! stands inside the expressions of others. The order is an evaluation order that keeps together what
//! is about one body, joint or force. The same plan serves every language.

use super::form::{Form, Rank};
use super::names::Names;
use super::vocabulary::Vocabulary;
use crate::expr::{F1, Graph, Id, Node, SymbolId};
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::{BTreeMap, BTreeSet};

/// Longest expression that is written without a name of its own [characters].
const LONGEST: usize = 110;
/// Deepest parentheses.
const DEEPEST: usize = 2;
/// A value that the derivation named gets its name from this many operations on.
const WORTH_A_NAME: usize = 3;
/// Longest generated name [characters].
const LONGEST_NAME: usize = 28;

/// Statements, then results.
pub struct Plan {
    /// In order of evaluation.
    pub statements: Vec<Statement>,
    /// One for each root.
    pub results: Vec<Form>,
    /// Values that the results use.
    pub result_uses: Vec<Value>,
    /// Symbols that the results read directly.
    pub result_symbols: Vec<SymbolId>,
    /// Functions that are called, by name.
    pub calls: BTreeSet<&'static str>,
}

impl Plan {
    /// All symbols that statements and results read.
    pub fn symbols(&self) -> BTreeSet<SymbolId> {
        self.statements.iter().flat_map(|s| &s.symbols).chain(&self.result_symbols).copied().collect()
    }
}

/// One intermediate value, or sine and cosine of one angle.
pub struct Statement {
    /// Scope on the graph: what it is about.
    pub scope: String,
    /// Its name does not say by itself what it is about.
    pub needs_comment: bool,
    /// What it defines.
    pub defines: Defines,
    /// Earlier values that it uses.
    pub uses: Vec<Value>,
    /// Symbols that it reads directly.
    pub symbols: Vec<SymbolId>,
}

/// A value that a statement defines.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Value {
    /// Statement that defines it.
    pub statement: usize,
    /// 1 for the cosine of a statement that defines sine and cosine.
    pub which: usize,
}

impl Value {
    /// Its name.
    pub fn name<'a>(&self, plan: &'a Plan) -> &'a str {
        match (&plan.statements[self.statement].defines, self.which) {
            (Defines::Value { name, .. }, _) => name,
            (Defines::SinCos { sin, .. }, 0) => sin,
            (Defines::SinCos { cos, .. }, _) => cos,
        }
    }
}

/// What a statement defines.
#[derive(Debug)]
pub enum Defines {
    /// name = value
    Value {
        /// Name.
        name: String,
        /// Value.
        value: Form,
    },
    /// (sin, cos) = sin_cos(angle)
    SinCos {
        /// Name of the sine.
        sin: String,
        /// Name of the cosine.
        cos: String,
        /// Angle.
        angle: Form,
    },
}

/// Plans the evaluation of `roots`.
pub fn plan(graph: &Graph, vocabulary: &Vocabulary, names: Names, roots: &[Id]) -> Plan {
    let mut planner = Planner::new(graph, vocabulary, names, roots);
    planner.choose();
    planner.schedule();
    planner.write(roots)
}

struct Planner<'a> {
    graph: &'a Graph,
    vocabulary: &'a Vocabulary,
    names: Names,
    order: Vec<Id>,
    uses: FxHashMap<Id, usize>,
    /// How many of the uses take the negative.
    negative_uses: FxHashMap<Id, usize>,
    /// Values with a name, and the statement that defines them once it is scheduled.
    named: FxHashMap<Id, usize>,
    /// Statements in order: the values that each defines.
    scheduled: Vec<Vec<Id>>,
    /// Names as handed out, and whether they are for the negative of the value.
    given: FxHashMap<Id, (String, bool)>,
    /// Number of the last value named after its scope.
    counters: FxHashMap<String, usize>,
}

const UNSCHEDULED: usize = usize::MAX;

impl<'a> Planner<'a> {
    fn new(graph: &'a Graph, vocabulary: &'a Vocabulary, names: Names, roots: &[Id]) -> Self {
        let order = graph.reachable(roots);
        let mut uses: FxHashMap<Id, usize> = FxHashMap::default();
        let mut negative_uses: FxHashMap<Id, usize> = FxHashMap::default();
        for &root in roots {
            *uses.entry(root).or_default() += 1;
        }
        let mut angles: FxHashSet<Id> = FxHashSet::default();
        for &id in order.iter().rev() {
            let own = uses.get(&id).copied().unwrap_or(0);
            // a sign moves through sums and products: who uses -a uses a
            let negative = matches!(graph.node(id), Node::Neg(_));
            // sine and cosine of one angle are one use of it
            if let Node::Call(F1::Sin | F1::Cos, angle) = graph.node(id)
                && !angles.insert(angle)
            {
                continue;
            }
            for operand in graph.node(id).operands().into_iter().flatten() {
                *uses.entry(operand).or_default() += if negative { own } else { 1 };
                *negative_uses.entry(operand).or_default() += if negative { own } else { 0 };
            }
        }
        Self {
            graph,
            vocabulary,
            names,
            order,
            uses,
            negative_uses,
            named: FxHashMap::default(),
            scheduled: Vec::new(),
            given: FxHashMap::default(),
            counters: FxHashMap::default(),
        }
    }

    /// Which values get a name: shared ones, sines and cosines, labelled ones of some weight, and
    /// those without which a line would grow too long or too deep.
    fn choose(&mut self) {
        let mut forms: FxHashMap<Id, (Form, usize)> = FxHashMap::default();
        for id in self.order.clone() {
            let node = self.graph.node(id);
            let mut form = self.form(node, &mut |operand| self.estimate(operand, &forms));
            while form.text().len() > LONGEST || form.depth() > DEEPEST {
                let inline = |x: Id| forms.get(&self.without_sign(x)).map_or(0, |(f, _)| f.text().len() + 200 * f.depth());
                let candidates = node
                    .operands()
                    .into_iter()
                    .flatten()
                    .map(|x| self.without_sign(x))
                    .filter(|&x| !self.graph.node(x).is_leaf() && !self.named.contains_key(&x));
                let Some(longest) = candidates.max_by_key(|&x| inline(x)) else { break };
                self.named.insert(longest, UNSCHEDULED);
                form = self.form(node, &mut |operand| self.estimate(operand, &forms));
            }
            let weight = 1 + node
                .operands()
                .into_iter()
                .flatten()
                .map(|x| if self.named.contains_key(&x) { 0 } else { forms.get(&x).map_or(0, |f| f.1) })
                .sum::<usize>();
            let weight = if node.is_leaf() { 0 } else { weight };
            let shared = self.uses.get(&id).is_some_and(|&n| n > 1);
            let gets_a_name = match node {
                Node::Number(_) | Node::Symbol(_) | Node::Neg(_) => false,
                Node::Call(F1::Sin | F1::Cos, _) => true,
                _ => shared || weight >= WORTH_A_NAME && self.graph.label_of(id).is_some(),
            };
            if gets_a_name {
                self.named.insert(id, UNSCHEDULED);
            }
            forms.insert(id, (form, weight));
        }
    }

    fn without_sign(&self, id: Id) -> Id {
        match self.graph.node(id) {
            Node::Neg(a) => a,
            _ => id,
        }
    }

    /// Form of an operand before names are known.
    fn estimate(&self, id: Id, forms: &FxHashMap<Id, (Form, usize)>) -> Form {
        if self.named.contains_key(&id) {
            return Form::atom(Rank::Named, self.graph.label_of(id).unwrap_or("a_name_of_some_length").to_owned());
        }
        forms.get(&id).map_or_else(|| Form::number(0.0), |f| f.0.clone())
    }

    /// Form of a node over the forms of its operands.
    fn form(&self, node: Node, of: &mut dyn FnMut(Id) -> Form) -> Form {
        match node {
            Node::Number(bits) => Form::number(f64::from_bits(bits)),
            Node::Symbol(s) => {
                let word = self.vocabulary.word(s);
                Form::ordered(word.rank, s.index(), word.text.clone())
            }
            Node::Add(a, b) => of(a).plus(of(b)),
            Node::Sub(a, b) => of(a).plus(of(b).negated()),
            Node::Mul(a, b) => of(a).times(of(b)),
            Node::Div(a, b) => of(a).over(of(b)),
            Node::Neg(a) => of(a).negated(),
            Node::Powi(a, n) => {
                let a = of(a);
                Form::call(format!("powi({}, {n})", a.text()), a.depth())
            }
            Node::Call(f, a) => {
                let a = of(a);
                Form::call(format!("{}({})", self.vocabulary.function(f), a.text()), a.depth())
            }
            Node::Call2(f, a, b) => {
                let (a, b) = (of(a), of(b));
                Form::call(format!("{}({}, {})", self.vocabulary.function2(f), a.text(), b.text()), a.depth().max(b.depth()))
            }
        }
    }

    /// The named values and symbols that a value needs directly.
    fn needs(&self, id: Id, named: &mut Vec<Id>, symbols: &mut Vec<SymbolId>) {
        let mut stack: Vec<Id> = self.graph.node(id).operands().into_iter().flatten().collect();
        if let Some(s) = self.graph.symbol_of(id) {
            symbols.push(s);
        }
        while let Some(x) = stack.pop() {
            if self.named.contains_key(&x) {
                named.push(x);
            } else if let Some(s) = self.graph.symbol_of(x) {
                symbols.push(s);
            } else {
                stack.extend(self.graph.node(x).operands().into_iter().flatten());
            }
        }
    }

    /// Orders the statements: sines and cosines as soon as they can be had, then what is about the same
    /// thing as the statement before, then the oldest.
    fn schedule(&mut self) {
        let mut groups: Vec<Vec<Id>> = Vec::new();
        let mut group_of: FxHashMap<Id, usize> = FxHashMap::default();
        let mut angles: FxHashMap<Id, usize> = FxHashMap::default();
        for id in self.order.iter().copied().filter(|id| self.named.contains_key(id)) {
            let group = match self.graph.node(id) {
                Node::Call(F1::Sin | F1::Cos, angle) => *angles.entry(angle).or_insert(groups.len()),
                _ => groups.len(),
            };
            if group == groups.len() {
                groups.push(Vec::new());
            }
            groups[group].push(id);
            group_of.insert(id, group);
        }
        let mut waiting: Vec<usize> = vec![0; groups.len()];
        let mut users: Vec<Vec<usize>> = vec![Vec::new(); groups.len()];
        for (k, group) in groups.iter().enumerate() {
            let mut needed = Vec::new();
            self.needs(group[0], &mut needed, &mut Vec::new());
            let before: BTreeSet<usize> = needed.iter().map(|id| group_of[id]).collect();
            waiting[k] = before.len();
            for b in before {
                users[b].push(k);
            }
        }
        let is_trig = |k: usize| matches!(self.graph.node(groups[k][0]), Node::Call(F1::Sin | F1::Cos, _));
        let scope = |k: usize| self.graph.scope_of(groups[k][0]);
        let mut trig: BTreeSet<usize> = BTreeSet::new();
        let mut ready: BTreeMap<&str, BTreeSet<usize>> = BTreeMap::new();
        let release = |k: usize, trig: &mut BTreeSet<usize>, ready: &mut BTreeMap<&'a str, BTreeSet<usize>>| {
            if is_trig(k) {
                trig.insert(k);
            } else {
                ready.entry(scope(k)).or_default().insert(k);
            }
        };
        for (k, &n) in waiting.iter().enumerate() {
            if n == 0 {
                release(k, &mut trig, &mut ready);
            }
        }
        let mut current: &str = "";
        let mut order = Vec::with_capacity(groups.len());
        loop {
            let next = if let Some(k) = trig.pop_first() {
                k
            } else {
                let here = ready.get(current).and_then(|set| set.first().copied());
                let oldest = || ready.values().filter_map(|set| set.first().copied()).min();
                let Some(k) = here.or_else(oldest) else { break };
                current = scope(k);
                if let Some(set) = ready.get_mut(current) {
                    set.remove(&k);
                }
                k
            };
            order.push(next);
            for &user in &users[next] {
                waiting[user] -= 1;
                if waiting[user] == 0 {
                    release(user, &mut trig, &mut ready);
                }
            }
        }
        self.scheduled = order.into_iter().map(|k| groups[k].clone()).collect();
        for (place, group) in self.scheduled.iter().enumerate() {
            for id in group {
                self.named.insert(*id, place);
            }
        }
    }

    /// Names in order of appearance, then the expressions.
    fn write(mut self, roots: &[Id]) -> Plan {
        let mut statements = Vec::with_capacity(self.scheduled.len());
        let mut calls = BTreeSet::new();
        for group in self.scheduled.clone() {
            let id = group[0];
            let (mut needed, mut symbols) = (Vec::new(), Vec::new());
            self.needs(id, &mut needed, &mut symbols);
            let uses: BTreeSet<Value> = needed.iter().map(|&x| self.value(x)).collect();
            symbols.sort_unstable();
            symbols.dedup();
            let mut needs_comment = false;
            let defines = match self.graph.node(id) {
                Node::Call(F1::Sin | F1::Cos, angle) if group.len() == 2 => {
                    let base = self.angle_name(angle);
                    let (sin, cos) = (self.names.take(&format!("s_{base}")), self.names.take(&format!("c_{base}")));
                    for &x in &group {
                        let is_sin = matches!(self.graph.node(x), Node::Call(F1::Sin, _));
                        self.given.insert(x, (if is_sin { sin.clone() } else { cos.clone() }, false));
                    }
                    calls.insert("sin_cos");
                    Defines::SinCos { sin, cos, angle: self.written(angle, &mut calls) }
                }
                node => {
                    let value = self.expression(node, &mut calls);
                    let (wanted, negative, is_description) = self.wanted_name(id, &value);
                    needs_comment = !is_description;
                    let name = self.names.take(&wanted);
                    let value = if negative { value.negated() } else { value };
                    self.given.insert(id, (name.clone(), negative));
                    Defines::Value { name, value }
                }
            };
            statements.push(Statement {
                scope: self.graph.scope_of(id).to_owned(),
                needs_comment,
                defines,
                uses: uses.into_iter().collect(),
                symbols,
            });
        }
        let results = roots.iter().map(|&root| self.written(root, &mut calls)).collect();
        let (mut needed, mut symbols) = (Vec::new(), Vec::new());
        for &root in roots {
            if self.named.contains_key(&root) {
                needed.push(root);
            } else {
                self.needs(root, &mut needed, &mut symbols);
            }
        }
        let result_uses: BTreeSet<Value> = needed.iter().map(|&x| self.value(x)).collect();
        symbols.sort_unstable();
        symbols.dedup();
        Plan { statements, results, result_uses: result_uses.into_iter().collect(), result_symbols: symbols, calls }
    }

    /// Where a named value is defined.
    fn value(&self, id: Id) -> Value {
        let statement = self.named[&id];
        let is_cosine_of_two = matches!(self.graph.node(id), Node::Call(F1::Cos, _)) && self.scheduled[statement].len() == 2;
        Value { statement, which: usize::from(is_cosine_of_two) }
    }

    /// A value as it is used: its name, or its expression.
    fn written(&self, id: Id, calls: &mut BTreeSet<&'static str>) -> Form {
        match self.given.get(&id) {
            Some((name, negative)) => {
                let trig = matches!(self.graph.node(id), Node::Call(F1::Sin | F1::Cos, _));
                let atom = Form::atom(if trig { Rank::Trig } else { Rank::Named }, name.clone());
                if *negative { atom.negated() } else { atom }
            }
            None => self.expression(self.graph.node(id), calls),
        }
    }

    fn expression(&self, node: Node, calls: &mut BTreeSet<&'static str>) -> Form {
        match node {
            Node::Powi(..) => drop(calls.insert("powi")),
            Node::Call(f, _) => drop(calls.insert(self.vocabulary.function(f))),
            Node::Call2(f, ..) => drop(calls.insert(self.vocabulary.function2(f))),
            _ => {}
        }
        self.form(node, &mut |operand| self.written(operand, calls))
    }

    /// The derivation's label, or a name that says what the value is made of, or its scope and a number;
    /// whether that names the negative of the value, and whether it is the second of the three.
    fn wanted_name(&mut self, id: Id, value: &Form) -> (String, bool, bool) {
        let node = self.graph.node(id);
        if let Node::Call(f @ (F1::Sin | F1::Cos), angle) = node {
            let base = self.angle_name(angle);
            return (format!("{}_{base}", if f == F1::Sin { "s" } else { "c" }), false, true);
        }
        if let Some(label) = self.graph.label_of(id) {
            return (label.to_owned(), self.graph.label_is_of_negative(id), false);
        }
        if let Some((name, negative)) = self.describe(node) {
            return (name, negative, true);
        }
        let scope = self.graph.scope_of(id).to_owned();
        let negative = value.is_negative() || self.uses.get(&id) == self.negative_uses.get(&id);
        (self.numbered(if scope.is_empty() { "part" } else { &scope }), negative, false)
    }

    fn numbered(&mut self, what: &str) -> String {
        let k = self.counters.entry(what.to_owned()).or_insert(0);
        *k += 1;
        format!("{what}_{k}")
    }

    /// `eps`, `2eps`, `q1_minus_q2`.
    fn angle_name(&mut self, angle: Id) -> String {
        let plain = |found: Option<(String, bool)>| found.map(|(name, negative)| if negative { format!("minus_{name}") } else { name });
        let name = match (self.graph.node(angle), self.given.get(&angle)) {
            (Node::Mul(a, b), None) => match (self.graph.number_of(a), self.graph.number_of(b)) {
                (Some(k), _) if k.fract() == 0.0 && k > 0.0 => plain(self.base(b)).map(|b| format!("{k}{b}")),
                (_, Some(k)) if k.fract() == 0.0 && k > 0.0 => plain(self.base(a)).map(|a| format!("{k}{a}")),
                _ => plain(self.base(angle)),
            },
            _ => plain(self.base(angle)),
        };
        name.filter(|n| n.len() <= LONGEST_NAME).unwrap_or_else(|| self.numbered("angle"))
    }

    /// A short name for a value that stands inside another one's name; true: for its negative.
    fn base(&self, id: Id) -> Option<(String, bool)> {
        if let Some(given) = self.given.get(&id) {
            return Some(given.clone());
        }
        match self.graph.node(id) {
            Node::Symbol(s) => Some((self.vocabulary.word(s).base.clone(), false)),
            Node::Number(bits) => {
                let x = f64::from_bits(bits);
                let size = x.abs();
                let word = match size {
                    1.0 => "one",
                    0.5 => "half",
                    0.25 => "quarter",
                    2.0 => "two",
                    3.0 => "three",
                    4.0 => "four",
                    _ if size.fract() == 0.0 && size < 100.0 => return Some((format!("{size}"), x < 0.0)),
                    _ => return None,
                };
                Some((word.to_owned(), x < 0.0))
            }
            node => self.describe(node),
        }
    }

    /// Names of the factors of a product, each with its place in products, and the product's sign.
    /// `None` where a factor has no short name.
    fn factors(&self, id: Id, out: &mut Vec<(Option<Rank>, String)>) -> Option<bool> {
        if let (Node::Mul(a, b), None) = (self.graph.node(id), self.given.get(&id)) {
            if a == b {
                out.push((Some(Rank::Named), format!("{}_sq", self.base(a)?.0)));
                return Some(false);
            }
            return Some(self.factors(a, out)? != self.factors(b, out)?);
        }
        let rank = match self.graph.node(id) {
            Node::Number(_) => None,
            Node::Symbol(s) => Some(self.vocabulary.word(s).rank),
            Node::Call(F1::Sin | F1::Cos, _) => Some(Rank::Trig),
            _ => Some(Rank::Named),
        };
        let (name, negative) = self.base(id)?;
        out.push((rank, name));
        (out.len() <= 8).then_some(negative)
    }

    /// A name that says what the value is, from the names of what it is made of; true: what its negative is.
    fn describe(&self, node: Node) -> Option<(String, bool)> {
        let sum = |a: Id, b: Id, subtract: bool| -> Option<(String, bool)> {
            let ((a, left), (b, right)) = (self.base(a)?, self.base(b)?);
            Some(match (left, right != subtract) {
                (false, false) => (format!("{a}_plus_{b}"), false),
                (false, true) => (format!("{a}_minus_{b}"), false),
                (true, false) => (format!("{b}_minus_{a}"), false),
                (true, true) => (format!("{a}_plus_{b}"), true),
            })
        };
        let argument = |a: Id| self.base(a).map(|(name, negative)| if negative { format!("minus_{name}") } else { name });
        let (name, negative) = match node {
            Node::Number(_) | Node::Symbol(_) => return None,
            Node::Add(a, b) => sum(a, b, false)?,
            Node::Sub(a, b) => sum(a, b, true)?,
            Node::Mul(a, b) if a == b => (format!("{}_sq", self.base(a)?.0), false),
            Node::Mul(a, b) => {
                let mut factors = Vec::new();
                let negative = self.factors(a, &mut factors)? != self.factors(b, &mut factors)?;
                factors.sort_by_key(|f| f.0);
                let names: Vec<&str> = factors.iter().map(|f| f.1.as_str()).collect();
                (names.join("_"), negative)
            }
            Node::Div(a, b) => {
                let (below, negative) = self.base(b)?;
                if self.graph.number_of(a) == Some(1.0) {
                    (format!("inv_{below}"), negative)
                } else {
                    let (above, other) = self.base(a)?;
                    (format!("{above}_per_{below}"), negative != other)
                }
            }
            Node::Neg(a) => {
                let (name, negative) = self.base(a)?;
                (name, !negative)
            }
            Node::Powi(a, n) => (format!("{}_pow{}{}", argument(a)?, if n < 0 { "m" } else { "" }, n.unsigned_abs()), false),
            Node::Call(f, a) => (format!("{}_{}", self.vocabulary.function(f), argument(a)?), false),
            Node::Call2(f, a, b) => (format!("{}_{}_{}", self.vocabulary.function2(f), argument(a)?, argument(b)?), false),
        };
        (name.len() <= LONGEST_NAME).then_some((name, negative))
    }
}
