//! Calls of every named function of the checked-in models, for tests.
//! Generated from `examples/rigs` by `cargo xtask gen`; edit the rigs, not this file.

use crate::calls::{Arguments, Called, Flat};

fn acrobot(given: &Arguments) -> Vec<Called> {
    use generated::acrobot::*;
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
        ("pivots", Ok({ let r = pivots(&x, &p); vec![r.flat()] })),
        ("forward_dynamics", forward_dynamics(&x, &u, &p).map(|r| vec![r.to_array().flat()])),
        ("linearize", linearize(&x, &u, &p).map(|r| vec![r.dx.flat(), r.a.flat(), r.b.flat()])),
        ("parameter_jacobian", parameter_jacobian(&x, &u, &p).map(|r| vec![r.flat()])),
        ("output_jacobian", Ok({ let r = output_jacobian(&x, &p); vec![r.by_x.flat(), r.by_p.flat()] })),
    ]
}

fn aero(given: &Arguments) -> Vec<Called> {
    use generated::aero::*;
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
        ("input_map", Ok({ let r = input_map(&q, &u, &p); vec![r.flat()] })),
        ("kinetic_energy", Ok({ let r = kinetic_energy(&q, &v, &p); vec![r.flat()] })),
        ("potential_energy", Ok({ let r = potential_energy(&q, &p); vec![r.flat()] })),
        ("inverse_dynamics", Ok({ let r = inverse_dynamics(&x, &a, &u, &p); vec![r.flat()] })),
        ("outputs", Ok({ let r = outputs(&x, &p); vec![r.to_array().flat()] })),
        ("pivots", Ok({ let r = pivots(&x, &p); vec![r.flat()] })),
        ("forward_dynamics", forward_dynamics(&x, &u, &p).map(|r| vec![r.to_array().flat()])),
        ("linearize", linearize(&x, &u, &p).map(|r| vec![r.dx.flat(), r.a.flat(), r.b.flat()])),
        ("parameter_jacobian", parameter_jacobian(&x, &u, &p).map(|r| vec![r.flat()])),
        ("output_jacobian", Ok({ let r = output_jacobian(&x, &p); vec![r.by_x.flat(), r.by_p.flat()] })),
    ]
}

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
        ("pivots", Ok({ let r = pivots(&x, &p); vec![r.flat()] })),
        ("forward_dynamics", forward_dynamics(&x, &u, &p).map(|r| vec![r.to_array().flat()])),
        ("linearize", linearize(&x, &u, &p).map(|r| vec![r.dx.flat(), r.a.flat(), r.b.flat()])),
        ("parameter_jacobian", parameter_jacobian(&x, &u, &p).map(|r| vec![r.flat()])),
        ("output_jacobian", Ok({ let r = output_jacobian(&x, &p); vec![r.by_x.flat(), r.by_p.flat()] })),
    ]
}

fn chain3(given: &Arguments) -> Vec<Called> {
    use generated::chain3::*;
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
        ("pivots", Ok({ let r = pivots(&x, &p); vec![r.flat()] })),
        ("forward_dynamics", forward_dynamics(&x, &u, &p).map(|r| vec![r.to_array().flat()])),
        ("linearize", linearize(&x, &u, &p).map(|r| vec![r.dx.flat(), r.a.flat(), r.b.flat()])),
        ("parameter_jacobian", parameter_jacobian(&x, &u, &p).map(|r| vec![r.flat()])),
        ("output_jacobian", Ok({ let r = output_jacobian(&x, &p); vec![r.by_x.flat(), r.by_p.flat()] })),
    ]
}

fn double_pendulum(given: &Arguments) -> Vec<Called> {
    use generated::double_pendulum::*;
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
        ("pivots", Ok({ let r = pivots(&x, &p); vec![r.flat()] })),
        ("forward_dynamics", forward_dynamics(&x, &u, &p).map(|r| vec![r.to_array().flat()])),
        ("linearize", linearize(&x, &u, &p).map(|r| vec![r.dx.flat(), r.a.flat(), r.b.flat()])),
        ("linearize_without_friction_slope", linearize_without_friction_slope(&x, &u, &p).map(|r| vec![r.dx.flat(), r.a.flat(), r.b.flat()])),
        ("parameter_jacobian", parameter_jacobian(&x, &u, &p).map(|r| vec![r.flat()])),
        ("output_jacobian", Ok({ let r = output_jacobian(&x, &p); vec![r.by_x.flat(), r.by_p.flat()] })),
    ]
}

fn emps(given: &Arguments) -> Vec<Called> {
    use generated::emps::*;
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
        ("pivots", Ok({ let r = pivots(&x, &p); vec![r.flat()] })),
        ("forward_dynamics", forward_dynamics(&x, &u, &p).map(|r| vec![r.to_array().flat()])),
        ("linearize", linearize(&x, &u, &p).map(|r| vec![r.dx.flat(), r.a.flat(), r.b.flat()])),
        ("linearize_without_friction_slope", linearize_without_friction_slope(&x, &u, &p).map(|r| vec![r.dx.flat(), r.a.flat(), r.b.flat()])),
        ("parameter_jacobian", parameter_jacobian(&x, &u, &p).map(|r| vec![r.flat()])),
        ("output_jacobian", Ok({ let r = output_jacobian(&x, &p); vec![r.by_x.flat(), r.by_p.flat()] })),
    ]
}

fn flexible_joint(given: &Arguments) -> Vec<Called> {
    use generated::flexible_joint::*;
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
        ("pivots", Ok({ let r = pivots(&x, &p); vec![r.flat()] })),
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
        ("pivots", Ok({ let r = pivots(&x, &p); vec![r.flat()] })),
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
        ("pivots", Ok({ let r = pivots(&x, &p); vec![r.flat()] })),
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
        ("pivots", Ok({ let r = pivots(&x, &p); vec![r.flat()] })),
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
        ("pivots", Ok({ let r = pivots(&x, &p); vec![r.flat()] })),
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
        ("pivots", Ok({ let r = pivots(&x, &p); vec![r.flat()] })),
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
        ("pivots", Ok({ let r = pivots(&x, &p); vec![r.flat()] })),
        ("forward_dynamics", forward_dynamics(&x, &u, &p).map(|r| vec![r.to_array().flat()])),
        ("linearize", linearize(&x, &u, &p).map(|r| vec![r.dx.flat(), r.a.flat(), r.b.flat()])),
        ("parameter_jacobian", parameter_jacobian(&x, &u, &p).map(|r| vec![r.flat()])),
        ("output_jacobian", Ok({ let r = output_jacobian(&x, &p); vec![r.by_x.flat(), r.by_p.flat()] })),
    ]
}

fn quanser(given: &Arguments) -> Vec<Called> {
    use generated::quanser::*;
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
        ("pivots", Ok({ let r = pivots(&x, &p); vec![r.flat()] })),
        ("forward_dynamics", forward_dynamics(&x, &u, &p).map(|r| vec![r.to_array().flat()])),
        ("linearize", linearize(&x, &u, &p).map(|r| vec![r.dx.flat(), r.a.flat(), r.b.flat()])),
        ("parameter_jacobian", parameter_jacobian(&x, &u, &p).map(|r| vec![r.flat()])),
        ("output_jacobian", Ok({ let r = output_jacobian(&x, &p); vec![r.by_x.flat(), r.by_p.flat()] })),
    ]
}

fn quanser_ads(given: &Arguments) -> Vec<Called> {
    use generated::quanser_ads::*;
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
        ("pivots", Ok({ let r = pivots(&x, &p); vec![r.flat()] })),
        ("forward_dynamics", forward_dynamics(&x, &u, &p).map(|r| vec![r.to_array().flat()])),
        ("linearize", linearize(&x, &u, &p).map(|r| vec![r.dx.flat(), r.a.flat(), r.b.flat()])),
        ("parameter_jacobian", parameter_jacobian(&x, &u, &p).map(|r| vec![r.flat()])),
        ("output_jacobian", Ok({ let r = output_jacobian(&x, &p); vec![r.by_x.flat(), r.by_p.flat()] })),
    ]
}

fn quanser_ads_driven(given: &Arguments) -> Vec<Called> {
    use generated::quanser_ads_driven::*;
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
        ("generalized_force", Ok({ let r = generalized_force(&q, &v, &u, &p); vec![r.flat()] })),
        ("input_map", Ok({ let r = input_map(&q, &p); vec![r.flat()] })),
        ("kinetic_energy", Ok({ let r = kinetic_energy(&q, &v, &p); vec![r.flat()] })),
        ("potential_energy", Ok({ let r = potential_energy(&q, &p); vec![r.flat()] })),
        ("inverse_dynamics", Ok({ let r = inverse_dynamics(&x, &a, &u, &p); vec![r.flat()] })),
        ("outputs", Ok({ let r = outputs(&x, &p); vec![r.to_array().flat()] })),
        ("pivots", Ok({ let r = pivots(&x, &p); vec![r.flat()] })),
        ("forward_dynamics", forward_dynamics(&x, &u, &p).map(|r| vec![r.to_array().flat()])),
        ("linearize", linearize(&x, &u, &p).map(|r| vec![r.dx.flat(), r.a.flat(), r.b.flat()])),
        ("parameter_jacobian", parameter_jacobian(&x, &u, &p).map(|r| vec![r.flat()])),
        ("output_jacobian", Ok({ let r = output_jacobian(&x, &p); vec![r.by_x.flat(), r.by_p.flat()] })),
    ]
}

fn tree(given: &Arguments) -> Vec<Called> {
    use generated::tree::*;
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
        ("pivots", Ok({ let r = pivots(&x, &p); vec![r.flat()] })),
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
        "acrobot" => acrobot(given),
        "aero" => aero(given),
        "cart_pole" => cart_pole(given),
        "chain3" => chain3(given),
        "double_pendulum" => double_pendulum(given),
        "emps" => emps(given),
        "flexible_joint" => flexible_joint(given),
        "furuta" => furuta(given),
        "googol" => googol(given),
        "googol_eq13" => googol_eq13(given),
        "googol_identified" => googol_identified(given),
        "googol_mrb" => googol_mrb(given),
        "googol_srb" => googol_srb(given),
        "quanser" => quanser(given),
        "quanser_ads" => quanser_ads(given),
        "quanser_ads_driven" => quanser_ads_driven(given),
        "tree" => tree(given),
        _ => return None,
    })
}
