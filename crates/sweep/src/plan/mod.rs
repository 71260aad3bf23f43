//! Plans: a release, what varies about it, and how many flights.

mod axes;
mod correlation;
mod fit;
mod read;

pub(crate) use axes::constant;
pub use axes::{Axis, AxisKind, Target};
pub use read::{MAX_FLIGHTS, read, read_file};

use flight::release::Release;
use flight::throw::Throw;
use model_spec::model::Model;
use ode::IntegrationOptions;

use crate::folder::fingerprint;
use correlation::Factor;

/// A sweep: flights of one model, whose inputs are drawn by their number.
///
/// Flight `k` is at point `k mod grid` of the grid; its random numbers depend on `k` and the seed alone.
#[derive(Clone)]
pub struct Plan {
    /// Model with the plan's effects.
    pub model: Model,
    /// The release that the flights vary.
    pub release: Release,
    /// Motion at release, where the plan states it by `[throw]`.
    pub throw: Option<Throw>,
    /// What varies, in the order of the file; coefficients of a fit come last.
    pub axes: Vec<Axis>,
    /// Whether every flight has gusts of its own, with phases by the seed of the gusts and the number of the flight.
    pub gusts: bool,
    /// Number of points of the grid; 1 without one.
    pub grid: u64,
    /// Number of flights.
    pub flights: u64,
    /// Seed of all random numbers.
    pub seed: u64,
    /// Method and tolerances of the integration.
    pub options: IntegrationOptions,
    /// Factor of the correlations of the normal axes, in their order.
    pub(crate) factor: Factor,
}

impl Plan {
    /// SHA-256 (hexadecimal) of everything that the flights' numbers depend on: the plan's values, the model's text, and
    /// whether the lanes of this machine fuse multiplications and additions.
    pub fn fingerprint(&self) -> String {
        let Plan {
            model,
            release,
            throw,
            axes,
            gusts,
            grid,
            flights,
            seed,
            options,
            factor,
        } = self;
        let source = codegen::rust::source_hash(model);
        fingerprint(format_args!(
            "hyzer.sweep/1 {source:x} {release:?} {throw:?} {axes:?} {gusts} {grid} {flights} {seed} {options:?} {factor:?}"
        ))
    }

    /// Flights in one part of the results; it depends on the number of flights alone.
    pub fn part_len(&self) -> u64 {
        const LEAST: u64 = 1 << 13;
        const GREATEST: u64 = 1 << 17;
        let even = (self.flights / 256).next_power_of_two();
        even.clamp(LEAST, GREATEST)
    }

    /// Number of parts of the results.
    pub fn parts(&self) -> u64 {
        self.flights.div_ceil(self.part_len())
    }
}
