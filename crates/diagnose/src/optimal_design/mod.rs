//! Discrimination (T-optimal) design: the next throw that would best distinguish the remaining hypotheses.

mod information;
mod next_throw;
mod release;

pub(crate) use next_throw::next_throw;

pub use next_throw::NextThrow;
