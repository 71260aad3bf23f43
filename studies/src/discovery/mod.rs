//! Study of the diagnosis: how often it finds effects of the simulated flights. Writes docs/studies/discovery.md.
//!
//! The oracle simulates flights with effects added to the law of motion ([`crate::seeded`]). The diagnosis receives the
//! flights and the model without these effects. The code that simulates the flights and scores the answers shares
//! nothing with the code under test.

mod case;
mod details;
mod outcome;
mod page;
mod peers;
mod plan;
mod rates;
mod row;
mod run;
mod score;

pub use case::Case;
pub use details::details;
pub use outcome::{Discordant, HeldOutErrors, Outcome};
pub use page::discovery_page;
pub use peers::{peer_section, with_peer_section};
pub use plan::plan;
pub use row::{Body, Group, Row, Size};
pub use run::{RowResult, rejections, run_rows};
