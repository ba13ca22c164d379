//! (on its way)

/// Not there yet.
pub fn run(_arguments: &[String]) -> Result<String, String> {
    Err("this task is not there yet".to_owned())
}
