//! Study of the diagnosis: how often it finds seeded effects. Writes docs/discovery.md.
//!
//! The oracle computes flights with seeded effects ([`crate::seeded`]); the diagnosis has the flights and the model without
//! those effects. Neither the flights nor the truth pass through anything that is tested.

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
