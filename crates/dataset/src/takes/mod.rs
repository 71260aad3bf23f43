//! Readers of motion-capture recordings, and detection of the throws in them.
//!
//! [`read`] recognises the format of a file by its content and returns a [`Take`]: times (s), points and poses (m)
//! along the axes of the file, with notes on the decisions made while reading. Properties that the file does not state,
//! such as a unit, come from [`ReadOptions`]; if they are missing there too, the error names the command-line option.
//! [`Take::with_z_up`] converts a take to the axes of a dataset (right-handed, z up).

mod axes;
pub(crate) mod c3d;
mod clock_time;
mod columns;
mod commented;
mod error;
pub(crate) mod file;
mod format;
mod import;
mod layout;
mod neighbours;
mod options;
mod quaternion;
mod read;
mod take;
mod template;
mod throws;
mod two_headers;
mod unit;
mod unseen;
mod z_up;

pub use axes::Axis;
pub use error::TakeError;
pub use flight::table::Location;
pub(crate) use flight::table::{Fault, Sheet, listed, separator, shown};
pub use format::Format;
pub(crate) use format::is_digitised;
pub use import::{Followed, ImportOptions, ImportedTake, found_otherwise, name_of_label, up_of};
pub(crate) use layout::{
    Attitude, Clock, Layout, MAX_COORDINATE, MAX_LABELS, MAX_POSITIONS, TrackColumns, Tracks,
    unique,
};
pub use options::ReadOptions;
pub(crate) use quaternion::product;
pub use quaternion::rotated;
pub use read::{parse, read};
pub use take::{Body, Point, Pose, Take};
pub use template::{
    CentreHeight, EstimatedMarker, EstimatedTemplate, FreeFlight, TemplateError, UpVote,
    estimate_template,
};
pub use throws::{Cause, Cut, Motion, Throw, ThrowOptions, Throws, find_throws, motion};
pub(crate) use unit::checked_rate;
pub use unit::{LengthUnit, TimeUnit};
