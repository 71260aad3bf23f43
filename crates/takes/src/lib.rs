//! Recordings of motion-capture laboratories: readers of their files, and the throws in them.
//!
//! [`read`] recognises the format of a file by its content and gives a [`Take`]: times, points and poses in s and m along
//! the axes of the file, with notes of what was decided. What the file does not state, such as a unit, is taken from
//! [`ReadOptions`], or the error names the option. [`Take::with_z_up`] turns a take to the axes of a dataset.

#![forbid(unsafe_code)]

mod axes;
pub mod c3d;
mod columns;
mod error;
pub mod file;
mod format;
mod layout;
pub mod number;
mod options;
mod quaternion;
mod read;
mod sheet;
mod take;
mod template;
mod throws;
mod unit;
pub mod words;
mod z_up;

pub use axes::Axis;
pub use error::{Place, TakeError};
pub use format::Format;
pub use options::ReadOptions;
pub use quaternion::rotated;
pub use read::{parse, read};
pub use take::{Body, Point, Pose, Take};
pub use template::{
    CentreHeight, EstimatedMarker, EstimatedTemplate, FreeFlight, TemplateError, UpVote,
    estimate_template,
};
pub use throws::{Cause, Cut, Motion, Throw, ThrowOptions, Throws, find_throws, motion};
pub use unit::{LengthUnit, TimeUnit};
