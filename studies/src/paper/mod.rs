//! Study of the paper: Hubbard & Hummel (2000) against hypotheses on the meaning of its tables. Writes docs/studies/paper.md.
//!
//! With the tables as printed, simulations do not reproduce the paper's own description of its two flights. The study
//! simulates both flights under every combination of declared hypotheses ([`Reading`]), compares the outcomes with the
//! paper's claims ([`Claim`]), and ranks the readings ([`Study`]).

mod claims;
mod coefficients;
mod columns;
mod conventions;
mod fly;
mod page;
mod reading;
mod study;
mod table;

pub use claims::{Claim, Outcome};
pub use columns::Columns;
pub use conventions::{Conventions, RollSpin, SpinDown};
pub use page::paper_page;
pub use reading::Reading;
pub use study::{Scored, Study};
pub(crate) use table::printed_coefficient;
