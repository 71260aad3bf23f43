//! Study of takes: simulated recordings of throws, with a hand before and a net or the ground after each flight, in the
//! file formats of laboratories. They are imported to a dataset, a marker template is estimated, and the dataset is
//! fitted. Writes docs/studies/takes.md.

mod c3d;
mod ends;
mod page;
mod run;
mod session;
mod text;

pub use page::takes_page;
pub use run::{
    CoefficientError, FitErrors, Session, SessionCuts, SessionResult, TemplateErrors, session_cuts,
    sessions,
};
