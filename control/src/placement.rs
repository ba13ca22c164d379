//! Pole placement: one input by shifting eigenvalues along the Schur form (after Varga 1981), several inputs by
//! well-conditioned eigenvectors (method 0 of Kautsky, Nichols and Van Dooren 1985). Knows matrices only.

use crate::modes::show;
use crate::reach::{pbh, rounding};
use crate::schur::{NoConvergence, Schur, eigenvalues};
use nalgebra::{Complex, DMatrix, DVector};
use std::fmt;

type C = Complex<f64>;

/// A placed gain.
#[derive(Clone, Debug, PartialEq)]
pub struct Placed {
    /// K (m x n): A - B K has the poles.
    pub gain: DMatrix<f64>,
    /// The poles that A - B K has in double precision.
    pub poles: Vec<Complex<f64>>,
}

/// Why poles cannot be placed.
#[derive(Clone, Debug, PartialEq)]
pub enum PlacementError {
    /// Not one pole for each state.
    Count {
        /// Poles.
        poles: usize,
        /// States.
        states: usize,
    },
    /// A complex pole without its conjugate.
    NoConjugate(Complex<f64>),
    /// With several inputs a pole can be repeated as often as there are inputs.
    Repeated {
        /// The pole.
        pole: Complex<f64>,
        /// How often it was asked for.
        times: usize,
        /// How often it can be placed.
        inputs: usize,
    },
    /// A mode out of reach stays where it is, and was not asked for.
    Unreachable(Complex<f64>),
    /// The closed loop's poles miss those asked for.
    Inaccurate {
        /// Largest distance, relative to the largest pole.
        distance: f64,
    },
    /// A value is not finite.
    NoConvergence(NoConvergence),
}

impl fmt::Display for PlacementError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Count { poles, states } => write!(f, "poles asked for: {poles}, states: {states}; one is needed for each"),
            Self::NoConjugate(z) => write!(f, "the pole {} needs its conjugate beside it", show(*z)),
            Self::Repeated { pole, times, inputs } => write!(
                f,
                "the pole {} is asked for {times} times; with {inputs} of them a pole can be placed {inputs} times at most",
                show(*pole)
            ),
            Self::Unreachable(z) => {
                write!(f, "the mode at {} is out of reach and stays there: ask for a pole there, or leave its states out", show(*z))
            }
            Self::Inaccurate { distance } => write!(
                f,
                "the poles come out {:.1e} (relative) from those asked for: the problem is too badly conditioned, move them apart or nearer to the open loop's",
                distance
            ),
            Self::NoConvergence(e) => e.fmt(f),
        }
    }
}

impl std::error::Error for PlacementError {}

/// Distance of a pole from the one asked for, relative to the largest, above which a placement is refused. Repeated
/// poles of one input move by the n-th root of rounding: 1e-4 for four of them.
const NEAR: f64 = 1e-2;
const SWEEPS: usize = 12;

/// K with the eigenvalues of A - B K (A n x n, B n x m) at `poles` (n of them, closed under conjugation).
///
/// # Errors
/// [`PlacementError`], one variant a cause.
pub fn place(a: &DMatrix<f64>, b: &DMatrix<f64>, poles: &[Complex<f64>]) -> Result<Placed, PlacementError> {
    let (n, m) = b.shape();
    if poles.len() != n {
        return Err(PlacementError::Count { poles: poles.len(), states: n });
    }
    if a.iter().chain(b.iter()).any(|x| !x.is_finite()) || poles.iter().any(|z| !(z.re.is_finite() && z.im.is_finite())) {
        return Err(PlacementError::NoConvergence(NoConvergence));
    }
    let ordered = pairs(poles)?;
    let gain = if m == 1 || n == 1 { by_shifts(a, b, &ordered)? } else { by_eigenvectors(a, b, &ordered)? };
    let closed = eigenvalues(&(a - b * &gain)).map_err(PlacementError::NoConvergence)?;
    let size = poles.iter().fold(f64::MIN_POSITIVE, |s, z| s.max(z.norm()));
    let mut left = closed.clone();
    let mut worst = 0.0_f64;
    for z in &ordered {
        let near = left.iter().enumerate().map(|(i, w)| (i, (w - z).norm())).min_by(|p, q| p.1.total_cmp(&q.1));
        if let Some((i, distance)) = near {
            left.remove(i);
            worst = worst.max(distance / size);
        }
    }
    if worst > NEAR { Err(PlacementError::Inaccurate { distance: worst }) } else { Ok(Placed { gain, poles: closed }) }
}

/// Observer gain L (n x p) with the eigenvalues of A - L C at `poles`: placement for the transposed system.
///
/// # Errors
/// [`PlacementError`], read with outputs for inputs.
pub fn place_observer(a: &DMatrix<f64>, c: &DMatrix<f64>, poles: &[Complex<f64>]) -> Result<Placed, PlacementError> {
    place(&a.transpose(), &c.transpose(), poles).map(|p| Placed { gain: p.gain.transpose(), poles: p.poles })
}

/// Poles with each pair side by side, the one above the axis first.
fn pairs(poles: &[C]) -> Result<Vec<C>, PlacementError> {
    let mut left = poles.to_vec();
    let mut ordered = Vec::with_capacity(left.len());
    while let Some(z) = left.pop() {
        if z.im == 0.0 {
            ordered.push(z);
            continue;
        }
        let i = left.iter().position(|w| (w - z.conj()).norm() <= 1e-9 * z.norm()).ok_or(PlacementError::NoConjugate(z))?;
        left.remove(i);
        let upper = if z.im > 0.0 { z } else { z.conj() };
        ordered.extend([upper, upper.conj()]);
    }
    Ok(ordered)
}

/// One input: the last eigenvalue of the Schur form is moved by feeding back its coordinate, then goes to the front.
fn by_shifts(a: &DMatrix<f64>, b: &DMatrix<f64>, poles: &[C]) -> Result<DMatrix<f64>, PlacementError> {
    let n = a.nrows();
    let mut schur = Schur::new(a).map_err(PlacementError::NoConvergence)?;
    let b = b.map(|x| C::new(x, 0.0));
    let mut gain = DMatrix::<C>::zeros(b.ncols(), n);
    let mut left = poles.to_vec();
    for done in 0..n {
        let last = n - 1;
        let (here, basis) = (schur.t[(last, last)], schur.u.column(last).into_owned());
        let push = b.adjoint() * &basis;
        let nearest = left.iter().enumerate().min_by(|p, q| (p.1 - here).norm().total_cmp(&(q.1 - here).norm())).map(|(i, _)| i);
        let Some(nearest) = nearest else { break };
        let target = left.remove(nearest);
        if push.norm() <= rounding(n) * b.norm() {
            if (target - here).norm() > 1e-6 * here.norm().max(target.norm()) {
                return Err(PlacementError::Unreachable(here));
            }
        } else {
            // u = -f (e^H x): the least feedback that moves this eigenvalue to its target
            let f = &push * ((here - target) / push.norm_squared());
            gain += &f * basis.adjoint();
            let moved = schur.u.adjoint() * &b * &f;
            for i in 0..n {
                schur.t[(i, last)] -= moved[i];
            }
        }
        for k in (done..last).rev() {
            schur.swap(k);
        }
    }
    Ok(gain.map(|z| z.re))
}

/// Several inputs: eigenvectors from what each pole allows, each as orthogonal to the others as can be.
fn by_eigenvectors(a: &DMatrix<f64>, b: &DMatrix<f64>, poles: &[C]) -> Result<DMatrix<f64>, PlacementError> {
    let (n, m) = b.shape();
    let rank = b.clone().svd(false, false).rank(rounding(n) * b.norm());
    for z in poles {
        let times = poles.iter().filter(|w| (*w - z).norm() <= 1e-9 * z.norm()).count();
        if times > rank {
            return Err(PlacementError::Repeated { pole: *z, times, inputs: rank });
        }
    }
    for z in eigenvalues(a).map_err(PlacementError::NoConvergence)? {
        if pbh(a, b, z).distance <= rounding(n) && !poles.iter().any(|w| (w - z).norm() <= 1e-6 * z.norm().max(w.norm())) {
            return Err(PlacementError::Unreachable(z));
        }
    }
    let allowed: Vec<DMatrix<C>> = poles.iter().map(|&z| allowed(a, b, z)).collect();
    let mut x = DMatrix::<C>::zeros(n, n);
    for (i, basis) in allowed.iter().enumerate() {
        x.set_column(i, &basis.column(i % m));
    }
    mirror(&mut x, poles);
    for _ in 0..SWEEPS {
        for i in 0..n {
            if poles[i].im < 0.0 {
                continue;
            }
            let mut others = x.clone();
            others.column_mut(i).fill(C::new(0.0, 0.0));
            let svd = others.svd(true, false);
            let Some(u) = svd.u else { continue };
            let apart = u.column(svd.singular_values.argmin().0).into_owned();
            let projected: DVector<C> = &allowed[i] * (allowed[i].adjoint() * apart);
            if projected.norm() > 1e-8 {
                x.set_column(i, &(&projected / C::new(projected.norm(), 0.0)));
                mirror(&mut x, poles);
            }
        }
    }
    let diagonal = DMatrix::from_diagonal(&DVector::from_column_slice(poles));
    let inverse = x.clone().try_inverse().ok_or(PlacementError::Inaccurate { distance: f64::INFINITY })?;
    let closed = (x * diagonal * inverse).map(|z| z.re);
    b.clone()
        .pseudo_inverse(rounding(n) * b.norm())
        .map(|inverse| inverse * (a - closed))
        .map_err(|_| PlacementError::Inaccurate { distance: f64::INFINITY })
}

/// The eigenvector of a conjugate pole is the conjugate eigenvector.
fn mirror(x: &mut DMatrix<C>, poles: &[C]) {
    for (i, z) in poles.iter().enumerate().skip(1) {
        if z.im < 0.0 {
            let conjugate = x.column(i - 1).map(|z| z.conj());
            x.set_column(i, &conjugate);
        }
    }
}

/// Orthonormal basis (n x m) of the vectors x with (A - z I) x in the range of B: the m directions in which
/// (A - z I) x leaves the least outside of it.
fn allowed(a: &DMatrix<f64>, b: &DMatrix<f64>, z: C) -> DMatrix<C> {
    let (n, m) = b.shape();
    let range = b.clone().svd(true, false);
    let floor = rounding(n) * b.norm();
    let mut outside = DMatrix::<f64>::identity(n, n);
    if let Some(u) = &range.u {
        for (k, &s) in range.singular_values.iter().enumerate() {
            if s > floor {
                outside -= u.column(k) * u.column(k).transpose();
            }
        }
    }
    let pencil = a.map(|x| C::new(x, 0.0)) - DMatrix::from_diagonal_element(n, n, z);
    let svd = (outside.map(|x| C::new(x, 0.0)) * pencil).svd(false, true);
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|&i, &j| svd.singular_values[i].total_cmp(&svd.singular_values[j]));
    match svd.v_t {
        Some(v_t) => DMatrix::from_fn(n, m.min(n), |i, j| v_t[(order[j], i)].conj()),
        None => DMatrix::identity(n, m.min(n)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::Random;
    use nalgebra::dmatrix;

    fn real(list: &[f64]) -> Vec<C> {
        list.iter().map(|&x| C::new(x, 0.0)).collect()
    }

    #[test]
    fn one_input_has_the_gain_of_the_characteristic_polynomial() {
        let (a, b) = (dmatrix![0.0, 1.0, 0.0; 0.0, 0.0, 1.0; -1.0, 2.0, 3.0], dmatrix![0.0; 0.0; 1.0]);
        // (s + 2)^3 = s^3 + 6 s^2 + 12 s + 8
        let k = place(&a, &b, &real(&[-2.0, -2.0, -2.0])).unwrap().gain;
        assert!((k - dmatrix![7.0, 14.0, 9.0]).norm() < 1e-12);
    }

    #[test]
    fn random_systems_get_their_poles() {
        let mut r = Random::new(11);
        for (n, m) in [(2, 1), (5, 1), (4, 2), (6, 3), (7, 2), (3, 3)] {
            let a = DMatrix::from_fn(n, n, |_, _| r.within(-1.0, 1.0));
            let b = DMatrix::from_fn(n, m, |_, _| r.within(-1.0, 1.0));
            let mut poles = real(&(0..n % 2).map(|_| r.within(-3.0, -1.0)).collect::<Vec<_>>());
            for _ in 0..n / 2 {
                let z = C::new(r.within(-3.0, -1.0), r.within(0.2, 2.0));
                poles.extend([z, z.conj()]);
            }
            let placed = place(&a, &b, &poles).unwrap();
            for z in &poles {
                let near = placed.poles.iter().map(|w| (w - z).norm()).fold(f64::INFINITY, f64::min);
                assert!(near < 1e-8, "{n} {m}: {near}");
            }
        }
    }

    #[test]
    fn an_observer_for_two_encoders() {
        let a = dmatrix![0.0, 1.0, 0.0, 0.0; -2.0, -0.1, 0.5, 0.0; 0.0, 0.0, 0.0, 1.0; 0.3, 0.0, -5.0, -0.2];
        let c = dmatrix![1.0, 0.0, 0.0, 0.0; 0.0, 0.0, 1.0, 0.0];
        let placed = place_observer(&a, &c, &real(&[-10.0, -10.0, -12.0, -12.0])).unwrap();
        let error = placed.poles.iter().map(|z| (z.re + 11.0).abs() - 1.0).fold(0.0_f64, |m, e| m.max(e.abs()));
        assert!(error < 1e-9, "{:?}", placed.poles);
        // two outputs: well-conditioned eigenvectors keep the gain at the size that the poles ask for
        assert!(placed.gain.norm() < 400.0, "{}", placed.gain);
    }

    #[test]
    fn what_cannot_be_placed_is_said() {
        let (a, b) = (dmatrix![1.0, 0.0; 0.0, -2.0], dmatrix![1.0; 0.0]);
        let say = |a: &DMatrix<f64>, b: &DMatrix<f64>, poles: &[C]| place(a, b, poles).unwrap_err().to_string();
        assert_eq!(
            say(&a, &b, &real(&[-1.0, -3.0])),
            "the mode at -2 is out of reach and stays there: ask for a pole there, or leave its states out"
        );
        assert!(place(&a, &b, &real(&[-1.0, -2.0])).is_ok());
        assert_eq!(say(&a, &b, &real(&[-1.0])), "poles asked for: 1, states: 2; one is needed for each");
        assert_eq!(say(&a, &b, &[C::new(-1.0, 1.0), C::new(-2.0, 0.0)]), "the pole -1 + 1i needs its conjugate beside it");
        let (a, b) = (DMatrix::zeros(3, 3), dmatrix![1.0, 0.0; 0.0, 1.0; 1.0, 1.0]);
        assert!(say(&a, &b, &real(&[-1.0, -1.0, -1.0])).contains("is asked for 3 times"));
    }
}
