//! E0308: a kinetic function is quadratic in the rates. T(q, k v) = k^2 T(q, v) and the parallelogram law hold for
//! quadratic functions and for no others; both are tried at pseudo-random places.

use super::{Context, motion::sample};
use crate::diagnostic::Diagnostic;
use crate::rig::EnergyKind;

pub(super) fn check(c: &Context<'_>, diagnostics: &mut Vec<Diagnostic>) {
    let n = c.rig.coordinates.len();
    for f in c.rig.functions.iter().filter(|f| f.kind == EnergyKind::Kinetic) {
        if !c.numbers.known(&f.value) {
            continue;
        }
        let span = c.statement("kinetic", &f.name).map_or(f.span, |s| s.span);
        for k in 0..3 {
            let q = sample(c.rig, k);
            let v: Vec<f64> = sample(c.rig, k + 5).iter().map(|x| x + 0.7).collect();
            let w: Vec<f64> = sample(c.rig, k + 9).iter().map(|x| x - 0.4).collect();
            let at = |a: f64, b: f64| c.numbers.at(&f.value, &q, &(0..n).map(|i| a * v[i] + b * w[i]).collect::<Vec<_>>());
            let (rest, once, twice, other) = (at(0.0, 0.0), at(1.0, 0.0), at(2.0, 0.0), at(0.0, 1.0));
            let (sum, difference) = (at(1.0, 1.0), at(1.0, -1.0));
            let size = once.abs().max(other.abs()).max(sum.abs()).max(twice.abs());
            // a difference beyond rounding, or NaN
            let differ = |x: f64| x.is_nan() || x.abs() > 1e-9 * size;
            let why = if differ(rest) {
                "it does not vanish at rest"
            } else if differ(twice - 4.0 * once) || differ(sum + difference - 2.0 * (once + other)) {
                "doubling the rates does not make it four times as large"
            } else {
                continue;
            };
            diagnostics.push(
                Diagnostic::error("E0308", format!("the kinetic energy `{}` is not quadratic in the rates", f.name), span, why)
                    .help("write it as in `kinetic rotor: 1/2 * J * theta.dot^2;`; energies of position go into `potential`"),
            );
            break;
        }
    }
}
