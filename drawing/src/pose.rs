//! Where a rig's frames, bodies, joints and forces are in space at given coordinates.

use codegen::{Lumps, Numbers};
use model_dsl::rig::{Along, Axis, Expr, ForceKind, FrameRef, InertiaPoint, Rig, Step};
use nalgebra::{Isometry3, Matrix3, Point3, Translation3, Unit, UnitQuaternion, Vector3};

/// A joint: where a coordinate moves something.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// Names of the coordinates.
    pub name: String,
    /// Place [m].
    pub at: Point3<f64>,
    /// Axis of turning, or direction of sliding (ground's axes).
    pub axis: Vector3<f64>,
    /// It slides.
    pub slides: bool,
}

/// A body.
#[derive(Clone, Debug, PartialEq)]
pub struct Mass {
    /// Name.
    pub name: String,
    /// Mass [kg].
    pub mass: f64,
    /// Centre of mass [m].
    pub at: Point3<f64>,
    /// Origin of its frame [m].
    pub origin: Point3<f64>,
    /// Half lengths of uniform rods of its moments of inertia, as vectors along its principal axes [m].
    pub extents: Vec<Vector3<f64>>,
}

/// A force where it acts, with its inputs at one.
#[derive(Clone, Debug, PartialEq)]
pub struct Arrow {
    /// Name.
    pub name: String,
    /// Point of application [m].
    pub at: Point3<f64>,
    /// Direction, of length one (ground's axes).
    pub direction: Vector3<f64>,
}

/// Everything that is drawn, in ground's axes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pose {
    /// Rigid links: from, to [m].
    pub links: Vec<(Point3<f64>, Point3<f64>)>,
    /// Joints.
    pub joints: Vec<Joint>,
    /// Bodies.
    pub masses: Vec<Mass>,
    /// Forces at points.
    pub forces: Vec<Arrow>,
    /// Springs and dampers between two points [m].
    pub springs: Vec<(Point3<f64>, Point3<f64>)>,
    /// Coordinates in words: `psi = 0.3 rad`.
    pub coordinates: Vec<String>,
}

/// Coordinates at which a rig shows its joints: a third of the way to the upper end of each range; without a range an
/// angle of 0.4 rad, a path of 0.1 m.
#[must_use]
pub fn sample(rig: &Rig) -> Vec<f64> {
    rig.coordinates
        .iter()
        .map(|c| {
            let usual = if c.unit.text == "m" { 0.1 } else { 0.4 };
            c.range.map_or(usual, |(lo, hi)| (lo + (hi - lo) * 2.0 / 3.0).clamp(-usual, usual))
        })
        .collect()
}

/// A rig at coordinates `q` [rad, m].
#[must_use]
pub fn pose(rig: &Rig, lumps: Lumps, q: &[f64]) -> Pose {
    let mut n = Numbers::new(rig, lumps);
    let mut pose = Pose::default();
    let mut frames: Vec<Isometry3<f64>> = Vec::new();
    for frame in &rig.frames {
        let mut at = of(&frames, frame.parent);
        for step in &frame.steps {
            at = stepped(rig, &mut n, q, step, at, &mut pose);
        }
        frames.push(at);
    }
    for body in &rig.bodies {
        let at = of(&frames, body.frame);
        let mass = n.value(&body.mass, q);
        let center = vector(&mut n, &body.center, q);
        let [xx, yy, zz, xy, xz, yz] = std::array::from_fn(|k| n.value(&body.inertia[k], q));
        let mut inertia = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
        if let InertiaPoint::FrameOrigin = body.about {
            inertia -= mass * (Matrix3::identity() * center.norm_squared() - center * center.transpose());
        }
        let extents = extents(inertia, mass).into_iter().map(|e| at.rotation * e).collect();
        let origin = Point3::from(at.translation.vector);
        pose.masses.push(Mass { name: body.name.clone(), mass, at: at * Point3::from(center), origin, extents });
    }
    n.signals = 1.0;
    for force in &rig.forces {
        if let ForceKind::Force { frame, point, vector: components, axes, .. } = &force.kind {
            let place = of(&frames, *frame) * Point3::from(vector(&mut n, point, q));
            let direction = of(&frames, *axes).rotation * vector(&mut n, components, q);
            if let Some(direction) = direction.try_normalize(0.0) {
                pose.forces.push(Arrow { name: force.name.clone(), at: place, direction });
            }
        }
    }
    n.signals = 0.0;
    let between = rig.springs.iter().map(|s| &s.along).chain(rig.dampers.iter().map(|d| &d.along));
    for along in between {
        if let Along::Points { from, to } = along {
            let mut point = |(frame, p): &(FrameRef, [Expr; 3])| of(&frames, *frame) * Point3::from(vector(&mut n, p, q));
            let ends = (point(from), point(to));
            pose.springs.push(ends);
        }
    }
    pose.coordinates = rig.coordinates.iter().zip(q).map(|(c, x)| format!("{} = {} {}", c.name, short(*x), c.unit.text)).collect();
    pose
}

/// Three digits.
fn short(x: f64) -> String {
    let text = format!("{x:.3}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

fn of(frames: &[Isometry3<f64>], frame: FrameRef) -> Isometry3<f64> {
    match frame {
        FrameRef::Ground => Isometry3::identity(),
        FrameRef::Frame(i) => frames.get(i).copied().unwrap_or_else(Isometry3::identity),
    }
}

fn vector(n: &mut Numbers, e: &[Expr; 3], q: &[f64]) -> Vector3<f64> {
    Vector3::from_fn(|k, _| n.value(&e[k], q))
}

/// Goes one step along a frame's chain, and notes links and joints.
fn stepped(rig: &Rig, n: &mut Numbers, q: &[f64], step: &Step, at: Isometry3<f64>, pose: &mut Pose) -> Isometry3<f64> {
    let origin = Point3::from(at.translation.vector);
    let names = |moves: &dyn Fn(usize) -> bool| {
        let all: Vec<&str> = rig.coordinates.iter().enumerate().filter(|(i, _)| moves(*i)).map(|(_, c)| c.name.as_str()).collect();
        (!all.is_empty()).then(|| all.join(", "))
    };
    match step {
        Step::Rotate { axis, angle } => {
            let axis = axis_vector(*axis);
            let slopes: Vec<f64> = (0..rig.coordinates.len()).map(|i| n.slope(angle, i, q)).collect();
            if let Some(name) = names(&|i| slopes[i].abs() > 1e-12) {
                pose.joints.push(Joint { name, at: origin, axis: at.rotation * axis, slides: false });
            }
            at * UnitQuaternion::from_axis_angle(&Unit::new_normalize(axis), n.value(angle, q))
        }
        Step::Translate(offset) => {
            let slope = |n: &mut Numbers, i: usize| Vector3::from_fn(|k, _| n.slope(&offset[k], i, q));
            let slopes: Vec<Vector3<f64>> = (0..rig.coordinates.len()).map(|i| slope(n, i)).collect();
            let next = at * Translation3::from(vector(n, offset, q));
            let end = Point3::from(next.translation.vector);
            if let Some(name) = names(&|i| slopes[i].norm() > 1e-12) {
                let along: Vector3<f64> = slopes.iter().sum();
                pose.joints.push(Joint { name, at: end, axis: at.rotation * along.normalize(), slides: true });
            }
            if (end - origin).norm() > 0.0 {
                pose.links.push((origin, end));
            }
            next
        }
    }
}

fn axis_vector(axis: Axis) -> Vector3<f64> {
    match axis {
        Axis::Principal { index, negative } => {
            let mut v = Vector3::zeros();
            v[index.min(2)] = if negative { -1.0 } else { 1.0 };
            v
        }
        Axis::Vector(v) => Vector3::from(v),
    }
}

/// Rods of the body's second moments: half length sqrt(3 s/m) where s is the moment of mass along the axis.
fn extents(inertia: Matrix3<f64>, mass: f64) -> Vec<Vector3<f64>> {
    if mass <= 0.0 || inertia.iter().all(|x| *x == 0.0) {
        return Vec::new();
    }
    let second = Matrix3::identity() * (inertia.trace() / 2.0) - inertia;
    let eigen = second.symmetric_eigen();
    (0..3)
        .filter(|&k| eigen.eigenvalues[k] > 1e-9 * inertia.norm())
        .map(|k| eigen.eigenvectors.column(k) * (3.0 * eigen.eigenvalues[k] / mass).sqrt())
        .collect()
}
