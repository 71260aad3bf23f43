//! Why a search finds no throw.

use crate::design::throw_flight::ThrowFlightError;

/// Reason why a search finds no throw.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum DesignError {
    /// None of the starting throws could be flown to the ground.
    #[error(
        "none of {tried} throws within the bounds could be flown to the ground; the last one: {last}"
    )]
    NoFlight {
        /// Number of starting throws.
        tried: usize,
        /// Reason why the last one could not be flown.
        last: ThrowFlightError,
    },
    /// Throws can be flown, but their derivatives cannot be computed.
    #[error(
        "throws within the bounds could be flown, but none with derivatives; expected a model that is smooth there"
    )]
    NoDescent,
    /// The bounds of a quantity of the throw are no range.
    #[error(
        "the bounds of {name} are {least} and {greatest}; expected finite numbers, the least one first"
    )]
    NoRange {
        /// Name of the quantity.
        name: &'static str,
        /// Lower bound, in the unit of the quantity.
        least: f64,
        /// Upper bound, in the unit of the quantity.
        greatest: f64,
    },
    /// The number of threads is 0.
    #[error("the number of threads is 0, expected at least 1")]
    NoThreads,
    /// The goal needs an obstacle, and the bounds have none.
    #[error(
        "the goal curve needs an obstacle; expected [obstacle] in the bounds, with x, y and radius"
    )]
    NoObstacle,
    /// A coordinate of the target is no finite number.
    #[error("the target is ({}); expected finite numbers", .0.map(|x| x.to_string()).join(", "))]
    NotFinite([f64; 3]),
    /// The target is below the ground, by the given depth, m.
    #[error("the target is {0} m below the ground; expected a height of 0 or more")]
    Buried(f64),
    /// The goal is a flare at a point on the ground.
    #[error("the goal flare needs a target above the ground; found a height of 0")]
    FlareOnGround,
    /// The throw that was found cannot be flown at the final tolerance.
    #[error(transparent)]
    Flight(#[from] ThrowFlightError),
}
