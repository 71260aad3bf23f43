//! The checked model: names resolved to indices, each expression with its shape, unit and source span.
//!
//! The compiler and the tree oracle read this representation. Indices are positions in the vectors of [`Model`].

mod claim;
mod effect;
mod function;
mod table;
mod walk;

use std::sync::Arc;

use crate::source::Span;
use crate::syntax::ast;
use crate::unit::Unit;

pub use crate::source::Source;
pub use claim::{Claim, ClaimedAttitude, ClaimedRotation};
pub use effect::{AppliedEffect, EffectUnknown, OfferedEffect};
pub use function::Function;
pub use table::{Continuation, Interpolation, Table};

/// A checked model of a flying body: its states, parameters, frames, loads and equations.
#[derive(Clone, Debug)]
pub struct Model {
    /// Name of the model, by which commands and datasets refer to it.
    pub name: String,
    /// Documentation: the `//!` lines of the file.
    pub doc: String,
    /// Name of the reference implementation that `hyzer verify` compares the model with.
    pub reference: Option<String>,
    /// Source texts: the model file first, then each applied effect.
    pub sources: Vec<Source>,
    /// Known constants of the body and its environment, in order of declaration.
    pub params: Vec<Parameter>,
    /// Coefficients, which are estimated from flights, in order of declaration; those of effects come last.
    pub coefficients: Vec<Parameter>,
    /// Vectors given with each flight, such as the wind.
    pub inputs: Vec<Input>,
    /// Components of the state vector, in order.
    pub states: Vec<State>,
    /// Frames of reference, parents before children; frame 0 is inertial with its third axis up.
    pub frames: Vec<Frame>,
    /// The body whose equations of motion are derived; none if every equation is stated.
    pub body: Option<Body>,
    /// Functions given by tables, in order of declaration.
    pub tables: Vec<Table>,
    /// Auxiliary variables, each after those that it uses.
    pub aux_variables: Vec<AuxVariable>,
    /// Forces at the centre of mass, N, in any frame.
    pub forces: Vec<Load>,
    /// Moments about the centre of mass, N m, in any frame.
    pub moments: Vec<Load>,
    /// Stated derivatives `der(state) = …`, in order of the states; with a body, only of states beyond the body's own.
    pub equations: Vec<Equation>,
    /// What the stated equations are about; none if the model does not say it, or has a body.
    pub claim: Option<Claim>,
    /// The point that is observed, if the model observes one; its coordinates are given with each observation.
    pub marker: Option<Marker>,
    /// The measurement equation: a vector in the inertial frame, m.
    pub observation: Option<Observation>,
    /// Rate of flight time against measured time; none if it is 1. It multiplies every derivative with respect to time.
    pub clock: Option<Clock>,
    /// Domain of validity: each expression must stay above its bound.
    pub limits: Vec<ValidityLimit>,
    /// Check cases of the model file.
    pub checks: Vec<CheckCase>,
    /// Applied effects, in order.
    pub effects: Vec<AppliedEffect>,
    /// Effects that the model's file declares, applied or not.
    pub offers: Vec<OfferedEffect>,
    /// The syntax tree that was checked, with the effects applied to it.
    pub tree: Arc<ast::File>,
}

/// A known constant or a coefficient: a number that does not change during a flight.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Name, such as `C_La` or `m`.
    pub name: String,
    /// Documentation: the `///` lines before the declaration.
    pub doc: String,
    /// Unit, declared or inferred.
    pub unit: Unit,
    /// Text of the unit of [`Parameter::value`]: as declared or inferred (`1`, `1/rad`, `kg*m^2`), and always an SI unit
    /// (`rad` where the file has `deg`).
    pub unit_text: String,
    /// Whether the unit was inferred from the uses of the parameter.
    pub inferred: bool,
    /// Default value, SI.
    pub value: f64,
    /// Lower and upper bound of the value, SI.
    pub bounds: Option<(f64, f64)>,
    /// Source span of the declaration.
    pub span: Span,
}

/// A vector given with each flight; its components are the parameters `<name>_x`, `<name>_y`, `<name>_z`.
#[derive(Clone, Debug)]
pub struct Input {
    /// Name of the input vector.
    pub name: String,
    /// Documentation: the `///` lines before the declaration.
    pub doc: String,
    /// Index of the frame of the vector's components, in [`Model::frames`].
    pub frame: usize,
    /// Unit of the vector's components.
    pub unit: Unit,
    /// Text of the components' unit, an SI unit.
    pub unit_text: String,
    /// Default values of the three components, SI.
    pub value: [f64; 3],
    /// Source span of the declaration.
    pub span: Span,
}

/// One component of the state vector.
#[derive(Clone, Debug)]
pub struct State {
    /// Name, such as `x` or `phidot`.
    pub name: String,
    /// Unit of the state.
    pub unit: Unit,
    /// Text of the state's unit, an SI unit.
    pub unit_text: String,
    /// Default initial value, SI: 0 unless stated, 1 for the scalar part of a quaternion.
    pub value: f64,
    /// Source span of the declaration.
    pub span: Span,
}

/// A frame of reference.
#[derive(Clone, Debug)]
pub struct Frame {
    /// Name of the frame.
    pub name: String,
    /// Orientation of the frame relative to its parent.
    pub kind: FrameKind,
    /// Source span of the declaration.
    pub span: Span,
}

/// Orientation of a frame relative to its parent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FrameKind {
    /// Inertial, third axis up; frame 0 and no other.
    Inertial,
    /// The parent rotated about its own axis `axis` by an angle.
    Turned {
        /// Index of the parent frame.
        parent: usize,
        /// Index of the state that is the rotation angle, rad.
        angle: usize,
        /// Index of the state that is the angle's rate, rad/s; none if equations are stated and the rate is no state.
        rate: Option<usize>,
        /// Number of the rotation axis: 1, 2 or 3.
        axis: u8,
    },
    /// The parent rotated by a unit quaternion: v_parent = q v_frame q*.
    Quaternion {
        /// Index of the parent frame.
        parent: usize,
        /// Indices of the quaternion's states, scalar part first.
        states: [usize; 4],
    },
}

/// The body whose equations of motion are derived from Newton's and Euler's laws.
#[derive(Clone, Debug)]
pub struct Body {
    /// Name of the body.
    pub name: String,
    /// Mass, kg; constant during a flight: depends only on parameters and coefficients.
    pub mass: Expr,
    /// Indices of the states of the position of the centre of mass, in frame 0.
    pub position: [usize; 3],
    /// Indices of the states of the velocity of the centre of mass.
    pub velocity: [usize; 3],
    /// Index of the frame of the velocity's components.
    pub velocity_frame: usize,
    /// Rotational motion; none for a point mass.
    pub rotation: Option<Rotation>,
    /// Source span of the declaration.
    pub span: Span,
}

/// Rotational motion of a rigid body.
#[derive(Clone, Debug)]
pub struct Rotation {
    /// Index of the body-fixed frame.
    pub body_frame: usize,
    /// Index of the frame of [`ExprKind::AngularVelocity`]; the inertia frame unless the body states another.
    pub angular_velocity_frame: usize,
    /// Index of the frame in which the inertia is constant: the body-fixed one, or one that differs from it by a rotation
    /// about an axis of symmetry.
    pub inertia_frame: usize,
    /// Inertia tensor, kg m², symmetric; entries depend on parameters and coefficients alone.
    pub inertia: [[Expr; 3]; 3],
    /// Indices of the angular velocity's states and of their frame for a quaternion attitude; none if the rates of the
    /// attitude angles are the states.
    pub angular_velocity: Option<([usize; 3], usize)>,
}

/// An auxiliary variable: a named expression, declared by `let`.
#[derive(Clone, Debug)]
pub struct AuxVariable {
    /// Name of the auxiliary variable.
    pub name: String,
    /// Documentation: the `///` lines before the declaration.
    pub doc: String,
    /// Defining expression.
    pub value: Expr,
    /// Source span of the declaration.
    pub span: Span,
    /// Index into [`Model::effects`] of the effect that added or replaced the statement; `None` for the model's own.
    pub effect: Option<usize>,
}

/// A force or a moment.
#[derive(Clone, Debug)]
pub struct Load {
    /// Name of the load.
    pub name: String,
    /// Force or moment vector in any frame, N or N m.
    pub value: Expr,
    /// Source span of the declaration.
    pub span: Span,
    /// Index into [`Model::effects`] of the effect that added or replaced the statement; `None` for the model's own.
    pub effect: Option<usize>,
}

impl Load {
    /// Whether the force is the body's weight, which an accelerometer does not feel: by its name, `weight` or one with
    /// `gravity` in it.
    pub fn is_weight(&self) -> bool {
        self.name == "weight" || self.name.contains("gravity")
    }
}

/// `der(state) = value`.
#[derive(Clone, Debug)]
pub struct Equation {
    /// Index of the state, in [`Model::states`].
    pub state: usize,
    /// Derivative of the state with respect to time.
    pub value: Expr,
    /// Source span of the declaration.
    pub span: Span,
}

/// The observed point, given by its coordinates in a frame.
#[derive(Clone, Debug)]
pub struct Marker {
    /// Name of the marker.
    pub name: String,
    /// Index of the frame of the marker's coordinates, in [`Model::frames`].
    pub frame: usize,
    /// Source span of the declaration.
    pub span: Span,
}

/// The measurement equation: the position that a sensor reports.
#[derive(Clone, Debug)]
pub struct Observation {
    /// Name of the observation.
    pub name: String,
    /// Observed position, a vector in the inertial frame 0, m.
    pub value: Expr,
    /// Source span of the declaration.
    pub span: Span,
}

/// Rate of flight time against the time of the measuring clock.
#[derive(Clone, Debug)]
pub struct Clock {
    /// Seconds of flight per second of the clock, dimensionless.
    pub value: Expr,
    /// Source span of the declaration.
    pub span: Span,
    /// Index into [`Model::effects`] of the effect that added or replaced the statement; `None` for the model's own.
    pub effect: Option<usize>,
}

/// A condition of the domain of validity: the model holds where `value > bound`.
#[derive(Clone, Debug)]
pub struct ValidityLimit {
    /// Scalar expression that must exceed the bound.
    pub value: Expr,
    /// Exclusive lower bound of the expression, SI.
    pub bound: f64,
    /// Reason why the model is invalid beyond the limit, for messages.
    pub reason: String,
    /// Source span of the declaration.
    pub span: Span,
}

/// A check case of the model file: settings and expected results.
#[derive(Clone, Debug)]
pub struct CheckCase {
    /// Title of the check case.
    pub title: String,
    /// Values that are set, SI; all others have their defaults.
    pub settings: Vec<(Target, f64)>,
    /// Results to compare, with expected values and tolerances.
    pub expectations: Vec<Expectation>,
    /// Source span of the declaration.
    pub span: Span,
}

/// A number that a check case sets; indices into the vectors of [`Model`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// A known constant, by index into [`Model::params`].
    Param(usize),
    /// A coefficient, by index into [`Model::coefficients`].
    Coefficient(usize),
    /// An input and the position (0 to 2) of its component.
    Input(usize, usize),
    /// A state, by index into [`Model::states`].
    State(usize),
}

/// A result that a check case compares.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Observable {
    /// The time derivative of a state, by index into [`Model::states`].
    Derivative(usize),
    /// A scalar auxiliary variable, by index into [`Model::aux_variables`].
    AuxVariable(usize),
}

/// An expected result of a check case.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Expectation {
    /// Model result that is compared.
    pub what: Observable,
    /// Expected value of the result, SI.
    pub value: f64,
    /// Absolute tolerance of the result, SI.
    pub within: f64,
    /// Source span of the statement.
    pub span: Span,
}

/// Shape of an expression: a number, or a vector with the frame of its components.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A scalar.
    Scalar,
    /// A vector with components in the frame of this index.
    Vector(usize),
}

/// A checked expression.
#[derive(Clone, Debug)]
pub struct Expr {
    /// Operation with its operands, or a name or literal.
    pub kind: ExprKind,
    /// Whether the value is a scalar, or a vector in which frame.
    pub shape: Shape,
    /// Unit of the expression's value.
    pub unit: Unit,
    /// Source span of the expression.
    pub span: Span,
}

/// Operations and operands of expressions. Indices point into the vectors of [`Model`]. Vectors are combined only in one
/// frame; `Reexpress` changes the frame.
#[derive(Clone, Debug)]
pub enum ExprKind {
    /// A literal, with its exact value if that is a fraction of small integers.
    Number {
        /// SI value.
        value: f64,
        /// SI value as numerator and denominator; none if it is not exact.
        exact: Option<(i64, i64)>,
    },
    /// The number π.
    Pi,
    /// Measured time since release, s; with a clock rate, that of the clock.
    Time,
    /// A known constant, by index into [`Model::params`].
    Param(usize),
    /// A coefficient, by index into [`Model::coefficients`].
    Coefficient(usize),
    /// An input vector, by index into [`Model::inputs`].
    Input(usize),
    /// A state, by index into [`Model::states`].
    State(usize),
    /// An auxiliary variable (`let`), by index into [`Model::aux_variables`].
    AuxVariable(usize),
    /// Unit vector along axis 1, 2 or 3 of the frame of this index.
    Axis(usize, u8),
    /// Position of the centre of mass, in the inertial frame 0, m.
    Position,
    /// Velocity of the centre of mass, in [`Body::velocity_frame`].
    Velocity,
    /// Angular velocity of the body, in the frame [`Rotation::angular_velocity_frame`].
    AngularVelocity,
    /// Sum of the forces other than the body's weight over its mass, in [`Body::velocity_frame`], m/s²; known once the
    /// forces are.
    SpecificForce,
    /// Derivative of the angular velocity in the inertial frame, with its components in
    /// [`Rotation::angular_velocity_frame`], rad/s²; known once forces and moments are.
    AngularAcceleration,
    /// Coordinates of the marker in the marker's frame, m.
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
    /// `a / b`; the scalar `b` is nonzero in the domain of validity.
    Div(Box<Expr>, Box<Expr>),
    /// `ratio(a, b, otherwise)`: `a / b`, or `otherwise` if `b` is 0.
    Ratio(Box<[Expr; 3]>),
    /// `a ^ (n/2)`, with `n` as the second field.
    Pow(Box<Expr>, i32),
    /// Scalar product of two vectors.
    Dot(Box<Expr>, Box<Expr>),
    /// Vector product of two vectors.
    Cross(Box<Expr>, Box<Expr>),
    /// Euclidean norm of a vector; 0 with derivative 0 at the zero vector.
    Norm(Box<Expr>),
    /// Unit vector along a vector; at the zero vector the second expression, or else the zero vector.
    Direction(Box<Expr>, Option<Box<Expr>>),
    /// Component 1, 2 or 3 of a vector in the frame of its shape.
    Component(Box<Expr>, u8),
    /// A vector with its components transformed to the frame of the expression's shape.
    Reexpress(Box<Expr>),
    /// A function of one scalar.
    Call(Function, Box<Expr>),
    /// `atan2(y, x)`: 0 with derivative 0 where both are 0.
    Atan2(Box<Expr>, Box<Expr>),
    /// The smaller of two scalars.
    Min(Box<Expr>, Box<Expr>),
    /// The greater of two scalars.
    Max(Box<Expr>, Box<Expr>),
}
