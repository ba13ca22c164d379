//! The truth beside what must be so in any mechanics: energy, and records that come out the same twice.

use battery::rigs::Rig;
use battery::truth::MOST;
use battery::truth::experiment::{Excitation, Experiment, Pushes};
use battery::truth::motion::Motion;
use battery::truth::plant::Plant;

/// Power of all forces into M(q), by v^T (M a - f) and d/dt (v^T M v / 2): without friction and commands, energy changes only by what
/// the forces do, so kinetic energy must follow from the forces' own work, if M and the terms by rates belong together.
#[test]
fn kinetic_energy_is_the_work_of_the_position_forces() {
    for rig in [Rig::Pendulum, Rig::CartPole, Rig::Furuta, Rig::DoublePendulum] {
        let bench = rig.bench(3);
        let plant = Plant::new(bench.plant.mechanics.clone());
        let n = plant.mechanics.coordinates();
        let mut motion = Motion::new(&plant, [0.4, -0.7, 0.0]);
        motion.state.v = [1.1, -2.3, 0.0];
        let none = [0.0; MOST];
        let kinetic = |motion: &Motion| {
            let (m, _) = plant.forces(&motion.state.q, &motion.state.v, &none);
            let v = motion.state.v;
            (0..n).map(|i| (0..n).map(|j| 0.5 * v[i] * m[i][j] * v[j]).sum::<f64>()).sum::<f64>()
        };
        let before = kinetic(&motion);
        let h = 1e-5;
        let (mut work, mut most) = (0.0, 0.0_f64);
        for _ in 0..60_000 {
            let power = |motion: &Motion| {
                // forces of position only: at rest
                let (_, f) = plant.forces(&motion.state.q, &none, &none);
                (0..n).map(|i| f[i] * motion.state.v[i]).sum::<f64>()
            };
            let first = power(&motion);
            motion.advance(h, &none, &none);
            work += 0.5 * h * (first + power(&motion));
            most = most.max(work.abs());
        }
        let gained = kinetic(&motion) - before;
        assert!((gained - work).abs() < 1e-6 * (most + before), "{}: gained {gained}, work {work}", rig.name());
    }
}

#[test]
fn an_experiment_comes_out_the_same_twice_and_reads_whole_counts() {
    let bench = Rig::CartPole.bench(5);
    let experiment = Experiment {
        plant: &bench.plant,
        start: bench.start,
        period: bench.period,
        samples: 300,
        command: bench.command,
        band: bench.band,
        excitation: Excitation::Steps,
        pushes: (Pushes::Exponential, [0.02, 0.01, 0.0]),
        loop_: Some(bench.regulator),
    };
    let (a, b) = (experiment.run(9), experiment.run(9));
    assert_eq!(a.y, b.y);
    assert_ne!(a.y, experiment.run(10).y);
    let quantum = bench.plant.sensors[0].quantum;
    assert!(a.y[0].iter().all(|y| (y / quantum - (y / quantum).round()).abs() < 1e-6));
    assert!(a.t.windows(2).all(|w| w[1] > w[0]));
}
