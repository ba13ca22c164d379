//! A checked expression back to text, as it was written.

use model_dsl::rig::{BinaryOp, Expr, Rig, Symbol};

/// Text of a checked expression with the rig's names.
#[must_use]
pub fn plain(rig: &Rig, expr: &Expr) -> String {
    write(rig, expr, 0)
}

fn write(rig: &Rig, expr: &Expr, outer: u8) -> String {
    let (text, own) = match expr {
        Expr::Number(x) => (format!("{x}"), if *x < 0.0 { 2 } else { 5 }),
        Expr::Symbol(s) => (name(rig, *s), 5),
        Expr::Neg(a) => (format!("-{}", write(rig, a, 3)), 2),
        Expr::Binary(op, a, b) => {
            let (sign, own, left, right) = match op {
                BinaryOp::Add => (" + ", 1, 1, 1),
                BinaryOp::Sub => (" - ", 1, 1, 2),
                BinaryOp::Mul => (" ", 3, 3, 3),
                BinaryOp::Div => ("/", 3, 3, 4),
                BinaryOp::Pow => ("^", 4, 5, 4),
            };
            (format!("{}{sign}{}", write(rig, a, left), write(rig, b, right)), own)
        }
        Expr::Call(f, args) => {
            let args: Vec<String> = args.iter().map(|a| write(rig, a, 0)).collect();
            (format!("{}({})", format!("{f:?}").to_lowercase(), args.join(", ")), 5)
        }
    };
    if own < outer { format!("({text})") } else { text }
}

fn name(rig: &Rig, symbol: Symbol) -> String {
    match symbol {
        Symbol::Time => "t".to_owned(),
        Symbol::Parameter(i) => rig.parameters[i].name.clone(),
        Symbol::Definition(i) => rig.definitions[i].name.clone(),
        Symbol::Coordinate(i) => rig.coordinates[i].name.clone(),
        Symbol::Rate(i) => format!("{}'", rig.coordinates[i].name),
        Symbol::Acceleration(i) => format!("{}''", rig.coordinates[i].name),
        Symbol::Input(i) => rig.inputs[i].name.clone(),
        Symbol::Actuator(i) => rig.actuators[i].name.clone(),
        Symbol::Mixed(mix, row) => rig.mixes[mix].names[row].clone(),
    }
}
