//! Table-tennis balls whose spin was measured independently of their trajectory: whether the measured spin explains
//! their lift.

mod agreement;
mod figure;
mod lift;
mod models;
mod page;
mod results;
mod stretches;

pub use agreement::Agreement;
pub(super) use figure::balls_figure;
pub(super) use page::balls_section;
pub(super) use results::Balls;
pub use stretches::is_agreeing;
