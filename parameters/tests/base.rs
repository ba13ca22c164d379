//! Base parameters, relations and consistency against what is known of the example rigs and of a planar arm.

use codegen::{Lumps, Options, derive};
use model_dsl::rig::Rig;
use nalgebra::{Matrix3, Vector3};
use parameters::{Inertia, Known, Verdict, base_parameters, bodies, links, of_lumps, verdict};
use std::path::Path;

fn rig(name: &str) -> Rig {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/rigs").join(name);
    model_dsl::check(&path.display().to_string(), &model_dsl::FileLoader, &model_dsl::CheckOptions::default()).rig.expect("an example rig")
}

fn base(rig: &Rig) -> parameters::Base {
    let equations = derive(rig, Options { jacobians: false, ..Options::default() }).expect("derives");
    base_parameters(rig, &equations, 7).expect("short enough")
}

fn texts(base: &parameters::Base) -> Vec<&str> {
    base.parameters.iter().map(|b| b.text.as_str()).collect()
}

/// Equation 13 of the seed paper in torque form.
#[test]
fn googol_under_its_assumptions_has_the_ten_of_equation_13() {
    let rig = rig("googol_mrb.rig");
    let base = base(&rig);
    let expected = ["l_oc", "l_df", "c0_psi", "c0_eps", "c0_theta", "I_psi", "I_eps", "I_theta", "m' g", "m_h g l_cd"];
    assert_eq!(texts(&base), expected);
    let weight = &base.parameters[8];
    assert!((weight.value - (0.78 * 1.8 + 0.2296 * 0.67948 - 0.33 * 3.433) * 9.81).abs() < 1e-12, "m' g = {}", weight.value);
    assert_eq!(base.dead, ["I_x", "I_z"], "the assumption puts diagonal entries in their place");
}

#[test]
fn full_googol_puts_bodies_together() {
    let base = base(&rig("googol.rig"));
    let found = texts(&base);
    assert_eq!(found.len(), 11, "{found:?}");
    for one in ["m' g", "m_h g l_cd", "m_h l_oc l_cd", "m_h l_cd^2 + I_x", "I_z - m_h l_cd^2"] {
        assert!(found.contains(&one), "{one} is missing: {found:?}");
    }
}

/// The base gives inverse dynamics back at states that had no part in finding it.
#[test]
fn base_parameters_carry_the_whole_regressor() {
    for name in ["googol.rig", "double_pendulum.rig", "chain3.rig", "tree.rig", "quanser_ads_driven.rig", "furuta.rig"] {
        let rig = rig(name);
        let base = base(&rig);
        let nominal = |n: &str| rig.parameters.iter().find(|p| p.name == n).map(|p| p.value);
        let values = base.form.values(&|n| nominal(n).expect("a parameter"));
        for state in 0..5 {
            // any smooth function of the name is a state that the search has not seen
            let value = |n: &str| {
                nominal(n).unwrap_or_else(|| (n.bytes().map(u32::from).sum::<u32>() as f64 * 0.37 + 1.3 * f64::from(state)).sin())
            };
            for row in base.form.regressor(&value) {
                let full: f64 = row.iter().zip(&values).map(|(y, p)| y * p).sum();
                let short: f64 = base.parameters.iter().map(|b| row[b.terms[0].0] * b.value).sum();
                let size: f64 = row.iter().zip(&values).map(|(y, p)| (y * p).abs()).sum();
                assert!((full - short).abs() <= 1e-11 * size, "{name}: {full} against {short}");
            }
        }
    }
}

/// Siciliano et al., section 7.3.3: of a planar arm's links 5 base parameters with gravity are left; the far link's mass
/// goes with l_1 to the near link's first moment and with l_1^2 to its inertia.
#[test]
fn planar_arm_of_the_textbook() {
    let text = "rig Arm {
        param m_1: kg = 1; param m_2: kg = 0.8; param l_1: m = 0.5; param c_1: m = 0.25; param c_2: m = 0.2;
        param J_1: kg*m^2 = 0.02; param J_2: kg*m^2 = 0.01; const g: m/s^2 = 9.81;
        coord q1: rad; coord q2: rad;
        frame near = ground.rotate(-y, q1);
        frame far = near.translate(l_1, 0, 0).rotate(-y, q2);
        body a on near { mass m_1; at (c_1, 0, 0); inertia diag(J_1, J_1, J_1); }
        body b on far { mass m_2; at (c_2, 0, 0); inertia diag(J_2, J_2, J_2); }
        gravity g; input tau: N*m; torque motor on q1: tau; }";
    let rig = model_dsl::check_text("arm.rig", text).rig.expect("a rig");
    let links = links(&rig, Lumps::AsParameters, 3).expect("bodies");
    assert_eq!(links.rank, 4, "mc and I of either link");
    assert_eq!(links.combined, ["mc_near_x + 0.5 m_far", "I_near_yy + 0.25 m_far"]);
    assert!(links.dead.contains(&"m_near".to_owned()) && links.dead.contains(&"I_far_xx".to_owned()), "{:?}", links.dead);
}

/// The seed's ten lumps have eight degrees of freedom; the identified values break a1 l_oc/b1 = a3 l_df/b2.
#[test]
fn identified_lumps_break_one_relation() {
    let rig = rig("googol_identified.rig");
    let beside: Vec<String> = ["c_psi", "c_eps", "c_theta"].map(str::to_owned).to_vec();
    let found = of_lumps(&rig, &Known::Lengths, &beside, 1).expect("lumps with values");
    assert_eq!((found.quantities.len(), found.freedom), (10, 8));
    let said: Vec<(String, &str)> = found.products.iter().map(|r| (r.product(), r.means.as_str())).collect();
    assert_eq!(said, [("a1 b2/(a3 b1)".to_owned(), "l_df/l_oc"), ("b4/b3".to_owned(), "l_df/l_oc")]);
    let broken = (0.2634 / 0.531 * 0.78) / (25.6488 / 5.3292 * 0.17);
    assert!((found.products[0].factor() - broken).abs() < 1e-12 && (1.0 / broken - 2.1).abs() < 0.05);
    assert!((found.products[1].factor() - 1.0).abs() < 1e-3);
    // with nothing known, one relation is left that needs no ruler
    let none = of_lumps(&rig, &Known::These(["g".to_owned()].into()), &[], 1).expect("lumps");
    assert_eq!((none.quantities.len(), none.freedom, none.products.len()), (7, 6, 1));
}

#[test]
fn example_rigs_have_possible_bodies() {
    for name in ["googol.rig", "quanser_ads.rig", "double_pendulum.rig", "furuta.rig", "aero.rig", "cart_pole.rig", "tree.rig"] {
        for b in bodies(&rig(name), Lumps::AsParameters) {
            assert_eq!(b.verdict, Verdict::Possible, "{name}: {}", b.body);
        }
    }
}

/// Design C.0, model 3.0 of the DFKI double pendulum: the lower link's published inertia about the elbow is below m r^2.
#[test]
fn a_published_set_that_no_body_can_have() {
    let link = |m: f64, r: f64, i: f64| Inertia {
        mass: m,
        center: Vector3::new(0.0, 0.0, -r),
        about_origin: Matrix3::from_diagonal(&Vector3::new(i, i, 0.0)),
    };
    let lower = verdict(&link(0.563935954099688, 0.3212669909674605, 0.053878129629650884)).0;
    assert!(matches!(lower, Verdict::NegativeMoment { least } if (least + 0.0043271).abs() < 1e-7), "{lower:?}");
    let upper = verdict(&link(0.6416937799349799, 0.2, 0.02671076499939512)).0;
    assert_eq!(upper, Verdict::Possible);
    assert_eq!(verdict(&link(-0.1, 0.0, 0.01)).0, Verdict::NegativeMass);
    let box_ = Inertia { mass: 1.0, center: Vector3::zeros(), about_origin: Matrix3::from_diagonal(&Vector3::new(0.1, 0.1, 0.3)) };
    assert!(matches!(verdict(&box_).0, Verdict::Triangle { missing } if (missing - 0.1).abs() < 1e-12));
}
