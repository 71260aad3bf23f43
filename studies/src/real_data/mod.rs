//! Study of measured data: table-tennis balls, a gyroscope in a disc, poses of a disc, a wind tunnel, disc-golf throws.
//! Writes docs/studies/real-data.md.

mod balls;
mod disc_golf;
mod disc_pose;
mod files;
mod page;
mod results;
mod spin_decay;
mod wind_tunnel;

pub use balls::{Agreement, is_agreeing};
pub use disc_golf::LaunchFit;
pub(crate) use disc_golf::{
    LAUNCH_NAMES, Launch, UNCERTAINTY, axis_and_velocity, filmed_throws, rms_distance,
};
pub use disc_pose::Ratio;
pub use page::real_data_page;
pub use results::RealData;
pub use spin_decay::{DecayFit, Form};
