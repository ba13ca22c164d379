//! Equal questions get equal bits, however two threads share the work.

use codegen::{Options, derive};
use cross_checks::{rig_of, root};
use ident::fit::ParameterSpec;
use ident::innovations::{EstimateOptions, Noise, Track, estimate};
use ident::record::read;
use jit::InProcess;
use sim::Hold;

#[test]
fn two_records_followed_side_by_side() {
    let rig = rig_of(&root().join("examples/hidden/d_double_pendulum.rig"));
    let records = ["d_double_pendulum_1.csv", "d_double_pendulum_2.csv"].map(|n| read(&root().join("examples/hidden").join(n)).unwrap());
    let specs = ParameterSpec::of_rig(&rig);
    let p: Vec<f64> = specs.iter().map(|s| s.value).collect();
    let fit = || {
        // a new model each time: when code takes over from the interpreter must not show
        let model = InProcess::at_work(derive(&rig, Options::default()).unwrap());
        let mut tracks = records.iter().map(|r| Track::new(r, &model, &p, Hold::Zero).unwrap()).collect::<Vec<_>>();
        let noise = Noise::guess(&model, &p, &tracks, Vec::new());
        let effort = EstimateOptions { rounds: 0, evaluations: 2, ..EstimateOptions::default() };
        let found = estimate(&model, &specs, &mut tracks, &[p.clone(), p.clone()], noise, effort).unwrap();
        found.p.iter().flatten().chain(found.covariance.iter()).map(|v| v.to_bits()).collect::<Vec<u64>>()
    };
    let first = fit();
    for again in 1..6 {
        assert!(fit() == first, "run {again} differs from the first");
    }
}
