//! An expression on its way to text: a sum of products, so that printing adds the parentheses that
//! are needed and no others. Knows precedence; knows nothing of languages, names and graphs.

/// Where a factor stands within a product, as in notes: numbers, constants, intermediate values,
/// sines and cosines, function values, variables, sums in parentheses.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Rank {
    /// A parameter.
    Parameter,
    /// A value with a name of its own.
    Named,
    /// A sine or a cosine.
    Trig,
    /// f(x)
    Call,
    /// Coordinate, rate, input, time.
    Variable,
    /// (a + b)
    Sum,
}

/// Something that needs no parentheses.
#[derive(Clone, Debug)]
struct Factor {
    rank: Rank,
    /// Parameters stand in the order of their declaration.
    order: usize,
    text: String,
}

/// coefficient * above.. / below..
#[derive(Clone, Debug)]
struct Product {
    coefficient: f64,
    above: Vec<Factor>,
    below: Vec<Factor>,
}

/// A sum of products of atoms.
#[derive(Clone, Debug)]
pub struct Form {
    terms: Vec<Product>,
    /// Parentheses within parentheses.
    depth: usize,
}

impl Form {
    /// A number.
    pub fn number(x: f64) -> Self {
        Self { terms: vec![Product { coefficient: x, above: Vec::new(), below: Vec::new() }], depth: 0 }
    }

    /// A name, or a call with its arguments.
    pub fn atom(rank: Rank, text: String) -> Self {
        Self::ordered(rank, 0, text)
    }

    /// A name with its place among names of its rank.
    pub fn ordered(rank: Rank, order: usize, text: String) -> Self {
        Self { terms: vec![Product { coefficient: 1.0, above: vec![Factor { rank, order, text }], below: Vec::new() }], depth: 0 }
    }

    /// f(arguments), one level deeper than the deepest argument.
    pub fn call(text: String, depth: usize) -> Self {
        Self { depth: depth + 1, ..Self::atom(Rank::Call, text) }
    }

    /// Every term has a minus sign.
    pub fn is_negative(&self) -> bool {
        self.terms.iter().all(|t| t.coefficient < 0.0)
    }

    /// How deeply parentheses are nested.
    pub fn depth(&self) -> usize {
        self.depth
    }

    /// -a
    pub fn negated(mut self) -> Self {
        for term in &mut self.terms {
            term.coefficient = -term.coefficient;
        }
        self
    }

    /// a + b
    pub fn plus(mut self, other: Self) -> Self {
        self.depth = self.depth.max(other.depth);
        self.terms.extend(other.terms);
        self
    }

    /// a * b
    pub fn times(self, other: Self) -> Self {
        let mut depth = self.depth.max(other.depth);
        let (a, b) = (self.into_product(&mut depth), other.into_product(&mut depth));
        let mut above = a.above;
        above.extend(b.above);
        above.sort_by_key(|f| (f.rank, f.order));
        let mut below = a.below;
        below.extend(b.below);
        Self { terms: vec![Product { coefficient: a.coefficient * b.coefficient, above, below }], depth }
    }

    /// a / b
    pub fn over(self, other: Self) -> Self {
        let mut depth = self.depth.max(other.depth);
        let (a, b) = (self.into_product(&mut depth), other.into_product(&mut depth));
        let mut above = a.above;
        above.extend(b.below);
        above.sort_by_key(|f| (f.rank, f.order));
        let mut below = a.below;
        let sign = if b.coefficient < 0.0 { -1.0 } else { 1.0 };
        if b.coefficient.abs() != 1.0 {
            below.push(Factor { rank: Rank::Named, order: 0, text: number(b.coefficient.abs()) });
        }
        below.extend(b.above);
        Self { terms: vec![Product { coefficient: sign * a.coefficient, above, below }], depth }
    }

    fn into_product(mut self, depth: &mut usize) -> Product {
        if self.terms.len() == 1
            && let Some(only) = self.terms.pop()
        {
            return only;
        }
        *depth = (*depth).max(self.depth + 1);
        Product {
            coefficient: 1.0,
            above: vec![Factor { rank: Rank::Sum, order: 0, text: format!("({})", self.text()) }],
            below: Vec::new(),
        }
    }

    /// One line.
    pub fn text(&self) -> String {
        self.pieces().concat()
    }

    /// Terms with their signs, in an order that starts with a positive one where there is one; joined
    /// they are the whole. A single product is cut into its factors.
    pub fn pieces(&self) -> Vec<String> {
        let mut terms: Vec<&Product> = self.terms.iter().collect();
        if let Some(first) = terms.iter().position(|t| t.coefficient >= 0.0) {
            let positive = terms.remove(first);
            terms.insert(0, positive);
        }
        match terms.as_slice() {
            [] => vec!["0.0".to_owned()],
            [only] => only.pieces(),
            _ => terms
                .iter()
                .enumerate()
                .map(|(i, term)| {
                    let size = Product { coefficient: term.coefficient.abs(), ..(*term).clone() }.pieces().concat();
                    match (i, term.coefficient < 0.0) {
                        (0, false) => size,
                        (0, true) => format!("-{size}"),
                        (_, false) => format!(" + {size}"),
                        (_, true) => format!(" - {size}"),
                    }
                })
                .collect(),
        }
    }
}

impl Product {
    fn pieces(&self) -> Vec<String> {
        let size = self.coefficient.abs();
        let mut factors: Vec<String> = Vec::new();
        if size != 1.0 || self.above.is_empty() {
            factors.push(number(size));
        }
        factors.extend(self.above.iter().map(|f| f.text.clone()));
        let mut pieces: Vec<String> = factors.into_iter().enumerate().map(|(i, f)| if i == 0 { f } else { format!(" * {f}") }).collect();
        if self.coefficient < 0.0 {
            pieces[0].insert(0, '-');
        }
        match self.below.as_slice() {
            [] => {}
            [one] => pieces.push(format!(" / {}", one.text)),
            several => {
                let bottom: Vec<&str> = several.iter().map(|f| f.text.as_str()).collect();
                pieces.push(format!(" / ({})", bottom.join(" * ")));
            }
        }
        pieces
    }
}

/// A finite number as both languages read it: shortest digits that give the same number back.
/// Infinity and not-a-number, which no checked rig holds, are written as quotients that give them.
pub fn number(x: f64) -> String {
    if x.is_nan() {
        "(0.0 / 0.0)".to_owned()
    } else if x.is_infinite() {
        if x > 0.0 { "(1.0 / 0.0)".to_owned() } else { "(-1.0 / 0.0)".to_owned() }
    } else {
        format!("{x:?}")
    }
}

#[cfg(test)]
mod tests {
    use super::{Form, Rank};

    fn name(text: &str) -> Form {
        Form::atom(Rank::Named, text.to_owned())
    }

    #[test]
    fn parentheses_where_they_are_needed_and_nowhere_else() {
        let (a, b, c) = (name("a"), name("b"), name("c"));
        let minus = |x: &Form, y: &Form| x.clone().plus(y.clone().negated());
        assert_eq!(minus(&a, &minus(&b, &c)).text(), "a - b + c");
        assert_eq!(minus(&minus(&a, &b), &c).text(), "a - b - c");
        assert_eq!(a.clone().negated().plus(b.clone()).text(), "b - a");
        assert_eq!(minus(&a, &b).times(c.clone()).text(), "c * (a - b)");
        assert_eq!(a.clone().over(minus(&b, &c)).text(), "a / (b - c)");
        assert_eq!(a.clone().over(b.clone().times(c.clone())).text(), "a / (b * c)");
        assert_eq!(a.clone().over(b.clone()).over(c.clone()).text(), "a / (b * c)");
        assert_eq!(a.clone().over(b.clone().over(c.clone())).text(), "a * c / b");
        assert_eq!(a.clone().times(b.clone()).negated().text(), "-a * b");
        assert_eq!(a.clone().plus(b.clone()).negated().text(), "-a - b");
        assert_eq!(Form::number(2.0).times(a.clone()).negated().plus(b.clone()).text(), "b - 2.0 * a");
        assert_eq!(Form::number(-3.0).text(), "-3.0");
        assert_eq!(Form::number(1.0).over(a.clone()).text(), "1.0 / a");
        assert_eq!(a.clone().over(Form::number(-12.0)).text(), "-a / 12.0");
        assert_eq!(a.times(Form::number(-1.5)).plus(c.over(Form::number(3.0).times(b))).text(), "c / (3.0 * b) - 1.5 * a");
    }
}
