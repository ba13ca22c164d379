//! The steady-state Kalman filter of a controller as code: correct the prediction by what is read, predict by what is held.

use super::{Controller, list};
use crate::emit::form::number;
use std::fmt::Write;

/// A predictor-corrector in deviations from an operating point: x^ = x- + M (y - y* - C x-), then x- <- A x^ + B u + b.
#[derive(Clone, Debug, PartialEq)]
pub struct Kalman {
    /// Names of the states (n).
    pub states: Vec<String>,
    /// A, row by row (n x n).
    pub a: Vec<Vec<f64>>,
    /// B by the rig's inputs (n x signals).
    pub b: Vec<Vec<f64>>,
    /// b: drift of the operating point, less B u* (n).
    pub constant: Vec<f64>,
    /// C (channels x n).
    pub c: Vec<Vec<f64>>,
    /// M (n x channels).
    pub correction: Vec<Vec<f64>>,
    /// Instead of M at the first sample (n x channels).
    pub first: Vec<Vec<f64>>,
    /// x* (n).
    pub x: Vec<f64>,
    /// y*, as the channels are read.
    pub y: Vec<f64>,
    /// For each channel, the states that are its value and its rate.
    pub shown: Vec<(Option<usize>, Option<usize>)>,
}

/// Names that the code of a filter uses.
pub(super) const LOCALS: [&str; 7] = ["shown", "predicted", "gain", "innovation", "corrected", "estimated", "started"];

/// Name, documentation, rows and a remark for each.
type Table = (&'static str, String, Vec<Vec<f64>>, Vec<String>);

fn tables(c: &Controller, k: &Kalman) -> [Table; 5] {
    let channels: Vec<String> = c.channels.iter().map(|c| c.name.clone()).collect();
    let signals: Vec<&str> = c.signals.iter().map(|s| s.name.as_str()).collect();
    let read = channels.join(", ");
    [
        ("PREDICTION", "The Kalman filter's model over a period, one row a state.".to_owned(), k.a.clone(), k.states.clone()),
        ("INFLUENCE", format!("How the inputs ({}) move it.", signals.join(", ")), k.b.clone(), k.states.clone()),
        ("SEEN", "What is read of its states.".to_owned(), k.c.clone(), channels),
        ("CORRECTION", format!("Its gain: how ({read}) correct the states."), k.correction.clone(), k.states.clone()),
        ("FIRST", format!("The same at the first sample: ({read}) as they are."), k.first.clone(), k.states.clone()),
    ]
}

fn vectors(k: &Kalman) -> [(&'static str, String, &[f64]); 3] {
    [
        ("CONSTANT", "What the operating point adds to a prediction.".to_owned(), &k.constant),
        ("STATES", format!("States of the operating point: {}.", k.states.join(", ")), &k.x),
        ("OUTPUTS", "What is read at the operating point.".to_owned(), &k.y),
    ]
}

/// Constants in Rust.
pub(super) fn constants_rust(out: &mut String, c: &Controller, k: &Kalman) {
    for (name, doc, rows, remarks) in tables(c, k) {
        super::rust::matrix(out, &doc, name, &rows, &remarks, false);
    }
    for (name, doc, values) in vectors(k) {
        let _ = writeln!(out, "/// {doc}\nconst {name}: [f64; {}] = [{}];\n", values.len(), list(values));
    }
}

/// Constants in C.
pub(super) fn constants_c(out: &mut String, c: &Controller, k: &Kalman) {
    for (name, doc, rows, remarks) in tables(c, k) {
        super::c::matrix(out, &doc, name, &rows, &remarks);
    }
    for (name, doc, values) in vectors(k) {
        let _ = writeln!(out, "/* {doc} */\nstatic const double {name}[{}] = {{{}}};\n", values.len(), list(values));
    }
}

/// The correction in Rust; `read` are the readings, unwrapped.
pub(super) fn correct_rust(out: &mut String, k: &Kalman, read: &[String]) {
    let (n, p) = (k.states.len(), k.y.len());
    let _ = write!(
        out,
        "        // the Kalman filter corrects its prediction by what is read\n        let shown = [{}];\n        \
         let predicted = self.predicted.unwrap_or([0.0; {n}]);\n        \
         let gain = if self.predicted.is_some() {{ &CORRECTION }} else {{ &FIRST }};\n        \
         let innovation: [f64; {p}] = core::array::from_fn(|i| shown[i] - OUTPUTS[i] - dot(&SEEN[i], &predicted));\n        \
         let corrected: [f64; {n}] = core::array::from_fn(|i| predicted[i] + dot(&gain[i], &innovation));\n        \
         let estimated: [f64; {n}] = core::array::from_fn(|i| corrected[i] + STATES[i]);\n",
        read.join(", ")
    );
}

/// The prediction in Rust.
pub(super) const PREDICT_RUST: &str = "        // its prediction for the next sample\n        \
    self.predicted = Some(core::array::from_fn(|i| dot(&PREDICTION[i], &corrected) + dot(&INFLUENCE[i], &u) + CONSTANT[i]));\n";

/// The correction in C.
pub(super) fn correct_c(out: &mut String, k: &Kalman, read: &[String]) {
    let (n, p) = (k.states.len(), k.y.len());
    let _ = write!(
        out,
        "    /* the Kalman filter corrects its prediction by what is read */\n    const double shown[{p}] = {{{}}};\n    \
         double innovation[{p}], corrected[{n}], estimated[{n}];\n    \
         for (int i = 0; i < {p}; i++) {{\n        innovation[i] = shown[i] - OUTPUTS[i] - dot(SEEN[i], memory->predicted, {n});\n    }}\n    \
         for (int i = 0; i < {n}; i++) {{\n        \
         corrected[i] = memory->predicted[i] + dot(memory->started ? CORRECTION[i] : FIRST[i], innovation, {p});\n        \
         estimated[i] = corrected[i] + STATES[i];\n    }}\n",
        read.join(", ")
    );
}

/// The prediction in C; `m` inputs.
pub(super) fn predict_c(out: &mut String, k: &Kalman, m: usize) {
    let n = k.states.len();
    let _ = write!(
        out,
        "    /* its prediction for the next sample */\n    for (int i = 0; i < {n}; i++) {{\n        \
         memory->predicted[i] = dot(PREDICTION[i], corrected, {n}) + dot(INFLUENCE[i], u, {m}) + CONSTANT[i];\n    }}\n"
    );
}

/// Line for the header of a controller.
pub(super) fn about(k: &Kalman) -> String {
    format!("The states ({}) come from a steady-state Kalman filter on the model at the operating point.", k.states.join(", "))
}

/// The operating value of a state, as an entry of the deviation: `estimated[3] - 0.5`.
pub(super) fn deviation(k: &Kalman, state: usize) -> String {
    let at = k.x.get(state).copied().unwrap_or(0.0);
    if at == 0.0 { format!("estimated[{state}]") } else { format!("estimated[{state}] - {}", number(at)).replace("- -", "+ ") }
}
