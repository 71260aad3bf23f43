//! Study of spoiled data: whether common mistakes of a laboratory are named, harmless, or reported as unreliable.
//! Writes docs/studies/spoiled.md.

mod harm;
mod judge;
mod kinds;
mod kinematics;
mod page;
mod run;

pub use judge::{Judged, Judgement};
pub use kinds::{KINDS, Kind};
pub use page::spoiled_page;
pub use run::{Run, Which, runs, spoiled};
