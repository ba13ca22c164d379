//! What went wrong, for people and for programs.

use model_dsl::Checked;
use serde_json::{Value, json};

/// Ends a command with exit code 1.
pub struct Failure {
    /// For standard error.
    pub text: String,
    /// For `diagnostics` of the JSON document.
    pub diagnostics: Vec<Value>,
    /// Further fields of the JSON document.
    pub fields: Vec<(&'static str, Value)>,
}

impl Failure {
    /// A failure that has no place in a rig file.
    pub fn new(code: &str, message: impl Into<String>) -> Self {
        let message = message.into();
        Self {
            text: format!("error[{code}]: {message}"),
            diagnostics: vec![json!({"code": code, "severity": "error", "message": message, "line": null, "column": null})],
            fields: Vec::new(),
        }
    }

    /// With a hint on how to mend it.
    pub fn with_help(mut self, help: &str) -> Self {
        self.text.push_str("\n  = help: ");
        self.text.push_str(help);
        self
    }

    /// The diagnostics of a rig that did not pass its checks.
    pub fn from_check(checked: &Checked, color: bool) -> Self {
        Self { text: crate::load::rendered(checked, color), diagnostics: crate::load::diagnostics_json(checked), fields: Vec::new() }
    }
}
