//! The second road and the power balance, at random states: every rig, every time.
//!
//! Two polynomials in sines, cosines and parameters that agree at several random points to rounding
//! agree everywhere (Schwartz-Zippel); no symbolic simplification is needed.

use super::DeriveError;
use super::parts::Parts;
use crate::equations::{CrossCheck, Layout};
use crate::expr::{Graph, Id, SymbolId, SymbolKind};
use crate::lower::Lowering;
use crate::mechanics::lagrange;
use model_dsl::rig::Rig;

/// Points that are compared.
const POINTS: u64 = 3;
/// Rounding of either road stays far below this; a wrong term does not.
const TOLERANCE: f64 = 1e-9;

/// Compares M and bias of both roads, and the power balance.
pub fn compare(rig: &Rig, lowering: &Lowering, g: &mut Graph, layout: &Layout, parts: &Parts) -> Result<CrossCheck, DeriveError> {
    let (Some(kinetic), Some(potential), Some(_)) = (parts.kinetic, parts.potential, &parts.coriolis) else {
        return Ok(CrossCheck::NotApplicable);
    };
    let n = rig.coordinates.len();
    let second = lagrange::from_kinetic_energy(g, kinetic, lowering);
    let pull = lagrange::from_potential(g, potential, lowering);
    let bias: Vec<Id> = second.coriolis.iter().zip(&pull).map(|(&c, &v)| g.add(c, v)).collect();
    let mut roots: Vec<Id> = Vec::new();
    roots.extend(parts.mass_matrix.iter().flatten());
    roots.extend(second.mass_matrix.iter().flatten());
    roots.extend(&parts.bias);
    roots.extend(&bias);
    // power balance: dE/dt along a motion with accelerations a equals v . (M a + bias)
    let seeds: Vec<(SymbolId, Id)> =
        lowering
            .q
            .iter()
            .copied()
            .zip(lowering.rates().iter().copied())
            .chain(lowering.v.iter().copied().zip(
                (0..n).map(|i| g.symbol(&format!("{}.ddot", rig.coordinates[i].name), SymbolKind::Acceleration(i))).collect::<Vec<_>>(),
            ))
            .collect();
    let energy = g.add(kinetic, potential);
    roots.extend(g.directional(&[energy], &seeds));
    let tape = g.tape(&roots);
    let (mut derivations, mut balance): (f64, f64) = (0.0, 0.0);
    for point in 0..POINTS {
        let values = tape.run(|s| sample(g, layout, s, point));
        let (m1, rest) = values.split_at(n * n);
        let (m2, rest) = rest.split_at(n * n);
        let (b1, rest) = rest.split_at(n);
        let (b2, rest) = rest.split_at(n);
        if values.iter().any(|v| !v.is_finite()) {
            // a state where the rig's own expressions are not defined (a root, a logarithm) says nothing
            continue;
        }
        let size = |v: &[f64]| v.iter().fold(0.0_f64, |m, x| m.max(x.abs())).max(f64::MIN_POSITIVE);
        let name = |i: usize| rig.coordinates[i].name.as_str();
        let scale = size(m1);
        for k in 0..n * n {
            let difference = (m1[k] - m2[k]).abs() / scale;
            if difference > TOLERANCE {
                return Err(DeriveError::RoadsDiffer { quantity: format!("M[{}, {}]", name(k / n), name(k % n)), difference });
            }
            derivations = derivations.max(difference);
        }
        // rates are within one, so that M is the size of the velocity products: they may cancel (isotropic bodies)
        let scale = size(b1).max(scale);
        for k in 0..n {
            let difference = (b1[k] - b2[k]).abs() / scale;
            if difference > TOLERANCE {
                return Err(DeriveError::RoadsDiffer { quantity: format!("the bias of {}", name(k)), difference });
            }
            derivations = derivations.max(difference);
        }
        let (mut power, mut terms) = (0.0, f64::MIN_POSITIVE);
        for i in 0..n {
            let v = sample(g, layout, lowering.v[i], point);
            let mut force = b1[i];
            for j in 0..n {
                force += m1[i * n + j] * sample(g, layout, lowering.a[j], point);
            }
            power += v * force;
            terms += (v * force).abs();
        }
        let difference = (rest[0] - power).abs() / terms;
        if difference > TOLERANCE {
            return Err(DeriveError::EnergyBalance { difference });
        }
        balance = balance.max(difference);
    }
    Ok(CrossCheck::Agree { derivations, energy: balance })
}

/// A repeatable value of every symbol: parameters near their nominal values, the rest within one.
fn sample(g: &Graph, layout: &Layout, symbol: SymbolId, point: u64) -> f64 {
    let r = noise(symbol.index() as u64, point);
    match g.symbol_info(symbol).kind {
        SymbolKind::Parameter(i) => match layout.nominal[i] {
            0.0 => 0.1 * r,
            value => value * (1.0 + 0.3 * r),
        },
        _ => r,
    }
}

/// SplitMix64 to a number in -1..1.
fn noise(a: u64, b: u64) -> f64 {
    let mut z = (a.wrapping_mul(0x9E37_79B9_7F4A_7C15)).wrapping_add(b.wrapping_add(1).wrapping_mul(0xD1B5_4A32_D192_ED03));
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^= z >> 31;
    (z >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}
