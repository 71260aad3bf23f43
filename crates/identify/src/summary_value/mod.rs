//! What the channels of summaries compare, and how exactly it is known where no standard deviation is stated.

mod dual;
mod quantity;

pub use self::quantity::SummaryValue;
pub(crate) use self::quantity::{Vectors, value};

/// Standard deviations of what is taken as exact, in the unit of its dimension: m/s, rad, rad/s, m. They are far below
/// what the path of a flight tells.
const EXACT: [(&str, f64); 4] = [("m/s", 0.02), ("rad", 3e-4), ("rad/s", 0.2), ("m", 1e-3)];

/// The same of what is taken as exact without being stated: the directions of a release bend with the attitude.
pub(crate) const ASSUMED: [(&str, f64); 4] =
    [("m/s", 0.02), ("rad", 2e-3), ("rad/s", 1.0), ("m", 1e-3)];

/// Standard deviation, SI, of a quantity of the release that a column states without one: it is taken as exact.
pub(crate) fn exact_deviation(unit: &str) -> f64 {
    of_unit(&EXACT, unit)
}

pub(crate) fn of_unit(deviations: &[(&str, f64)], unit: &str) -> f64 {
    let own = deviations.iter().find(|(of, _)| *of == unit);
    own.map_or(1e-3, |(_, sigma)| *sigma)
}
