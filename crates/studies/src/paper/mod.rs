//! Hubbard & Hummel (2000) reproduced and questioned.
//!
//! Flown with its tables as printed, the paper's own account of its two flights does not come out. This
//! study declares hypotheses on what the tables mean ([`reading`]), flies both flights under every
//! combination ([`study`]), holds the outcomes against what the paper says ([`claims`]) and writes
//! the page that tells which readings survive ([`page`]).

pub mod claims;
pub mod fly;
pub mod page;
pub mod reading;
pub mod study;
