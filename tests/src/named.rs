//! Calls of every named function of the checked-in models, for tests.
//! Generated from `examples/rigs` by `cargo xtask gen`; edit the rigs, not this file.

use crate::calls::{Arguments, Called, Flat};

fn cart_pole(given: &Arguments) -> Vec<Called> {
    use generated::cart_pole::*;
    let x = State::from_array(runtime::array(given.x));
    let q = Coordinates::from_array(runtime::array(given.q));
    let v = Rates::from_array(runtime::array(given.v));
    let a = Accelerations::from_array(runtime::array(given.a));
    let u = Inputs::from_array(runtime::array(given.u));
    let p = Parameters::from_array(runtime::array(given.p));
    vec![
        ("mass_matrix", Ok({ let r = mass_matrix(&q, &p); vec![r.flat()] })),
        ("bias", Ok({ let r = bias(&q, &v, &p); vec![r.flat()] })),
        ("velocity_products", Ok({ let r = velocity_products(&q, &v, &p); vec![r.flat()] })),
        ("gravity", Ok({ let r = gravity(&q, &p); vec![r.flat()] })),
        ("dissipation", Ok({ let r = dissipation(&q, &v, &p); vec![r.flat()] })),
        ("generalized_force", Ok({ let r = generalized_force(&q, &u, &p); vec![r.flat()] })),
        ("input_map", Ok({ let r = input_map(&q, &p); vec![r.flat()] })),
        ("kinetic_energy", Ok({ let r = kinetic_energy(&q, &v, &p); vec![r.flat()] })),
        ("potential_energy", Ok({ let r = potential_energy(&q, &p); vec![r.flat()] })),
        ("inverse_dynamics", Ok({ let r = inverse_dynamics(&x, &a, &u, &p); vec![r.flat()] })),
        ("outputs", Ok({ let r = outputs(&x, &p); vec![r.to_array().flat()] })),
        ("forward_dynamics", forward_dynamics(&x, &u, &p).map(|r| vec![r.to_array().flat()])),
        ("linearize", linearize(&x, &u, &p).map(|r| vec![r.dx.flat(), r.a.flat(), r.b.flat()])),
        ("parameter_jacobian", parameter_jacobian(&x, &u, &p).map(|r| vec![r.flat()])),
        ("output_jacobian", Ok({ let r = output_jacobian(&x, &p); vec![r.by_x.flat(), r.by_p.flat()] })),
    ]
}

fn furuta(given: &Arguments) -> Vec<Called> {
    use generated::furuta::*;
    let x = State::from_array(runtime::array(given.x));
    let q = Coordinates::from_array(runtime::array(given.q));
    let v = Rates::from_array(runtime::array(given.v));
    let a = Accelerations::from_array(runtime::array(given.a));
    let u = Inputs::from_array(runtime::array(given.u));
    let p = Parameters::from_array(runtime::array(given.p));
    vec![
        ("mass_matrix", Ok({ let r = mass_matrix(&q, &p); vec![r.flat()] })),
        ("bias", Ok({ let r = bias(&q, &v, &p); vec![r.flat()] })),
        ("velocity_products", Ok({ let r = velocity_products(&q, &v, &p); vec![r.flat()] })),
        ("gravity", Ok({ let r = gravity(&q, &p); vec![r.flat()] })),
        ("dissipation", Ok({ let r = dissipation(&q, &v, &p); vec![r.flat()] })),
        ("generalized_force", Ok({ let r = generalized_force(&q, &u, &p); vec![r.flat()] })),
        ("input_map", Ok({ let r = input_map(&q, &p); vec![r.flat()] })),
        ("kinetic_energy", Ok({ let r = kinetic_energy(&q, &v, &p); vec![r.flat()] })),
        ("potential_energy", Ok({ let r = potential_energy(&q, &p); vec![r.flat()] })),
        ("inverse_dynamics", Ok({ let r = inverse_dynamics(&x, &a, &u, &p); vec![r.flat()] })),
        ("outputs", Ok({ let r = outputs(&x, &p); vec![r.to_array().flat()] })),
        ("forward_dynamics", forward_dynamics(&x, &u, &p).map(|r| vec![r.to_array().flat()])),
        ("linearize", linearize(&x, &u, &p).map(|r| vec![r.dx.flat(), r.a.flat(), r.b.flat()])),
        ("parameter_jacobian", parameter_jacobian(&x, &u, &p).map(|r| vec![r.flat()])),
        ("output_jacobian", Ok({ let r = output_jacobian(&x, &p); vec![r.by_x.flat(), r.by_p.flat()] })),
    ]
}

fn googol(given: &Arguments) -> Vec<Called> {
    use generated::googol::*;
    let x = State::from_array(runtime::array(given.x));
    let q = Coordinates::from_array(runtime::array(given.q));
    let v = Rates::from_array(runtime::array(given.v));
    let a = Accelerations::from_array(runtime::array(given.a));
    let u = Inputs::from_array(runtime::array(given.u));
    let p = Parameters::from_array(runtime::array(given.p));
    vec![
        ("mass_matrix", Ok({ let r = mass_matrix(&q, &p); vec![r.flat()] })),
        ("bias", Ok({ let r = bias(&q, &v, &p); vec![r.flat()] })),
        ("velocity_products", Ok({ let r = velocity_products(&q, &v, &p); vec![r.flat()] })),
        ("gravity", Ok({ let r = gravity(&q, &p); vec![r.flat()] })),
        ("dissipation", Ok({ let r = dissipation(&q, &v, &p); vec![r.flat()] })),
        ("generalized_force", Ok({ let r = generalized_force(&q, &u, &p); vec![r.flat()] })),
        ("input_map", Ok({ let r = input_map(&q, &p); vec![r.flat()] })),
        ("kinetic_energy", Ok({ let r = kinetic_energy(&q, &v, &p); vec![r.flat()] })),
        ("potential_energy", Ok({ let r = potential_energy(&q, &p); vec![r.flat()] })),
        ("inverse_dynamics", Ok({ let r = inverse_dynamics(&x, &a, &u, &p); vec![r.flat()] })),
        ("outputs", Ok({ let r = outputs(&x, &p); vec![r.to_array().flat()] })),
        ("forward_dynamics", forward_dynamics(&x, &u, &p).map(|r| vec![r.to_array().flat()])),
        ("linearize", linearize(&x, &u, &p).map(|r| vec![r.dx.flat(), r.a.flat(), r.b.flat()])),
        ("parameter_jacobian", parameter_jacobian(&x, &u, &p).map(|r| vec![r.flat()])),
        ("output_jacobian", Ok({ let r = output_jacobian(&x, &p); vec![r.by_x.flat(), r.by_p.flat()] })),
    ]
}

fn googol_eq13(given: &Arguments) -> Vec<Called> {
    use generated::googol_eq13::*;
    let x = State::from_array(runtime::array(given.x));
    let q = Coordinates::from_array(runtime::array(given.q));
    let v = Rates::from_array(runtime::array(given.v));
    let a = Accelerations::from_array(runtime::array(given.a));
    let u = Inputs::from_array(runtime::array(given.u));
    let p = Parameters::from_array(runtime::array(given.p));
    vec![
        ("mass_matrix", Ok({ let r = mass_matrix(&q, &p); vec![r.flat()] })),
        ("bias", Ok({ let r = bias(&q, &v, &p); vec![r.flat()] })),
        ("gravity", Ok({ let r = gravity(&q, &p); vec![r.flat()] })),
        ("dissipation", Ok({ let r = dissipation(&q, &v, &p); vec![r.flat()] })),
        ("generalized_force", Ok({ let r = generalized_force(&q, &u, &p); vec![r.flat()] })),
        ("input_map", Ok({ let r = input_map(&q, &p); vec![r.flat()] })),
        ("inverse_dynamics", Ok({ let r = inverse_dynamics(&x, &a, &u, &p); vec![r.flat()] })),
        ("outputs", Ok({ let r = outputs(&x, &p); vec![r.to_array().flat()] })),
        ("forward_dynamics", forward_dynamics(&x, &u, &p).map(|r| vec![r.to_array().flat()])),
        ("linearize", linearize(&x, &u, &p).map(|r| vec![r.dx.flat(), r.a.flat(), r.b.flat()])),
        ("parameter_jacobian", parameter_jacobian(&x, &u, &p).map(|r| vec![r.flat()])),
        ("output_jacobian", Ok({ let r = output_jacobian(&x, &p); vec![r.by_x.flat(), r.by_p.flat()] })),
    ]
}

fn googol_identified(given: &Arguments) -> Vec<Called> {
    use generated::googol_identified::*;
    let x = State::from_array(runtime::array(given.x));
    let q = Coordinates::from_array(runtime::array(given.q));
    let v = Rates::from_array(runtime::array(given.v));
    let a = Accelerations::from_array(runtime::array(given.a));
    let u = Inputs::from_array(runtime::array(given.u));
    let p = Parameters::from_array(runtime::array(given.p));
    vec![
        ("mass_matrix", Ok({ let r = mass_matrix(&q, &p); vec![r.flat()] })),
        ("bias", Ok({ let r = bias(&q, &v, &p); vec![r.flat()] })),
        ("gravity", Ok({ let r = gravity(&q, &p); vec![r.flat()] })),
        ("dissipation", Ok({ let r = dissipation(&q, &v, &p); vec![r.flat()] })),
        ("generalized_force", Ok({ let r = generalized_force(&q, &u, &p); vec![r.flat()] })),
        ("input_map", Ok({ let r = input_map(&q, &p); vec![r.flat()] })),
        ("inverse_dynamics", Ok({ let r = inverse_dynamics(&x, &a, &u, &p); vec![r.flat()] })),
        ("outputs", Ok({ let r = outputs(&x, &p); vec![r.to_array().flat()] })),
        ("forward_dynamics", forward_dynamics(&x, &u, &p).map(|r| vec![r.to_array().flat()])),
        ("linearize", linearize(&x, &u, &p).map(|r| vec![r.dx.flat(), r.a.flat(), r.b.flat()])),
        ("parameter_jacobian", parameter_jacobian(&x, &u, &p).map(|r| vec![r.flat()])),
        ("output_jacobian", Ok({ let r = output_jacobian(&x, &p); vec![r.by_x.flat(), r.by_p.flat()] })),
    ]
}

fn googol_mrb(given: &Arguments) -> Vec<Called> {
    use generated::googol_mrb::*;
    let x = State::from_array(runtime::array(given.x));
    let q = Coordinates::from_array(runtime::array(given.q));
    let v = Rates::from_array(runtime::array(given.v));
    let a = Accelerations::from_array(runtime::array(given.a));
    let u = Inputs::from_array(runtime::array(given.u));
    let p = Parameters::from_array(runtime::array(given.p));
    vec![
        ("mass_matrix", Ok({ let r = mass_matrix(&q, &p); vec![r.flat()] })),
        ("bias", Ok({ let r = bias(&q, &v, &p); vec![r.flat()] })),
        ("velocity_products", Ok({ let r = velocity_products(&q, &v, &p); vec![r.flat()] })),
        ("gravity", Ok({ let r = gravity(&q, &p); vec![r.flat()] })),
        ("dissipation", Ok({ let r = dissipation(&q, &v, &p); vec![r.flat()] })),
        ("generalized_force", Ok({ let r = generalized_force(&q, &u, &p); vec![r.flat()] })),
        ("input_map", Ok({ let r = input_map(&q, &p); vec![r.flat()] })),
        ("potential_energy", Ok({ let r = potential_energy(&q, &p); vec![r.flat()] })),
        ("inverse_dynamics", Ok({ let r = inverse_dynamics(&x, &a, &u, &p); vec![r.flat()] })),
        ("outputs", Ok({ let r = outputs(&x, &p); vec![r.to_array().flat()] })),
        ("forward_dynamics", forward_dynamics(&x, &u, &p).map(|r| vec![r.to_array().flat()])),
        ("linearize", linearize(&x, &u, &p).map(|r| vec![r.dx.flat(), r.a.flat(), r.b.flat()])),
        ("parameter_jacobian", parameter_jacobian(&x, &u, &p).map(|r| vec![r.flat()])),
        ("output_jacobian", Ok({ let r = output_jacobian(&x, &p); vec![r.by_x.flat(), r.by_p.flat()] })),
    ]
}

fn googol_srb(given: &Arguments) -> Vec<Called> {
    use generated::googol_srb::*;
    let x = State::from_array(runtime::array(given.x));
    let q = Coordinates::from_array(runtime::array(given.q));
    let v = Rates::from_array(runtime::array(given.v));
    let a = Accelerations::from_array(runtime::array(given.a));
    let u = Inputs::from_array(runtime::array(given.u));
    let p = Parameters::from_array(runtime::array(given.p));
    vec![
        ("mass_matrix", Ok({ let r = mass_matrix(&q, &p); vec![r.flat()] })),
        ("bias", Ok({ let r = bias(&q, &v, &p); vec![r.flat()] })),
        ("velocity_products", Ok({ let r = velocity_products(&q, &v, &p); vec![r.flat()] })),
        ("gravity", Ok({ let r = gravity(&q, &p); vec![r.flat()] })),
        ("dissipation", Ok({ let r = dissipation(&q, &v, &p); vec![r.flat()] })),
        ("generalized_force", Ok({ let r = generalized_force(&q, &u, &p); vec![r.flat()] })),
        ("input_map", Ok({ let r = input_map(&q, &p); vec![r.flat()] })),
        ("kinetic_energy", Ok({ let r = kinetic_energy(&q, &v, &p); vec![r.flat()] })),
        ("potential_energy", Ok({ let r = potential_energy(&q, &p); vec![r.flat()] })),
        ("inverse_dynamics", Ok({ let r = inverse_dynamics(&x, &a, &u, &p); vec![r.flat()] })),
        ("outputs", Ok({ let r = outputs(&x, &p); vec![r.to_array().flat()] })),
        ("forward_dynamics", forward_dynamics(&x, &u, &p).map(|r| vec![r.to_array().flat()])),
        ("linearize", linearize(&x, &u, &p).map(|r| vec![r.dx.flat(), r.a.flat(), r.b.flat()])),
        ("parameter_jacobian", parameter_jacobian(&x, &u, &p).map(|r| vec![r.flat()])),
        ("output_jacobian", Ok({ let r = output_jacobian(&x, &p); vec![r.by_x.flat(), r.by_p.flat()] })),
    ]
}

/// Every named function of a rig's module at one state; `None` where there is no module of this name.
#[must_use]
pub fn named(rig: &str, given: &Arguments) -> Option<Vec<Called>> {
    Some(match rig {
        "cart_pole" => cart_pole(given),
        "furuta" => furuta(given),
        "googol" => googol(given),
        "googol_eq13" => googol_eq13(given),
        "googol_identified" => googol_identified(given),
        "googol_mrb" => googol_mrb(given),
        "googol_srb" => googol_srb(given),
        _ => return None,
    })
}
