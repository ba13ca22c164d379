//! The checked rig: what the front end hands over, and the only way into the derivation.
//!
//! Knows: names resolved to indices, numbers in SI units and radians, dimensions that have been
//! checked, frames in an order in which parents stand before their children. Knows nothing of
//! text, of derivation and of code. `#[non_exhaustive]` keeps other crates from building a [`Rig`]
//! by hand: it comes out of [`crate::check`] only.

use crate::units::Unit;

/// Byte range in one of the source files of a rig.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Span {
    /// Index into the source map.
    pub file: u32,
    /// First byte.
    pub start: u32,
    /// One past the last byte.
    pub end: u32,
}

/// A rig whose names, dimensions and mechanics have been checked.
#[non_exhaustive]
#[derive(Clone, Debug)]
pub struct Rig {
    /// Name after the word `rig`, as written (`GoogolMrb`).
    pub name: String,
    /// `///` lines above `rig`; the first line is the title.
    pub doc: String,
    /// Everything with a value: `param`, `const`, and a `lump` that was given a value of its own.
    /// The order is that of declaration (base rig first) and is the order of `p` everywhere.
    pub parameters: Vec<Parameter>,
    /// `lump` and `derived`: names for expressions over parameters (and other definitions that
    /// stand earlier in this list).
    pub definitions: Vec<Definition>,
    /// Generalized coordinates in order of declaration, prescribed ones too.
    pub coordinates: Vec<Coordinate>,
    /// Physical actuators' commands, in order of declaration; the order of `u`.
    pub inputs: Vec<Input>,
    /// Input paths; an actuator with a lag adds one state, in this order (`z`).
    pub actuators: Vec<Actuator>,
    /// Invertible linear changes of inputs.
    pub mixes: Vec<Mix>,
    /// Frames, parents before children. Ground is not in the list.
    pub frames: Vec<Frame>,
    /// Rigid bodies.
    pub bodies: Vec<Body>,
    /// Acceleration of gravity as a vector in ground [m/s^2]; components over parameters (and time).
    pub gravity: Option<Gravity>,
    /// Applied forces, torques and generalized forces.
    pub forces: Vec<Force>,
    /// Springs, on coordinates or between two points.
    pub springs: Vec<Spring>,
    /// Friction and dampers on coordinates.
    pub frictions: Vec<Friction>,
    /// Dampers between two points.
    pub dampers: Vec<Damper>,
    /// Potential energies, kinetic energies and dissipation functions written directly.
    pub functions: Vec<EnergyFunction>,
    /// Equations of motion written directly. Empty, or one for each free coordinate.
    pub equations: Vec<Equation>,
    /// Measured outputs in order of declaration; where none is declared, every coordinate.
    pub outputs: Vec<Output>,
    /// Named operating points.
    pub trims: Vec<Trim>,
    /// Assumptions in order of declaration.
    pub assumptions: Vec<Assumption>,
}

/// One entry of `p`.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Name.
    pub name: String,
    /// Text after `//` or `///` that belongs to it.
    pub doc: String,
    /// Declared unit, for display.
    pub unit: Unit,
    /// Value in SI.
    pub value: f64,
    /// Standard deviation of the prior, SI (`+- 5 %` of the value).
    pub prior_sd: Option<f64>,
    /// Bounds in SI.
    pub bounds: Option<(f64, f64)>,
    /// `fixed`, or declared by `const`.
    pub fixed: bool,
    /// Declared by `const`.
    pub constant: bool,
    /// `per record`: belongs to the day, not to the plant.
    pub per_record: bool,
    /// For a `lump` with a value: the index of its definition.
    pub definition: Option<usize>,
    /// Where it was declared.
    pub span: Span,
}

/// `lump` or `derived`.
#[derive(Clone, Debug)]
pub struct Definition {
    /// Name.
    pub name: String,
    /// Comment that belongs to it.
    pub doc: String,
    /// Declared or inferred unit.
    pub unit: Unit,
    /// What it stands for, over parameters and earlier definitions.
    pub value: Expr,
    /// `lump`: shown by its name in equations. `derived`: always expanded in equations.
    pub is_lump: bool,
    /// For a `lump` with a value: the index of its parameter. Uses of its name in the rig are
    /// then `Symbol::Definition`, and mean the parameter unless lumps are expanded.
    pub parameter: Option<usize>,
    /// Where it was declared.
    pub span: Span,
}

/// A generalized coordinate.
#[derive(Clone, Debug)]
pub struct Coordinate {
    /// Name.
    pub name: String,
    /// Comment that belongs to it.
    pub doc: String,
    /// rad or m.
    pub unit: Unit,
    /// Range of travel in SI, for plots, random states and hard stops.
    pub range: Option<(f64, f64)>,
    /// Moved from outside: its acceleration is an exogenous signal `name.ddot`, its equation is dropped.
    pub prescribed: bool,
    /// For `prescribed NAME = EXPR`: the trajectory over time and parameters.
    pub trajectory: Option<Expr>,
    /// Where it was declared.
    pub span: Span,
}

/// Command to a physical actuator.
#[derive(Clone, Debug)]
pub struct Input {
    /// Name.
    pub name: String,
    /// Comment that belongs to it.
    pub doc: String,
    /// Unit.
    pub unit: Unit,
    /// Limits in SI; applied where signals enter the model (simulation, control), not in the equations.
    pub limits: Option<(f64, f64)>,
    /// Where it was declared.
    pub span: Span,
}

/// Input path: command (delayed) -> map -> dead zone -> saturation -> lag.
///
/// `input f_1: N { lag 0.1 s; }` gives an actuator of the input's own name; uses of that name
/// outside the actuator's own map are then `Symbol::Actuator`.
#[derive(Clone, Debug)]
pub struct Actuator {
    /// Name.
    pub name: String,
    /// Comment that belongs to it.
    pub doc: String,
    /// Unit of what comes out.
    pub unit: Unit,
    /// Static map over inputs, parameters, and actuators that stand earlier; may read coordinates
    /// and rates (back-EMF).
    pub map: Expr,
    /// Delay of the inputs [s]; lives in the signal path, not in the state.
    pub delay: Option<Expr>,
    /// Half width of the dead zone, in the actuator's unit.
    pub dead_zone: Option<Expr>,
    /// Saturation, in the actuator's unit.
    pub saturation: Option<(Expr, Expr)>,
    /// Time constant of the first-order lag [s]: tau z' = w - z. Its state is called `name.lag`.
    pub lag: Option<Expr>,
    /// Where it was declared.
    pub span: Span,
}

/// `mix { f_s = f_1 + f_2; f_d = f_1 - f_2; }`: new inputs as linear combinations of all old ones.
#[derive(Clone, Debug)]
pub struct Mix {
    /// New names, units and rows: `rows[i][j]` is the coefficient of input `inputs[j]` in `names[i]`.
    pub names: Vec<String>,
    /// Units of the new inputs.
    pub units: Vec<Unit>,
    /// Indices of the inputs that are mixed; as many as `names`.
    pub inputs: Vec<usize>,
    /// The matrix, invertible.
    pub rows: Vec<Vec<f64>>,
    /// Where it was declared.
    pub span: Span,
}

/// Ground, or a frame of the rig.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FrameRef {
    /// The inertial frame; z is up unless gravity says otherwise.
    Ground,
    /// Index into `Rig::frames`.
    Frame(usize),
}

/// A frame, reached from its parent by elementary steps.
#[derive(Clone, Debug)]
pub struct Frame {
    /// Name.
    pub name: String,
    /// Comment that belongs to it.
    pub doc: String,
    /// Parent.
    pub parent: FrameRef,
    /// Steps, each in the frame that the steps before it have reached.
    pub steps: Vec<Step>,
    /// Where it was declared.
    pub span: Span,
}

/// One elementary step of a frame chain.
#[derive(Clone, Debug)]
pub enum Step {
    /// Right-handed rotation about an axis through the current origin; the angle is affine in the
    /// coordinates with coefficients over parameters.
    Rotate {
        /// Axis in the current frame.
        axis: Axis,
        /// Angle [rad].
        angle: Expr,
    },
    /// Translation in the current frame [m]; each component is affine in the coordinates.
    Translate([Expr; 3]),
}

/// Axis of a rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Axis {
    /// x, y or z (0, 1, 2), or its opposite.
    Principal {
        /// 0, 1, 2 for x, y, z.
        index: usize,
        /// `-x`.
        negative: bool,
    },
    /// A unit vector.
    Vector([f64; 3]),
}

/// A rigid body.
#[derive(Clone, Debug)]
pub struct Body {
    /// Name.
    pub name: String,
    /// Comment that belongs to it.
    pub doc: String,
    /// The frame that it is fixed to.
    pub frame: FrameRef,
    /// Mass [kg].
    pub mass: Expr,
    /// Centre of mass in the frame [m].
    pub center: [Expr; 3],
    /// Tensor entries Ixx, Iyy, Izz, Ixy, Ixz, Iyz in the frame's axes [kg m^2]
    /// (products are minus the integrals).
    pub inertia: [Expr; 6],
    /// The point that the inertia is about.
    pub about: InertiaPoint,
    /// Where it was declared.
    pub span: Span,
}

/// The point that an inertia tensor is stated about.
#[derive(Clone, Debug)]
pub enum InertiaPoint {
    /// The centre of mass (default).
    CenterOfMass,
    /// The origin of the body's frame.
    FrameOrigin,
}

/// Gravity.
#[derive(Clone, Debug)]
pub struct Gravity {
    /// Acceleration of free fall in ground [m/s^2], e.g. (0, 0, -g).
    pub acceleration: [Expr; 3],
    /// The direction as written, where it is a vector in parentheses; checked to have length one.
    pub direction: Option<[Expr; 3]>,
    /// Where it was declared.
    pub span: Span,
}

/// An applied force, torque or generalized force.
#[derive(Clone, Debug)]
pub struct Force {
    /// Name.
    pub name: String,
    /// Comment that belongs to it.
    pub doc: String,
    /// What it is and where it acts.
    pub kind: ForceKind,
    /// Where it was declared.
    pub span: Span,
}

/// Kinds of applied forces.
#[derive(Clone, Debug)]
pub enum ForceKind {
    /// Force at a point of a frame.
    Force {
        /// The frame it pushes.
        frame: FrameRef,
        /// Point of application, in `frame` [m].
        point: [Expr; 3],
        /// Components [N], in the axes of `axes`.
        vector: [Expr; 3],
        /// `in ground`: the frame whose axes the components are in (default: `frame`).
        axes: FrameRef,
        /// `against FRAME`: the reaction acts on this frame at the same point of space.
        against: Option<FrameRef>,
    },
    /// Torque on a frame.
    Torque {
        /// The frame it turns.
        frame: FrameRef,
        /// Components [N m], in the axes of `axes`.
        vector: [Expr; 3],
        /// The frame whose axes the components are in (default: `frame`).
        axes: FrameRef,
        /// `against FRAME`: the reaction acts on this frame.
        against: Option<FrameRef>,
    },
    /// Generalized force on one coordinate, in the unit of its equation.
    Generalized {
        /// Coordinate.
        coordinate: usize,
        /// Value.
        value: Expr,
    },
}

/// Something that acts along a scalar: a coordinate combination or the distance of two points.
#[derive(Clone, Debug)]
pub enum Along {
    /// An affine combination of coordinates.
    Coordinate(Expr),
    /// Distance between two points.
    Points {
        /// First frame and point in it [m].
        from: (FrameRef, [Expr; 3]),
        /// Second frame and point in it [m].
        to: (FrameRef, [Expr; 3]),
    },
}

/// Potential 1/2 k (x - rest)^2 + 1/4 k_3 (x - rest)^4.
#[derive(Clone, Debug)]
pub struct Spring {
    /// Name.
    pub name: String,
    /// What is stretched.
    pub along: Along,
    /// k.
    pub stiffness: Expr,
    /// Rest position or length; zero where it was not given.
    pub rest: Expr,
    /// k_3; zero where it was not given.
    pub cubic: Expr,
    /// Where it was declared.
    pub span: Span,
}

/// Friction along an affine combination s of coordinates with rate v = s'. The friction force
/// (on the left-hand side, opposing motion where the constants are positive) is
/// viscous v + (coulomb + stribeck exp(-(v/stribeck_speed)^2)) tanh(v/width)
/// + quadratic v abs(v) + asymmetric_slope abs(v) + asymmetric_offset.
#[derive(Clone, Debug)]
pub struct Friction {
    /// Name: the coordinate's, or the one given.
    pub name: String,
    /// s.
    pub of: Expr,
    /// Viscous coefficient.
    pub viscous: Option<Expr>,
    /// Coulomb level.
    pub coulomb: Option<Expr>,
    /// Width of the regularization, unit of v; set where `coulomb` or `stribeck` is.
    pub width: Option<Expr>,
    /// Excess of static friction over Coulomb friction, and the Stribeck speed.
    pub stribeck: Option<(Expr, Expr)>,
    /// Quadratic drag.
    pub quadratic: Option<Expr>,
    /// Slope and offset of the asymmetric part.
    pub asymmetric: Option<(Expr, Expr)>,
    /// Where it was declared.
    pub span: Span,
}

/// Viscous damper between two points.
#[derive(Clone, Debug)]
pub struct Damper {
    /// Name.
    pub name: String,
    /// The points.
    pub along: Along,
    /// Coefficient [N s/m].
    pub viscous: Expr,
    /// Where it was declared.
    pub span: Span,
}

/// A scalar function written directly.
#[derive(Clone, Debug)]
pub struct EnergyFunction {
    /// Name.
    pub name: String,
    /// Which.
    pub kind: EnergyKind,
    /// Potential: over coordinates. Kinetic: over coordinates and rates, quadratic in the rates.
    /// Dissipation: over coordinates and rates; the force is -dD/d(rate).
    pub value: Expr,
    /// Where it was declared.
    pub span: Span,
}

/// Kinds of scalar functions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EnergyKind {
    /// V(q) [J].
    Potential,
    /// T(q, v) [J].
    Kinetic,
    /// D(q, v) [W].
    Dissipation,
}

/// `equation I_eps * eps.ddot = ...;`
#[derive(Clone, Debug)]
pub struct Equation {
    /// The coordinate whose equation (row) this is.
    pub coordinate: usize,
    /// Left-hand side: coefficients of accelerations, over coordinates and parameters.
    pub mass: Vec<(usize, Expr)>,
    /// Right-hand side over time, coordinates, rates, inputs, actuators, parameters.
    pub rhs: Expr,
    /// Unit of the row.
    pub unit: Unit,
    /// Where it was declared.
    pub span: Span,
}

/// A measured output: y = encoder(play(scale * value(t - delay) + bias)).
#[derive(Clone, Debug)]
pub struct Output {
    /// Name.
    pub name: String,
    /// Unit.
    pub unit: Unit,
    /// Over coordinates, rates, accelerations' absence, parameters.
    pub value: Expr,
    /// Scale (default 1).
    pub scale: Option<Expr>,
    /// Bias (default 0).
    pub bias: Option<Expr>,
    /// Delay [s].
    pub delay: Option<Expr>,
    /// Whole width of the play (backlash) between the value and its sensor, in the output's unit.
    pub play: Option<Expr>,
    /// Quantization.
    pub encoder: Option<Encoder>,
    /// Where it was declared.
    pub span: Span,
}

/// Incremental encoder.
#[derive(Clone, Debug)]
pub struct Encoder {
    /// Counts per turn (rad) or per metre (m); the quantum is 2 pi / counts or 1 / counts.
    pub counts: f64,
    /// The coordinate's value at which the encoder reads zero, over parameters.
    pub zero: Option<Expr>,
    /// Reads modulo one turn.
    pub wrapped: bool,
}

/// A named operating point.
#[derive(Clone, Debug)]
pub struct Trim {
    /// Name.
    pub name: String,
    /// Fixed coordinates, rates and inputs. What is not listed and not solved is zero.
    pub fixed: Vec<(Symbol, Expr)>,
    /// Coordinates whose acceleration vanishes.
    pub zero: Vec<usize>,
    /// Coordinates, rates and inputs (or mixed inputs) that are solved for.
    pub solve: Vec<Symbol>,
    /// Where it was declared.
    pub span: Span,
}

/// A declared assumption; applied after the full derivation, in a fixed order.
#[derive(Clone, Debug)]
pub struct Assumption {
    /// What is assumed.
    pub kind: AssumptionKind,
    /// Where it was declared.
    pub span: Span,
}

/// Kinds of assumptions, in the order in which they are applied.
#[derive(Clone, Debug)]
pub enum AssumptionKind {
    /// `set l_cd = 0;`: a parameter's value, put into the equations as a number.
    Set {
        /// Parameter.
        parameter: usize,
        /// Value in SI.
        value: f64,
    },
    /// `neglect coriolis;` or `neglect coriolis in psi, eps;`: velocity products.
    NeglectCoriolis {
        /// Rows; all where `None`.
        rows: Option<Vec<usize>>,
    },
    /// `neglect gravity;`, `neglect gravity of fuselage;`, `neglect gravity in psi;`
    NeglectGravity {
        /// Bodies; all where `None`.
        bodies: Option<Vec<usize>>,
        /// Rows; all where `None`.
        rows: Option<Vec<usize>>,
    },
    /// `neglect friction;` or `neglect friction in psi;`
    NeglectFriction {
        /// Rows; all where `None`.
        rows: Option<Vec<usize>>,
    },
    /// `neglect right;` or `neglect right in psi;`: a named force, spring, damper or function.
    NeglectTerm {
        /// Name of the statement.
        name: String,
        /// Rows; all where `None`.
        rows: Option<Vec<usize>>,
    },
    /// `neglect inertia[eps, theta];`: an entry of the mass matrix and its mirror.
    NeglectInertia {
        /// Row.
        row: usize,
        /// Column.
        column: usize,
    },
    /// `inertia diag(I_psi, I_eps, I_theta);`: the mass matrix of the free coordinates.
    InertiaDiagonal(
        /// Entries over parameters, in the order of the coordinates.
        Vec<Expr>,
    ),
}

/// A name, resolved.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Symbol {
    /// `t` [s].
    Time,
    /// `Rig::parameters[i]` (a `param` or `const`).
    Parameter(usize),
    /// `Rig::definitions[i]`.
    Definition(usize),
    /// `Rig::coordinates[i]`.
    Coordinate(usize),
    /// `name.dot`.
    Rate(usize),
    /// `name.ddot`: on the left-hand side of `equation` (there taken apart), and for prescribed coordinates.
    Acceleration(usize),
    /// `Rig::inputs[i]`.
    Input(usize),
    /// `Rig::actuators[i]`.
    Actuator(usize),
    /// New input `names[i.1]` of `Rig::mixes[i.0]`.
    Mixed(usize, usize),
}

/// A checked expression; numbers are SI and radians.
#[derive(Clone, Debug, PartialEq)]
pub enum Expr {
    /// Number in SI.
    Number(f64),
    /// Name.
    Symbol(Symbol),
    /// -a.
    Neg(Box<Expr>),
    /// a op b.
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    /// f(a, ..), arity checked.
    Call(Function, Vec<Expr>),
}

impl Expr {
    /// The names in it, each as often as it stands there.
    #[must_use]
    pub fn symbols(&self) -> Vec<Symbol> {
        match self {
            Self::Number(_) => Vec::new(),
            Self::Symbol(s) => vec![*s],
            Self::Neg(a) => a.symbols(),
            Self::Binary(_, a, b) => [a.symbols(), b.symbols()].concat(),
            Self::Call(_, args) => args.iter().flat_map(Self::symbols).collect(),
        }
    }
}

/// Binary operators.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BinaryOp {
    /// +
    Add,
    /// -
    Sub,
    /// *
    Mul,
    /// /
    Div,
    /// ^ (a power with a non-integer exponent has a dimensionless base)
    Pow,
}

/// Functions of the language.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Function {
    /// sin(x)
    Sin,
    /// cos(x)
    Cos,
    /// tan(x)
    Tan,
    /// asin(x)
    Asin,
    /// acos(x)
    Acos,
    /// atan(x)
    Atan,
    /// atan2(y, x)
    Atan2,
    /// sinh(x)
    Sinh,
    /// cosh(x)
    Cosh,
    /// tanh(x)
    Tanh,
    /// exp(x)
    Exp,
    /// ln(x)
    Ln,
    /// sqrt(x), of any dimension with even exponents
    Sqrt,
    /// abs(x)
    Abs,
    /// sign(x): -1, 0, 1
    Sign,
    /// min(a, b)
    Min,
    /// max(a, b)
    Max,
    /// saturate(x, lo, hi)
    Saturate,
    /// dead_zone(x, w): x - w above w, 0 within, x + w below -w
    DeadZone,
}
