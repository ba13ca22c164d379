//! The functions of an emitted model, the same in every language: name, documentation, arguments,
//! results and the roots behind them.

use crate::equations::{Equations, Linear, Variable};
use crate::expr::{Graph, Id, SymbolId, SymbolKind};

/// Vectors of a model that functions take and give.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Vector {
    /// t, a number.
    Time,
    /// x = [q | v | z]
    State,
    /// q
    Coordinates,
    /// v
    Rates,
    /// a
    Accelerations,
    /// z
    Lags,
    /// u
    Inputs,
    /// p
    Parameters,
    /// y
    Outputs,
}

impl Vector {
    /// The letter that it has in equations.
    #[must_use]
    pub fn letter(self) -> &'static str {
        match self {
            Self::Time => "t",
            Self::State => "x",
            Self::Coordinates => "q",
            Self::Rates => "v",
            Self::Accelerations => "a",
            Self::Lags => "z",
            Self::Inputs => "u",
            Self::Parameters => "p",
            Self::Outputs => "y",
        }
    }

    /// The vector in which a symbol stands.
    #[must_use]
    pub fn of(kind: SymbolKind) -> Self {
        match kind {
            SymbolKind::Coordinate(_) => Self::Coordinates,
            SymbolKind::Rate(_) => Self::Rates,
            SymbolKind::Acceleration(_) => Self::Accelerations,
            SymbolKind::Lag(_) => Self::Lags,
            SymbolKind::Signal(_) => Self::Inputs,
            SymbolKind::Parameter(_) | SymbolKind::Definition(_) | SymbolKind::Inertial(_) => Self::Parameters,
            SymbolKind::Time => Self::Time,
        }
    }

    /// One of the parts of the state.
    #[must_use]
    pub fn is_part_of_state(self) -> bool {
        matches!(self, Self::Coordinates | Self::Rates | Self::Lags)
    }
}

/// What one result looks like.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Shape {
    /// A number.
    Scalar,
    /// An array of this length.
    Array(usize),
    /// Rows, columns.
    Matrix(usize, usize),
    /// Rows, columns: one column a parameter, most of them zero in most rows.
    OverParameters(usize, usize),
    /// A vector with named entries.
    Named(Vector),
}

/// One result.
pub struct Output {
    /// Short name: `dx`, `a`, `b`.
    pub name: &'static str,
    /// What it is, with shape.
    pub doc: String,
    /// Shape.
    pub shape: Shape,
    /// Entries, row by row.
    pub roots: Vec<Id>,
    /// What the rows are: `psi`, `psi'`.
    pub rows: Vec<String>,
}

/// One function.
pub struct Function {
    /// Name: `mass_matrix`.
    pub name: String,
    /// Documentation, line by line.
    pub doc: Vec<String>,
    /// Arguments in order.
    pub arguments: Vec<Vector>,
    /// Results. Several of them make a record of the name `record`.
    pub outputs: Vec<Output>,
    /// Name of the record of several results.
    pub record: &'static str,
    /// Pivots that must be positive: (coordinate, value). `Some` for all functions that may find the mass
    /// matrix singular, even where every pivot is a positive number.
    pub pivots: Option<Vec<(usize, Id)>>,
}

impl Function {
    /// Some row over the parameters has zeros and other entries.
    pub(super) fn has_sparse_rows(&self, graph: &Graph) -> bool {
        self.outputs.iter().any(|o| o.has_sparse_rows(graph))
    }

    /// All roots: results, then pivots.
    #[must_use]
    pub fn roots(&self) -> Vec<Id> {
        let results = self.outputs.iter().flat_map(|o| o.roots.iter().copied());
        results.chain(self.pivots.iter().flatten().map(|p| p.1)).collect()
    }
}

impl Output {
    /// A row over the parameters that has zeros and other entries.
    fn has_sparse_rows(&self, graph: &Graph) -> bool {
        let Shape::OverParameters(_, columns) = self.shape else { return false };
        self.roots.chunks(columns.max(1)).any(|row| {
            let zeros = row.iter().filter(|&&id| graph.is_zero(id)).count();
            zeros > 0 && zeros < row.len()
        })
    }
}

/// All functions of a model, in the order in which they are written: what [`super::rust`] and [`super::c`] print.
#[must_use]
pub fn functions(e: &Equations) -> Vec<Function> {
    let l = &e.layout;
    let (n, m) = (l.q.len(), l.u.len());
    let q_names: Vec<String> = l.q.iter().map(|c| c.name.clone()).collect();
    let direct = e.coriolis.is_none();
    let unit = if direct {
        "[unit of the row]".to_owned()
    } else {
        let units: Vec<&str> = l.q.iter().map(|c| if c.unit == "m" { "N" } else { "N m" }).collect();
        match units.as_slice() {
            [] => String::new(),
            [first, rest @ ..] if rest.iter().all(|u| u == first) => format!("[{first}]"),
            _ => format!("[{}]", units.join(", ")),
        }
    };
    let rows = format!("rows ({})", q_names.join(", "));
    let array = |name: &'static str, doc: String, roots: &[Id]| Output {
        name,
        doc,
        shape: Shape::Array(roots.len()),
        roots: roots.to_vec(),
        rows: q_names.clone(),
    };
    let mut list = Vec::new();
    let mut simple = |name: &str, doc: Vec<String>, base: &[Vector], output: Output| {
        let arguments = arguments(e, base, &output.roots);
        list.push(Function { name: name.to_owned(), doc, arguments, outputs: vec![output], record: "", pivots: None });
    };
    use Vector::{Accelerations, Coordinates, Inputs, Parameters, Rates, State, Time};

    let flat = |rows: &[Vec<Id>]| rows.concat();
    simple(
        "mass_matrix",
        vec![format!("Mass matrix M(q), {n} x {n}, symmetric; {rows}.")],
        &[Coordinates, Parameters],
        Output { name: "m", doc: "M".into(), shape: Shape::Matrix(n, n), roots: flat(&e.mass_matrix), rows: q_names.clone() },
    );
    let parts = if direct { "terms without rates and inputs, on the left-hand side" } else { "velocity products + gravity + springs" };
    simple(
        "bias",
        vec![format!("Bias h(q, v) {unit}: {parts}; {rows}.")],
        &[Coordinates, Rates, Parameters],
        array("h", "h".into(), &e.bias),
    );
    if let Some(coriolis) = &e.coriolis {
        simple(
            "velocity_products",
            vec![format!("Velocity products C(q, v) v {unit}: Coriolis and centrifugal terms; {rows}.")],
            &[Coordinates, Rates, Parameters],
            array("c", "C v".into(), coriolis),
        );
    }
    let what = if direct {
        format!("Bias of the equations as written {unit}; {rows}.")
    } else {
        format!("Generalized gravity g(q) {unit}: what holds the rig still; {rows}.")
    };
    simple("gravity", vec![what], &[Coordinates, Parameters], array("g", "g".into(), &e.gravity));
    simple(
        "dissipation",
        vec![format!("Friction and dampers d(q, v) {unit}, on the left-hand side; {rows}.")],
        &[Coordinates, Rates, Parameters],
        array("d", "d".into(), &e.dissipation),
    );
    simple(
        "generalized_force",
        vec![format!("Generalized force Q {unit} of the inputs; {rows}.")],
        &[Coordinates, Inputs, Parameters],
        array("f", "Q".into(), &e.force),
    );
    if m > 0 {
        let signals: Vec<&str> = l.u.iter().map(|u| u.name.as_str()).collect();
        simple(
            "input_map",
            vec![format!("Input map dQ/du, {n} x {m}; {rows}, columns ({}).", signals.join(", "))],
            &[Coordinates, Parameters],
            Output { name: "s", doc: "dQ/du".into(), shape: Shape::Matrix(n, m), roots: flat(&e.input_map), rows: q_names.clone() },
        );
    }
    let scalar = |root: Id, doc: &str| Output { name: "e", doc: doc.into(), shape: Shape::Scalar, roots: vec![root], rows: Vec::new() };
    if let Some(kinetic) = e.kinetic {
        simple("kinetic_energy", vec!["Kinetic energy T(q, v) [J].".into()], &[Coordinates, Rates, Parameters], scalar(kinetic, "T"));
    }
    if let Some(potential) = e.potential {
        simple(
            "potential_energy",
            vec!["Potential energy V(q) [J]: gravity and springs.".into()],
            &[Coordinates, Parameters],
            scalar(potential, "V"),
        );
    }
    for (i, s, rate) in &e.trajectories {
        let name = &l.q[*i].name;
        simple(
            &format!("trajectory_{name}"),
            vec![format!("Prescribed motion of {name}: position [{}] and rate at time t.", l.q[*i].unit)],
            &[Time, Parameters],
            Output {
                name: "s",
                doc: "position and rate".into(),
                shape: Shape::Array(2),
                roots: vec![*s, *rate],
                rows: vec![name.clone(), format!("{name}'")],
            },
        );
    }
    if !e.lag_rates.is_empty() {
        let output = Output {
            name: "dz",
            doc: "z'".into(),
            shape: Shape::Array(l.z.len()),
            roots: e.lag_rates.clone(),
            rows: l.z.iter().map(|z| format!("{}'", z.name)).collect(),
        };
        simple("lag_rates", vec!["Rates z' of the actuator states [their unit/s].".into()], &[State, Inputs, Parameters], output);
    }
    simple(
        "inverse_dynamics",
        vec![
            format!("Inverse dynamics M a + h + d - Q {unit}: the generalized force that is missing for the accelerations a;"),
            "zero where a, v, q and u fit together.".into(),
        ],
        &[State, Accelerations, Inputs, Parameters],
        array("r", "M a + h + d - Q".into(), &e.inverse_dynamics),
    );
    if !l.outputs.is_empty() {
        let play = e.output_paths.iter().any(|path| e.graph.number_of(path.play) != Some(0.0));
        let left_out = if play { "delay, play and quantization" } else { "delay and quantization" };
        let output =
            Output { name: "y", doc: "y".into(), shape: Shape::Named(Vector::Outputs), roots: e.outputs.clone(), rows: Vec::new() };
        simple("outputs", vec![format!("Measured outputs y(x), with scale and bias, without {left_out}.")], &[State, Parameters], output);
    }
    if !e.pivots.is_empty() {
        simple(
            "pivots",
            vec![
                "Pivots D of M = L^T D L, one a free coordinate, eliminated from the last to the first: all positive where M is".into(),
                "positive definite; a vanishing one says which coordinate moves no inertia.".into(),
            ],
            &[State, Parameters],
            Output {
                name: "d",
                doc: "D".into(),
                shape: Shape::Array(e.pivots.len()),
                roots: e.pivots.clone(),
                rows: e.free.iter().map(|&i| l.q[i].name.clone()).collect(),
            },
        );
    }
    let pivots: Vec<(usize, Id)> =
        e.pivots_as_eliminated().into_iter().filter(|(_, d)| e.graph.number_of(*d).is_none_or(|x| x <= 0.0)).collect();
    let dynamics = arguments(e, &[State, Inputs, Parameters], &e.state_derivative());
    list.push(Function {
        name: "forward_dynamics".into(),
        doc: vec![
            "Forward dynamics: the accelerations a that solve M a + h + d = Q, by L^T D L of M.".into(),
            format!("{} operations.", e.forward_operations()),
        ],
        arguments: dynamics.clone(),
        outputs: vec![Output {
            name: "a",
            doc: "a".into(),
            shape: Shape::Named(Accelerations),
            roots: e.acceleration.clone(),
            rows: Vec::new(),
        }],
        record: "",
        pivots: Some(pivots.clone()),
    });
    let states = l.states();
    let state_rows: Vec<String> = l.x().map(rate_of).collect();
    let x_names: Vec<&str> = l.x().map(|x| x.name.as_str()).collect();
    let u_names: Vec<&str> = l.u.iter().map(|x| x.name.as_str()).collect();
    let mut linear = |name: &str, first: &str, linear: &Linear| {
        let mut doc = vec![first.to_owned(), format!("{} operations.", e.jacobian_operations()), String::new()];
        doc.push("Rows x', columns x | u: `.` is always zero, `1` always one, `*` computed.".into());
        doc.push("```text".into());
        doc.extend(pattern(&e.graph, &state_rows, &[(&x_names, &linear.a), (&u_names, &linear.b)]));
        doc.push("```".into());
        let mut outputs = vec![
            Output { name: "dx", doc: "x'".into(), shape: Shape::Array(states), roots: e.state_derivative(), rows: state_rows.clone() },
            Output {
                name: "a",
                doc: format!("A = dx'/dx, {states} x {states}"),
                shape: Shape::Matrix(states, states),
                roots: flat(&linear.a),
                rows: state_rows.clone(),
            },
        ];
        if m > 0 {
            outputs.push(Output {
                name: "b",
                doc: format!("B = dx'/du, {states} x {m}"),
                shape: Shape::Matrix(states, m),
                roots: flat(&linear.b),
                rows: state_rows.clone(),
            });
        }
        list.push(Function {
            name: name.into(),
            doc,
            arguments: dynamics.clone(),
            outputs,
            record: "Linearization",
            pivots: Some(pivots.clone()),
        });
    };
    if !e.linear.a.is_empty() {
        linear("linearize", "State derivative and its Jacobians A, B, exact, at any state.", &e.linear);
        if let Some(smooth) = &e.linear_without_friction_slope {
            linear(
                "linearize_without_friction_slope",
                "As [`linearize`], without the slope of regularized Coulomb friction (at rest an artefact of its width).",
                smooth,
            );
        }
        let np = l.p.len();
        if np > 0 {
            let output = Output {
                name: "by_p",
                doc: format!("dx'/dp, {states} x {np}"),
                shape: Shape::OverParameters(states, np),
                roots: flat(&e.parameter_jacobian),
                rows: state_rows.clone(),
            };
            list.push(Function {
                name: "parameter_jacobian".into(),
                doc: vec![format!("Parameter Jacobian dx'/dp, {states} x {np}; columns in the order of [`Parameters`].")],
                arguments: dynamics.clone(),
                outputs: vec![output],
                record: "",
                pivots: Some(pivots.clone()),
            });
        }
        let ny = l.outputs.len();
        if ny > 0 {
            let rows: Vec<String> = l.outputs.iter().map(|y| y.name.clone()).collect();
            let mut outputs = vec![Output {
                name: "by_x",
                doc: format!("C = dy/dx, {ny} x {states}"),
                shape: Shape::Matrix(ny, states),
                roots: flat(&e.output_jacobian),
                rows: rows.clone(),
            }];
            if np > 0 {
                outputs.push(Output {
                    name: "by_p",
                    doc: format!("dy/dp, {ny} x {np}"),
                    shape: Shape::OverParameters(ny, np),
                    roots: flat(&e.output_parameter_jacobian),
                    rows,
                });
            }
            let roots: Vec<Id> = outputs.iter().flat_map(|o| o.roots.iter().copied()).collect();
            list.push(Function {
                name: "output_jacobian".into(),
                doc: vec!["Jacobians of the measured outputs.".into()],
                arguments: arguments(e, &[State, Parameters], &roots),
                outputs,
                record: "OutputJacobian",
                pivots: None,
            });
        }
    }
    list
}

/// `psi'`, `psi''` for the entries of x'.
fn rate_of(x: &Variable) -> String {
    match x.name.strip_suffix(".dot") {
        Some(name) => format!("{name}''"),
        None => format!("{}'", x.name),
    }
}

/// The vectors of `base`, the same for every rig, and whatever else the roots depend on; empty vectors are left out.
pub fn arguments(e: &Equations, base: &[Vector], roots: &[Id]) -> Vec<Vector> {
    let mut all: Vec<Vector> = base.to_vec();
    for s in e.graph.symbols_of(roots) {
        let vector = Vector::of(e.graph.symbol_info(s).kind);
        let is_within_state = vector.is_part_of_state() && base.contains(&Vector::State);
        if !is_within_state && !all.contains(&vector) {
            all.push(vector);
        }
    }
    all.sort_unstable();
    all.retain(|&v| !entries(e, v).is_some_and(<[Variable]>::is_empty));
    all
}

/// The variables of a vector that is one list of them.
pub fn entries(e: &Equations, vector: Vector) -> Option<&[Variable]> {
    let l = &e.layout;
    Some(match vector {
        Vector::Coordinates => &l.q,
        Vector::Rates => &l.v,
        Vector::Accelerations => &l.a,
        Vector::Lags => &l.z,
        Vector::Inputs => &l.u,
        Vector::Parameters => &l.p,
        Vector::Time | Vector::State | Vector::Outputs => return None,
    })
}

/// The symbol's place in its vector.
pub fn place(graph: &Graph, symbol: SymbolId) -> usize {
    match graph.symbol_info(symbol).kind {
        SymbolKind::Coordinate(i)
        | SymbolKind::Rate(i)
        | SymbolKind::Acceleration(i)
        | SymbolKind::Lag(i)
        | SymbolKind::Signal(i)
        | SymbolKind::Parameter(i)
        | SymbolKind::Definition(i)
        | SymbolKind::Inertial(i) => i,
        SymbolKind::Time => 0,
    }
}

/// Zeros, ones and the rest of matrices side by side.
fn pattern(g: &Graph, rows: &[String], blocks: &[(&[&str], &Vec<Vec<Id>>)]) -> Vec<String> {
    let margin = rows.iter().map(|r| r.chars().count()).max().unwrap_or(0);
    let mut lines = Vec::new();
    // column names where they fit, numbers of columns are clear from them
    let width: usize = blocks.iter().flat_map(|(names, _)| names.iter().map(|n| n.chars().count() + 1)).sum();
    let named = margin + width < 120;
    if named {
        let heads: Vec<String> = blocks.iter().map(|(names, _)| names.join(" ")).collect();
        lines.push(format!("{:margin$}  {}", "", heads.join(" | ")).trim_end().to_owned());
    }
    for (i, row) in rows.iter().enumerate() {
        let sides: Vec<String> = blocks
            .iter()
            .filter(|(names, _)| !names.is_empty())
            .map(|(names, matrix)| {
                let entries = names.iter().zip(&matrix[i]).map(|(name, &id)| {
                    let mark = match g.number_of(id) {
                        Some(0.0) => ".",
                        Some(1.0) => "1",
                        _ => "*",
                    };
                    let width = if named { name.chars().count() } else { 1 };
                    format!("{mark:width$}")
                });
                entries.collect::<Vec<_>>().join(" ")
            })
            .collect();
        lines.push(format!("{row:margin$}  {}", sides.join(" | ")).trim_end().to_owned());
    }
    lines
}
