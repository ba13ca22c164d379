//! Checked-in models of the example rigs, one module a rig.
//! Generated from `examples/rigs` by `cargo xtask gen`; edit the rigs, not these files.
//!
//! Each module has structs with named fields, a function a quantity, and a unit struct with the rig's
//! name that implements `runtime::Model`. It needs `core` and `runtime` alone.
#![no_std]
#![forbid(unsafe_code)]

/// Cart and pole.
pub mod cart_pole;

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

/// All models, by the names of their rigs' files.
pub const MODELS: [(&str, &dyn runtime::Model); 7] = [
    ("cart_pole", &cart_pole::CartPole),
    ("furuta", &furuta::Furuta),
    ("googol", &googol::Googol),
    ("googol_eq13", &googol_eq13::GoogolEq13),
    ("googol_identified", &googol_identified::GoogolIdentified),
    ("googol_mrb", &googol_mrb::GoogolMrb),
    ("googol_srb", &googol_srb::GoogolSrb),
];
