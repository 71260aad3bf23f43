//! Report of a stability analysis: page, text, JSON and CSV.

mod page;
mod words;

use analysis::stability::{Instant, Modes, Trim};

pub use page::{page, text};
pub use words::{controls, csv, json};

/// Modes and stability criteria of a body.
pub struct Found {
    /// At release.
    pub release: Instant,
    /// Along the flight to the ground; empty if it cannot be simulated.
    pub flight: Vec<Instant>,
    /// Steady flight with the spin of release, and its modes, if one is found.
    pub trim: Option<(Trim, Modes)>,
    /// At release, for a grid of speed and spin.
    pub map: Vec<Instant>,
}
