//! Disc-golf throws filmed from above, with stated launch uncertainties, compared with the oracle's simulation of a
//! disc with a computed aerodynamic table.

mod band;
mod launch_fit;
mod page;
mod read;
mod results;
mod simulate;
mod throw;

pub use launch_fit::LaunchFit;
pub(super) use page::disc_golf_section;
pub(crate) use read::throws as filmed_throws;
pub(super) use results::DiscGolf;
pub(crate) use throw::{LAUNCH_NAMES, Launch, UNCERTAINTY, axis_and_velocity, rms_distance};
