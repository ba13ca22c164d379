//! Checked-in models of the example rigs, one module a rig.
//! Generated from `examples/rigs` by `cargo xtask gen`; edit the rigs, not these files.
//!
//! Each module has structs with named fields, a function a quantity, and a unit struct with the rig's
//! name that implements `runtime::Model`. It needs `core` and `runtime` alone.
#![no_std]
#![forbid(unsafe_code)]

/// Acrobot.
pub mod acrobot;

/// Quanser Aero, two degrees of freedom.
pub mod aero;

/// Cart and pole.
pub mod cart_pole;

/// Spatial chain of three joints.
pub mod chain3;

/// Double pendulum with quasi-direct drives and a belt to the elbow.
pub mod double_pendulum;

/// EMPS, electro-mechanical positioning system.
pub mod emps;

/// Flexible joint: a link in gravity, driven through a spring.
pub mod flexible_joint;

/// Furuta pendulum (QUBE-Servo 2).
pub mod furuta;

/// Googol GHP2002 3-DOF helicopter, full physics.
pub mod googol;

/// Googol GHP2002, eq. 13 as printed.
pub mod googol_eq13;

/// Googol GHP2002, identified model.
pub mod googol_identified;

/// Googol GHP2002, multi-rigid-body model.
pub mod googol_mrb;

/// Googol GHP2002, single-rigid-body model.
pub mod googol_srb;

/// Quanser 3-DOF helicopter, the arm hanging below its elevation axis.
pub mod quanser;

/// Quanser 3-DOF helicopter with the active disturbance system, its carriage moved from outside.
pub mod quanser_ads;

/// Quanser 3-DOF helicopter with the active disturbance system, its carriage driven by its motor.
pub mod quanser_ads_driven;

/// Two arms on one column.
pub mod tree;

/// All models, by the names of their rigs' files.
pub const MODELS: [(&str, &dyn runtime::Model); 17] = [
    ("acrobot", &acrobot::Acrobot),
    ("aero", &aero::Aero),
    ("cart_pole", &cart_pole::CartPole),
    ("chain3", &chain3::Chain3),
    ("double_pendulum", &double_pendulum::DoublePendulum),
    ("emps", &emps::Emps),
    ("flexible_joint", &flexible_joint::FlexibleJoint),
    ("furuta", &furuta::Furuta),
    ("googol", &googol::Googol),
    ("googol_eq13", &googol_eq13::GoogolEq13),
    ("googol_identified", &googol_identified::GoogolIdentified),
    ("googol_mrb", &googol_mrb::GoogolMrb),
    ("googol_srb", &googol_srb::GoogolSrb),
    ("quanser", &quanser::Quanser),
    ("quanser_ads", &quanser_ads::QuanserAds),
    ("quanser_ads_driven", &quanser_ads_driven::QuanserAdsDriven),
    ("tree", &tree::Tree),
];
