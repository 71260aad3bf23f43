//! Parts of a model: claimed body, applied effects, tables and functions.

use super::{Expr, FlightAxes, Model, Rotation};
use crate::fingerprint;
pub use crate::syntax::ast::{Continuation, Interpolation};
use crate::unit::Unit;

/// Mass, motion and loads of a body that a `claim` block declares, which `hyzer verify` compares with the equations.
#[derive(Clone, Debug)]
pub struct Claim {
    /// Name of the body that the equations of the model are declared to describe.
    pub name: String,
    /// Mass, kg; depends only on parameters and coefficients.
    pub mass: Expr,
    /// Position of the centre of mass, a vector in any frame, m.
    pub position: Expr,
    /// Velocity of the centre of mass relative to the inertial frame, a vector in any frame, m/s.
    pub velocity: Expr,
    /// Sum of all forces including the weight, a vector in any frame, N.
    pub force: Expr,
    /// Rotational motion; `None` for a point mass.
    pub rotation: Option<ClaimedRotation>,
}

/// Rotational motion of a claimed body.
#[derive(Clone, Debug)]
pub struct ClaimedRotation {
    /// Body-fixed frame, or axis of revolution, that gives the orientation of the body.
    pub attitude: ClaimedAttitude,
    /// Index into [`Model::frames`](super::Model::frames) of the frame in which the inertia tensor is constant.
    pub inertia_frame: usize,
    /// Inertia tensor about the centre of mass, kg m², in [`ClaimedRotation::inertia_frame`].
    pub inertia: [[Expr; 3]; 3],
    /// Angular velocity of the body relative to the inertial frame, a vector in any frame, rad/s.
    pub angular_velocity: Expr,
    /// Sum of all moments about the centre of mass, a vector in any frame, N m.
    pub moment: Expr,
    /// Axis of the spin and axis that points ahead, in the frame of [`ClaimedRotation::attitude`].
    pub axes: FlightAxes,
}

/// How a [`Claim`] specifies the orientation of the body: by a body-fixed frame, or by the axis of revolution alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ClaimedAttitude {
    /// The body-fixed frame, by index into [`Model::frames`](super::Model::frames).
    Frame(usize),
    /// The axis of revolution: frame, which does not spin with the body, and number of its axis (1 to 3).
    Axis(usize, u8),
}

impl Model {
    /// Rotational motion of the declared body; `None` without a body, or of a point.
    pub fn rotation(&self) -> Option<&Rotation> {
        self.body.as_ref()?.rotation.as_ref()
    }

    /// Whether its body turns: rigid, not a point.
    pub fn has_rotating_body(&self) -> bool {
        self.rotation().is_some()
    }

    /// Axes of the declared or claimed body in flight, and the index into [`Model::frames`] of their frame; `None`
    /// without a body that turns.
    pub fn flight_axes(&self) -> Option<(usize, FlightAxes)> {
        if self.body.is_some() {
            let rotation = self.rotation()?;
            return Some((rotation.body_frame, rotation.axes));
        }
        let rotation = self.claim.as_ref()?.rotation.as_ref()?;
        let (ClaimedAttitude::Frame(frame) | ClaimedAttitude::Axis(frame, _)) = rotation.attitude;
        Some((frame, rotation.axes))
    }
}

/// Function body of [`Claim::expressions`] and [`Claim::expressions_mut`], which differ only in the kind of reference.
macro_rules! expressions {
    ($claim:expr, $iter:ident $(, $mutable:tt)?) => {{
        let Claim { mass, position, velocity, force, rotation, .. } = $claim;
        let mut all = vec![mass, position, velocity, force];
        for rotation in rotation.$iter() {
            all.extend(rotation.inertia.$iter().flatten());
            all.push(&$($mutable)? rotation.angular_velocity);
            all.push(&$($mutable)? rotation.moment);
        }
        all
    }};
}

impl Claim {
    /// References to all expressions of the `claim` block.
    pub fn expressions(&self) -> Vec<&Expr> {
        expressions!(self, iter)
    }

    /// Mutable references to all expressions of the `claim` block.
    pub fn expressions_mut(&mut self) -> Vec<&mut Expr> {
        expressions!(self, iter_mut, mut)
    }
}

/// An effect that has been applied to a model.
#[derive(Clone, Debug, Default)]
pub struct AppliedEffect {
    /// Name of the effect, words separated by underscores, such as `added_mass`.
    pub name: String,
    /// Documentation: the `///` lines before the effect.
    pub doc: String,
    /// Component of the model that the effect changes: one of [`SITES`](crate::SITES).
    pub site: String,
    /// Kinds of variables on which the effect depends, from [`VARIABLES`](crate::VARIABLES); may be empty.
    pub variables: Vec<String>,
    /// Literature reference of the effect, from its `source` statement; empty if there is none.
    pub citation: String,
    /// Sentence for a first coefficient beyond its null value, from the statement of this name; may be empty.
    pub increases: String,
    /// Sentence for a first coefficient beyond its null value, from the statement of this name; may be empty.
    pub decreases: String,
    /// Coefficients that the effect adds; [`EffectUnknown::index`] refers to `Model::coefficients`.
    pub coefficients: Vec<EffectUnknown>,
    /// States that the effect adds, with an initial value for each flight; indices into `Model::states`.
    pub states: Vec<EffectUnknown>,
}

impl AppliedEffect {
    /// Sentence for a first coefficient that exceeds its null value by `departure`; by default the documentation.
    pub fn sentence(&self, departure: f64) -> &str {
        let stated = if departure > 0.0 {
            &self.increases
        } else if departure < 0.0 {
            &self.decreases
        } else {
            &self.doc
        };
        if stated.is_empty() { &self.doc } else { stated }
    }
}

/// A coefficient or initial state that an effect adds; at its null value, the effect is absent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EffectUnknown {
    /// Index into `Model::coefficients` for a coefficient, or into `Model::states` for a state.
    pub index: usize,
    /// Null value: value at which the effect is absent, SI; equal to the default value of the coefficient or state.
    pub null_value: f64,
    /// Smallest difference from [`EffectUnknown::null_value`] that matters in practice, SI; `None` if not stated.
    pub smallest_effect_of_interest: Option<f64>,
}

/// A function of one or two scalars that is specified by its values at knots. The function and its first derivatives
/// are continuous, except with [`Interpolation::Linear`].
///
/// With [`Interpolation::Spline`], the second derivative is continuous between the first and the last knot. With linear
/// continuation it is zero at both end knots (natural cubic spline), so it is continuous everywhere. With constant
/// continuation the slope is zero at both end knots (clamped cubic spline). With [`Interpolation::Monotone`], the slope
/// at an inner knot is the weighted harmonic mean of the slopes of the two adjacent chords (Fritsch and Butland 1984),
/// with weights from the chords' widths. The slopes at the end knots are one-sided three-point estimates limited to
/// preserve the shape, or zero with constant continuation. Two knots are joined by a straight line, with constant
/// continuation by a cubic.
///
/// A table of two arguments is the tensor product: what the function of one argument is along the first argument for
/// the values at each knot of the second is so along the second argument.
#[derive(Clone, Debug)]
pub struct Table {
    /// Name by which expressions call the table.
    pub name: String,
    /// Documentation: the `///` lines before the declaration.
    pub doc: String,
    /// One or two arguments, with their knots.
    pub arguments: Vec<TableArgument>,
    /// Unit of the value.
    pub unit: Unit,
    /// Text of the SI unit of the value.
    pub unit_text: String,
    /// Values at the knots, SI; of two arguments row by row, the knots of the second running faster.
    pub values: Vec<f64>,
    /// Method of interpolation between the knots.
    pub interpolation: Interpolation,
    /// Method of extrapolation below the first and above the last knot.
    pub continuation: Continuation,
}

/// An argument of a [`Table`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TableArgument {
    /// Name of the argument, which serves only as documentation.
    pub name: String,
    /// Unit of the argument.
    pub unit: Unit,
    /// Text of the SI unit of the argument.
    pub unit_text: String,
    /// Knots, SI: at least 2, strictly increasing, all finite.
    pub knots: Vec<f64>,
}

impl Table {
    /// Knots of the first argument, each with its value, of a table of one argument.
    pub fn points(&self) -> Vec<(f64, f64)> {
        let knots = self.arguments[0].knots.iter().copied();
        knots.zip(self.values.iter().copied()).collect()
    }

    /// 64-bit FNV-1a hash of the curve: equal for tables with the same knots (SI), interpolation and continuation.
    pub fn fingerprint(&self) -> u64 {
        let ways = [self.interpolation as u64, self.continuation as u64];
        let arguments = self.arguments.iter();
        let knots = arguments.flat_map(|own| own.knots.iter().chain([&f64::INFINITY]));
        let numbers = knots.chain(&self.values).map(|number| number.to_bits());
        let bytes = ways.into_iter().chain(numbers).flat_map(u64::to_le_bytes);
        fingerprint(&bytes.collect::<Vec<u8>>())
    }
}

/// A function of one scalar, defined with its derivative for every argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Function {
    /// Sine.
    Sin,
    /// Cosine.
    Cos,
    /// Tangent.
    Tan,
    /// Arcsine, the argument clamped to -1 .. 1; derivative 0 where the argument is at most -1 or at least 1.
    Asin,
    /// Arccosine, the argument clamped to -1 .. 1; derivative 0 where the argument is at most -1 or at least 1.
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
    /// Signum: -1, 0 or 1; derivative 0.
    Sign,
    /// Heaviside function: 1 for arguments above 0, else 0; derivative 0.
    Step,
    /// Hyperbolic tangent.
    Tanh,
    /// A table, by index into [`Model::tables`](super::Model::tables).
    Table(usize),
}

impl Function {
    /// The built-in functions with their names in the model language.
    pub const NAMES: [(&'static str, Function); 13] = [
        ("sin", Function::Sin),
        ("cos", Function::Cos),
        ("tan", Function::Tan),
        ("asin", Function::Asin),
        ("acos", Function::Acos),
        ("atan", Function::Atan),
        ("sqrt", Function::Sqrt),
        ("exp", Function::Exp),
        ("log", Function::Log),
        ("abs", Function::Abs),
        ("sign", Function::Sign),
        ("step", Function::Step),
        ("tanh", Function::Tanh),
    ];

    /// The built-in function of the name `name`; `None` if there is none.
    pub fn named(name: &str) -> Option<Function> {
        Self::NAMES
            .into_iter()
            .find(|known| known.0 == name)
            .map(|known| known.1)
    }
}
