//! The checked model: every name resolved, every expression with its shape and unit, every place kept.
//!
//! This is the seam that the compiler and the tree oracle read. Indices point into the vectors of [`Model`].

mod effect;
mod walk;

use std::sync::Arc;

use crate::source::Span;
use crate::syntax::ast;
use crate::unit::Unit;

pub use crate::source::Source;
pub use effect::{AppliedEffect, EffectUnknown, OfferedEffect};

/// A model of a flying body, checked.
#[derive(Clone, Debug)]
pub struct Model {
    /// Its name, as other programs refer to it.
    pub name: String,
    /// Its `//!` lines.
    pub doc: String,
    /// The physics it claims to be, by the name of an oracle written by hand; see `hyzer verify`.
    pub reference: Option<String>,
    /// The texts it was made from: the model file first, then each effect that was switched on.
    pub sources: Vec<Source>,
    /// Known constants of the body and the place, in order of declaration.
    pub params: Vec<Parameter>,
    /// What flights are fitted for, in order of declaration; those of effects come last.
    pub coefficients: Vec<Parameter>,
    /// Vectors that are given with each flight: the wind, a known spin.
    pub inputs: Vec<Input>,
    /// The state, in order.
    pub states: Vec<State>,
    /// Frames, parents before children; the first is inertial with its third axis up.
    pub frames: Vec<Frame>,
    /// The body whose equations of motion are derived; none where every equation is stated.
    pub body: Option<Body>,
    /// Named quantities, each after those that it uses.
    pub aux_variables: Vec<AuxVariable>,
    /// Forces at the mass centre; vectors in any frame.
    pub forces: Vec<Load>,
    /// Moments about the mass centre; vectors in any frame.
    pub moments: Vec<Load>,
    /// Stated derivatives `der(state) = …`, in order of the states; where a body is declared, of those that are
    /// not the body's.
    pub equations: Vec<Equation>,
    /// A point whose coordinates in `frame` are given when it is observed.
    pub marker: Option<Marker>,
    /// What is observed of the marker: a vector in the inertial frame.
    pub observation: Option<Observation>,
    /// Seconds of flight that pass in a second of the clock by which things are measured; none where they are
    /// the same. Every derivative of a state by the measured time is multiplied by it.
    pub clock: Option<Clock>,
    /// Where the model ends: each expression must stay above its bound.
    pub limits: Vec<ValidityLimit>,
    /// Cases that the model file itself states.
    pub checks: Vec<CheckCase>,
    /// Effects that are switched on, in order.
    pub effects: Vec<AppliedEffect>,
    /// Effects that the model's own file offers, switched on or not.
    pub offers: Vec<OfferedEffect>,
    /// The syntax tree that was checked, with the effects applied to it.
    pub tree: Arc<ast::File>,
}

/// A parameter or coefficient: a number that does not change during a flight.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Name in the notation of the paper.
    pub name: String,
    /// Its `///` lines.
    pub doc: String,
    /// Declared or inferred unit.
    pub unit: Unit,
    /// The unit of [`Parameter::value`]: as the file spells it, or as inferred (`1`, `1/rad`, `kg*m^2`);
    /// the SI's own where the file has another (`rad` for `deg`).
    pub unit_text: String,
    /// Whether the unit was inferred from its uses.
    pub inferred: bool,
    /// Default, SI.
    pub value: f64,
    /// Least and greatest value allowed, SI.
    pub bounds: Option<(f64, f64)>,
    /// Place of the declaration.
    pub span: Span,
}

/// A vector given with each flight; its components are named `<name>_x`, `<name>_y`, `<name>_z`.
#[derive(Clone, Debug)]
pub struct Input {
    /// Name.
    pub name: String,
    /// Its `///` lines.
    pub doc: String,
    /// Frame of its components.
    pub frame: usize,
    /// Unit of its components.
    pub unit: Unit,
    /// The unit as spelled.
    pub unit_text: String,
    /// Default, SI.
    pub value: [f64; 3],
    /// Place of the declaration.
    pub span: Span,
}

/// One component of the state.
#[derive(Clone, Debug)]
pub struct State {
    /// Name.
    pub name: String,
    /// Its unit.
    pub unit: Unit,
    /// The unit as spelled.
    pub unit_text: String,
    /// Value where a release does not say otherwise: 0, but 1 for the scalar part of a quaternion.
    pub value: f64,
    /// Place of the declaration.
    pub span: Span,
}

/// A frame of reference.
#[derive(Clone, Debug)]
pub struct Frame {
    /// Name.
    pub name: String,
    /// How it is placed.
    pub kind: FrameKind,
    /// Place of the declaration.
    pub span: Span,
}

/// How a frame is placed relative to its parent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FrameKind {
    /// At rest, third axis up. Always frame 0 and no other.
    Inertial,
    /// The parent turned about its own axis `axis` (1, 2 or 3) by an angle.
    Turned {
        /// Parent frame.
        parent: usize,
        /// State that holds the angle, rad.
        angle: usize,
        /// State that holds the angle's rate, rad/s; none where equations are stated and it has no state.
        rate: Option<usize>,
        /// 1, 2 or 3.
        axis: u8,
    },
    /// The parent turned by a unit quaternion: v_parent = q v_frame q*.
    Quaternion {
        /// Parent frame.
        parent: usize,
        /// States of the quaternion, scalar part first.
        states: [usize; 4],
    },
}

/// The body whose equations of motion are derived from Newton's and Euler's laws.
#[derive(Clone, Debug)]
pub struct Body {
    /// Name.
    pub name: String,
    /// Mass: a scalar that depends on parameters alone.
    pub mass: Expr,
    /// States of the position of the mass centre, components in frame 0.
    pub position: [usize; 3],
    /// States of the velocity of the mass centre.
    pub velocity: [usize; 3],
    /// Frame of the velocity's components.
    pub velocity_frame: usize,
    /// Rotation; none for a point mass.
    pub rotation: Option<Rotation>,
    /// Place of the declaration.
    pub span: Span,
}

/// The rotating part of a rigid body.
#[derive(Clone, Debug)]
pub struct Rotation {
    /// Frame fixed in the body.
    pub body_frame: usize,
    /// Frame of the components of [`ExprKind::AngularVelocity`]: that of the inertia where the body states no other.
    pub angular_velocity_frame: usize,
    /// Frame of the inertia's components, in which they are constant: the body's own, or one that
    /// differs from it by a turn about an axis of symmetry.
    pub inertia_frame: usize,
    /// Moments of inertia, row by row, symmetric; scalars that depend on parameters and coefficients alone.
    pub inertia: [[Expr; 3]; 3],
    /// States of the angular velocity's components and their frame, where the attitude is a quaternion;
    /// none where the rates of the angles are the states.
    pub angular_velocity: Option<([usize; 3], usize)>,
}

/// A named quantity.
#[derive(Clone, Debug)]
pub struct AuxVariable {
    /// Name.
    pub name: String,
    /// Its `///` lines.
    pub doc: String,
    /// What it is.
    pub value: Expr,
    /// Place of the declaration.
    pub span: Span,
    /// Effect that put it there: index into [`Model::effects`].
    pub effect: Option<usize>,
}

/// A force or a moment.
#[derive(Clone, Debug)]
pub struct Load {
    /// Name.
    pub name: String,
    /// Vector, in any frame.
    pub value: Expr,
    /// Place of the declaration.
    pub span: Span,
    /// Effect that put it there.
    pub effect: Option<usize>,
}

/// `der(state) = value`.
#[derive(Clone, Debug)]
pub struct Equation {
    /// Index of the state.
    pub state: usize,
    /// Its derivative.
    pub value: Expr,
    /// Place of the declaration.
    pub span: Span,
}

/// A point given by its coordinates in a frame.
#[derive(Clone, Debug)]
pub struct Marker {
    /// Name.
    pub name: String,
    /// Frame of its coordinates.
    pub frame: usize,
    /// Place of the declaration.
    pub span: Span,
}

/// What is observed.
#[derive(Clone, Debug)]
pub struct Observation {
    /// Name.
    pub name: String,
    /// Vector in frame 0, m.
    pub value: Expr,
    /// Place of the declaration.
    pub span: Span,
}

/// How fast the flight's time passes against that of the clock by which things are measured.
#[derive(Clone, Debug)]
pub struct Clock {
    /// Scalar, a pure number.
    pub value: Expr,
    /// Place of the declaration.
    pub span: Span,
    /// Effect that put it there.
    pub effect: Option<usize>,
}

/// The model holds only where `value > bound`.
#[derive(Clone, Debug)]
pub struct ValidityLimit {
    /// Scalar.
    pub value: Expr,
    /// Bound, SI.
    pub bound: f64,
    /// What happens there, for people.
    pub reason: String,
    /// Place of the declaration.
    pub span: Span,
}

/// A case with known answers, stated in the model file.
#[derive(Clone, Debug)]
pub struct CheckCase {
    /// Title.
    pub title: String,
    /// What is set; everything else has its default.
    pub settings: Vec<(Target, f64)>,
    /// What must come out.
    pub expectations: Vec<Expectation>,
    /// Place of the declaration.
    pub span: Span,
}

/// What a check case sets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// A parameter.
    Param(usize),
    /// A coefficient.
    Coefficient(usize),
    /// A component (0 to 2) of an input.
    Input(usize, usize),
    /// A state.
    State(usize),
}

/// What a check case looks at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Observable {
    /// The derivative of a state.
    Derivative(usize),
    /// A scalar named quantity.
    AuxVariable(usize),
}

/// One expected number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Expectation {
    /// What.
    pub what: Observable,
    /// Its value, SI.
    pub value: f64,
    /// Greatest absolute difference, SI.
    pub within: f64,
    /// Place.
    pub span: Span,
}

/// Whether an expression is a number or a vector, and in which frame its components are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A number.
    Scalar,
    /// A vector with components in a frame.
    Vector(usize),
}

/// A checked expression.
#[derive(Clone, Debug)]
pub struct Expr {
    /// What it is.
    pub kind: ExprKind,
    /// Number or vector.
    pub shape: Shape,
    /// Its unit.
    pub unit: Unit,
    /// Where it was written.
    pub span: Span,
}

/// The kinds of expression. Vectors are added only where their frames agree; `Reexpress` changes the frame.
#[derive(Clone, Debug)]
pub enum ExprKind {
    /// A literal: its SI value, and the same as an exact fraction where the decimal and its unit are exact.
    Number {
        /// SI value.
        value: f64,
        /// Numerator and denominator.
        exact: Option<(i64, i64)>,
    },
    /// The ratio of a circle's circumference to its diameter.
    Pi,
    /// Time since release as it is measured, s: that of the clock where the model has one.
    Time,
    /// A parameter.
    Param(usize),
    /// A coefficient.
    Coefficient(usize),
    /// An input: a vector in its frame.
    Input(usize),
    /// A state.
    State(usize),
    /// A named quantity.
    AuxVariable(usize),
    /// Unit vector along axis 1, 2 or 3 of a frame.
    Axis(usize, u8),
    /// Position of the mass centre, in frame 0.
    Position,
    /// Velocity of the mass centre, in the body's velocity frame.
    Velocity,
    /// Angular velocity of the body, in the frame [`Rotation::angular_velocity_frame`].
    AngularVelocity,
    /// The marker: a vector in its frame.
    Marker,
    /// Three scalars as a vector in the expression's frame.
    Components(Box<[Expr; 3]>),
    /// `-a`.
    Neg(Box<Expr>),
    /// `a + b`.
    Add(Box<Expr>, Box<Expr>),
    /// `a - b`.
    Sub(Box<Expr>, Box<Expr>),
    /// `a * b`; one of them may be a vector.
    Mul(Box<Expr>, Box<Expr>),
    /// `a / b`, `b` a scalar that is nowhere zero within the model's limits.
    Div(Box<Expr>, Box<Expr>),
    /// `ratio(a, b, otherwise)`: `a / b`, and `otherwise` where `b` is 0.
    Ratio(Box<[Expr; 3]>),
    /// `a ^ (n/2)`: twice the exponent.
    Pow(Box<Expr>, i32),
    /// Scalar product.
    Dot(Box<Expr>, Box<Expr>),
    /// Vector product.
    Cross(Box<Expr>, Box<Expr>),
    /// Length of a vector; 0 with derivative 0 at the zero vector.
    Norm(Box<Expr>),
    /// Direction of a vector; at the zero vector the second expression, or the zero vector.
    Direction(Box<Expr>, Option<Box<Expr>>),
    /// Component 1, 2 or 3 of a vector in its own frame.
    Component(Box<Expr>, u8),
    /// The same vector with components in the expression's frame.
    Reexpress(Box<Expr>),
    /// A function of one scalar.
    Call(Function, Box<Expr>),
    /// `atan2(y, x)`: 0 with derivative 0 where both are 0.
    Atan2(Box<Expr>, Box<Expr>),
    /// The smaller of two.
    Min(Box<Expr>, Box<Expr>),
    /// The greater of two.
    Max(Box<Expr>, Box<Expr>),
}

/// Functions of one scalar, with their behaviour where they are singular.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Function {
    /// Sine.
    Sin,
    /// Cosine.
    Cos,
    /// Tangent.
    Tan,
    /// Arcsine of the argument held within -1 .. 1; derivative 0 beyond.
    Asin,
    /// Arccosine of the argument held within -1 .. 1; derivative 0 beyond.
    Acos,
    /// Arctangent.
    Atan,
    /// Square root; 0 with derivative 0 where the argument is 0 or less.
    Sqrt,
    /// Exponential.
    Exp,
    /// Natural logarithm; 0 with derivative 0 where the argument is 0 or less.
    Log,
    /// Absolute value; derivative 0 at 0.
    Abs,
    /// -1, 0 or 1; derivative 0.
    Sign,
    /// 1 where the argument is above 0, else 0; derivative 0.
    Step,
    /// Hyperbolic tangent.
    Tanh,
}
