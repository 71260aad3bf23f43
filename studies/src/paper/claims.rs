//! Numerical outcomes that the paper states for its two flights.

use serde::Deserialize;

/// One outcome that the paper (Hubbard & Hummel, 2000) states for one of its two flights.
#[derive(Clone, Debug, Deserialize)]
pub struct Claim {
    /// Name of the flight: `fssh3` or `bffl8`.
    pub flight: String,
    /// Time in the flight to which the value that the paper states refers, s; `None` if the quantity is itself a time.
    pub at: Option<f64>,
    /// Name of the quantity that the paper states, equal to a field of [`Outcome`], such as `"delta_x"`.
    pub quantity: String,
    /// Value that Hubbard & Hummel (2000) state, in `unit`.
    pub value: f64,
    /// Maximum deviation from `value` that the wording of Hubbard & Hummel (2000) allows for a faithful reproduction,
    /// in `unit`.
    pub tolerance: f64,
    /// Unit of `value` and `tolerance`; `1` if dimensionless.
    pub unit: String,
}

#[derive(Deserialize)]
struct File {
    claim: Vec<Claim>,
}

/// Returns all outcomes that Hubbard & Hummel (2000) state for their flights, in the order of data/claims.toml.
pub(super) fn all() -> Vec<Claim> {
    let file: File =
        toml::from_str(include_str!("data/claims.toml")).expect("the built-in claims are valid");
    file.claim
}

/// Quantities of one simulated flight for which Hubbard & Hummel (2000) state values. Unless stated otherwise, they
/// refer to the end of the simulation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome {
    /// Displacement along the horizontal inertial axis x from release to end, m.
    pub delta_x: f64,
    /// Height gained, m; negative if the flight ends below its start.
    pub delta_z: f64,
    /// Euler angle phi (first rotation, about axis 1) at the end of the simulated flight, rad.
    pub phi: f64,
    /// Euler angle theta (second rotation, about axis 2) at the end of the simulated flight, rad.
    pub theta: f64,
    /// Spin gammadot at the end of the simulated flight, rad/s.
    pub gammadot: f64,
    /// Change of the spin magnitude |gammadot| between release and end / spin magnitude at release.
    pub gammadot_change_fraction: f64,
    /// Time from the release to the maximum height of the flight, s.
    pub time_of_highest_z: f64,
}

impl Outcome {
    /// Value of the field whose name is `name`, such as `"delta_x"`, in that field's unit.
    ///
    /// # Panics
    /// If no field has this name.
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

    /// Deviation (simulated − stated) of this flight from the value that a claim gives, in units of the claim's
    /// tolerance.
    pub(super) fn departure(&self, claim: &Claim) -> f64 {
        (self.quantity(&claim.quantity) - claim.value) / claim.tolerance
    }
}
