//! A regulator on a checked-in model: eq. 26 of the seed paper, from `generated::googol_identified`.
//!
//! `cargo run -p control --example lqr_googol`
//!
//! No rig file and no derivation: trim, linear model and gain see the model through its trait. The numbers are those of
//! `rig lqr googol_identified.rig --trim hover --inputs f_s,f_d --states eps,eps.dot,theta,theta.dot
//! --weights-x 180,10,400,1 --weights-u 1,1`.

use control::{LqrDesign, Plant, Sampling, TrimProblem, Unknown, Weight};
use generated::googol_identified::GoogolIdentified;
use nalgebra::DMatrix;
use runtime::Model;
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let model = GoogolIdentified;
    let d = model.dimensions();
    let mut p = vec![0.0; d.parameters];
    model.nominal(&mut p);

    // theta = 5 deg; the thrusts hold elevation and pitch, yaw drifts
    let mut x = vec![0.0; d.states()];
    x[2] = 5.0_f64.to_radians();
    let unknowns = vec![Unknown::signal("f_1", 0), Unknown::signal("f_2", 1)];
    let trim = control::solve(&model, &p, &TrimProblem { x, u: vec![0.0; d.signals()], unknowns, zero: vec![1, 2] })?;
    println!("f_1 = {:.6} N, f_2 = {:.6} N, psi'' = {:.6} rad/s^2", trim.u[0], trim.u[1], trim.drift[0]);

    // f_s = f_1 + f_2 and f_d = f_1 - f_2: moving one alone moves both thrusts by halves
    let directions = DMatrix::from_row_slice(2, 2, &[0.5, 0.5, 0.5, -0.5]);
    let linear = control::linearize(&model, &p, &trim.x, &directions, |dx, a, b| model.linearize(0.0, &trim.x, &trim.u, &p, dx, a, b))?;
    let plant = Plant::new(&model, &linear, &["f_s".to_owned(), "f_d".to_owned()]);
    let design = LqrDesign {
        states: ["eps", "eps.dot", "theta", "theta.dot"].map(str::to_owned).to_vec(),
        integrate: Vec::new(),
        weight_x: Weight::Diagonal(vec![180.0, 10.0, 400.0, 1.0]),
        weight_u: Weight::Diagonal(vec![1.0, 1.0]),
        sampling: Sampling::Continuous,
    };
    let lqr = control::lqr(&plant, &design)?;
    println!("K = {:.4}poles {:?}", lqr.k, lqr.poles.iter().map(|z| format!("{:.4} {:+.4}i", z.re, z.im)).collect::<Vec<_>>());
    Ok(())
}
