//! Units as eight exponents: the seven of the SI and the plane angle.
//!
//! The angle is carried so that messages can say `rad/s`, but it never decides whether two units agree:
//! the radian is 1, as in the SI.

/// Index of an exponent in [`Unit`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[allow(missing_docs)]
pub enum Base {
    Metre,
    Kilogram,
    Second,
    Ampere,
    Kelvin,
    Mole,
    Candela,
    Radian,
}

/// A unit of measure: exponents of the base units, doubled so that square roots stay whole.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Unit {
    /// Twice the exponent of each [`Base`], in its order.
    pub doubled: [i8; 8],
}
