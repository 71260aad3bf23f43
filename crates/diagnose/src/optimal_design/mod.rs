//! Discrimination design: the next throw, after which the remaining hypotheses differ most.

mod information;
mod next_throw;
mod release;

pub(crate) use next_throw::next_throw;

pub use next_throw::NextThrow;
