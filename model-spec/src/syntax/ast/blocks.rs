//! Syntax trees of the statements with a block: bodies, claims, cases, effects and tables.

use super::{Expr, Item, Name, Number, Quantity, UnitExpr};
use crate::location::Span;

/// Whether a body is rigid or a point mass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BodyClass {
    /// Rigid body with mass and inertia (`body`).
    Rigid,
    /// Point mass (`point`).
    Point,
}

impl BodyClass {
    pub(crate) fn keyword(self) -> &'static str {
        match self {
            BodyClass::Rigid => "body",
            BodyClass::Point => "point",
        }
    }
}

/// Block `body NAME { … }` or `point NAME { … }` that declares a body, or that follows `claim`.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Whether the body is rigid or a point mass.
    pub class: BodyClass,
    /// Name of the body.
    pub name: Name,
    /// Statements between the braces, in order.
    pub parts: Vec<BodyPart>,
}

/// A statement in the block of a body, such as `mass EXPR;`.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyPart {
    /// Keywords: `mass`, `inertia`, `fixed in`, `axis` of the spin, `forward`, `position`, `velocity`, `angular velocity`,
    /// `angular velocity in`; of a claim also `force` and `moment`, the sums of all loads with the weight.
    pub words: &'static str,
    /// Content of the statement.
    pub kind: BodyPartKind,
    /// Source span of the statement.
    pub span: Span,
}

/// Content of a statement in the block of a body.
#[derive(Clone, Debug, PartialEq)]
pub enum BodyPartKind {
    /// Inertia tensor, kg m²: `inertia … in FRAME;`
    Inertia(Box<Inertia>),
    /// Frame fixed in the body, or of the components of `angular_velocity`.
    Frame(Name),
    /// Names of the states of a declared body, the frame of their components, and their defaults:
    /// `position (x, y, z) in FRAME = (0, 0, 2) m;`
    States([Name; 3], Name, Option<Box<InitialValues>>),
    /// Mass, axis, or quantity of a claimed body.
    Value(Expr),
}

/// Default initial values of three states.
#[derive(Clone, Debug, PartialEq)]
pub struct InitialValues {
    /// The numbers, in [`InitialValues::unit`].
    pub values: [Number; 3],
    /// Unit of the numbers; `None` if none is written.
    pub unit: Option<UnitExpr>,
    /// Source span of the numbers with their unit.
    pub span: Span,
}

impl BodyPart {
    /// Expressions of the statement, in order.
    pub fn expressions(&self) -> Vec<&Expr> {
        match &self.kind {
            BodyPartKind::Inertia(inertia) => inertia.rows.iter().flatten().flatten().collect(),
            BodyPartKind::Value(e) => vec![e],
            BodyPartKind::Frame(_) | BodyPartKind::States(..) => Vec::new(),
        }
    }
}

/// Inertia tensor about the centre of mass, kg m², with off-diagonal entries such as `-∫ x y dm`.
#[derive(Clone, Debug, PartialEq)]
pub struct Inertia {
    /// Entries of the tensor, row by row; `None` for the off-diagonal entries of `diag(…)`.
    pub rows: [[Option<Expr>; 3]; 3],
    /// Name of the frame of the tensor's components.
    pub frame: Name,
}

/// An effect `effect NAME { … }`: a named change to a model, such as an additional force.
#[derive(Clone, Debug, PartialEq)]
pub struct Effect {
    /// Name of the effect, words separated by underscores.
    pub name: Name,
    /// Documentation: the `///` lines before the effect.
    pub doc: String,
    /// Names of the models that the effect is compatible with; empty for any model.
    pub on: Vec<Name>,
    /// Statements in the block of the effect, in order.
    pub parts: Vec<EffectPart>,
}

impl Effect {
    /// Quantities that a model must have, or that have a fallback.
    pub(crate) fn needs(&self) -> impl Iterator<Item = &Need> {
        self.parts.iter().flat_map(|part| match part {
            EffectPart::Needs(needs) => needs.as_slice(),
            _ => &[],
        })
    }

    /// Statements that the effect adds to the model, in order.
    pub(crate) fn added(&self) -> impl Iterator<Item = &Item> {
        self.parts.iter().filter_map(|part| match part {
            EffectPart::Add(item) => Some(&**item),
            _ => None,
        })
    }

    /// Whether the effect is restricted to certain models by `on MODEL, …`, and `model` is not one of them.
    pub(crate) fn excludes(&self, model: &str) -> bool {
        !self.on.is_empty() && self.on.iter().all(|on| on.text != model)
    }
}

/// A quantity that a model must have for an effect to be applicable.
#[derive(Clone, Debug, PartialEq)]
pub struct Need {
    /// Name of the needed quantity, such as `air_velocity`.
    pub name: Name,
    /// Whether the needed quantity is a vector.
    pub is_vector: bool,
    /// Unit of the needed quantity; `None` for an angle or a pure number.
    pub unit: Option<UnitExpr>,
    /// Fallback expression in a model that lacks the quantity.
    pub otherwise: Option<Expr>,
}

/// A statement in the block of an effect.
#[derive(Clone, Debug, PartialEq)]
pub enum EffectPart {
    /// `needs NAME: UNIT, …;`: quantities that the model must have.
    Needs(Vec<Need>),
    /// `generalises NAME, …;`: more specific effects; where one is applicable, this one is no candidate.
    Generalises(Vec<Name>),
    /// `source "…";`: literature reference, with the source span of the statement.
    Citation(String, Span),
    /// `increases "…";`: sentence for a first coefficient above its null value, with the span of the statement.
    Increases(String, Span),
    /// `decreases "…";`: sentence for a first coefficient below its null value, with the span of the statement.
    Decreases(String, Span),
    /// `site NAME;`: component of the model that changes, one of [`SITES`](crate::SITES).
    Site(Name),
    /// `variables NAME, NAME;`: what the effect depends on, from [`VARIABLES`](crate::VARIABLES), with the span.
    Variables(Vec<Name>, Span),
    /// `negligible NAME value;`: smallest effect size of interest of a coefficient or initial state.
    Negligible(Name, Quantity),
    /// `replace …;`: statement that replaces the model's statement of equal kind and name.
    Replace(Box<Item>),
    /// `replace inertia … in FRAME;`: inertia tensor in place of the body's, with the span of the statement.
    ReplaceInertia(Box<Inertia>, Span),
    /// A declaration, such as a coefficient or a load, that the effect adds to the model.
    Add(Box<Item>),
}

/// Method of interpolation between the knots of a table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Interpolation {
    /// Cubic spline, natural with [`Continuation::Linear`] and clamped with [`Continuation::Constant`]. The default.
    #[default]
    Spline,
    /// Piecewise cubic that is monotone between knots (Fritsch and Carlson 1980). Stated as `monotone`.
    Monotone,
    /// Straight lines between knots, or bilinear in two arguments; the slope jumps at the knots. Stated as `linear`.
    Linear,
}

/// Method of extrapolation below the first and above the last knot of a table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Continuation {
    /// Linear extrapolation, with the slope of the interpolated curve at the end knot. The default.
    #[default]
    Linear,
    /// Constant extrapolation, with slope zero at the end knots. Stated as `constant`.
    Constant,
}

/// Declaration of a table of one or two arguments: `table NAME(ARGUMENT: UNIT): UNIT = { argument: value, … };`.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Name of the table, by which it is called.
    pub name: Name,
    /// One or two arguments, each with its unit, which is `None` for a pure number.
    pub arguments: Vec<(Name, Option<UnitExpr>)>,
    /// Unit of the value; `None` for a pure number.
    pub unit: Option<UnitExpr>,
    /// Path of the file with the knots, relative to the file of the statement, until the file has been read.
    pub file: Option<Name>,
    /// Knots of the second argument; empty for a table of one argument.
    pub columns: Vec<Quantity>,
    /// Each knot of the first argument with the values there: one, or one for each knot of the second argument. A
    /// quantity without a unit has the unit declared for the argument or the value.
    pub rows: Vec<(Quantity, Vec<Quantity>)>,
    /// Method of interpolation between the knots.
    pub interpolation: Interpolation,
    /// Method of extrapolation below the first and above the last knot.
    pub continuation: Continuation,
}

/// A test case, `check "title" { … }`: values to set, and results expected for these values.
#[derive(Clone, Debug, PartialEq)]
pub struct Check {
    /// Title of the check case; no other check case of the file has the same title.
    pub title: String,
    /// Statements between the braces of the check case, in order.
    pub parts: Vec<CheckPart>,
}

/// A statement of a check case: sets a value or states an expected result.
#[derive(Clone, Debug, PartialEq)]
pub enum CheckPart {
    /// Sets a value: `set NAME = value;`
    Set {
        /// Name of a parameter, coefficient, state, input or marker, or of a component of an input.
        name: Name,
        /// One literal, or three literals for the components of an input or of the marker.
        value: Vec<Number>,
        /// Unit of the literals; zeros need none.
        unit: Option<UnitExpr>,
        /// Source span of the statement.
        span: Span,
    },
    /// Compares a result with its expected value: `expect NAME = value within tolerance;`
    Expect {
        /// Name of an auxiliary variable, or of a state if `derivative`.
        name: Name,
        /// Whether the compared result is the derivative `der(NAME)`.
        derivative: bool,
        /// Expected value of the result; without a unit it is dimensionless, but 0 is valid for every unit.
        value: Quantity,
        /// Tolerance of the comparison; without a unit it has the unit of the expected value.
        within: Quantity,
        /// Whether the tolerance is relative to the expected value: `within 1e-9 relative`.
        is_relative: bool,
        /// Source span of the statement.
        span: Span,
    },
}
