//! How a compliance between an actuator and what it moves is seen where it is absent: by what a resonance of the given frequency makes of a
//! record's command. Knows records, no rig.

use ident::innovations::{Shape, Track};
use runtime::Model;

/// Steps of a sample, and of a radian of the resonance, at the least.
const STEPS: (f64, f64) = (4.0, 20.0);

/// u - z over a record, z being command `input` behind z'' + 2 d w z' + w^2 (z - u) = 0; begins settled.
pub(crate) fn strain(model: &dyn Model, p: &[f64], track: &Track, input: usize, w: f64, d: f64) -> Box<Shape> {
    let times = track.times();
    let (first, last) = (times[0], times[times.len() - 1]);
    let period = (last - first) / (times.len() - 1).max(1) as f64;
    let h = (period / STEPS.0).min(1.0 / (STEPS.1 * w));
    let count = ((last - first) / h).ceil() as usize + 1;
    let u = |t: f64| track.inputs(model, p, t).get(input).copied().unwrap_or(0.0);
    let (mut z, mut rate) = (u(first), 0.0);
    let mut strain = Vec::with_capacity(count);
    // exact for a command that is constant over a step
    let (decay, damped) = ((-d * w * h).exp(), w * (1.0 - d * d).max(1e-6).sqrt());
    let (sin, cos) = (damped * h).sin_cos();
    for k in 0..count {
        let t = first + k as f64 * h;
        strain.push(u(t) - z);
        let command = u(t + 0.5 * h);
        let (e, slope) = (z - command, (rate + d * w * (z - command)) / damped);
        z = command + decay * (e * cos + slope * sin);
        rate = decay * (damped * (slope * cos - e * sin)) - d * w * (z - command);
    }
    Box::new(move |t, _, _| {
        let place = ((t - first) / h).clamp(0.0, (strain.len() - 1) as f64);
        let k = place as usize;
        let next = strain.get(k + 1).copied().unwrap_or(strain[k]);
        strain[k] + (next - strain[k]) * (place - k as f64)
    })
}

#[cfg(test)]
mod tests {
    use super::strain;
    use ident::innovations::Track;
    use ident::record::{Column, Record, Start};
    use jit::InProcess;
    use sim::Hold;

    const RIG: &str = "rig Slide { param m: kg = 1; coord q: m; frame rail = ground.translate(q, 0, 0); body block on rail { mass m; }
        input F: N; torque push on q: F; }";

    /// A step of one: u - z is then exp(-d w t) (cos w_d t + d w / w_d sin w_d t).
    #[test]
    fn the_strain_of_a_step_is_that_of_the_textbook() {
        let checked = model_dsl::check_text("slide.rig", RIG);
        let model = InProcess::new(codegen::derive(&checked.rig.unwrap(), codegen::Options::default()).unwrap());
        let t: Vec<f64> = (0..200).map(|k| 0.01 * f64::from(k)).collect();
        let column = |name: &str, values: Vec<f64>| Column { name: name.to_owned(), unit: None, values };
        let force = t.iter().map(|t| f64::from(u8::from(*t > 0.495))).collect();
        let columns = vec![column("q", vec![0.0; 200]), column("F", force)];
        let record = Record { source: "step".to_owned(), t, columns, declared: Vec::new(), start: Start::Free };
        let track = Track::new(&record, &model, &[1.0], Hold::Zero).unwrap();
        let (w, d) = (17.0, 0.2);
        let shape = strain(&model, &[1.0], &track, 0, w, d);
        let damped = w * (1.0_f64 - d * d).sqrt();
        for k in 0..140 {
            let (t, at) = (0.01 * f64::from(k), 0.5 + 0.01 * f64::from(k));
            let expected = (-d * w * t).exp() * ((damped * t).cos() + d * w / damped * (damped * t).sin());
            assert!((shape(at, &[], &[]) - expected).abs() < 2e-3, "{t} s: {} instead of {expected}", shape(at, &[], &[]));
        }
        assert_eq!(shape(0.3, &[], &[]), 0.0);
    }
}
