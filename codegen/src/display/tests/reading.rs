//! Small readers of printed text and LaTeX, for comparing values.

use super::super::latex::name_latex;
use super::super::text::name_text;
use rustc_hash::FxHashMap;

type Value = Result<f64, String>;

/// Value of printed text: products by juxtaposition, `*` and `/` of one rank, `^` above.
pub fn text_value(text: &str, values: &FxHashMap<String, f64>) -> Value {
    let names = values.iter().map(|(n, x)| (name_text(n), *x)).collect();
    whole(Reader { rest: text, names: longest_first(names), latex: false })
}

/// Value of a formula in LaTeX.
pub fn latex_value(formula: &str, values: &FxHashMap<String, f64>) -> Value {
    let names = values.iter().map(|(n, x)| (name_latex(n), *x)).collect();
    whole(Reader { rest: formula, names: longest_first(names), latex: true })
}

fn longest_first(mut names: Vec<(String, f64)>) -> Vec<(String, f64)> {
    names.sort_by_key(|n| (std::cmp::Reverse(n.0.len()), n.0.clone()));
    names
}

fn whole(mut reader: Reader) -> Value {
    let value = reader.sum()?;
    reader.space();
    if reader.rest.is_empty() { Ok(value) } else { Err(format!("left over: {}", reader.rest)) }
}

struct Reader<'a> {
    rest: &'a str,
    names: Vec<(String, f64)>,
    latex: bool,
}

impl Reader<'_> {
    fn space(&mut self) {
        self.rest = self.rest.trim_start();
    }

    fn eat(&mut self, token: &str) -> bool {
        self.space();
        match self.rest.strip_prefix(token) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    fn need(&mut self, token: &str) -> Result<(), String> {
        if self.eat(token) { Ok(()) } else { Err(format!("expected {token} at {}", self.rest)) }
    }

    fn sum(&mut self) -> Value {
        let mut total = if self.eat("-") { -self.product()? } else { self.product()? };
        loop {
            if self.eat("+") {
                total += self.product()?;
            } else if self.eat("-") {
                total -= self.product()?;
            } else {
                return Ok(total);
            }
        }
    }

    fn product(&mut self) -> Value {
        let mut total = self.power()?;
        loop {
            self.space();
            if self.eat("*") || self.latex && self.eat("\\cdot") {
                total *= self.power()?;
            } else if !self.latex && self.eat("/") {
                total /= self.power()?;
            } else if self.starts_factor() {
                total *= self.power()?;
            } else {
                return Ok(total);
            }
        }
    }

    fn starts_factor(&self) -> bool {
        let first = self.rest.chars().next();
        let closing = ["\\right", "\\bigr"].iter().any(|c| self.rest.starts_with(c));
        !closing && first.is_some_and(|c| c.is_alphanumeric() || c == '(' || c == '\\')
    }

    fn power(&mut self) -> Value {
        let base = self.primary()?;
        // no space before the mark, so that the exponent belongs to what stands before it
        if self.rest.starts_with('^') {
            self.rest = &self.rest[1..];
            let exponent = if self.latex { self.braced()? } else { self.signed_power()? };
            return Ok(base.powf(exponent));
        }
        Ok(base)
    }

    fn signed_power(&mut self) -> Value {
        if self.eat("-") { Ok(-self.signed_power()?) } else { self.power() }
    }

    fn braced(&mut self) -> Value {
        self.need("{")?;
        let value = self.sum()?;
        self.need("}")?;
        Ok(value)
    }

    fn primary(&mut self) -> Value {
        self.space();
        if self.rest.starts_with(|c: char| c.is_ascii_digit()) {
            return self.number();
        }
        if self.latex { self.latex_primary() } else { self.text_primary() }
    }

    fn number(&mut self) -> Value {
        let mut end = self.rest.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(self.rest.len());
        // 4e-6 in text
        if let Some(tail) = self.rest[end..].strip_prefix('e')
            && !self.latex
        {
            let sign = usize::from(tail.starts_with('-'));
            let digits = tail[sign..].bytes().take_while(u8::is_ascii_digit).count();
            end += if digits > 0 { 1 + sign + digits } else { 0 };
        }
        let (number, rest) = self.rest.split_at(end);
        self.rest = rest;
        number.parse().map_err(|_| format!("no number: {number}"))
    }

    fn text_primary(&mut self) -> Value {
        if self.eat("(") {
            let value = self.sum()?;
            self.need(")")?;
            return Ok(value);
        }
        let end = self.rest.find(|c: char| !c.is_alphanumeric() && !matches!(c, '_' | '.' | '\'')).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest;
        if let Some((_, x)) = self.names.iter().find(|n| n.0 == word) {
            return Ok(*x);
        }
        if word == "pi" {
            return Ok(std::f64::consts::PI);
        }
        if !self.rest.starts_with('(') {
            return Err(format!("unknown name {word}"));
        }
        self.need("(")?;
        let arguments = self.arguments()?;
        self.need(")")?;
        function(word, &arguments)
    }

    fn arguments(&mut self) -> Result<Vec<f64>, String> {
        let mut list = vec![self.sum()?];
        while self.eat(",") {
            list.push(self.sum()?);
        }
        Ok(list)
    }

    fn latex_primary(&mut self) -> Value {
        if self.eat("\\left(") || self.eat("\\bigl(") {
            let value = self.sum()?;
            if !self.eat("\\bigr)") {
                self.need("\\right)")?;
            }
            return Ok(value);
        }
        if self.eat("\\frac") {
            let top = self.braced()?;
            return Ok(top / self.braced()?);
        }
        if self.eat("\\sqrt") {
            return Ok(self.braced()?.sqrt());
        }
        if self.eat("\\left|") {
            let value = self.sum()?;
            self.need("\\right|")?;
            return Ok(value.abs());
        }
        let names = std::mem::take(&mut self.names);
        let found = names.iter().find(|n| self.rest.starts_with(&n.0)).map(|n| (n.0.len(), n.1));
        self.names = names;
        if let Some((length, x)) = found {
            self.rest = &self.rest[length..];
            return Ok(x);
        }
        if self.eat("\\operatorname{") {
            let (word, rest) = self.rest.split_once('}').ok_or("an open brace")?;
            let word = word.replace('\\', "");
            self.rest = rest;
            return self.call(&word);
        }
        let end = self.rest[1..].find(|c: char| !c.is_ascii_alphabetic()).map_or(self.rest.len(), |i| i + 1);
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest;
        match word {
            "\\pi" => Ok(std::f64::consts::PI),
            _ => self.call(word.strip_prefix('\\').ok_or_else(|| format!("unknown name {word}"))?),
        }
    }

    /// A function with an exponent before its argument, and a single name or a bracket as argument.
    fn call(&mut self, word: &str) -> Value {
        let exponent = if self.rest.starts_with('^') {
            self.rest = &self.rest[1..];
            Some(self.braced()?)
        } else {
            None
        };
        let arguments = if self.eat("\\left(") {
            let list = self.arguments()?;
            self.need("\\right)")?;
            list
        } else {
            vec![self.primary()?]
        };
        let value = function(word, &arguments)?;
        Ok(exponent.map_or(value, |n| value.powf(n)))
    }
}

fn function(word: &str, x: &[f64]) -> Value {
    Ok(match (word, x) {
        ("sin", [x]) => x.sin(),
        ("cos", [x]) => x.cos(),
        ("tan", [x]) => x.tan(),
        ("atan" | "arctan", [x]) => x.atan(),
        ("tanh", [x]) => x.tanh(),
        ("exp", [x]) => x.exp(),
        ("ln", [x]) => x.ln(),
        ("sqrt", [x]) => x.sqrt(),
        ("abs", [x]) => x.abs(),
        ("sign" | "sgn", [x]) => f64::from(*x > 0.0) - f64::from(*x < 0.0),
        ("step", [x]) => f64::from(*x > 0.0),
        ("min", [x, y]) => x.min(*y),
        ("max", [x, y]) => x.max(*y),
        ("atan2", [x, y]) => x.atan2(*y),
        ("saturate" | "sat", [x, lo, hi]) => x.max(*lo).min(*hi),
        ("dead_zone", [x, w]) => x - x.max(-*w).min(*w),
        _ => return Err(format!("unknown function {word} of {} arguments", x.len())),
    })
}
