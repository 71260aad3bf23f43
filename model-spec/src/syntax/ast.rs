//! Syntax tree of a model file: names unresolved, each node with its source span.
//!
//! Fields are public so that other crates can change a model and check it with [`check`](crate::check()).

mod claim;
mod effect;
mod table;

use crate::source::Span;
pub use claim::{Claim, ClaimPart, ClaimPartKind};
pub use effect::{Effect, EffectPart, Need};
pub use table::{Continuation, Interpolation, Table};

/// A parsed file: a model, effects, or both.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct File {
    /// Documentation: the `//!` lines.
    pub doc: String,
    /// Statements in order; those of applied effects come last.
    pub items: Vec<Item>,
    /// Applied effects, in order.
    pub applied: Vec<Applied>,
    /// End of the text, the source span of errors about missing statements.
    pub end: Span,
}

/// An effect that has been applied to a syntax tree, without its statements.
#[derive(Clone, Debug, PartialEq)]
pub struct Applied {
    /// Name of the effect.
    pub name: Name,
    /// Documentation: the `///` lines before the effect.
    pub doc: String,
    /// Name of the component of the model that the effect changes, such as `drag`.
    pub site: String,
    /// Variables that the effect depends on, such as `alpha`.
    pub variables: Vec<String>,
    /// Literature reference of the effect; empty if none is stated.
    pub citation: String,
    /// What the effect does where its first coefficient is above its null value; empty if none is stated.
    pub increases: String,
    /// What the effect does where its first coefficient is below its null value; empty if none is stated.
    pub decreases: String,
    /// Smallest effect size of interest of each coefficient and state that states one (`negligible`).
    pub negligible: Vec<(Name, Quantity)>,
    /// Quantities of the model that the effect needs, without those that the model lacks and the effect can do without.
    pub needs: Vec<Need>,
}

/// A statement of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Item {
    /// Kind of statement, with its content.
    pub kind: ItemKind,
    /// Documentation: the `///` lines before the statement.
    pub doc: String,
    /// Source span from the first word of the statement to its end.
    pub span: Span,
    /// Index into [`File::applied`] of the effect that added or replaced the statement; `None` for the model's own.
    pub effect: Option<usize>,
}

/// Kinds of statement in a model file, with their content.
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
    /// `table NAME(ARGUMENT: UNIT): UNIT = { … };`
    Table(Table),
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
    /// `claim body NAME { … }` or `claim point NAME { … }`
    Claim(Claim),
    /// `effect NAME { … }`
    Effect(Effect),
}

/// A name in ASCII spelling (`alpha` for `α`).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Name {
    /// ASCII spelling of the name.
    pub text: String,
    /// Source span of the name.
    pub span: Span,
}

/// A literal number with its sign, as text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Number {
    /// Sign, digits, point and exponent, in a form that `f64::from_str` reads.
    pub text: String,
    /// Source span of the literal.
    pub span: Span,
}

/// A literal number with an optional unit.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    /// Literal number.
    pub number: Number,
    /// Unit of the number; `None` if none is written.
    pub unit: Option<UnitExpr>,
    /// Source span of number and unit.
    pub span: Span,
}

/// Unit expression: a product of powers of unit symbols; without factors it is `1`. The only factor `?`
/// ([`UnitExpr::INFERRED`]) asks for the unit that the uses of the declared name imply.
#[derive(Clone, Debug, PartialEq)]
pub struct UnitExpr {
    /// Powers of unit symbols whose product is the unit.
    pub factors: Vec<UnitFactor>,
    /// Source span of the unit expression.
    pub span: Span,
}

impl UnitExpr {
    /// Symbol of the unit that is inferred: `[?]` behind the number of a declaration.
    pub const INFERRED: &str = "?";

    /// Whether the unit is to be inferred from uses, `[?]`.
    pub fn is_inferred(&self) -> bool {
        matches!(&self.factors[..], [only] if only.symbol == UnitExpr::INFERRED)
    }
}

/// One power of a unit symbol.
#[derive(Clone, Debug, PartialEq)]
pub struct UnitFactor {
    /// Unit symbol, such as `kg`.
    pub symbol: String,
    /// Exponent of the symbol, times 2.
    pub doubled: i32,
    /// Source span of symbol and exponent.
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
    /// Known constant or coefficient to be estimated.
    pub class: ParameterClass,
    /// Name of the parameter.
    pub name: Name,
    /// Default value, with its unit.
    pub value: Quantity,
    /// Lower and upper bound; in the unit of the default unless they state one.
    pub bounds: Option<(Quantity, Quantity)>,
}

/// Declaration of a vector given with each flight.
#[derive(Clone, Debug, PartialEq)]
pub struct Input {
    /// Name of the input vector.
    pub name: Name,
    /// Name of the frame of the vector's components.
    pub frame: Name,
    /// Default values of the three components, in [`Input::unit`].
    pub value: [Number; 3],
    /// Unit of the components; `None` if none is written.
    pub unit: Option<UnitExpr>,
}

/// Declaration of a state that is not the body's.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// Name of the state.
    pub name: Name,
    /// Default initial value, with its unit.
    pub value: Quantity,
}

/// Declaration of a frame of reference.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// Name of the frame.
    pub name: Name,
    /// Orientation of the frame relative to its parent.
    pub kind: FrameKind,
}

/// Orientation of a frame relative to its parent.
#[derive(Clone, Debug, PartialEq)]
pub enum FrameKind {
    /// Inertial, third axis up.
    Inertial,
    /// Parent frame rotated about one of its axes by an angle.
    Turned {
        /// Name of the parent frame.
        parent: Name,
        /// Name of the state that is the rotation angle.
        angle: Name,
        /// Number of the rotation axis: 1, 2 or 3.
        axis: u8,
    },
    /// Parent frame rotated by a unit quaternion.
    Quaternion {
        /// Name of the parent frame.
        parent: Name,
        /// Names of the quaternion's states, scalar part first.
        states: [Name; 4],
    },
}

/// Whether a body is rigid or a point mass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BodyClass {
    /// Rigid body with mass and inertia (`body`).
    Rigid,
    /// Point mass (`point`).
    Point,
}

/// Declaration of a rigid body or a point mass.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Rigid body or point mass.
    pub class: BodyClass,
    /// Name of the body.
    pub name: Name,
    /// Statements of the body's block, in order.
    pub parts: Vec<BodyPart>,
}

/// A statement in the block of a body.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyPart {
    /// Kind of statement, with its content.
    pub kind: BodyPartKind,
    /// Source span of the statement.
    pub span: Span,
}

/// Kinds of statement in the block of a body.
#[derive(Clone, Debug, PartialEq)]
pub enum BodyPartKind {
    /// `mass EXPR;`: mass, kg.
    Mass(Expr),
    /// `inertia … in FRAME;`: inertia tensor, kg m².
    Inertia(Box<Inertia>),
    /// `fixed in FRAME;`: the body-fixed frame.
    Fixed(Name),
    /// `position (x, y, z) in FRAME;`: position states of the centre of mass, and their frame.
    Position([Name; 3], Name),
    /// `velocity (u, v, w) in FRAME;`: velocity states of the centre of mass, and their frame.
    Velocity([Name; 3], Name),
    /// `angular velocity (p, q, r) in FRAME;`: angular-velocity states, and their frame.
    AngularVelocity([Name; 3], Name),
    /// `angular velocity in FRAME;`: frame of the name `angular_velocity` in expressions.
    AngularVelocityIn(Name),
}

/// Inertia tensor of a body.
#[derive(Clone, Debug, PartialEq)]
pub struct Inertia {
    /// Entries of the tensor, row by row; `None` for the off-diagonal entries of `diag(…)`.
    pub rows: [[Option<Expr>; 3]; 3],
    /// Name of the frame of the tensor's components.
    pub frame: Name,
}

/// Declaration of an auxiliary variable: `let NAME: unit = …;`.
#[derive(Clone, Debug, PartialEq)]
pub struct Let {
    /// Name of the auxiliary variable.
    pub name: Name,
    /// Declared unit; `None` if it is to be computed.
    pub unit: Option<UnitExpr>,
    /// Defining expression.
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
    /// Whether the load is a force or a moment.
    pub class: LoadClass,
    /// Name of the load.
    pub name: Name,
    /// Vector expression of the load, N or N m.
    pub value: Expr,
}

/// A stated differential equation: `der(STATE) = …`.
#[derive(Clone, Debug, PartialEq)]
pub struct Equation {
    /// Name of the state.
    pub state: Name,
    /// Derivative of the state with respect to time.
    pub value: Expr,
}

/// Declaration of the observed point (marker).
#[derive(Clone, Debug, PartialEq)]
pub struct Marker {
    /// Name of the marker.
    pub name: Name,
    /// Name of the frame of the marker's coordinates.
    pub frame: Name,
}

/// The measurement equation: `observe NAME = …`.
#[derive(Clone, Debug, PartialEq)]
pub struct Observe {
    /// Name of the observation.
    pub name: Name,
    /// Expression of the observed position, m.
    pub value: Expr,
}

/// A validity limit: the model holds where the value is above the bound.
#[derive(Clone, Debug, PartialEq)]
pub struct Limit {
    /// Scalar expression that must exceed the bound.
    pub value: Expr,
    /// Lower bound of the expression.
    pub bound: Quantity,
    /// Reason why the model is invalid beyond the limit, for messages.
    pub reason: String,
}

/// A check case: values to set, and expected results.
#[derive(Clone, Debug, PartialEq)]
pub struct Check {
    /// Title of the case, unique in the file.
    pub title: String,
    /// Statements of the case's block, in order.
    pub parts: Vec<CheckPart>,
}

/// A statement of a check case.
#[derive(Clone, Debug, PartialEq)]
pub enum CheckPart {
    /// `set NAME = value;`
    Set {
        /// Name of a parameter, coefficient, state or input, or of a component of an input.
        name: Name,
        /// One literal, or the three components of a vector.
        value: Vec<Number>,
        /// Unit of the literals; `None` if none is written.
        unit: Option<UnitExpr>,
        /// Source span of the statement.
        span: Span,
    },
    /// `expect NAME = value within tolerance;`
    Expect {
        /// Name of an auxiliary variable, or of a state if `derivative`.
        name: Name,
        /// Whether the compared result is the derivative `der(NAME)`.
        derivative: bool,
        /// Expected value of the result.
        value: Quantity,
        /// Absolute tolerance; without a unit it has the unit of the value.
        within: Quantity,
        /// Source span of the statement.
        span: Span,
    },
}

/// An expression of the syntax tree.
#[derive(Clone, Debug, PartialEq)]
pub struct Expr {
    /// Operation with its operands, or a name or literal.
    pub kind: ExprKind,
    /// Source span of the expression, with enclosing brackets.
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
    /// A literal number with an optional unit.
    Number(Quantity),
    /// A name, not yet resolved.
    Name(String),
    /// `F.k` or `v.k`: unit vector along axis k of frame F, or component k (1 to 3) of a vector.
    Part(Box<Expr>, u8),
    /// `der(STATE)`: derivative of a state with respect to time.
    Derivative(Name),
    /// `(a, b, c) in FRAME`: a vector by its components.
    Components(Box<[Expr; 3]>, Name),
    /// Negation `-a`.
    Neg(Box<Expr>),
    /// A binary operation, such as `a + b`.
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    /// Function call `f(a, …)`.
    Call(Name, Vec<Expr>),
}
