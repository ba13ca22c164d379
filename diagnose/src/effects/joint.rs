//! Effects in a joint: friction, springs, stops, torques that are constant or turn with an angle, products of rates.

use super::unit::{is_angle, of_coordinate, of_rate, of_row};
use super::{Effect, Names, Scales, added, crutch, parameter, rounded, shape};
use model_dsl::rig::{Expr, Rig, Symbol};

/// Periods per turn that are tried.
const HARMONICS: [usize; 4] = [1, 2, 3, 4];

pub(super) fn effects(rig: &Rig, scales: &Scales, names: &mut Names, out: &mut Vec<Effect>) {
    let free: Vec<usize> = (0..rig.coordinates.len()).filter(|&i| !rig.coordinates[i].prescribed).collect();
    for &i in &free {
        friction(rig, scales, i, names, out);
        position(rig, scales, i, names, out);
    }
    for &i in &free {
        for &j in free.iter().filter(|&&j| turns(rig, scales, j)) {
            periodic(rig, j, i, names, out);
        }
    }
    // with bodies behind the equations, products of rates follow from them
    if !rig.equations.is_empty() && free.len() > 1 {
        velocity_products(rig, &free, names, out);
    }
}

/// The coordinate is an angle that may turn, or did by more than half a turn.
pub(super) fn turns(rig: &Rig, scales: &Scales, i: usize) -> bool {
    let wide = |(lo, hi): (f64, f64)| hi - lo > std::f64::consts::PI;
    is_angle(rig, i) && rig.coordinates[i].range.is_none_or(wide) && scales.range.get(i).copied().is_some_and(wide)
}

/// Width of the smooth sign of static friction, in parts of the speed at which it is gone: a wider one eats what acts next to rest.
pub(crate) const STRIBECK_WIDTH: f64 = 0.06;

/// The rig has dry friction on this coordinate.
pub(super) fn is_dry(rig: &Rig, i: usize) -> bool {
    rig.frictions.iter().any(|f| f.coulomb.is_some() && matches!(f.of, Expr::Symbol(Symbol::Coordinate(of)) if of == i))
}

fn friction(rig: &Rig, scales: &Scales, i: usize, names: &mut Names, out: &mut Vec<Effect>) {
    let q = &rig.coordinates[i].name;
    let (row, rate) = (of_row(rig, i), of_rate(rig, i));
    let rate_unit = rate.text();
    let name = names.free(&format!("b_{q}"));
    let p = vec![parameter(&name, row.by(&rate, -1).text(), true, "viscous friction")];
    out.push(added("viscous", q, p, None, format!("friction viscous_{q} on {q} {{ viscous {name}; }}")));

    let typical = scales.rate.get(i).copied().unwrap_or(0.0);
    // another width of a friction that is there is no effect
    let dry = is_dry(rig, i);
    if typical > 0.0 {
        let widths: &[f64] = if dry { &[] } else { &[0.03, 0.15, 0.006] };
        for (k, share) in widths.iter().copied().enumerate() {
            let width = rounded(share * typical);
            let (name, w) = (names.free(&format!("F_c_{q}")), names.free(&format!("w_c_{q}")));
            let p = vec![
                parameter(&name, row.text(), true, "Coulomb friction"),
                crutch(&w, rate_unit.clone(), width, "width of its smooth sign"),
            ];
            let statement = format!("friction coulomb_{q}{} on {q} {{ coulomb {name} width {w}; }}", tail(k));
            out.push(added("coulomb", q, p, Some(format!("width {width} {rate_unit}")), statement));
        }
        for (k, share) in [0.1, 0.3].into_iter().enumerate() {
            let speed = rounded(share * typical);
            let (name, v_s) = (names.free(&format!("F_s_{q}")), names.free(&format!("v_s_{q}")));
            let p = vec![
                parameter(&name, row.text(), true, "static friction beyond Coulomb friction"),
                shape(&v_s, rate_unit.clone(), speed, (0.2 * speed, 4.0 * speed), "speed at which it is gone"),
            ];
            let statement = format!(
                "torque stribeck_{q}{} on {q}: -{name} * exp(-({q}.dot / {v_s})^2) * tanh({q}.dot / ({STRIBECK_WIDTH} * {v_s}));",
                tail(k)
            );
            out.push(added("stribeck", q, p, Some(format!("speed {speed} {rate_unit}")), statement));
        }
    }
    let (slope, offset) = (names.free(&format!("b_a_{q}")), names.free(&format!("c_a_{q}")));
    let p = vec![
        parameter(&slope, row.by(&rate, -1).text(), false, "slope of asymmetric friction"),
        parameter(&offset, row.text(), false, "offset of asymmetric friction"),
    ];
    out.push(added("asymmetric_friction", q, p, None, format!("friction asymmetric_{q} on {q} {{ asymmetric {slope}, {offset}; }}")));
    let name = names.free(&format!("c_2_{q}"));
    let p = vec![parameter(&name, row.by(&rate, -2).text(), true, "quadratic drag")];
    out.push(added("quadratic_drag", q, p, None, format!("friction drag_{q} on {q} {{ quadratic {name}; }}")));
}

fn position(rig: &Rig, scales: &Scales, i: usize, names: &mut Names, out: &mut Vec<Effect>) {
    let q = &rig.coordinates[i].name;
    let (row, unit) = (of_row(rig, i), of_coordinate(rig, i));
    let (k, t0) = (names.free(&format!("k_{q}")), names.free(&format!("tau_k_{q}")));
    let p = vec![parameter(&k, row.by(&unit, -1).text(), true, "stiffness"), parameter(&t0, row.text(), false, "its force at zero")];
    out.push(added("spring", q, p, None, format!("torque spring_{q} on {q}: {t0} - {k} * {q};")));
    let name = names.free(&format!("k_3_{q}"));
    let p = vec![parameter(&name, row.by(&unit, -3).text(), false, "cubic stiffness")];
    out.push(added("cubic_spring", q, p, None, format!("torque cubic_{q} on {q}: -{name} * {q}^3;")));
    let name = names.free(&format!("tau_0_{q}"));
    let p = vec![parameter(&name, row.text(), false, "constant torque")];
    let mut constant = added("constant_torque", q, p, None, format!("torque constant_{q} on {q}: {name};"));
    constant.of_the_day = true;
    out.push(constant);
    let Some(&(lo, hi)) = scales.range.get(i) else { return };
    if hi > lo {
        let unit_text = if is_angle(rig, i) { "rad".to_owned() } else { unit.text() };
        for (k, share) in [0.15, 0.03].into_iter().enumerate() {
            let (low, high) = (rounded(lo + share * (hi - lo)), rounded(hi - share * (hi - lo)));
            let (below, above) = (names.free(&format!("k_lo_{q}")), names.free(&format!("k_hi_{q}")));
            let (from, to) = (names.free(&format!("lo_{q}")), names.free(&format!("hi_{q}")));
            let stiffness = row.by(&unit, -1).text();
            let third = (hi - lo) / 3.0;
            let p = vec![
                parameter(&below, stiffness.clone(), true, "stiffness of the lower stop"),
                parameter(&above, stiffness, true, "stiffness of the upper stop"),
                shape(&from, unit_text.clone(), low, (lo, lo + third), "where the lower stop begins"),
                shape(&to, unit_text.clone(), high, (hi - third, hi), "where the upper stop begins"),
            ];
            let statement = format!("torque stop_{q}{} on {q}: {below} * max({from} - {q}, 0) - {above} * max({q} - {to}, 0);", tail(k));
            out.push(added("hard_stop", q, p, Some(format!("from {low} and {high} {unit_text}")), statement));
        }
    }
}

fn periodic(rig: &Rig, angle: usize, row: usize, names: &mut Names, out: &mut Vec<Effect>) {
    let (psi, q) = (&rig.coordinates[angle].name, &rig.coordinates[row].name);
    let unit = of_row(rig, row).text();
    for n in HARMONICS {
        let (s, c) = (names.free(&format!("A_s{n}_{q}")), names.free(&format!("A_c{n}_{q}")));
        let p = vec![parameter(&s, unit.clone(), false, "sine of the angle"), parameter(&c, unit.clone(), false, "cosine of the angle")];
        let of = if n == 1 { psi.clone() } else { format!("{n} * {psi}") };
        let place = if angle == row { q.clone() } else { format!("{psi}->{q}") };
        let statement = format!("torque periodic_{psi}_{q}_{n} on {q}: {s} * sin({of}) + {c} * cos({of});");
        out.push(added("periodic_torque", &place, p, Some(format!("{n} per turn")), statement));
    }
}

fn velocity_products(rig: &Rig, free: &[usize], names: &mut Names, out: &mut Vec<Effect>) {
    for &k in free {
        for (a, &i) in free.iter().enumerate() {
            for &j in &free[a..] {
                // v_k^2 in its own equation is drag
                if i == k && j == k {
                    continue;
                }
                let (vi, vj, q) = (&rig.coordinates[i].name, &rig.coordinates[j].name, &rig.coordinates[k].name);
                let name = names.free(&format!("h_{q}_{vi}_{vj}"));
                let unit = of_row(rig, k).by(&of_rate(rig, i), -1).by(&of_rate(rig, j), -1);
                let p = vec![parameter(&name, unit.text(), false, "product of rates")];
                let product = if i == j { format!("{vi}.dot^2") } else { format!("{vi}.dot * {vj}.dot") };
                let statement = format!("torque product_{q}_{vi}_{vj} on {q}: {name} * {product};");
                out.push(added("velocity_product", &format!("{vi},{vj}->{q}"), p, None, statement));
            }
        }
    }
}

/// Statements of one kind at one place need different names.
fn tail(k: usize) -> String {
    if k == 0 { String::new() } else { format!("_{}", k + 1) }
}
