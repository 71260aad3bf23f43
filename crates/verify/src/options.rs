//! Options of a verification, and the tolerance of its comparisons.

/// Options of a verification.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// Seed of all random numbers of the verification.
    pub seed: u64,
    /// Number of random points at which each check evaluates the model.
    pub cases: usize,
    /// Whether to run mutation testing.
    pub mutants: bool,
    /// Whether to check effects.
    pub effects: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            seed: 1,
            cases: 200,
            mutants: true,
            effects: true,
        }
    }
}

/// Maximum rounding error in f64, relative to the sum of the magnitudes of the terms, except of flights.
pub const TOLERANCE: f64 = 1e-12;

/// Maximum allowed error, ulp of the magnitude: 128 rounding errors of half a unit with the same sign.
pub const ALLOWED: f64 = 64.0;
