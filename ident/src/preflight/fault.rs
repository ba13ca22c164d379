//! A fault of a record: what, how it was seen, how to mend it.

use super::change::Change;
use super::suspects::Suspect;
use super::timing::Gap;

/// A fault in one record.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// Record.
    pub record: String,
    /// What.
    pub kind: FaultKind,
}

/// Kinds of faults.
#[derive(Clone, Debug, PartialEq)]
pub enum FaultKind {
    /// Model and record agree much better after a change: a turned sign, exchanged columns, a wrong unit, a wrong zero, an
    /// input of another run, a parameter of the wrong sign.
    Contradicts(Suspect),
    /// Samples are missing.
    Gaps(
        /// All of them, at least one.
        Vec<Gap>,
    ),
    /// The output never changes while others move.
    Dead {
        /// Output.
        output: String,
        /// Its value (SI).
        value: f64,
    },
    /// The encoder's step is another than the rig declares.
    Quantum {
        /// Output.
        output: String,
        /// In the increments (SI).
        seen: f64,
        /// In the rig (SI).
        declared: f64,
        /// Unit.
        unit: String,
    },
    /// The input goes beyond the rig's limits, which the model clips.
    BeyondLimits {
        /// Input.
        input: String,
        /// Share of the samples.
        share: f64,
        /// Range of the record.
        range: (f64, f64),
        /// Limits of the rig.
        limits: (f64, f64),
        /// Unit.
        unit: String,
    },
}

impl Fault {
    /// The word for JSON.
    #[must_use]
    pub fn id(&self) -> &'static str {
        match &self.kind {
            FaultKind::Contradicts(s) => s.change.id(),
            FaultKind::Gaps(_) => "gaps",
            FaultKind::Dead { .. } => "dead_channel",
            FaultKind::Quantum { .. } => "quantum",
            FaultKind::BeyondLimits { .. } => "beyond_limits",
        }
    }

    /// Channels (or the parameter) concerned.
    #[must_use]
    pub fn channels(&self) -> Vec<String> {
        match &self.kind {
            FaultKind::Contradicts(s) => s.change.channels(),
            FaultKind::Gaps(_) => vec!["t".to_owned()],
            FaultKind::Dead { output, .. } | FaultKind::Quantum { output, .. } => vec![output.clone()],
            FaultKind::BeyondLimits { input, .. } => vec![input.clone()],
        }
    }

    /// What is wrong and how it was seen, as one sentence.
    #[must_use]
    pub fn sentence(&self) -> String {
        match &self.kind {
            FaultKind::Contradicts(s) => {
                let mut text = s.change.claim();
                for (k, other) in s.alternatives.iter().enumerate() {
                    let glue = if k == 0 { "; or, as good an explanation: " } else { "; or " };
                    text.push_str(glue);
                    text.push_str(&other.claim());
                }
                let after = if matches!(s.change, Change::Foreign(_)) { "with inputs held at their means" } else { "after the change" };
                format!(
                    "{text} (the model leaves {} of the accelerations of `{}` unexplained, {} {after})",
                    percent(s.unexplained.0),
                    s.equation,
                    percent(s.unexplained.1)
                )
            }
            FaultKind::Gaps(gaps) => {
                let longest = gaps.iter().fold(gaps[0], |m, g| if g.length > m.length { *g } else { m });
                let count = if gaps.len() == 1 {
                    "samples are missing in one place".to_owned()
                } else {
                    format!("samples are missing in {} places", gaps.len())
                };
                format!("{count}, the longest gap is {} s after t = {} s", short(longest.length), short(longest.after))
            }
            FaultKind::Dead { output, value } => {
                format!(
                    "`{output}` never changes (it is {} throughout) while other outputs move: a dead channel, or a locked axis",
                    short(*value)
                )
            }
            FaultKind::Quantum { output, seen, declared, unit } => {
                let per = |q: f64| {
                    if unit == "rad" {
                        format!("{:.0} counts a turn", std::f64::consts::TAU / q)
                    } else {
                        format!("{:.0} counts per {unit}", 1.0 / q)
                    }
                };
                let ratio = seen / declared;
                let hint = if unit == "rad" && (ratio.to_radians() - 1.0).abs() < 0.03 {
                    ": 57.3 times as much, as of degrees that are read as radians"
                } else if [0.25, 0.5, 2.0, 4.0].iter().any(|r| (ratio / r - 1.0).abs() < 0.02) {
                    ": a factor of two or four is usual where edges are counted differently"
                } else {
                    ""
                };
                format!(
                    "`{output}` moves in steps of {} {unit} ({}), the rig's encoder has {} {unit} ({}){hint}",
                    short(*seen),
                    per(*seen),
                    short(*declared),
                    per(*declared)
                )
            }
            FaultKind::BeyondLimits { input, share, range, limits, unit } => format!(
                "`{input}` runs from {} to {} {unit}, beyond the rig's limits {}..{} in {} of the samples; the model clips it there",
                short(range.0),
                short(range.1),
                short(limits.0),
                short(limits.1),
                percent(*share)
            ),
        }
    }

    /// How to mend it.
    #[must_use]
    pub fn mend(&self) -> String {
        match &self.kind {
            FaultKind::Contradicts(s) => s.change.mend(),
            FaultKind::Gaps(_) => "use the parts between the gaps as records of their own (`from`, `to` in a description)".to_owned(),
            FaultKind::Dead { output, .. } => {
                format!("leave `{output}` out of the record if its axis was locked; otherwise check its cable and its column")
            }
            FaultKind::Quantum { output, seen, unit, .. } => {
                let counts = if unit == "rad" { std::f64::consts::TAU / seen } else { 1.0 / seen };
                format!("check the unit of the column; if it is right, write `encoder {output}: {counts:.0};` in the rig")
            }
            FaultKind::BeyondLimits { input, .. } => {
                format!(
                    "check the sign and the unit of `{input}`; if they are right, widen the limits in the rig, or log what the amplifier sent out"
                )
            }
        }
    }
}

fn percent(x: f64) -> String {
    if x < 0.0095 { format!("{:.1} %", 100.0 * x) } else { format!("{:.0} %", 100.0 * x) }
}

fn short(x: f64) -> String {
    let text = format!("{x:.4}");
    if x != 0.0 && x.abs() < 0.01 { format!("{x:.3e}") } else { text.trim_end_matches('0').trim_end_matches('.').to_owned() }
}
