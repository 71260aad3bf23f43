//! Lift, drag and pitching moment of a disc measured in a wind tunnel, compared with the curves of the model `disc`.

mod curves;
mod effects;
mod figure;
mod page;
mod paper_flights;
mod table;

pub(super) use effects::effects_section;
pub(super) use figure::tunnel_figure;
pub(super) use page::tunnel_section;
pub(super) use paper_flights::paper_flights_section;
pub(super) use table::{Measured, interpolated, read};
