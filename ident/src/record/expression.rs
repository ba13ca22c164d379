//! Expressions over the columns of a file: `(V_s - V_d)/2`.
//!
//! Numbers, names, `+ - * / ^`, parentheses, `pi`, and the functions abs, sqrt, sin, cos, exp, ln, min, max. A recursive
//! descent with a depth limit; nothing here knows files or units.

/// A parsed expression.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Expression {
    Number(f64),
    /// Index into the names that were used, in order of their first use.
    Name(usize),
    Negative(Box<Expression>),
    Binary(char, Box<Expression>, Box<Expression>),
    Call(Function, Vec<Expression>),
}

/// Functions of the language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Function {
    Abs,
    Sqrt,
    Sin,
    Cos,
    Exp,
    Ln,
    Min,
    Max,
}

const FUNCTIONS: [(&str, Function, usize); 8] = [
    ("abs", Function::Abs, 1),
    ("sqrt", Function::Sqrt, 1),
    ("sin", Function::Sin, 1),
    ("cos", Function::Cos, 1),
    ("exp", Function::Exp, 1),
    ("ln", Function::Ln, 1),
    ("min", Function::Min, 2),
    ("max", Function::Max, 2),
];

const DEPTH: usize = 64;

/// Parses; the second part lists the names that the expression uses.
pub(crate) fn parse(text: &str) -> Result<(Expression, Vec<String>), String> {
    let mut parser = Parser { rest: text, names: Vec::new(), depth: 0 };
    let expression = parser.sum()?;
    match parser.peek() {
        None => Ok((expression, parser.names)),
        Some(c) => Err(format!("`{c}` is not expected here, after `{}`", &text[..text.len() - parser.rest.len()].trim_end())),
    }
}

impl Expression {
    /// Value for the values of the names.
    pub fn value(&self, names: &[f64]) -> f64 {
        match self {
            Self::Number(x) => *x,
            Self::Name(i) => names[*i],
            Self::Negative(a) => -a.value(names),
            Self::Binary(op, a, b) => {
                let (a, b) = (a.value(names), b.value(names));
                match op {
                    '+' => a + b,
                    '-' => a - b,
                    '*' => a * b,
                    '/' => a / b,
                    _ => a.powf(b),
                }
            }
            Self::Call(function, args) => {
                let a = args[0].value(names);
                match function {
                    Function::Abs => a.abs(),
                    Function::Sqrt => a.sqrt(),
                    Function::Sin => a.sin(),
                    Function::Cos => a.cos(),
                    Function::Exp => a.exp(),
                    Function::Ln => a.ln(),
                    Function::Min => a.min(args[1].value(names)),
                    Function::Max => a.max(args[1].value(names)),
                }
            }
        }
    }
}

struct Parser<'a> {
    rest: &'a str,
    names: Vec<String>,
    depth: usize,
}

impl Parser<'_> {
    fn peek(&mut self) -> Option<char> {
        self.rest = self.rest.trim_start();
        self.rest.chars().next()
    }

    fn eat(&mut self, wanted: char) -> bool {
        let found = self.peek() == Some(wanted);
        if found {
            self.rest = &self.rest[wanted.len_utf8()..];
        }
        found
    }

    fn expect(&mut self, wanted: char) -> Result<(), String> {
        if self.eat(wanted) {
            return Ok(());
        }
        Err(match self.peek() {
            Some(c) => format!("`{wanted}` is expected, not `{c}`"),
            None => format!("`{wanted}` is missing at the end"),
        })
    }

    fn deeper(&mut self) -> Result<(), String> {
        self.depth += 1;
        if self.depth > DEPTH { Err("nested too deeply".to_owned()) } else { Ok(()) }
    }

    fn sum(&mut self) -> Result<Expression, String> {
        self.deeper()?;
        let mut left = self.product()?;
        while let Some(op) = self.peek().filter(|c| "+-".contains(*c)) {
            self.eat(op);
            left = Expression::Binary(op, Box::new(left), Box::new(self.product()?));
        }
        self.depth -= 1;
        Ok(left)
    }

    fn product(&mut self) -> Result<Expression, String> {
        let mut left = self.signed()?;
        while let Some(op) = self.peek().filter(|c| "*/".contains(*c)) {
            self.eat(op);
            left = Expression::Binary(op, Box::new(left), Box::new(self.signed()?));
        }
        Ok(left)
    }

    fn signed(&mut self) -> Result<Expression, String> {
        self.deeper()?;
        let result = if self.eat('-') { Expression::Negative(Box::new(self.signed()?)) } else { self.power()? };
        self.depth -= 1;
        Ok(result)
    }

    fn power(&mut self) -> Result<Expression, String> {
        let base = self.atom()?;
        if self.eat('^') { Ok(Expression::Binary('^', Box::new(base), Box::new(self.signed()?))) } else { Ok(base) }
    }

    fn atom(&mut self) -> Result<Expression, String> {
        match self.peek() {
            None => Err("it ends where a number or a name is expected".to_owned()),
            Some('(') => {
                self.eat('(');
                let inside = self.sum()?;
                self.expect(')')?;
                Ok(inside)
            }
            Some(c) if c.is_ascii_digit() || c == '.' => self.number(),
            Some(c) if c.is_alphabetic() || c == '_' => self.name(),
            Some(c) => Err(format!("`{c}` is not expected here")),
        }
    }

    fn number(&mut self) -> Result<Expression, String> {
        let bytes = self.rest.as_bytes();
        let digits = |from: usize| from + bytes[from..].iter().take_while(|b| b.is_ascii_digit() || **b == b'.').count();
        let mut end = digits(0);
        if bytes.get(end).is_some_and(|b| b"eE".contains(b)) {
            let sign = usize::from(bytes.get(end + 1).is_some_and(|b| b"+-".contains(b)));
            let exponent = end + 1 + sign;
            if bytes.get(exponent).is_some_and(u8::is_ascii_digit) {
                end = digits(exponent);
            }
        }
        let (text, rest) = self.rest.split_at(end);
        self.rest = rest;
        match text.parse::<f64>() {
            Ok(x) if x.is_finite() => Ok(Expression::Number(x)),
            _ => Err(format!("`{text}` is no number")),
        }
    }

    fn name(&mut self) -> Result<Expression, String> {
        let end = self.rest.find(|c: char| !(c.is_alphanumeric() || c == '_' || c == '.')).unwrap_or(self.rest.len());
        let (name, rest) = self.rest.split_at(end);
        let name = name.to_owned();
        self.rest = rest;
        if self.peek() == Some('(') {
            let Some(&(_, function, arity)) = FUNCTIONS.iter().find(|(n, ..)| *n == name) else {
                let known: Vec<&str> = FUNCTIONS.iter().map(|(n, ..)| *n).collect();
                return Err(format!("there is no function `{name}`; functions are {}", known.join(", ")));
            };
            self.eat('(');
            let mut args = vec![self.sum()?];
            while self.eat(',') {
                args.push(self.sum()?);
            }
            self.expect(')')?;
            if args.len() != arity {
                return Err(format!("`{name}` takes {arity} argument{}, not {}", if arity == 1 { "" } else { "s" }, args.len()));
            }
            return Ok(Expression::Call(function, args));
        }
        if name == "pi" {
            return Ok(Expression::Number(std::f64::consts::PI));
        }
        let index = self.names.iter().position(|n| *n == name).unwrap_or_else(|| {
            self.names.push(name);
            self.names.len() - 1
        });
        Ok(Expression::Name(index))
    }
}

#[cfg(test)]
mod tests {
    use super::parse;

    fn value(text: &str, names: &[f64]) -> f64 {
        parse(text).unwrap().0.value(names)
    }

    #[test]
    fn arithmetic() {
        assert_eq!(value("(V_s - V_d)/2", &[3.0, 1.0]), 1.0);
        assert_eq!(value("-2^2 + 3 * 2 - 1e1", &[]), -8.0);
        assert_eq!(value("2^-1", &[]), 0.5);
        assert_eq!(value("max(min(a, 5), -5)", &[7.0]), 5.0);
        assert_eq!(value("a + a * b - b", &[2.0, 3.0]), 5.0);
        assert_eq!(parse("b + a + b").unwrap().1, ["b", "a"]);
    }

    #[test]
    fn mistakes() {
        let why = |text: &str| parse(text).unwrap_err();
        assert_eq!(why("(a - b"), "`)` is missing at the end");
        assert_eq!(why("a b"), "`b` is not expected here, after `a`");
        assert_eq!(why("a +"), "it ends where a number or a name is expected");
        assert_eq!(why("tg(a)"), "there is no function `tg`; functions are abs, sqrt, sin, cos, exp, ln, min, max");
        assert_eq!(why("min(a)"), "`min` takes 2 arguments, not 1");
        assert_eq!(why("1.2.3"), "`1.2.3` is no number");
        assert_eq!(why(&"(".repeat(100_000)), "nested too deeply");
        assert_eq!(why(&"-".repeat(100_000)), "nested too deeply");
        assert_eq!(why("a % b"), "`%` is not expected here, after `a`");
    }
}
