//! Tables: functions of one number, given by their values at knots.

use crate::source::Span;
use crate::unit::Unit;

pub use crate::syntax::ast::{Continuation, Interpolation};

/// A function of one number that is given by its values at knots. Its value is continuous with its first derivative.
///
/// With [`Interpolation::Spline`] the second derivative is continuous between the ends, too, and beyond them where the table
/// goes straight on: the second derivative is zero at the first and the last knot (natural cubic spline). Where the table goes
/// on with a constant, the slope is zero at the ends (clamped cubic spline). With [`Interpolation::Monotone`] the slopes at the
/// inner knots are those of Fritsch and Butland (1984), weighted by the intervals, and at the ends the one-sided ones of three
/// points, limited to keep the shape, or zero.
#[derive(Clone, Debug)]
pub struct Table {
    /// Name, by which the table is called.
    pub name: String,
    /// Documentation: the `///` lines before the declaration.
    pub doc: String,
    /// Name of the argument.
    pub argument: String,
    /// Unit of the argument.
    pub argument_unit: Unit,
    /// Unit of the value.
    pub unit: Unit,
    /// Texts of the units of argument and value, SI units.
    pub unit_texts: [String; 2],
    /// Arguments and values at the knots, SI: at least 3, arguments strictly increasing, all finite.
    pub knots: Vec<(f64, f64)>,
    /// How the table is interpolated between its knots.
    pub interpolation: Interpolation,
    /// How the table continues beyond its ends.
    pub continuation: Continuation,
    /// Source span of the name in the declaration.
    pub span: Span,
    /// Index into [`Model::effects`](super::Model::effects) of the effect that added the table; `None` for the model's own.
    pub effect: Option<usize>,
}

impl Table {
    /// Hash of the curve: equal for tables with the same knots (SI), interpolation and continuation (64-bit FNV-1a).
    pub fn fingerprint(&self) -> u64 {
        let ways = [self.interpolation as u64, self.continuation as u64];
        let numbers = self
            .knots
            .iter()
            .flat_map(|(x, y)| [x.to_bits(), y.to_bits()]);
        let bytes = ways.into_iter().chain(numbers).flat_map(u64::to_le_bytes);
        bytes.fold(0xcbf2_9ce4_8422_2325, |hash: u64, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
        })
    }
}
