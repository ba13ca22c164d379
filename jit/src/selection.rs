//! Programs for a selection of parameters: x', A and some columns of df/dp together, so that what they share is computed
//! once and what nobody asks for is not.

use crate::program::Program;
use std::sync::OnceLock;

/// Selections that are kept; a fit uses one or two.
const KEPT: usize = 8;

/// Programs by their columns. Looked up without a lock.
#[derive(Default)]
pub(crate) struct Selections([OnceLock<(Vec<usize>, Program)>; KEPT]);

impl Selections {
    /// The program of these columns, made by `make` when it is first asked for; `None` where all places are taken.
    pub fn get(&self, columns: &[usize], make: impl Fn() -> Program) -> Option<&Program> {
        for place in &self.0 {
            let (kept, program) = place.get_or_init(|| (columns.to_vec(), make()));
            if kept == columns {
                return Some(program);
            }
        }
        None
    }
}
