//! Compares throws found by `design` with published results: Crowther and Potts on launches of a disc, Frohlich on the
//! discus in the wind. Writes docs/studies/throws.md.

mod crowther_potts;
mod frohlich;
mod page;

pub use crowther_potts::{Launches, Tilts, launches, rolls};
pub use frohlich::{Winds, winds};
pub use page::throws_page;
