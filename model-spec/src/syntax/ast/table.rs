//! Syntax tree of tables: functions of one scalar, specified by their values at knots.

use super::{Name, Quantity, UnitExpr};

/// Method of interpolation between the knots of a table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Interpolation {
    /// Cubic spline, natural with [`Continuation::Linear`] and clamped with [`Continuation::Constant`]. The default.
    #[default]
    Spline,
    /// Piecewise cubic that is monotone between knots (Fritsch and Carlson 1980). Stated as `monotone`.
    Monotone,
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

/// Declaration of a table: `table NAME(ARGUMENT: UNIT): UNIT = { argument: value, … };`.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Name of the table, by which it is called.
    pub name: Name,
    /// Name of the argument, which serves only as documentation.
    pub argument: Name,
    /// Unit of the argument; `None` for a pure number.
    pub argument_unit: Option<UnitExpr>,
    /// Unit of the value; `None` for a pure number.
    pub unit: Option<UnitExpr>,
    /// Argument and value at each knot. A quantity without a unit has the unit declared for the argument or the value.
    pub knots: Vec<(Quantity, Quantity)>,
    /// Method of interpolation between the knots.
    pub interpolation: Interpolation,
    /// Method of extrapolation below the first and above the last knot.
    pub continuation: Continuation,
}
