//! What the paper says came out of its two flights.

use serde::Deserialize;

/// One stated outcome.
#[derive(Clone, Debug, Deserialize)]
pub struct Claim {
    /// `fssh3` or `bffl8`.
    pub flight: String,
    /// When, s; absent where the quantity is itself a time.
    pub at: Option<f64>,
    /// Which quantity; see [`Outcome`].
    pub quantity: String,
    /// Its value in `unit`.
    pub value: f64,
    /// How far the wording lets a faithful reproduction be.
    pub tolerance: f64,
    /// Unit of value and tolerance.
    pub unit: String,
}

#[derive(Deserialize)]
struct File {
    claim: Vec<Claim>,
}

/// All claims, in the order of the file.
pub fn all() -> Vec<Claim> {
    let file: File = toml::from_str(include_str!("data/claims.toml"))
        .expect("the built-in claims are well formed");
    file.claim
}

/// What came out of one simulated flight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome {
    /// Distance gone along x, m.
    pub delta_x: f64,
    /// Height gained, m.
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
    /// The quantity that a claim is about.
    ///
    /// # Panics
    /// For a name that is not a field: the claims are built in and a test reads them all.
    pub fn quantity(&self, name: &str) -> f64 {
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

    /// How far this outcome is from a claim, in tolerances, with sign.
    pub fn departure(&self, claim: &Claim) -> f64 {
        (self.quantity(&claim.quantity) - claim.value) / claim.tolerance
    }
}
