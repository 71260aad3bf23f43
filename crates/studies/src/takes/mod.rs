//! Study of takes: recordings of throws with a hand before and a net or the ground after, as laboratories write them, become a
//! dataset with a template of its own, which is fitted. Writes docs/takes.md.

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
