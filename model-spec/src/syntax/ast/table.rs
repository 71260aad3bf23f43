//! Syntax tree of tables: functions of one number, given by their values at knots.

use super::{Name, Quantity, UnitExpr};

/// How a table is interpolated between its knots.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Interpolation {
    /// Cubic spline: continuous second derivative. The default.
    #[default]
    Spline,
    /// Piecewise cubic that is monotone wherever the values at the knots are (Fritsch and Carlson 1980), so that it does not
    /// leave their range; the second derivative jumps at the knots. Stated as `monotone`.
    Monotone,
}

/// How a table continues beyond its first and last knot.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Continuation {
    /// Straight on, with the slope at the end. The default.
    #[default]
    Linear,
    /// With the value at the end; the slope is zero there. Stated as `constant`.
    Constant,
}

/// Declaration of a table: `table NAME(ARGUMENT: UNIT): UNIT = { argument: value, … };`.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Name of the table, by which it is called.
    pub name: Name,
    /// Name of the argument, for readers.
    pub argument: Name,
    /// Unit of the argument; `None` for a pure number.
    pub argument_unit: Option<UnitExpr>,
    /// Unit of the value; `None` for a pure number.
    pub unit: Option<UnitExpr>,
    /// Argument and value at each knot; in the units of the table unless they state their own.
    pub knots: Vec<(Quantity, Quantity)>,
    /// How the table is interpolated between its knots.
    pub interpolation: Interpolation,
    /// How the table continues beyond its ends.
    pub continuation: Continuation,
}
