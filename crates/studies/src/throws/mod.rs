//! Throws by `design`, held against what others report: Crowther and Potts's study of launches of a disc, Frohlich's of the discus in
//! the wind.

mod crowther_potts;
mod frohlich;
mod page;

pub use crowther_potts::{Launches, Tilts, launches, rolls};
pub use frohlich::{Winds, winds};
pub use page::throws_page;
