//! Syntax tree of a model file, with unresolved names; each node has its source span.
//!
//! Fields are public so that other crates can change a model and check it with [`check`](crate::check()).

mod blocks;
mod functions;
mod solve;
mod unit;

use crate::location::Span;
pub use blocks::{
    Body, BodyClass, BodyPart, BodyPartKind, Check, CheckPart, Continuation, Effect, EffectPart,
    Inertia, InitialValues, Interpolation, Need, Table,
};
pub use functions::{
    Array, Ascription, Expanded, Function, FunctionParameter, Index, Template, Type,
};
pub use solve::{Balance, ImplicitEquation, Solve, UnknownQuantity};
use std::sync::Arc;
pub use unit::{UnitExpr, UnitFactor};

/// A parsed file: a model, effects, or both.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct File {
    /// Documentation: the `//!` lines of the file.
    pub doc: String,
    /// Statements in the order of the file, followed by the statements that applied effects add.
    pub items: Vec<Item>,
    /// Applied effects, in order of application, by the names of the model; their statements are in [`File::items`].
    pub applied: Vec<Effect>,
    /// Statements of quantities that are unknown in each flight, whose place states have taken, and the check cases.
    pub set_aside: SetAside,
    /// Empty span at the end of the text, for errors about missing statements.
    pub end: Span,
}

/// Statements that are left out while states stand for unknown quantities.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SetAside {
    /// The statements, each with its index in [`File::items`].
    pub items: Vec<(usize, Item)>,
    /// Names of the quantities, each with the states that stand for it.
    pub unknown: Vec<(String, Vec<String>)>,
    /// Source of the spans of the statements that have taken their place.
    pub source: u16,
}

/// A statement of a model file, such as a declaration, an equation or a check case.
#[derive(Clone, Debug, PartialEq)]
pub struct Item {
    /// Kind of statement, with its content.
    pub kind: ItemKind,
    /// Documentation: the `///` lines before the statement.
    pub doc: String,
    /// Source span from the first word of the statement to its end.
    pub span: Span,
    /// Index into [`File::applied`] of the effect that added or replaced the statement, if any.
    pub effect: Option<usize>,
    /// Statement of the text from which this one was expanded; `None` if it stands in the text itself.
    pub expanded: Option<Expanded>,
}

impl Item {
    /// Creates a statement that no applied effect has added.
    pub fn new(kind: ItemKind, doc: impl Into<String>, span: Span) -> Item {
        Item {
            kind,
            doc: doc.into(),
            span,
            effect: None,
            expanded: None,
        }
    }

    /// Whether the statement was made for a body after the first one, and does not stand in the text.
    pub fn is_of_body(&self) -> bool {
        let written = self.expanded.as_ref().map(|own| &own.from.written.kind);
        matches!(written, Some(ItemKind::Body(_))) && !matches!(self.kind, ItemKind::Body(_))
    }

    /// Whether the statement is an auxiliary variable of a function that a call has added.
    pub fn is_of_call(&self) -> bool {
        self.expanded.as_ref().is_some_and(|own| own.call.is_some())
    }
}

/// Kinds of statement in a model file, with their content.
#[derive(Clone, Debug, PartialEq)]
pub enum ItemKind {
    /// Name of the model: `model NAME;`
    Model(Name),
    /// Name of the reference implementation: `reference NAME;`
    Reference(Name),
    /// Declaration of a known constant or a coefficient: `param …;` or `coefficient …;`
    Parameter(Parameter),
    /// Declaration of an input vector: `input NAME in FRAME = (…) unit;`
    Input(Input),
    /// Declaration of a state: `state NAME = value;`
    State(State),
    /// Declaration of a frame of reference: `frame …;`
    Frame(Frame),
    /// Declaration of a rigid body or a point mass: `body NAME { … }` or `point NAME { … }`
    Body(Body),
    /// Declaration of a table: `table NAME(ARGUMENT: UNIT): UNIT = { … };`
    Table(Table),
    /// Statements of another file: `include "FILE";`
    Include(Name),
    /// Declaration of an auxiliary variable: `let NAME = …;`
    Let(Let),
    /// Declaration of a load: `force NAME = …;` or `moment NAME = …;`
    Load(Load),
    /// Differential equation: `der(STATE) = …;`
    Equation(Equation),
    /// Equations that are not solved for: `solve { … }`
    Solve(Solve),
    /// Declaration of the observed point: `marker NAME in FRAME;`
    Marker(Marker),
    /// Measurement equation: `observe NAME = …;`
    Observe(Observe),
    /// Rate of true time relative to recorded time: `clock EXPR;`
    Clock(Expr),
    /// Validity limit: `limit … > bound "reason";`
    Limit(Limit),
    /// Check case: `check "title" { … }`
    Check(Check),
    /// The body that the stated equations describe: `claim body NAME { … }` or `claim point NAME { … }`
    Claim(Body),
    /// Claimed change of a quantity along the motion: `claim der(EXPR) = EXPR;`
    Balance(Balance),
    /// Declaration of an effect: `effect NAME { … }`
    Effect(Effect),
    /// Declaration of a function: `function NAME(PARAMETER: TYPE, …): TYPE { … }`
    Function(Function),
    /// Statement for each element of an array: `let NAME[i] for i in 1..8 = …;`
    Array(Array),
}

/// A name with its source span; the text is in ASCII spelling (`alpha` for `α`).
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Name {
    /// ASCII spelling of the name.
    pub text: String,
    /// Source span of the name.
    pub span: Span,
}

impl Name {
    /// Creates a name from its ASCII spelling.
    pub fn new(text: impl Into<String>, span: Span) -> Name {
        Name {
            text: text.into(),
            span,
        }
    }
}

/// A numeric literal with its sign, as text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Number {
    /// Sign, digits, decimal point and exponent, in a form that `f64::from_str` accepts.
    pub text: String,
    /// Source span of the literal.
    pub span: Span,
}

/// A numeric literal with an optional unit.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    /// Numeric literal.
    pub number: Number,
    /// Unit of the number; `None` if none is written.
    pub unit: Option<UnitExpr>,
    /// Source span of number and unit.
    pub span: Span,
}

impl Quantity {
    /// Creates a literal from a text that `f64::from_str` accepts.
    pub fn new(text: impl Into<String>, unit: Option<UnitExpr>, span: Span) -> Quantity {
        Quantity {
            number: Number {
                text: text.into(),
                span,
            },
            unit,
            span,
        }
    }
}

/// Whether a parameter is a known constant, a coefficient to be estimated, or an input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ParameterClass {
    /// Known constant of the body or its environment (`param`).
    Param,
    /// Coefficient that is estimated from flights (`coefficient`).
    Coefficient,
    /// Scalar that is specified for each flight and may vary during it (`input`).
    Input,
}

impl ParameterClass {
    pub(crate) fn keyword(self) -> &'static str {
        match self {
            ParameterClass::Param => "param",
            ParameterClass::Coefficient => "coefficient",
            ParameterClass::Input => "input",
        }
    }
}

/// Declaration of a known constant, a coefficient or a scalar input.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// Whether the parameter is a known constant, a coefficient or an input.
    pub class: ParameterClass,
    /// Name of the parameter.
    pub name: Name,
    /// Default value, with its unit.
    pub value: Quantity,
    /// Lower and upper bound; a bound without a unit has the unit of the default value. `None` if no bounds are stated.
    pub bounds: Option<(Quantity, Quantity)>,
}

/// Declaration of an input: a vector, such as the wind, whose value is specified for each flight.
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

/// Declaration `state NAME = value;` of a state that neither frames nor a body declare.
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
    /// Orientation of the frame relative to its parent, the frame from which it is rotated.
    pub kind: FrameKind,
}

/// Orientation of a frame relative to its parent, the frame from which it is rotated.
#[derive(Clone, Debug, PartialEq)]
pub enum FrameKind {
    /// Inertial frame, with its third axis up.
    Inertial,
    /// Parent frame rotated about one of its axes by an angle.
    Turned {
        /// Name of the parent frame.
        parent: Name,
        /// Name of the rotation angle: a state, a parameter or a coefficient.
        angle: Name,
        /// Number of the rotation axis: axis 1, 2 or 3 of the parent frame, which the rotation leaves unchanged.
        axis: u8,
    },
    /// Parent frame rotated about one of its axes by an angle that is an expression of more than a name.
    Fixed {
        /// Name of the parent frame.
        parent: Name,
        /// The rotation angle, constant during a flight.
        angle: Expr,
        /// Number of the rotation axis: axis 1, 2 or 3 of the parent frame.
        axis: u8,
    },
    /// Parent frame rotated by a unit quaternion.
    Quaternion {
        /// Name of the parent frame.
        parent: Name,
        /// Names of the four quaternion states, scalar part first.
        states: [Name; 4],
    },
}

/// Declaration of an auxiliary variable: `let NAME: unit = …;`, or `param NAME: unit = …;` with an expression.
#[derive(Clone, Debug, PartialEq)]
pub struct Let {
    /// Whether the variable is declared by `param`, so that it must not change during a flight.
    pub is_constant: bool,
    /// Name of the auxiliary variable.
    pub name: Name,
    /// Declared unit; `None` if the unit follows from the defining expression.
    pub unit: Option<UnitExpr>,
    /// Defining expression.
    pub value: Expr,
}

impl Let {
    /// Creates the definition of a quantity that may change during a flight.
    pub fn new(name: Name, unit: Option<UnitExpr>, value: Expr) -> Let {
        Let {
            is_constant: false,
            name,
            unit,
            value,
        }
    }
}

/// Whether a load is a force or a moment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LoadClass {
    /// Force at the centre of mass.
    Force,
    /// Moment about the centre of mass.
    Moment,
}

impl LoadClass {
    pub(crate) fn keyword(self) -> &'static str {
        match self {
            LoadClass::Force => "force",
            LoadClass::Moment => "moment",
        }
    }
}

/// Declaration of a force or a moment.
#[derive(Clone, Debug, PartialEq)]
pub struct Load {
    /// Whether the load is a force or a moment.
    pub class: LoadClass,
    /// Name of the force or moment.
    pub name: Name,
    /// Body on which it acts; `None` for the first body.
    pub on: Option<Name>,
    /// Vector expression of the load, N or N m.
    pub value: Expr,
}

impl Load {
    /// Whether the load is stated to act on the body of this name.
    pub(crate) fn is_on(&self, body: &str) -> bool {
        self.on.as_ref().is_some_and(|on| on.text == body)
    }
}

/// A differential equation: `der(STATE) = …`.
#[derive(Clone, Debug, PartialEq)]
pub struct Equation {
    /// Name of the state whose derivative the equation defines.
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
    /// Name of the observed position.
    pub name: Name,
    /// Expression of the observed position, m.
    pub value: Expr,
}

/// A validity limit: the model is valid only where the expression `value` exceeds `bound`.
#[derive(Clone, Debug, PartialEq)]
pub struct Limit {
    /// Scalar expression that must exceed the bound.
    pub value: Expr,
    /// Exclusive lower bound of the expression; without a unit it is dimensionless, but 0 is valid for every unit.
    pub bound: Quantity,
    /// Reason why the model is invalid where the expression does not exceed the bound, for messages.
    pub reason: String,
}

/// An expression of the syntax tree.
#[derive(Clone, Debug, PartialEq)]
pub struct Expr {
    /// Operation with its operands, or a name or literal.
    pub kind: ExprKind,
    /// Source span of the expression, including enclosing parentheses.
    pub span: Span,
}

impl Expr {
    /// Creates an expression.
    pub fn new(kind: ExprKind, span: Span) -> Expr {
        Expr { kind, span }
    }

    /// Creates a name.
    pub fn name(text: impl Into<String>, span: Span) -> Expr {
        Expr::new(ExprKind::Name(text.into()), span)
    }

    /// Creates a numeric literal without a unit.
    pub fn number(text: impl Into<String>, span: Span) -> Expr {
        Expr::new(ExprKind::Number(Quantity::new(text, None, span)), span)
    }
}

/// Binary operators of expressions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BinaryOp {
    /// Addition, `+`.
    Add,
    /// Subtraction, `-`.
    Sub,
    /// Multiplication, `*`.
    Mul,
    /// Operator `·`: scalar product of two vectors, otherwise multiplication.
    Dot,
    /// Operator `×`: vector product of two vectors, otherwise multiplication.
    Cross,
    /// Division, `/`.
    Div,
    /// Exponentiation, `^`.
    Pow,
}

/// Operations and leaves of expressions, before names are resolved.
#[derive(Clone, Debug, PartialEq)]
pub enum ExprKind {
    /// A numeric literal with an optional unit.
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
    /// `NAME[i, …]`: an element of an array.
    Element(String, Vec<Expr>),
    /// `sum(i in 1..8, EXPR)`: sum over the values of an index.
    Sum(Box<Index>, Box<Expr>),
    /// Argument or result of a function, which must have a certain type.
    Ascribed(Box<Expr>, Arc<Ascription>),
}
