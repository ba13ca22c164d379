//! The syntax tree: what was written, with places, before names mean anything.

use crate::rig::{BinaryOp, EnergyKind, Span};

/// A name and its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Name {
    /// Text.
    pub text: String,
    /// Place.
    pub span: Span,
}

/// An expression as written.
#[derive(Clone, Debug)]
pub struct Expr {
    /// What it is.
    pub kind: ExprKind,
    /// Place of all of it.
    pub span: Span,
    /// Levels of the tree; limited by the parser.
    pub depth: u32,
}

impl Expr {
    /// A leaf.
    pub fn leaf(kind: ExprKind, span: Span) -> Self {
        Self { kind, span, depth: 1 }
    }
}

/// Kinds of expressions.
#[derive(Clone, Debug)]
pub enum ExprKind {
    /// Number, with a unit if one was written.
    Number(f64, Option<UnitExpr>),
    /// `eps`, `eps.dot`, `eps.ddot`: the name and its suffix.
    Name(Name, Option<Name>),
    /// -a
    Neg(Box<Expr>),
    /// a op b
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    /// f(a, ..)
    Call(Name, Vec<Expr>),
}

/// A unit as written: factors with exponents (negative below the slash).
#[derive(Clone, Debug)]
pub struct UnitExpr {
    /// (name, exponent); the name `1` stands for no unit.
    pub factors: Vec<(Name, i16)>,
    /// Text, blanks removed.
    pub text: String,
    /// Place.
    pub span: Span,
}

/// What stands behind `=` of a parameter.
#[derive(Clone, Debug)]
pub struct Value {
    /// Value.
    pub value: Expr,
    /// Standard deviation behind `+-`.
    pub prior: Option<Expr>,
    /// `in lo..hi`
    pub bounds: Option<(Expr, Expr)>,
    /// `fixed`
    pub fixed: bool,
    /// `per record`
    pub per_record: bool,
}

/// A vector in parentheses.
pub type Vector = (Vec<Expr>, Span);

/// Direction of an axis.
#[derive(Clone, Debug)]
pub enum AxisExpr {
    /// `x`, `-z`: index, opposite.
    Principal(usize, bool),
    /// `(1, 0, 1)`
    Vector(Vector),
}

/// A step of a frame chain.
#[derive(Clone, Debug)]
pub enum Step {
    /// `.rotate(axis, angle)`
    Rotate(AxisExpr, Expr),
    /// `.translate(x, y, z)`
    Translate(Vec<Expr>, Span),
}

/// Input or output path, spring and friction blocks: `keyword value..;` entries.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Keyword.
    pub key: Name,
    /// Values in order, ranges as two values.
    pub values: Vec<Expr>,
    /// Further keywords with their value: `width w`, `speed v`, `zero at z`; `wrapped` has none.
    pub options: Vec<(Name, Option<Expr>)>,
}

/// What a spring, damper or friction acts along.
#[derive(Clone, Debug)]
pub enum Along {
    /// `on EXPR`
    On(Expr),
    /// `from FRAME at (..) to FRAME at (..)`
    Between(Box<((Name, Vector), (Name, Vector))>),
}

/// An assumption.
#[derive(Clone, Debug)]
pub enum Assume {
    /// `set p = value`
    Set(Name, Expr),
    /// `neglect WHAT [of B, ..] [in Q, ..]`
    Neglect(Name, Vec<Name>, Vec<Name>),
    /// `neglect inertia[a, b]`
    NeglectInertia(Name, Name),
    /// `inertia diag(..)`
    Diagonal(Vec<Expr>),
}

/// Kinds of statements.
#[derive(Clone, Debug)]
pub enum Kind {
    /// `param` (false) or `const` (true).
    Param(UnitExpr, Value, bool),
    /// `lump` (true) or `derived` (false): unit, definition, own value.
    Define(Option<UnitExpr>, Expr, Option<Value>, bool),
    /// `coord` (false) or `prescribed` (true): unit, range, trajectory.
    Coord(UnitExpr, Option<(Expr, Expr)>, Option<Expr>, bool),
    /// `frame`
    Frame(Name, Vec<Step>),
    /// `body .. on FRAME { .. }`
    Body(Name, Vec<BodyEntry>),
    /// `gravity g [along ..]`
    Gravity(Expr, Option<AxisOrVector>),
    /// `input`: unit, limits, path.
    Input(UnitExpr, Option<(Expr, Expr)>, Vec<Entry>),
    /// `actuator`: unit, map, path.
    Actuator(UnitExpr, Expr, Vec<Entry>),
    /// `mix { a = ..; }`
    Mix(Vec<(Name, Expr)>),
    /// `force .. on FRAME at (..): (..) [in F] [against F]`
    Force(Name, Option<Vector>, Vector, Option<Name>, Option<Name>),
    /// `torque .. on FRAME: (..) ..`
    Torque(Name, Vector, Option<Name>, Option<Name>),
    /// `torque .. on COORD: expr`
    Generalized(Name, Expr),
    /// `spring`
    Spring(Along, Vec<Entry>),
    /// `damper`
    Damper(Along, Vec<Entry>),
    /// `friction`
    Friction(Expr, Vec<Entry>),
    /// `potential`, `kinetic`, `dissipation`
    Function(EnergyKind, Expr),
    /// `equation lhs = rhs`
    Equation(Expr, Expr),
    /// `encoder COORD: counts [zero at ..] [wrapped]`
    Encoder(Entry),
    /// `output name: unit = expr { .. }`
    Output(UnitExpr, Expr, Vec<Entry>),
    /// `trim name { .. }`
    Trim(Vec<(Name, Option<Name>, Expr)>, Vec<Name>, Vec<(Name, Option<Name>)>),
    /// `assume { .. }`
    Assume(Vec<(Assume, Span)>),
    /// A statement with an error in it: what it would have declared is known by name only.
    Broken,
}

/// Direction of gravity.
#[derive(Clone, Debug)]
pub enum AxisOrVector {
    /// `-y`
    Axis(usize, bool),
    /// `(sin(a), 0, -cos(a))`
    Vector(Vector),
}

/// An entry of a body.
#[derive(Clone, Debug)]
pub enum BodyEntry {
    /// `mass m;`
    Mass(Expr),
    /// `at (..);`
    At(Vector),
    /// `inertia diag(..) | (..) [about origin | center];`
    Inertia(Vec<Expr>, bool, Span),
}

/// What a statement does to the rig that it extends.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// Adds.
    Add,
    /// `replace`
    Replace,
}

/// A statement.
#[derive(Clone, Debug)]
pub struct Statement {
    /// Its name; for `gravity`, `mix`, `assume` the keyword.
    pub name: Name,
    /// The keyword that it starts with.
    pub keyword: &'static str,
    /// Documentation.
    pub doc: String,
    /// Action.
    pub action: Action,
    /// What it says.
    pub kind: Kind,
    /// All of it.
    pub span: Span,
}

/// `remove [KIND] NAME`
#[derive(Clone, Debug)]
pub struct Removal {
    /// Keyword, if one was given.
    pub keyword: Option<Name>,
    /// Name.
    pub name: Name,
}

/// `rig NAME [extends BASE] { .. }`
#[derive(Clone, Debug)]
pub struct RigItem {
    /// Name.
    pub name: Name,
    /// Documentation.
    pub doc: String,
    /// Base.
    pub extends: Option<Name>,
    /// Statements.
    pub statements: Vec<Statement>,
    /// Removals.
    pub removals: Vec<Removal>,
}

/// A parsed file.
#[derive(Clone, Debug, Default)]
pub struct File {
    /// `use "..";`
    pub uses: Vec<Name>,
    /// Rigs in order.
    pub rigs: Vec<RigItem>,
}
