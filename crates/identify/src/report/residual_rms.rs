//! Root mean square residuals by kind of sensor.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::numbers::quantity;

/// Kind under which the residuals and the noise of measured positions are reported: of markers or, without markers, of
/// pose sensors.
pub const MARKER: &str = "marker";

/// Root mean square residual of one component of a measured quantity.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rms {
    /// Root mean square of the residuals, outliers excluded, in the unit `unit`.
    pub value: f64,
    /// Unit of the measured quantity.
    pub unit: String,
}

/// Sums of squared residuals and their numbers, by kind of sensor.
#[derive(Clone, Debug, Default)]
pub(crate) struct SquareSums(BTreeMap<&'static str, (f64, usize, &'static str)>);

impl SquareSums {
    /// Adds `count` squared residuals of a kind of sensor, whose sum is `squares`, in the square of `unit`.
    pub fn add(&mut self, kind: &'static str, unit: &'static str, squares: f64, count: usize) {
        let sum = self.0.entry(kind).or_insert((0.0, 0, unit));
        sum.0 += squares;
        sum.1 += count;
    }

    /// Root mean square of the residuals of each kind that has any.
    pub fn rms(self) -> BTreeMap<String, Rms> {
        let kinds = self.0.into_iter().filter(|(_, (_, count, _))| *count > 0);
        let each = kinds.map(|(kind, (squares, count, unit))| {
            let value = (squares / count as f64).sqrt();
            let unit = unit.to_owned();
            (kind.to_owned(), Rms { value, unit })
        });
        each.collect()
    }
}

/// The value of the [`leading`] kind of sensor with its unit, in words; `–` if there is none.
pub(super) fn text(by_kind: &BTreeMap<String, Rms>) -> String {
    leading(by_kind).map_or_else(|| "–".to_owned(), |rms| quantity(rms.value, &rms.unit))
}

/// What belongs to the positions among the kinds of sensors, or to the first kind where no positions are measured.
pub(super) fn leading<T>(by_kind: &BTreeMap<String, T>) -> Option<&T> {
    by_kind.get(MARKER).or_else(|| by_kind.values().next())
}
