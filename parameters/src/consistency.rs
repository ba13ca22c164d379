//! Whether masses, centres and inertias can belong to a body of positive mass density.
//!
//! They can if and only if the pseudo-inertia [[S, m c], [m c', m]] with S = tr(I)/2 1 - I, I about the same origin, has
//! no negative eigenvalue (Wensing, Kim, Slotine, Linear matrix inequalities for physically consistent inertial
//! parameter identification, RA-L 3(1), 2018).

use codegen::{Lumps, Numbers};
use model_dsl::rig::{InertiaPoint, Rig};
use nalgebra::{Matrix3, Matrix4, Vector3};

/// Rounding, relative to the largest entry: point masses and thin rods have eigenvalues of zero.
const ROUNDING: f64 = 1e-9;

/// Mass, centre and tensor about the frame's origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inertia {
    /// Mass [kg].
    pub mass: f64,
    /// Centre of mass [m].
    pub center: Vector3<f64>,
    /// Tensor about the origin [kg m^2].
    pub about_origin: Matrix3<f64>,
}

impl Inertia {
    /// Tensor about the centre of mass [kg m^2].
    #[must_use]
    pub fn central(&self) -> Matrix3<f64> {
        let c = self.center;
        self.about_origin - self.mass * (Matrix3::identity() * c.norm_squared() - c * c.transpose())
    }
}

/// What was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Verdict {
    /// A body can have these numbers.
    Possible,
    /// The mass is negative.
    NegativeMass,
    /// A moment of inertia about the centre of mass is negative: the one about the origin is smaller than m r^2.
    NegativeMoment {
        /// The least central moment [kg m^2].
        least: f64,
    },
    /// A central moment is larger than the sum of the two others.
    Triangle {
        /// How much is missing [kg m^2].
        missing: f64,
    },
}

/// A body and its verdict.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// The body.
    pub body: String,
    /// Its numbers.
    pub inertia: Inertia,
    /// Eigenvalues of the pseudo-inertia relative to the largest: the least one.
    pub least_eigenvalue: f64,
    /// Verdict.
    pub verdict: Verdict,
}

/// All bodies of a rig, at the parameters' present values and q = 0.
#[must_use]
pub fn bodies(rig: &Rig, lumps: Lumps) -> Vec<Finding> {
    let mut numbers = Numbers::new(rig, lumps);
    rig.bodies
        .iter()
        .map(|b| {
            let mass = numbers.value(&b.mass, &[]);
            let center = Vector3::from_fn(|k, _| numbers.value(&b.center[k], &[]));
            let [xx, yy, zz, xy, xz, yz] = std::array::from_fn(|k| numbers.value(&b.inertia[k], &[]));
            let stated = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
            let about_origin = match b.about {
                InertiaPoint::FrameOrigin => stated,
                InertiaPoint::CenterOfMass => stated + mass * (Matrix3::identity() * center.norm_squared() - center * center.transpose()),
            };
            let inertia = Inertia { mass, center, about_origin };
            let (verdict, least_eigenvalue) = verdict(&inertia);
            Finding { body: b.name.clone(), inertia, least_eigenvalue, verdict }
        })
        .collect()
}

/// The verdict, and the least eigenvalue of the pseudo-inertia relative to its largest.
#[must_use]
pub fn verdict(inertia: &Inertia) -> (Verdict, f64) {
    let i = inertia.about_origin;
    let s = Matrix3::identity() * (i.trace() / 2.0) - i;
    let mc = inertia.center * inertia.mass;
    // lengths in units of the body's own size: kg and kg m^2 stand in one matrix
    let size = (i.norm() / inertia.mass.abs()).sqrt().max(inertia.center.norm());
    let size = if size.is_finite() && size > 0.0 { size } else { 1.0 };
    let mut pseudo = Matrix4::zeros();
    pseudo.fixed_view_mut::<3, 3>(0, 0).copy_from(&(s / (size * size)));
    pseudo.fixed_view_mut::<3, 1>(0, 3).copy_from(&(mc / size));
    pseudo.fixed_view_mut::<1, 3>(3, 0).copy_from(&(mc / size).transpose());
    pseudo[(3, 3)] = inertia.mass;
    let values = pseudo.symmetric_eigenvalues();
    let largest = values.amax().max(f64::MIN_POSITIVE);
    let least = values.min() / largest;
    if least > -ROUNDING {
        return (Verdict::Possible, least);
    }
    if inertia.mass < 0.0 {
        return (Verdict::NegativeMass, least);
    }
    let moments = inertia.central().symmetric_eigenvalues();
    let reference = i.norm().max(f64::MIN_POSITIVE);
    if moments.min() < -ROUNDING * reference {
        return (Verdict::NegativeMoment { least: moments.min() }, least);
    }
    (Verdict::Triangle { missing: 2.0 * moments.max() - moments.sum() }, least)
}
