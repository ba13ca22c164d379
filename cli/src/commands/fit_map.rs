//! `rig fit-map`: a static map from pairs, and its inverse.

use crate::args::FitMap;
use crate::failure::Failure;
use crate::output::{Answer, number};
use ident::static_map::{Axis, FORMS, Fitted, fit_map, read_pairs};
use serde_json::{Value, json};
use std::fmt::Write;

pub fn run(args: &FitMap) -> Result<Answer, Failure> {
    let only = match &args.form {
        None => None,
        Some(name) => Some(FORMS.into_iter().find(|f| f.id() == name).ok_or_else(|| {
            let known: Vec<&str> = FORMS.iter().map(|f| f.id()).collect();
            Failure::new("C0603", format!("there is no form `{name}`")).with_help(&format!("the forms are {}", known.join(", ")))
        })?),
    };
    let pairs = read_pairs(&args.pairs).map_err(|e| Failure::new("C0601", e.to_string()))?;
    let (x, y) = (&pairs.x, &pairs.y);
    let found = fit_map(&x.values, &y.values, only).map_err(|e| Failure::new("C0602", format!("{}: {e}", args.pairs.display())))?;
    let Some(best) = found.chosen() else {
        return Err(Failure::new("C0602", format!("{}: no form can be fitted", args.pairs.display())));
    };
    let inverse = Inverse::of(best, x, y, found.range, &args.invert);
    let mut text = format!(
        "{}: {} pairs, {} from {} to {}{}\n\n",
        args.pairs.display(),
        x.values.len(),
        x.name,
        number(found.range.0),
        number(found.range.1),
        unit(x)
    );
    let _ = writeln!(text, "{}    [{}], errors {}", best.form.written(&x.name, &y.name), best.form.id(), errors(best, y));
    for (i, name) in best.form.parameters().iter().enumerate() {
        let interval = best.std_error.as_ref().map_or_else(
            || "not told by these pairs".to_owned(),
            |s| {
                let half = best.factor * s[i];
                format!("+- {}   95 %: {} .. {}", number(s[i]), number(best.p[i] - half), number(best.p[i] + half))
            },
        );
        let _ = writeln!(text, "  {name:3} {:>12}  {interval}", number(best.p[i]));
    }
    text.push_str(&inverse.words(best, x, y));
    if found.forms.len() > 1 {
        let _ = writeln!(text, "\n  {:20} {:>10} {:>10} {:>12}  errors", "form", "AICc", "BIC", "rms error");
        let bic = found.forms.iter().map(|f| f.bic).fold(f64::INFINITY, f64::min);
        for f in &found.forms {
            let _ = writeln!(
                text,
                "  {:20} {:>+10.1} {:>+10.1} {:>12}  {}",
                f.form.id(),
                f.aicc - best.aicc,
                f.bic - bic,
                number(f.rms),
                f.errors.id()
            );
        }
        let ties: Vec<&str> = found.near_ties().iter().map(|f| f.form.id()).collect();
        if ties.is_empty() {
            text.push_str("no other form is within 2 of the best AICc\n");
        } else {
            let _ = writeln!(text, "near ties: these pairs can hardly tell {} from {}", best.form.id(), ties.join(", "));
        }
    }
    let json = json!({
        "form": best.form.id(),
        "equation": best.form.written(&x.name, &y.name),
        "parameters": parameters(best),
        "errors": best.errors.id(),
        "rms": best.rms,
        "sigma": best.sigma,
        "range": [found.range.0, found.range.1],
        "inverse": inverse.json(),
        "alternatives": found.forms[1..].iter().map(|f| json!({
            "form": f.form.id(), "parameters": parameters(f), "errors": f.errors.id(), "rms": f.rms,
            "aicc_above_best": f.aicc - best.aicc, "bic_above_chosen": f.bic - best.bic,
        })).collect::<Vec<_>>(),
        "near_ties": found.near_ties().iter().map(|f| f.form.id()).collect::<Vec<_>>(),
    });
    Ok(Answer { text, json })
}

fn unit(axis: &Axis) -> String {
    axis.unit.as_ref().map_or_else(String::new, |u| format!(" {u}"))
}

fn errors(f: &Fitted, y: &Axis) -> String {
    match f.errors {
        ident::static_map::Errors::Constant => format!("of {}{}", number(f.sigma), unit(y)),
        ident::static_map::Errors::Proportional => format!("of {} % of {}", number(100.0 * f.sigma), y.name),
    }
}

fn parameters(f: &Fitted) -> Vec<Value> {
    f.form
        .parameters()
        .iter()
        .enumerate()
        .map(|(i, name)| {
            let s = f.std_error.as_ref().map(|s| s[i]);
            json!({"name": name, "value": f.p[i], "std_error": s, "ci95": s.map(|s| [f.p[i] - f.factor * s, f.p[i] + f.factor * s])})
        })
        .collect()
}

/// The chosen map, the other way round.
struct Inverse {
    expression: Option<String>,
    monotonic: bool,
    /// (ordinate, abscissa).
    values: Vec<(f64, Option<f64>)>,
}

impl Inverse {
    fn of(f: &Fitted, x: &Axis, y: &Axis, range: (f64, f64), asked: &[f64]) -> Self {
        let monotonic = f.form.monotonic(&f.p, range);
        let (a, b) = (f.form.evaluate(&f.p, range.0).0, f.form.evaluate(&f.p, range.1).0);
        let ordinates: Vec<f64> =
            if asked.is_empty() { (0..=6).map(|k| a + (b - a) * f64::from(k) / 6.0).collect() } else { asked.to_vec() };
        Self {
            expression: f.form.inverse(&f.p, &x.name, &y.name, range).filter(|_| monotonic),
            monotonic,
            values: ordinates.into_iter().map(|y| (y, f.form.invert(&f.p, y, range))).collect(),
        }
    }

    fn words(&self, f: &Fitted, x: &Axis, y: &Axis) -> String {
        if !self.monotonic {
            return format!("inverse: none, {} rises and falls within the range of the pairs\n", f.form.id());
        }
        let expression = self.expression.clone().unwrap_or_else(|| format!("the {} within the range that solves the cubic", x.name));
        let mut text = format!("inverse: {expression}\n");
        let cell = |v: Option<f64>| v.map_or_else(|| "outside".to_owned(), number);
        let rows = [
            (&y.name, self.values.iter().map(|v| number(v.0)).collect::<Vec<_>>()),
            (&x.name, self.values.iter().map(|v| cell(v.1)).collect()),
        ];
        for (name, cells) in rows {
            let cells: Vec<String> = cells.iter().map(|c| format!("{c:>10}")).collect();
            let _ = writeln!(text, "  {name:6} {}", cells.join(" "));
        }
        text
    }

    fn json(&self) -> Value {
        json!({
            "expression": self.expression,
            "exists": self.monotonic,
            "values": self.values.iter().map(|(y, x)| json!({"y": y, "x": x})).collect::<Vec<_>>(),
        })
    }
}
