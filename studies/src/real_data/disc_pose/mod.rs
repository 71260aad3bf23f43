//! Throws of one golf disc whose full pose was measured for a tenth of a second each.

mod figure;
mod fit;
mod page;
mod read;

pub(super) use figure::ratio_figure;
pub(super) use fit::DiscPose;
pub use fit::Ratio;
pub(super) use page::disc_pose_section;
