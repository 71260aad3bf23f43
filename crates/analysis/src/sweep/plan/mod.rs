//! Plans of sweeps: a release, the quantities that vary, and the number of flights.

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

use crate::sweep::folder::fingerprint;
use correlation::Factor;

/// Plan of a sweep: flights of one model whose inputs are determined by the flight number.
///
/// Flight `k` is at point `k mod grid` of the grid of input values; its random draws depend on `k` and the seed alone.
#[derive(Clone)]
pub struct Plan {
    /// Model that is simulated, including the effects that the plan names.
    pub model: Model,
    /// Release that all flights have in common; the varied quantities replace some of its values.
    pub release: Release,
    /// Motion at release, if it is specified in the table `[throw]` of the plan.
    pub throw: Option<Throw>,
    /// Varied quantities, in the order of the file; coefficients of a fit come last.
    pub axes: Vec<Axis>,
    /// Whether every flight has random gusts of its own.
    pub gusts: bool,
    /// Number of points of the grid: all combinations of grid values; 1 without a grid.
    pub grid: u64,
    /// Total number of flights of the sweep.
    pub flights: u64,
    /// Seed of the random draws of the varied quantities.
    pub seed: u64,
    /// Method and tolerances of the numerical integration of the flights.
    pub options: IntegrationOptions,
    /// Factor of the correlation matrix of the normal quantities, in their order in `axes`.
    pub(crate) factor: Factor,
    /// Why the fit of the plan is not to be relied on.
    pub doubt: Option<String>,
}

impl Plan {
    /// SHA-256 (hexadecimal) of everything on which the results depend.
    pub fn fingerprint(&self) -> String {
        let source = codegen::rust::source_hash(&self.model);
        let (release, throw, axes, gusts) = (&self.release, &self.throw, &self.axes, self.gusts);
        let (grid, flights, seed) = (self.grid, self.flights, self.seed);
        let (options, factor) = (&self.options, &self.factor);
        fingerprint(format_args!(
            "hyzer.sweep/1 {source:x} {release:?} {throw:?} {axes:?} {gusts} {grid} {flights} {seed} {options:?} {factor:?}"
        ))
    }

    /// Number of flights in one part; it depends on the number of flights alone.
    pub fn part_len(&self) -> u64 {
        const MIN: u64 = 1 << 13;
        const MAX: u64 = 1 << 17;
        let even = (self.flights / 256).next_power_of_two();
        even.clamp(MIN, MAX)
    }

    /// Number of parts of the sweep.
    pub fn parts(&self) -> u64 {
        self.flights.div_ceil(self.part_len())
    }
}
