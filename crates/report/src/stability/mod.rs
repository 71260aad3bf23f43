//! Report of a stability analysis: page, text, JSON and CSV.

mod page;
mod text;
mod words;

use analysis::stability::{Instant, Modes, Trim};

pub use page::page;
pub use text::text;
pub use words::{csv, json};

/// Modes and stability criteria of a body, the result of `hyzer stability`.
pub struct Found {
    /// Modes and stability criteria at release.
    pub release: Instant,
    /// Modes and stability criteria along the flight to the ground; empty if the flight cannot be simulated.
    pub flight: Vec<Instant>,
    /// Steady (trimmed) flight with the same spin as at release, and its modes; `None` if no steady flight is found.
    pub trim: Option<(Trim, Modes)>,
    /// Modes and stability criteria at release for each point of a grid of speed and spin, which replace the speed and
    /// spin of the throw.
    pub map: Vec<Instant>,
}
