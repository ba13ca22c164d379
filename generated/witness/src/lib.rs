//! Proof that the checked-in models need no standard library: a static library for bare metal.
//!
//! `std` brings a panic handler; this crate has its own. Were `std` anywhere in the dependency graph,
//! there would be two, and the compiler would refuse. All models are reached through [`witness_rhs`], so
//! none is left out of the build.
#![no_std]

use runtime::Model as _;

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    loop {}
}

/// Largest rate of change over all models at their nominal parameters, at a state that is all `angle`.
#[unsafe(no_mangle)]
pub extern "C" fn witness_rhs(angle: f64) -> f64 {
    let (mut x, mut u, mut p, mut dx) = ([angle; 64], [0.0; 64], [0.0; 256], [0.0; 64]);
    let mut largest = 0.0_f64;
    for (_, model) in generated::MODELS {
        let sizes = model.dimensions();
        let (n, m, np) = (sizes.states(), sizes.signals(), sizes.parameters);
        let (Some(x), Some(u), Some(p), Some(dx)) = (x.get_mut(..n), u.get_mut(..m), p.get_mut(..np), dx.get_mut(..n)) else { continue };
        model.nominal(p);
        if model.rhs(0.0, x, u, p, dx).is_ok() {
            largest = dx.iter().fold(largest, |a, b| a.max(runtime::math::abs(*b)));
        }
    }
    largest
}
