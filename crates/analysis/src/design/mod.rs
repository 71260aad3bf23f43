//! Throws for a purpose: the release that hits a point, flies farthest or longest, avoids an obstacle, flares over a
//! point or lands with the least spread, within bounds.
//!
//! - [`ThrownBody`] is a compiled model of a body, [`ThrowFlights`] its flights with given parameters. A [`Path`]
//!   provides the derivatives of its points, its landing and its nearest approaches with respect to the quantities of
//!   the throw and to parameters.
//! - [`design`](fn@design) searches for the throw that serves a [`Goal`] best within [`Bounds`]; a [`Design`] states
//!   whether it meets the constraints, by how much it misses, and the effect of each quantity of the throw.
//! - [`spread`](fn@spread) is the distribution of landings due to the scatter of release, wind and coefficients,
//!   linearized and sampled.
//!
//! ```
//! use analysis::design::{Bounds, Goal, SearchOptions, ThrownBody, design};
//!
//! let body = ThrownBody::new(model_spec::load::load("ball", &[])?)?;
//! let flights = body.with_parameters(body.compiled.layout().default_parameters());
//! let goal = Goal::Hit([4.0, 1.0, 0.0]);
//! let found = design(&flights, goal, &Bounds::standard(&body), &SearchOptions::default())?;
//! assert!(found.feasible && (found.landing.x - 4.0).abs() < 1e-3);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod bounds;
mod box_quadratic;
mod error;
mod fly;
mod goal;
mod json;
mod optimise;
mod path;
mod read_bounds;
mod search;
mod sensitivity;
mod spread;
mod throw_flight;

pub use bounds::{Bounds, Scatter};
pub use error::DesignError;
pub use flight::release::ReleaseError as BoundsError;
pub use goal::{GOALS, Goal, Obstacle, Side};
pub use path::{Landing, Path};
pub use search::{Design, SearchOptions, design, numbers};
pub use sensitivity::{OneUnit, Sensitivity, sensitivities};
pub use spread::{
    Agreement, Aims, Band, Landings, QUANTILES, SampleOptions, Sampled, Scattered, Spread,
    TOLERATED, landing_covariance, spread,
};
pub use throw_flight::{By, Point, ThrowFlightError, ThrowFlights, ThrownBody};
