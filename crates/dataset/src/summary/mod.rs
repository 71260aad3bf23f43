//! Flights of which a launch monitor tells one row: the release, and what was seen of the rest.

mod quantity;
mod unit;

pub use quantity::{SummaryEvent, SummaryQuantity};
pub use unit::SummaryUnit;

/// Column of a table of summaries: what it measures, and how it is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SummaryColumn {
    /// What is measured.
    pub quantity: SummaryQuantity,
    /// Unit of the values.
    pub unit: SummaryUnit,
    /// Whether the values are positive to the other side than [`SummaryQuantity::is_positive_right`] tells.
    pub is_mirrored: bool,
}

impl SummaryColumn {
    /// Factor from the unit of the column, with its sign, to the SI unit of the quantity, with the quantity's sign.
    pub fn to_si(self) -> f64 {
        let sign = if self.is_mirrored { -1.0 } else { 1.0 };
        sign * self.unit.si()
    }
}
