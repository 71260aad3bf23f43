//! Outcomes that the paper states for its two flights.

use serde::Deserialize;

/// One stated outcome of a flight.
#[derive(Clone, Debug, Deserialize)]
pub struct Claim {
    /// `fssh3` or `bffl8`.
    pub flight: String,
    /// Time of the flight, s; absent if the quantity is itself a time.
    pub at: Option<f64>,
    /// Name of a field of [`Outcome`].
    pub quantity: String,
    /// Stated value, in `unit`.
    pub value: f64,
    /// Greatest departure of a faithful reproduction that the paper's wording admits, in `unit`.
    pub tolerance: f64,
    /// Unit of value and tolerance; `1` if dimensionless.
    pub unit: String,
}

#[derive(Deserialize)]
struct File {
    claim: Vec<Claim>,
}

/// All claims, in the order of data/claims.toml.
pub(super) fn all() -> Vec<Claim> {
    let file: File =
        toml::from_str(include_str!("data/claims.toml")).expect("the built-in claims are valid");
    file.claim
}

/// Outcome of one simulated flight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome {
    /// Displacement along x, m.
    pub delta_x: f64,
    /// Height gained, m; negative if the flight ends lower.
    pub delta_z: f64,
    /// phi at the end, rad.
    pub phi: f64,
    /// theta at the end, rad.
    pub theta: f64,
    /// gammadot at the end, rad/s.
    pub gammadot: f64,
    /// Change of |gammadot| as a fraction of its value at release.
    pub gammadot_change_fraction: f64,
    /// Time of the greatest height, s.
    pub time_of_highest_z: f64,
}

impl Outcome {
    /// The field of this name, in its unit.
    ///
    /// # Panics
    /// If there is no such field: the names are those of the built-in claims.
    pub(super) fn quantity(&self, name: &str) -> f64 {
        match name {
            "delta_x" => self.delta_x,
            "delta_z" => self.delta_z,
            "phi" => self.phi,
            "theta" => self.theta,
            "gammadot" => self.gammadot,
            "gammadot_change_fraction" => self.gammadot_change_fraction,
            "time_of_highest_z" => self.time_of_highest_z,
            other => unreachable!("no outcome is called {other}"),
        }
    }

    /// Departure (simulated − stated) from a claim, in units of its tolerance.
    pub(super) fn departure(&self, claim: &Claim) -> f64 {
        (self.quantity(&claim.quantity) - claim.value) / claim.tolerance
    }
}
