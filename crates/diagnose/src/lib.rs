//! What a simulation gets wrong, and why.

pub mod bench;
pub mod catalogue;
pub mod causes;
pub mod chance;
pub mod leftover;
pub mod report;
pub mod scores;
