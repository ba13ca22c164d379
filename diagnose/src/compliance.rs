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
