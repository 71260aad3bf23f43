//! Discrimination (T-optimal) design: the next throw that would best distinguish the remaining hypotheses.

mod information;
mod proposed_throw;
mod release;

pub(crate) use proposed_throw::proposed_throw;

pub use proposed_throw::ProposedThrow;
