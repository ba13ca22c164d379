//! E0303: an inertia tensor is one of some mass distribution. About the centre of mass it is positive semidefinite,
//! and no principal moment exceeds the sum of the other two; equality (a thin plate, a rod) is accepted.

use super::matrix::{M3, eigen, steiner, tensor};
use super::{Context, shown};
use crate::diagnostic::Diagnostic;
use crate::rig::{Body, InertiaPoint};

/// Rounding of decimal entries.
const ROUNDING: f64 = 1e-9;

/// Which rule a tensor breaks, and by how much.
enum Fault {
    /// A negative principal moment.
    Negative(f64),
    /// The largest exceeds the sum of the other two.
    Triangle { moments: [f64; 3], excess: f64 },
}

pub(super) fn check(c: &Context<'_>, diagnostics: &mut Vec<Diagnostic>) {
    for b in &c.rig.bodies {
        let values: Option<Vec<f64>> = b.inertia.iter().chain(&b.center).chain([&b.mass]).map(|e| c.numbers.value(e)).collect();
        let Some(x) = values.filter(|x| x.iter().all(|x| x.is_finite())) else { continue };
        let entries: [f64; 6] = std::array::from_fn(|k| x[k]);
        // a negative mass is its own mistake
        if x[9] < 0.0 || entries == [0.0; 6] {
            continue;
        }
        let stated = tensor(entries);
        let moved = steiner(x[9], [x[6], x[7], x[8]]);
        let about_origin = matches!(b.about, InertiaPoint::FrameOrigin);
        let combine = |sign: f64| std::array::from_fn(|i| std::array::from_fn(|j| stated[i][j] + sign * moved[i][j]));
        let central: M3 = if about_origin { combine(-1.0) } else { stated };
        let size = stated.iter().chain(&moved).flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
        if let Some(fault) = fault(&central, size) {
            let other: M3 = if about_origin { stated } else { combine(-1.0) };
            diagnostics.push(report(c, b, &entries, &fault, about_origin, self::fault(&other, size).is_none() && x[6..9] != [0.0; 3]));
        }
    }
}

fn fault(tensor: &M3, size: f64) -> Option<Fault> {
    let rows: Vec<Vec<f64>> = tensor.iter().map(|r| r.to_vec()).collect();
    let moments: Vec<f64> = eigen(&rows).into_iter().map(|e| e.0).collect();
    let [a, b, c] = [moments[0], moments[1], moments[2]];
    if a < -ROUNDING * size {
        return Some(Fault::Negative(a));
    }
    let excess = c - a - b;
    (excess > ROUNDING * size).then_some(Fault::Triangle { moments: [a, b, c], excess })
}

fn report(c: &Context<'_>, b: &Body, entries: &[f64; 6], fault: &Fault, about_origin: bool, other_point_is_right: bool) -> Diagnostic {
    let diagonal = entries[3..] == [0.0; 3] && !about_origin;
    let names = ["I_xx", "I_yy", "I_zz"];
    let label = match fault {
        Fault::Negative(x) if diagonal => {
            let k = (0..3).find(|&k| entries[k] < 0.0).unwrap_or(0);
            format!("{} = {} kg m^2 is negative", names[k], shown(*x))
        }
        Fault::Negative(x) if about_origin => format!("about the centre of mass, a principal moment would be {} kg m^2", shown(*x)),
        Fault::Negative(x) => format!("one of its principal moments is {} kg m^2", shown(*x)),
        Fault::Triangle { excess, .. } if diagonal => {
            let k = (0..3).max_by(|&i, &j| entries[i].total_cmp(&entries[j])).unwrap_or(0);
            let others: Vec<&str> = (0..3).filter(|&i| i != k).map(|i| names[i]).collect();
            let sum = entries[..3].iter().sum::<f64>() - entries[k];
            format!(
                "{} = {} exceeds {} + {} = {} by {} kg m^2",
                names[k],
                shown(entries[k]),
                others[0],
                others[1],
                shown(sum),
                shown(*excess)
            )
        }
        Fault::Triangle { moments, excess } => {
            let about = if about_origin { "about the centre of mass, the" } else { "the" };
            format!(
                "{about} largest principal moment, {}, exceeds the sum of the others, {} + {}, by {} kg m^2",
                shown(moments[2]),
                shown(moments[0]),
                shown(moments[1]),
                shown(*excess)
            )
        }
    };
    let mut d =
        Diagnostic::error("E0303", format!("no mass distribution has the inertia of `{}`", b.name), c.inertia(&b.name, b.span), label);
    d = match fault {
        Fault::Triangle { moments, excess } if *excess < 0.02 * moments[2] => {
            d.help("if these are rounded numbers of a thin plate or rod, round the largest one down")
        }
        Fault::Triangle { .. } => {
            d.help("a moment of inertia is never larger than the sum of the other two: check the units and the order of the axes")
        }
        Fault::Negative(_) if entries[3..] != [0.0; 3] => {
            d.help("the products I_xy, I_xz, I_yz are tensor entries (minus the integrals): check their size and sign")
        }
        Fault::Negative(_) => d,
    };
    match (about_origin, other_point_is_right) {
        (true, true) => d.help("if it is stated about the centre of mass, leave `about origin` out"),
        (true, false) => d.help("about the frame's origin it contains m (c.c 1 - c c^T) of the centre of mass c: check `at` and the mass"),
        (false, true) => d.help("if it is stated about the frame's origin, write `about origin` behind it"),
        (false, false) => d,
    }
}
