//! Rates and accelerations from encoder angles (section 2.2 of the seed paper): observer, filter of eq. 23 and
//! differencing side by side, on simulated encoders of 2400 and 4800 counts where the truth is known.

use control::{AngleObserver, DerivativeFilter, Rule, Running, differences, moving_mean};
use nalgebra::Complex;
use std::f64::consts::TAU;

const PERIOD: f64 = 0.005;

/// A decaying swing as of the pitch in the open-loop record: angle, rate, acceleration.
fn motion(t: f64) -> (f64, f64, f64) {
    let (size, decay, w) = (0.3, 0.17, 5.05);
    let (s, c) = (w * t).sin_cos();
    let e = size * (-decay * t).exp();
    (e * s, e * (w * c - decay * s), e * ((decay * decay - w * w) * s - 2.0 * decay * w * c))
}

fn rms(estimate: &[f64], truth: &[f64]) -> f64 {
    // the first half second is the estimators' own start
    let skip = 100;
    let n = (truth.len() - skip) as f64;
    (estimate.iter().zip(truth).skip(skip).map(|(e, t)| (e - t).powi(2)).sum::<f64>() / n).sqrt()
}

#[test]
fn observer_filter_and_differencing_side_by_side() {
    let triple = [Complex::new(-60.0, 0.0), Complex::new(-36.0, 48.0), Complex::new(-36.0, -48.0)];
    println!("rms errors               rate [rad/s]                          acceleration [rad/s^2]");
    println!("counts      observer  eq. 23  difference  mean of 10      observer  difference of eq. 23  of the mean");
    let mut last = None;
    for counts in [2400.0, 4800.0] {
        let quantum = TAU / counts;
        let times: Vec<f64> = (0..4000).map(|k| PERIOD * f64::from(k)).collect();
        let angles: Vec<f64> = times.iter().map(|&t| (motion(t).0 / quantum).round() * quantum).collect();
        let rates: Vec<f64> = times.iter().map(|&t| motion(t).1).collect();
        let accelerations: Vec<f64> = times.iter().map(|&t| motion(t).2).collect();
        let through = |mut f: Running| -> Vec<f64> { angles.iter().map(|&y| f.next(y)).collect() };
        let observer = AngleObserver::new(&triple);
        let observed = |order| through(Running::new(observer.sampled(order, PERIOD).unwrap_or_else(|e| panic!("{e}"))));
        let filter = DerivativeFilter { omega: 100.0, damping: 0.9 }.sampled(PERIOD, Rule::Tustin).unwrap_or_else(|e| panic!("{e}"));
        let filtered = through(Running::new(filter));
        let differenced = differences(&angles, PERIOD);
        let smoothed = moving_mean(&differenced, 10);
        let rate = [&observed(1), &filtered, &differenced, &smoothed].map(|e| rms(e, &rates));
        let acceleration = [&observed(2), &differences(&filtered, PERIOD), &differences(&smoothed, PERIOD)].map(|e| rms(e, &accelerations));
        println!(
            "{counts:<11} {:<9.4} {:<7.4} {:<11.4} {:<15.4} {:<9.2} {:<21.2} {:.2}",
            rate[0], rate[1], rate[2], rate[3], acceleration[0], acceleration[1], acceleration[2]
        );
        // a difference of two counts carries the whole quantum: q / (T sqrt 6) rms if both roundings are independent
        assert!((rate[2] / (quantum / PERIOD / 6.0_f64.sqrt()) - 1.0).abs() < 0.35, "{rate:?}");
        // half a quantum over the filter's time is far less, and the observer beats differencing in acceleration
        assert!(rate[0] < rate[2] && acceleration[0] < acceleration[1] && acceleration[0] < acceleration[2], "{rate:?} {acceleration:?}");
        if let Some(coarse) = last {
            assert!(rate[2] < 0.7 * coarse, "finer counts halve what quantization does to a difference");
        }
        last = Some(rate[2]);
    }
}
