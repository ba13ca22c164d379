//! How deriving, compiling and calling grow with the number of joints.

use crate::ours;
use crate::rigs;
use crate::steps::SHAPES;
use crate::table::Table;

const JOINTS: [usize; 9] = [2, 3, 4, 6, 8, 10, 15, 20, 30];

/// Table of growth for planar chains, spatial chains and trees.
///
/// # Errors
/// What deriving says.
pub fn table() -> Result<Table, String> {
    let mut table = Table::new(
        "growth with the number of joints",
        &["joints", "shape", "derive [ms]", "ops x'", "ops [A, B]", "compile x' [ms]", "[A, B] [ms]", "call x' [ns]", "[A, B] [ns]"],
    );
    for (shape, name) in SHAPES {
        for n in JOINTS {
            let rig = rigs::check("family", &rigs::family(shape, n))?;
            let (f, _) = ours::measure(&rig, if n > 10 { 2 } else { 5 })?;
            let ms = |x: f64| format!("{x:.1}");
            let ns = |x: f64| format!("{x:.0}");
            let [forward, linear] = f.operations.map(|n| n.to_string());
            table.row(vec![
                n.to_string(),
                name.to_owned(),
                ms(f.derive_ms),
                forward,
                linear,
                ms(f.compile_ms[0]),
                ms(f.compile_ms[1]),
                ns(f.call_ns[0]),
                ns(f.call_ns[1]),
            ]);
        }
    }
    Ok(table)
}
