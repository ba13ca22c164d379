//! Poses against places worked out by hand, and pictures that hold what was declared.

use codegen::Lumps;
use drawing::{picture, pose, sample};
use model_dsl::rig::Rig;
use nalgebra::{Point3, Vector3};
use std::path::Path;

fn rig(name: &str) -> Rig {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/rigs").join(name);
    model_dsl::check(&path.display().to_string(), &model_dsl::FileLoader, &model_dsl::CheckOptions::default()).rig.expect("an example rig")
}

fn near(a: Point3<f64>, b: [f64; 3]) -> bool {
    (a.coords - Vector3::from(b)).norm() < 1e-12
}

/// psi a quarter turn, eps 30 degrees, theta a quarter turn: the fuselage hangs off sideways, at the arm's end.
#[test]
fn googols_bodies_stand_where_they_should() {
    let quarter = std::f64::consts::FRAC_PI_2;
    let p = pose(&rig("googol.rig"), Lumps::AsParameters, &[quarter, std::f64::consts::FRAC_PI_6, quarter]);
    let (sin, cos) = std::f64::consts::FRAC_PI_6.sin_cos();
    let body = |name: &str| p.masses.iter().find(|m| m.name == name).expect("a body").at;
    // the arm points along y of ground, upwards by 30 degrees
    assert!(near(body("counterweight"), [0.0, -0.33 * cos, -0.33 * sin]), "{:?}", body("counterweight"));
    // turned about -x of the arm by a quarter, what hung down (0, 0, -l_cd) points along -y of the arm: x of ground
    assert!(near(body("fuselage"), [0.1, 0.78 * cos, 0.78 * sin]), "{:?}", body("fuselage"));
    let names: Vec<&str> = p.joints.iter().map(|j| j.name.as_str()).collect();
    assert_eq!(names, ["psi", "eps", "theta"]);
    assert!((p.joints[1].axis - Vector3::new(1.0, 0.0, 0.0)).norm() < 1e-12, "-y of the column: {:?}", p.joints[1].axis);
    assert_eq!(p.forces.len(), 2);
}

/// A slender rod's extents reach from end to end.
#[test]
fn rods_are_drawn_from_end_to_end() {
    let p = pose(&rig("furuta.rig"), Lumps::AsParameters, &[0.0, 0.0]);
    let rod = p.masses.iter().find(|m| m.name == "rod").expect("the pendulum");
    let longest = rod.extents.iter().map(|e| e.norm()).fold(0.0, f64::max);
    assert!((longest - 0.129 / 2.0).abs() < 1e-6, "half of L_p, not {longest}");
}

#[test]
fn sliding_joints_slide_and_prescribed_ones_are_drawn() {
    let p = pose(&rig("quanser_ads.rig"), Lumps::AsParameters, &[0.0, 0.0, 0.0, 0.1]);
    let slide = p.joints.iter().find(|j| j.name == "s").expect("the carriage");
    assert!(slide.slides && near(slide.at, [0.1, 0.0, -0.02]), "{slide:?}");
}

#[test]
fn pictures_name_everything_and_repeat_byte_by_byte() {
    for name in ["quanser.rig", "tree.rig", "cart_pole.rig"] {
        let rig = rig(name);
        let p = pose(&rig, Lumps::AsParameters, &sample(&rig));
        let svg = picture(&p, "A <title> & more", name);
        assert_eq!(svg, picture(&p, "A <title> & more", name));
        assert!(svg.contains("A &lt;title&gt; &amp; more") && svg.contains("Generated from `"), "{svg}");
        for body in &rig.bodies {
            assert!(svg.contains(&format!(">{}</text>", body.name)), "{name}: {} has no name", body.name);
        }
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
    }
}
