//! The checked model: names resolved to indices, each expression with its shape, unit and source span.
//!
//! The compiler and the tree oracle read this representation. All indices refer to the vectors of [`Model`].

mod axes;
mod cases;
mod inertia;
mod parts;
mod system;
mod walk;

use std::sync::Arc;

use crate::location::Span;
use crate::syntax::ast;
use crate::unit::Unit;

pub use crate::location::Source;
pub use axes::{BodyAxis, FlightAxes};
pub use cases::{CheckCase, Expectation, Observable, Target};
pub use inertia::InertiaTensor;
pub use parts::{
    AppliedEffect, Claim, ClaimedAttitude, ClaimedRotation, Continuation, EffectUnknown, Function,
    Interpolation, Table, TableArgument,
};
pub use system::{Balance, LinearSystem, Unknown};

/// A checked model of a flying body: its states, parameters, frames, forces, moments and equations.
#[derive(Clone, Debug, Default)]
pub struct Model {
    /// Name of the model, by which commands and datasets refer to it.
    pub name: String,
    /// Documentation: the `//!` lines of the file.
    pub doc: String,
    /// Name of the equations coded by hand with which `hyzer verify` compares the model, if any.
    pub reference: Option<String>,
    /// Source texts: the text of the model file first, then the text of each applied effect.
    pub sources: Vec<Source>,
    /// Known constants of the body and its environment, and scalar inputs, in order of declaration.
    pub params: Vec<Parameter>,
    /// Coefficients, which are estimated from flights, in order of declaration; those that effects add come last.
    pub coefficients: Vec<Parameter>,
    /// Input vectors, whose values are specified for each flight, such as the wind.
    pub inputs: Vec<Input>,
    /// Components of the state vector, in order.
    pub states: Vec<State>,
    /// Frames of reference, each after its parent. Frame 0 is inertial, with its third axis up.
    pub frames: Vec<Frame>,
    /// Angles, rad, by which frames are turned for a whole flight: expressions of numbers, parameters and coefficients.
    pub constant_angles: Vec<Expr>,
    /// The body whose equations of motion are derived; `None` if the model states every equation.
    pub body: Option<Body>,
    /// Functions given by tables, in order of declaration.
    pub tables: Vec<Table>,
    /// Auxiliary variables, ordered so that each follows the variables that its definition uses.
    pub aux_variables: Vec<AuxVariable>,
    /// Forces at the centre of mass, N; each may have its components in any frame.
    pub forces: Vec<Load>,
    /// Moments about the centre of mass, N m; each may have its components in any frame.
    pub moments: Vec<Load>,
    /// Stated equations `der(STATE) = …`, in order of the states; with a body, of states that it does not determine.
    pub equations: Vec<Equation>,
    /// Blocks `solve { … }`, each after those whose unknowns its equations use.
    pub systems: Vec<LinearSystem>,
    /// Mass, motion and loads of a body that [`Model::equations`] are claimed to describe, for `hyzer verify`.
    pub claim: Option<Claim>,
    /// Changes of quantities along the motion that are claimed, for `hyzer verify`.
    pub balances: Vec<Balance>,
    /// The observed point, whose coordinates are specified with each observation.
    pub marker: Option<Marker>,
    /// Measurement equation: the observed position, in the inertial frame, m.
    pub observation: Option<Observation>,
    /// Rate of true time relative to recorded time. Every time derivative is multiplied by it. `None` if the rate is 1.
    pub clock: Option<Clock>,
    /// Limits of the domain of validity: the model is valid only where each limit's expression exceeds its lower bound.
    pub limits: Vec<ValidityLimit>,
    /// Test cases that the model file states as `check "title" { … }`, each with values to set and expected results.
    pub checks: Vec<CheckCase>,
    /// Applied effects, in order of application.
    pub effects: Vec<AppliedEffect>,
    /// The syntax tree that was checked, with the effects applied to it.
    pub tree: Arc<ast::File>,
}

/// A known constant, a coefficient or a scalar input.
#[derive(Clone, Debug, Default)]
pub struct Parameter {
    /// Name, such as `C_La` or `m`.
    pub name: String,
    /// Documentation: the `///` lines before the declaration.
    pub doc: String,
    /// Unit, declared or inferred.
    pub unit: Unit,
    /// Text of the SI unit of [`Parameter::value`], such as `1/rad`; `rad` for a parameter in `deg`.
    pub unit_text: String,
    /// Whether the value may vary during a flight: a scalar input.
    pub varies: bool,
    /// Whether the unit was inferred from the uses of the parameter.
    pub inferred: bool,
    /// Default value, SI.
    pub value: f64,
    /// Lower and upper bound of the value, SI; `None` if the declaration states no bounds.
    pub bounds: Option<(f64, f64)>,
    /// Source span of the name in the declaration.
    pub span: Span,
}

/// A vector specified for each flight, such as the wind, with the parameters `<name>_x`, `<name>_y`, `<name>_z`.
#[derive(Clone, Debug, Default)]
pub struct Input {
    /// Name of the input vector.
    pub name: String,
    /// Documentation: the `///` lines before the declaration.
    pub doc: String,
    /// Index into [`Model::frames`] of the frame of the vector's components.
    pub frame: usize,
    /// Unit of the vector's components.
    pub unit: Unit,
    /// Text of the components' unit, an SI unit.
    pub unit_text: String,
    /// Default values of the three components, SI.
    pub value: [f64; 3],
    /// Source span of the name in the declaration.
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
    /// Default initial value, SI; unless stated, 1 for the scalar part of a quaternion and 0 for others.
    pub value: f64,
    /// Source span of the name in the declaration; for the rate of a rotation angle, such as `phidot`, of the angle.
    pub span: Span,
}

/// A frame of reference, in which vectors have their components.
#[derive(Clone, Debug)]
pub struct Frame {
    /// Name of the frame.
    pub name: String,
    /// Orientation of the frame relative to its parent, the frame from which it is rotated.
    pub kind: FrameKind,
    /// Source span of the name in the declaration.
    pub span: Span,
}

/// Orientation of a frame relative to its parent, the frame from which it is rotated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FrameKind {
    /// The inertial frame, with its third axis up. Only frame 0 has this kind.
    Inertial,
    /// The parent frame rotated by an angle about the parent's axis `axis`, positive by the right-hand rule.
    Turned {
        /// Index into [`Model::frames`] of the parent frame.
        parent: usize,
        /// Index into [`Model::states`] of the rotation angle, rad.
        angle: usize,
        /// Index into [`Model::states`] of the time derivative of the rotation angle, rad/s; `None` if that derivative
        /// is not a state, which is possible only in a model without a body.
        rate: Option<usize>,
        /// Number of the rotation axis: axis 1, 2 or 3 of the parent frame, which the rotation leaves unchanged.
        axis: u8,
    },
    /// The parent frame rotated about its axis `axis` by a constant angle, positive by the right-hand rule.
    Fixed {
        /// Index into [`Model::frames`] of the parent frame.
        parent: usize,
        /// Index into [`Model::constant_angles`] of the rotation angle, rad.
        angle: usize,
        /// Number of the rotation axis: axis 1, 2 or 3 of the parent frame, which the rotation leaves unchanged.
        axis: u8,
    },
    /// The parent frame rotated by a unit quaternion q: v_parent = q v_frame q*.
    Quaternion {
        /// Index into [`Model::frames`] of the parent frame.
        parent: usize,
        /// Indices into [`Model::states`] of the quaternion's components, scalar part first.
        states: [usize; 4],
    },
}

impl FrameKind {
    /// Index into [`Model::frames`] of the parent frame; `None` for the inertial frame.
    pub fn parent(self) -> Option<usize> {
        match self {
            FrameKind::Inertial => None,
            FrameKind::Turned { parent, .. }
            | FrameKind::Fixed { parent, .. }
            | FrameKind::Quaternion { parent, .. } => Some(parent),
        }
    }
}

/// The body whose equations of motion are derived from Newton's and Euler's laws.
#[derive(Clone, Debug)]
pub struct Body {
    /// Name of the body.
    pub name: String,
    /// Mass, kg. It depends only on parameters and coefficients, so it is constant during a flight.
    pub mass: Expr,
    /// Indices into [`Model::states`] of the position of the centre of mass, with components in the inertial frame.
    pub position: [usize; 3],
    /// Indices into [`Model::states`] of the velocity of the centre of mass.
    pub velocity: [usize; 3],
    /// Index into [`Model::frames`] of the frame of the velocity's components.
    pub velocity_frame: usize,
    /// Frames, inertia tensor and angular-velocity states of the rotational motion; `None` for a point mass.
    pub rotation: Option<Rotation>,
    /// Source span of the name in the declaration.
    pub span: Span,
}

/// Rotational motion of a rigid body: its frames, inertia tensor and angular-velocity states.
#[derive(Clone, Debug)]
pub struct Rotation {
    /// Index into [`Model::frames`] of the body-fixed frame.
    pub body_frame: usize,
    /// Index into [`Model::frames`] of the frame of [`ExprKind::AngularVelocity`].
    pub angular_velocity_frame: usize,
    /// Index into [`Model::frames`] of a frame in which the inertia tensor is constant.
    pub inertia_frame: usize,
    /// Inertia tensor about the centre of mass, kg m², in [`Rotation::inertia_frame`]: symmetric, of parameters alone,
    /// with off-diagonal entries such as -∫ x y dm.
    pub inertia: [[Expr; 3]; 3],
    /// With a quaternion attitude: indices of the states of the angular velocity, and of their frame. `None` for three
    /// angles, whose rates are states.
    pub angular_velocity: Option<([usize; 3], usize)>,
    /// Axis of the spin and axis that points ahead, in [`Rotation::body_frame`].
    pub axes: FlightAxes,
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
    /// Source span of the name in the declaration; after [`AuxVariable::new`], of the definition.
    pub span: Span,
    /// Index into [`Model::effects`] of the effect that added or replaced the declaration, if any.
    pub effect: Option<usize>,
    /// Whether a call of a function has added the variable: no [`Layout`](crate::Layout) lists it.
    pub is_of_call: bool,
}

impl AuxVariable {
    /// Creates an auxiliary variable that no effect has added; its span is that of its definition.
    pub fn new(name: impl Into<String>, value: Expr) -> AuxVariable {
        AuxVariable {
            name: name.into(),
            doc: String::new(),
            span: value.span,
            value,
            effect: None,
            is_of_call: false,
        }
    }
}

/// A force or a moment that acts on the body.
#[derive(Clone, Debug)]
pub struct Load {
    /// Name of the force or moment, such as `drag`.
    pub name: String,
    /// Force or moment vector in any frame, N or N m.
    pub value: Expr,
    /// Source span of the name in the declaration.
    pub span: Span,
    /// Index into [`Model::effects`] of the effect that added or replaced the declaration, if any.
    pub effect: Option<usize>,
}

impl Load {
    /// Whether the force, by its name, is the weight, which an accelerometer does not measure.
    pub fn is_weight(&self) -> bool {
        self.name == "weight" || self.name.contains("gravity")
    }
}

/// A differential equation that the model file writes explicitly: `der(state) = value`.
#[derive(Clone, Debug)]
pub struct Equation {
    /// Index into [`Model::states`] of the state whose derivative the equation defines.
    pub state: usize,
    /// Derivative of the state with respect to time.
    pub value: Expr,
    /// Source span of the name of the state in `der(STATE) = …`.
    pub span: Span,
}

/// Marker: the point whose position is observed. It is fixed in a frame of the model.
#[derive(Clone, Debug)]
pub struct Marker {
    /// Name of the marker.
    pub name: String,
    /// Index into [`Model::frames`] of the frame in which the marker is fixed and has its coordinates.
    pub frame: usize,
    /// Source span of the name in the declaration.
    pub span: Span,
}

/// The measurement equation: the position that a sensor reports.
#[derive(Clone, Debug)]
pub struct Observation {
    /// Name of the observed position.
    pub name: String,
    /// Observed position, a vector with components in the inertial frame, m.
    pub value: Expr,
    /// Source span of the name in the declaration.
    pub span: Span,
}

/// Rate of true time relative to recorded time.
#[derive(Clone, Debug)]
pub struct Clock {
    /// Seconds of true time per second of recorded time, dimensionless.
    pub value: Expr,
    /// Source span of the `clock` statement.
    pub span: Span,
}

/// A condition that bounds the domain of validity: the model is valid only where `value > bound`.
#[derive(Clone, Debug)]
pub struct ValidityLimit {
    /// Scalar expression that must exceed the bound.
    pub value: Expr,
    /// Exclusive lower bound of the expression, SI.
    pub bound: f64,
    /// Reason why the model is invalid where `value` does not exceed `bound`, for messages.
    pub reason: String,
    /// Source span of the `limit` statement; of a frame for a limit that [`Model::is_automatic`].
    pub span: Span,
}

/// Shape of an expression: a scalar, or a vector with the frame of its components.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A scalar.
    Scalar,
    /// A vector. The field is the index into [`Model::frames`] of the frame of its components.
    Vector(usize),
}

/// A checked expression: a node of the expression tree, with shape and unit.
#[derive(Clone, Debug)]
pub struct Expr {
    /// Operation with its operands, or a leaf such as a literal or a state.
    pub kind: ExprKind,
    /// Shape of the value: scalar, or vector with the frame of its components.
    pub shape: Shape,
    /// Unit of the expression's value.
    pub unit: Unit,
    /// Source span of the expression.
    pub span: Span,
}

/// Operations and leaves of expressions. Operands of vector operations other than `Reexpress` have one frame.
#[derive(Clone, Debug)]
pub enum ExprKind {
    /// A numeric literal.
    Number {
        /// Value of the literal, SI.
        value: f64,
        /// Exact SI value as (numerator, denominator), if it is rational and they fit `i64`.
        exact: Option<(i64, i64)>,
    },
    /// The number π.
    Pi,
    /// Recorded time since the start of the flight, s, see [`Clock`].
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
    /// An unknown of [`Model::systems`]: index of the system, and of the unknown in it.
    Unknown(usize, usize),
    /// How well the equations of a system, by index into [`Model::systems`], determine its unknowns: the least, over
    /// the steps of an elimination, of a pivot's size over the sum of the sizes of its terms. 0 where they do not.
    Determinacy(usize),
    /// Derivative by the time of the flight along the motion, of a vector in the inertial frame: `der(EXPR)`. States on
    /// which the expression depends, and their derivatives.
    Rate(Box<Expr>, Vec<usize>, Box<[Expr]>),
    /// Derivative of a state of the body by the time of the flight: index into [`Model::states`], and the forces or
    /// moments on which it depends; none of a coordinate.
    BodyRate(usize, Box<[Expr]>),
    /// Derivative of a scalar by a state, all others held: `partial(EXPR, STATE)`.
    Partial(Box<Expr>, usize),
    /// Unit vector along an axis of a frame: index into [`Model::frames`], and number of the axis (1 to 3).
    Axis(usize, u8),
    /// Position of the centre of mass, m, with components in the inertial frame.
    Position,
    /// Velocity of the centre of mass relative to the inertial frame, m/s, with components in [`Body::velocity_frame`].
    Velocity,
    /// Inertial angular velocity of the body, rad/s, in [`Rotation::angular_velocity_frame`].
    AngularVelocity,
    /// Specific force: forces other than the weight per mass, in [`Body::velocity_frame`], m/s².
    SpecificForce,
    /// Inertial derivative of the angular velocity, in [`Rotation::angular_velocity_frame`], rad/s².
    AngularAcceleration,
    /// Coordinates of the marker in the frame [`Marker::frame`], m.
    Marker,
    /// A vector made of three scalar components, which refer to the frame in [`Expr::shape`].
    Components(Box<[Expr; 3]>),
    /// Negation `-a`.
    Neg(Box<Expr>),
    /// Sum `a + b`.
    Add(Box<Expr>, Box<Expr>),
    /// Difference `a - b`.
    Sub(Box<Expr>, Box<Expr>),
    /// Product `a * b`; one operand may be a vector.
    Mul(Box<Expr>, Box<Expr>),
    /// Quotient `a / b`; the scalar `b` is nonzero in the domain of validity.
    Div(Box<Expr>, Box<Expr>),
    /// Guarded quotient `ratio(a, b, otherwise)`: `a / b`, or `otherwise` if `b` is 0.
    Ratio(Box<[Expr; 3]>),
    /// Power `a ^ (n/2)`; for odd `n`, 0 with derivative 0 where `a` is 0 or less.
    Pow(Box<Expr>, i32),
    /// Power `a ^ b` of dimensionless scalars, with any exponent; 0 with derivative 0 where `a` is 0 or less.
    RealPower(Box<Expr>, Box<Expr>),
    /// Scalar product of two vectors.
    Dot(Box<Expr>, Box<Expr>),
    /// Vector product of two vectors.
    Cross(Box<Expr>, Box<Expr>),
    /// Euclidean norm of a vector; 0 with derivative 0 at the zero vector.
    Norm(Box<Expr>),
    /// Unit vector along the first vector; the second, or 0, where that is zero.
    Direction(Box<Expr>, Option<Box<Expr>>),
    /// Component 1, 2 or 3 of a vector, in the frame in the vector's [`Expr::shape`].
    Component(Box<Expr>, u8),
    /// A vector whose components are transformed to the frame in [`Expr::shape`].
    Reexpress(Box<Expr>),
    /// A function of one scalar, with its argument.
    Call(Function, Box<Expr>),
    /// A table of two arguments, by index into [`Model::tables`], with its arguments.
    Lookup(usize, Box<Expr>, Box<Expr>),
    /// Arctangent `atan2(y, x)` of y/x in the correct quadrant; 0 with derivative 0 where both arguments are 0.
    Atan2(Box<Expr>, Box<Expr>),
    /// The smaller of two scalars. Where they are equal, the compiled derivative is that of the second.
    Min(Box<Expr>, Box<Expr>),
    /// The greater of two scalars. Where they are equal, the compiled derivative is that of the second.
    Max(Box<Expr>, Box<Expr>),
}
