//! Throws for a purpose.
mod bounds;
mod box_quadratic;
mod design;
mod goal;
mod json;
mod optimise;
mod path;
mod read_bounds;
mod sensitivity;
mod spread;
mod throw_flight;

pub use bounds::{Bounds, Scatter};
pub use design::{Design, DesignError, SearchOptions, design, numbers};
pub use goal::{GOALS, Goal, Obstacle, Side};
pub use path::{Landing, Path, Point};
pub use read_bounds::BoundsError;
pub use sensitivity::{OneUnit, Sensitivity, sensitivities};
pub use spread::{
    Agreement, Band, CoefficientErrors, Landings, QUANTILES, SampleOptions, Sampled, Scattered,
    Spread, TOLERATED, landing_covariance, spread,
};
pub use throw_flight::{By, ThrowFlightError, ThrowFlights, ThrownBody};
