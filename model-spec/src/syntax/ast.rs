//! Syntax tree of a model file: names unresolved, each node with its source span.
//!
//! Fields are public so that other crates can change a model (mutants, effects) and check the result with
//! [`check`](crate::check()).

use crate::source::Span;

/// A file: a model, effects, or both.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct File {
    /// Documentation: the `//!` lines.
    pub doc: String,
    /// Statements in order; those of applied effects come last.
    pub items: Vec<Item>,
    /// Applied effects, in order.
    pub applied: Vec<Applied>,
    /// Span of the end of the file, for faults of missing statements.
    pub end: Span,
}

/// An effect that has been applied to a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Applied {
    /// Name of the effect.
    pub name: Name,
    /// Documentation: its `///` lines.
    pub doc: String,
    /// Name of its site, such as `drag`.
    pub site: String,
    /// Variables it depends on, such as `alpha`.
    pub variables: Vec<String>,
    /// Literature reference.
    pub citation: String,
    /// Smallest departures of interest of its coefficients and states (`negligible`).
    pub negligible: Vec<(Name, Quantity)>,
}

/// A statement of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Item {
    /// Kind and content.
    pub kind: ItemKind,
    /// Documentation: the `///` lines before it.
    pub doc: String,
    /// Source span from its first word to its end.
    pub span: Span,
    /// Index into [`File::applied`] of the effect that added or replaced it.
    pub effect: Option<usize>,
}

/// Kinds of statement of a file.
#[derive(Clone, Debug, PartialEq)]
pub enum ItemKind {
    /// `model NAME;`
    Model(Name),
    /// `reference NAME;`
    Reference(Name),
    /// `param …;` or `coefficient …;`
    Parameter(Parameter),
    /// `input NAME in FRAME = (…) unit;`
    Input(Input),
    /// `state NAME = value;`
    State(State),
    /// `frame …;`
    Frame(Frame),
    /// `body NAME { … }` or `point NAME { … }`
    Body(Body),
    /// `let NAME = …;`
    Let(Let),
    /// `force NAME = …;` or `moment NAME = …;`
    Load(Load),
    /// `der(STATE) = …;`
    Equation(Equation),
    /// `marker NAME in FRAME;`
    Marker(Marker),
    /// `observe NAME = …;`
    Observe(Observe),
    /// `clock EXPR;`
    Clock(Expr),
    /// `limit … > bound "reason";`
    Limit(Limit),
    /// `check "title" { … }`
    Check(Check),
    /// `effect NAME { … }`
    Effect(Effect),
}

/// A name in ASCII spelling (`alpha` for `α`).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Name {
    /// The ASCII spelling.
    pub text: String,
    /// Source span.
    pub span: Span,
}

/// A literal number with its sign, as text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Number {
    /// Sign, digits, point and exponent, in a form that `f64::from_str` reads.
    pub text: String,
    /// Source span.
    pub span: Span,
}

/// A literal number with an optional unit.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    /// The number.
    pub number: Number,
    /// Its unit, if one is written.
    pub unit: Option<UnitExpr>,
    /// Source span of number and unit.
    pub span: Span,
}

/// A unit: a product of powers of unit symbols; without factors it is `1`.
#[derive(Clone, Debug, PartialEq)]
pub struct UnitExpr {
    /// The powers.
    pub factors: Vec<UnitFactor>,
    /// Source span.
    pub span: Span,
}

/// One power of a unit symbol.
#[derive(Clone, Debug, PartialEq)]
pub struct UnitFactor {
    /// The symbol, such as `kg`.
    pub symbol: String,
    /// Twice its exponent.
    pub doubled: i32,
    /// Source span.
    pub span: Span,
}

/// Whether a parameter is a known constant or a coefficient to be estimated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ParameterClass {
    /// Known constant of the body or its environment (`param`).
    Param,
    /// Estimated from flights (`coefficient`).
    Coefficient,
}

/// Declaration of a known constant or a coefficient.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// Known or estimated.
    pub class: ParameterClass,
    /// Name.
    pub name: Name,
    /// Default value, with its unit.
    pub value: Quantity,
    /// Lower and upper bound; in the unit of the default unless they state one.
    pub bounds: Option<(Quantity, Quantity)>,
}

/// Declaration of a vector given with each flight.
#[derive(Clone, Debug, PartialEq)]
pub struct Input {
    /// Name.
    pub name: Name,
    /// Frame of its components.
    pub frame: Name,
    /// Default components.
    pub value: [Number; 3],
    /// Unit of the components.
    pub unit: Option<UnitExpr>,
}

/// Declaration of a state that is not the body's.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// Name.
    pub name: Name,
    /// Default initial value, with its unit.
    pub value: Quantity,
}

/// Declaration of a frame of reference.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// Name.
    pub name: Name,
    /// Orientation relative to its parent.
    pub kind: FrameKind,
}

/// Orientation of a frame.
#[derive(Clone, Debug, PartialEq)]
pub enum FrameKind {
    /// Inertial, third axis up.
    Inertial,
    /// Rotated about an axis of its parent.
    Turned {
        /// Parent frame.
        parent: Name,
        /// State that is the angle.
        angle: Name,
        /// Number of the axis, 1 to 3.
        axis: u8,
    },
    /// Rotated by a unit quaternion, scalar part first.
    Quaternion {
        /// Parent frame.
        parent: Name,
        /// States of the quaternion.
        states: [Name; 4],
    },
}

/// Whether a body rotates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BodyClass {
    /// Rigid body with mass and inertia (`body`).
    Rigid,
    /// Point mass (`point`).
    Point,
}

/// Declaration of a body.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Rigid body or point mass.
    pub class: BodyClass,
    /// Name.
    pub name: Name,
    /// Statements of the block.
    pub parts: Vec<BodyPart>,
}

/// A statement in the block of a body.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyPart {
    /// Kind and content.
    pub kind: BodyPartKind,
    /// Source span.
    pub span: Span,
}

/// Kinds of statement in the block of a body.
#[derive(Clone, Debug, PartialEq)]
pub enum BodyPartKind {
    /// `mass EXPR;`
    Mass(Expr),
    /// `inertia … in FRAME;`
    Inertia(Box<Inertia>),
    /// `fixed in FRAME;`
    Fixed(Name),
    /// `position (x, y, z) in FRAME;`
    Position([Name; 3], Name),
    /// `velocity (u, v, w) in FRAME;`
    Velocity([Name; 3], Name),
    /// `angular velocity (p, q, r) in FRAME;`
    AngularVelocity([Name; 3], Name),
    /// `angular velocity in FRAME;`: the frame of `angular_velocity` in expressions.
    AngularVelocityIn(Name),
}

/// Inertia tensor of a body.
#[derive(Clone, Debug, PartialEq)]
pub struct Inertia {
    /// Entries row by row; none off the diagonal for `diag(…)`.
    pub rows: [[Option<Expr>; 3]; 3],
    /// Frame of the components.
    pub frame: Name,
}

/// Declaration of an auxiliary variable.
#[derive(Clone, Debug, PartialEq)]
pub struct Let {
    /// Name.
    pub name: Name,
    /// Declared unit, if any.
    pub unit: Option<UnitExpr>,
    /// Definition.
    pub value: Expr,
}

/// Whether a load is a force or a moment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LoadClass {
    /// Force at the centre of mass.
    Force,
    /// Moment about the centre of mass.
    Moment,
}

/// Declaration of a force or a moment.
#[derive(Clone, Debug, PartialEq)]
pub struct Load {
    /// Force or moment.
    pub class: LoadClass,
    /// Name.
    pub name: Name,
    /// Definition.
    pub value: Expr,
}

/// A stated differential equation: `der(STATE) = …`.
#[derive(Clone, Debug, PartialEq)]
pub struct Equation {
    /// The state.
    pub state: Name,
    /// Derivative of the state with respect to time.
    pub value: Expr,
}

/// Declaration of the observed point, given by its coordinates in a frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Marker {
    /// Name.
    pub name: Name,
    /// Frame of its coordinates.
    pub frame: Name,
}

/// The measurement equation: `observe NAME = …`.
#[derive(Clone, Debug, PartialEq)]
pub struct Observe {
    /// Name.
    pub name: Name,
    /// Definition.
    pub value: Expr,
}

/// A validity limit: the model holds where the value is above the bound.
#[derive(Clone, Debug, PartialEq)]
pub struct Limit {
    /// The limited quantity.
    pub value: Expr,
    /// Lower bound.
    pub bound: Quantity,
    /// Why the model ends there.
    pub reason: String,
}

/// A check case with known results.
#[derive(Clone, Debug, PartialEq)]
pub struct Check {
    /// Title, unique in the file.
    pub title: String,
    /// Statements of the block.
    pub parts: Vec<CheckPart>,
}

/// A statement of a check case.
#[derive(Clone, Debug, PartialEq)]
pub enum CheckPart {
    /// `set NAME = value;`
    Set {
        /// Parameter, coefficient, state, input or component of one.
        name: Name,
        /// One number, or the three components of a vector.
        value: Vec<Number>,
        /// Unit of the numbers.
        unit: Option<UnitExpr>,
        /// Source span of the statement.
        span: Span,
    },
    /// `expect NAME = value within tolerance;`
    Expect {
        /// An auxiliary variable, or the state of a derivative.
        name: Name,
        /// Whether the result is `der(NAME)`.
        derivative: bool,
        /// Expected value.
        value: Quantity,
        /// Absolute tolerance; in the unit of the value unless it states one.
        within: Quantity,
        /// Source span of the statement.
        span: Span,
    },
}

/// An effect: a named change to a model.
#[derive(Clone, Debug, PartialEq)]
pub struct Effect {
    /// Name.
    pub name: Name,
    /// Documentation: its `///` lines.
    pub doc: String,
    /// Names of the models it applies to; empty for any.
    pub on: Vec<Name>,
    /// Statements of the block.
    pub parts: Vec<EffectPart>,
}

/// A statement of an effect.
#[derive(Clone, Debug, PartialEq)]
pub enum EffectPart {
    /// `source "…";`
    Citation(String, Span),
    /// `site NAME;`
    Site(Name),
    /// `variables NAME, NAME;`: what the effect depends on.
    Variables(Vec<Name>, Span),
    /// `negligible NAME value;`: smallest departure of interest.
    Negligible(Name, Quantity),
    /// `replace …;`: takes the place of the statement of the same kind and name.
    Replace(Box<Item>),
    /// `replace inertia … in FRAME;`
    ReplaceInertia(Box<Inertia>, Span),
    /// A statement that is added to the model.
    Add(Box<Item>),
}

/// An expression.
#[derive(Clone, Debug, PartialEq)]
pub struct Expr {
    /// Operation or operand.
    pub kind: ExprKind,
    /// Source span, including brackets around the expression.
    pub span: Span,
}

/// Binary operators.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BinaryOp {
    /// `+`
    Add,
    /// `-`
    Sub,
    /// `*`
    Mul,
    /// `·`: scalar product of two vectors, else multiplication.
    Dot,
    /// `×`: vector product of two vectors, else multiplication.
    Cross,
    /// `/`
    Div,
    /// `^`
    Pow,
}

/// Operations and operands of expressions.
#[derive(Clone, Debug, PartialEq)]
pub enum ExprKind {
    /// A literal with an optional unit.
    Number(Quantity),
    /// A name.
    Name(String),
    /// `F.k` or `v.k`: an axis of a frame, or a component of a vector.
    Part(Box<Expr>, u8),
    /// `der(STATE)`.
    Derivative(Name),
    /// `(a, b, c) in FRAME`.
    Components(Box<[Expr; 3]>, Name),
    /// `-a`.
    Neg(Box<Expr>),
    /// A binary operation, such as `a + b`.
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    /// `f(a, …)`.
    Call(Name, Vec<Expr>),
}
