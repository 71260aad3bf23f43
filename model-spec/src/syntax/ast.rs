//! The tree of a model file as it was written: nothing resolved, every place kept.
//!
//! Fields are public so that other programs can change a model (make mutants of it, apply effects to it)
//! and have the result checked like any other.

use crate::source::Span;

/// A file: a model, effects, or both.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct File {
    /// Its `//!` lines.
    pub doc: String,
    /// Its statements in order; those of applied effects come last.
    pub items: Vec<Item>,
    /// Effects that were applied, in order.
    pub applied: Vec<Applied>,
    /// Where the file ends, for what is missing from it.
    pub end: Span,
}

/// An effect that was applied to a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Applied {
    /// Its name.
    pub name: Name,
    /// Its `///` lines.
    pub doc: String,
    /// Where it acts.
    pub site: String,
    /// On what it depends, in words.
    pub variables: Vec<String>,
    /// Where it is described, as the effect cites it.
    pub citation: String,
    /// Departures of its coefficients and states that do not matter in practice.
    pub negligible: Vec<(Name, Quantity)>,
}

/// A statement.
#[derive(Clone, Debug, PartialEq)]
pub struct Item {
    /// What it says.
    pub kind: ItemKind,
    /// The `///` lines before it.
    pub doc: String,
    /// From its first word to its end.
    pub span: Span,
    /// The applied effect that put it there: index into [`File::applied`].
    pub effect: Option<usize>,
}

/// The kinds of statement.
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

/// A name in its plain spelling (`alpha` for `α`).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Name {
    /// The plain spelling.
    pub text: String,
    /// Where it was written.
    pub span: Span,
}

/// A number as it was written, with its sign.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Number {
    /// Digits, point and exponent, as Rust reads them.
    pub text: String,
    /// Where.
    pub span: Span,
}

/// A number and, perhaps, its unit.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    /// The number.
    pub number: Number,
    /// Its unit; none where none was written.
    pub unit: Option<UnitExpr>,
    /// Both.
    pub span: Span,
}

/// A product of powers of unit symbols; without factors it is `1`.
#[derive(Clone, Debug, PartialEq)]
pub struct UnitExpr {
    /// Its factors.
    pub factors: Vec<UnitFactor>,
    /// Where.
    pub span: Span,
}

/// One power of a unit symbol.
#[derive(Clone, Debug, PartialEq)]
pub struct UnitFactor {
    /// The symbol, such as `kg`.
    pub symbol: String,
    /// Twice its exponent.
    pub doubled: i32,
    /// Where.
    pub span: Span,
}

/// Whether a constant is known or fitted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ParameterClass {
    /// Known: of the body or the place.
    Param,
    /// What flights are fitted for.
    Coefficient,
}

/// A parameter or a coefficient.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// Which of the two.
    pub class: ParameterClass,
    /// Its name.
    pub name: Name,
    /// Its default, with its unit.
    pub value: Quantity,
    /// Least and greatest value; in the default's unit where they state none.
    pub bounds: Option<(Quantity, Quantity)>,
}

/// A vector given with each flight.
#[derive(Clone, Debug, PartialEq)]
pub struct Input {
    /// Its name.
    pub name: Name,
    /// Frame of its components.
    pub frame: Name,
    /// Default components.
    pub value: [Number; 3],
    /// Their unit.
    pub unit: Option<UnitExpr>,
}

/// A state that is not one of a body.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// Its name.
    pub name: Name,
    /// Its value where a release does not say otherwise, with its unit.
    pub value: Quantity,
}

/// A frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// Its name.
    pub name: Name,
    /// How it is placed.
    pub kind: FrameKind,
}

/// How a frame is placed.
#[derive(Clone, Debug, PartialEq)]
pub enum FrameKind {
    /// At rest, third axis up.
    Inertial,
    /// Turned about an axis of its parent.
    Turned {
        /// Parent frame.
        parent: Name,
        /// The angle's state.
        angle: Name,
        /// The axis, 1 to 3.
        axis: u8,
    },
    /// Turned by a unit quaternion, scalar part first.
    Quaternion {
        /// Parent frame.
        parent: Name,
        /// Its states.
        states: [Name; 4],
    },
}

/// Whether a body turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BodyClass {
    /// `body`: mass and inertia.
    Rigid,
    /// `point`: mass alone.
    Point,
}

/// A body.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Rigid or a point.
    pub class: BodyClass,
    /// Its name.
    pub name: Name,
    /// Its statements.
    pub parts: Vec<BodyPart>,
}

/// A statement about a body.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyPart {
    /// What it says.
    pub kind: BodyPartKind,
    /// Where.
    pub span: Span,
}

/// The kinds of statement about a body.
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
    /// `angular velocity in FRAME;`: where `angular_velocity` has its components.
    AngularVelocityIn(Name),
}

/// Moments of inertia.
#[derive(Clone, Debug, PartialEq)]
pub struct Inertia {
    /// Row by row; none off the diagonal where `diag(…)` was written.
    pub rows: [[Option<Expr>; 3]; 3],
    /// Frame of the components.
    pub frame: Name,
}

/// A named quantity.
#[derive(Clone, Debug, PartialEq)]
pub struct Let {
    /// Its name.
    pub name: Name,
    /// The unit it is said to have.
    pub unit: Option<UnitExpr>,
    /// What it is.
    pub value: Expr,
}

/// Force or moment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LoadClass {
    /// A force at the mass centre.
    Force,
    /// A moment about the mass centre.
    Moment,
}

/// A force or a moment.
#[derive(Clone, Debug, PartialEq)]
pub struct Load {
    /// Which of the two.
    pub class: LoadClass,
    /// Its name.
    pub name: Name,
    /// What it is.
    pub value: Expr,
}

/// `der(STATE) = …`
#[derive(Clone, Debug, PartialEq)]
pub struct Equation {
    /// The state.
    pub state: Name,
    /// Its derivative.
    pub value: Expr,
}

/// A point given by its coordinates in a frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Marker {
    /// Its name.
    pub name: Name,
    /// Frame of its coordinates.
    pub frame: Name,
}

/// What is observed.
#[derive(Clone, Debug, PartialEq)]
pub struct Observe {
    /// Its name.
    pub name: Name,
    /// What it is.
    pub value: Expr,
}

/// The model holds only where the value is above the bound.
#[derive(Clone, Debug, PartialEq)]
pub struct Limit {
    /// The value.
    pub value: Expr,
    /// The bound.
    pub bound: Quantity,
    /// What happens there.
    pub reason: String,
}

/// A case with known answers.
#[derive(Clone, Debug, PartialEq)]
pub struct Check {
    /// Its title.
    pub title: String,
    /// Its statements.
    pub parts: Vec<CheckPart>,
}

/// A statement of a case.
#[derive(Clone, Debug, PartialEq)]
pub enum CheckPart {
    /// `set NAME = value;`
    Set {
        /// What is set.
        name: Name,
        /// Its value: one number, or the components of a vector.
        value: Vec<Number>,
        /// Its unit.
        unit: Option<UnitExpr>,
        /// The whole statement.
        span: Span,
    },
    /// `expect NAME = value within tolerance;`
    Expect {
        /// A named quantity, or the state of a derivative.
        name: Name,
        /// Whether `der(NAME)` was written.
        derivative: bool,
        /// What must come out.
        value: Quantity,
        /// Greatest difference; in the value's unit where it states none.
        within: Quantity,
        /// The whole statement.
        span: Span,
    },
}

/// A change to a model.
#[derive(Clone, Debug, PartialEq)]
pub struct Effect {
    /// Its name.
    pub name: Name,
    /// Its `///` lines.
    pub doc: String,
    /// The models it is made for; any where none is said.
    pub on: Vec<Name>,
    /// Its statements.
    pub parts: Vec<EffectPart>,
}

/// A statement of an effect.
#[derive(Clone, Debug, PartialEq)]
pub enum EffectPart {
    /// `source "…";`
    Citation(String, Span),
    /// `site NAME;`
    Site(Name),
    /// `variables NAME, NAME;`: on what the effect depends, in words.
    Variables(Vec<Name>, Span),
    /// `negligible NAME value;`
    Negligible(Name, Quantity),
    /// `replace …;`: the statement of the same kind and name is exchanged for this one.
    Replace(Box<Item>),
    /// `replace inertia … in FRAME;`
    ReplaceInertia(Box<Inertia>, Span),
    /// A statement that is added.
    Add(Box<Item>),
}

/// An expression.
#[derive(Clone, Debug, PartialEq)]
pub struct Expr {
    /// What it is.
    pub kind: ExprKind,
    /// Where, with the brackets around it.
    pub span: Span,
}

/// Operators between two expressions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BinaryOp {
    /// `+`
    Add,
    /// `-`
    Sub,
    /// `*`
    Mul,
    /// `·`: scalar product of two vectors, else a product.
    Dot,
    /// `×`: vector product of two vectors, else a product.
    Cross,
    /// `/`
    Div,
    /// `^`
    Pow,
}

/// The kinds of expression.
#[derive(Clone, Debug, PartialEq)]
pub enum ExprKind {
    /// A number with, perhaps, a unit.
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
    /// `a + b` and its like.
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    /// `f(a, …)`.
    Call(Name, Vec<Expr>),
}
