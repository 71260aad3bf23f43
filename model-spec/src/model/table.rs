//! Tables: functions of one scalar, specified by their values at knots.

use crate::fingerprint;
use crate::source::Span;
use crate::unit::Unit;

pub use crate::syntax::ast::{Continuation, Interpolation};

/// A function of one scalar that is specified by its values at knots. The function and its first derivative are
/// continuous.
///
/// With [`Interpolation::Spline`], the second derivative is continuous between the first and the last knot. With linear
/// continuation it is zero at both end knots (natural cubic spline), so it is continuous everywhere. With constant
/// continuation the slope is zero at both end knots (clamped cubic spline). With [`Interpolation::Monotone`], the slope
/// at an inner knot is the weighted harmonic mean of the slopes of the two adjacent chords (Fritsch and Butland 1984),
/// with weights from the chords' widths. The slopes at the end knots are one-sided three-point estimates limited to
/// preserve the shape, or zero with constant continuation.
#[derive(Clone, Debug)]
pub struct Table {
    /// Name by which expressions call the table.
    pub name: String,
    /// Documentation: the `///` lines before the declaration.
    pub doc: String,
    /// Name of the argument, which serves only as documentation.
    pub argument: String,
    /// Unit of the argument.
    pub argument_unit: Unit,
    /// Unit of the value.
    pub unit: Unit,
    /// Texts of the SI units of the argument and of the value, in this order.
    pub unit_texts: [String; 2],
    /// Pairs of argument and value at the knots, SI: at least 3 pairs, arguments strictly increasing, all finite.
    pub knots: Vec<(f64, f64)>,
    /// Method of interpolation between the knots.
    pub interpolation: Interpolation,
    /// Method of extrapolation below the first and above the last knot.
    pub continuation: Continuation,
    /// Source span of the name in the declaration.
    pub span: Span,
    /// Index into [`Model::effects`](super::Model::effects) of the effect that added the table.
    pub effect: Option<usize>,
}

impl Table {
    /// 64-bit FNV-1a hash of the curve: equal for tables with the same knots (SI), interpolation and continuation.
    pub fn fingerprint(&self) -> u64 {
        let ways = [self.interpolation as u64, self.continuation as u64];
        let numbers = self
            .knots
            .iter()
            .flat_map(|(x, y)| [x.to_bits(), y.to_bits()]);
        let bytes = ways.into_iter().chain(numbers).flat_map(u64::to_le_bytes);
        fingerprint(&bytes.collect::<Vec<u8>>())
    }
}
