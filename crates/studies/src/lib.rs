//! Studies of what a fit and a diagnosis are worth: on flights computed by the oracle, and on measured ones.
//!
//! Synthetic flights come from the oracle's vector mechanics and an integrator of this crate ([`oracle_flights`]), so
//! that neither the generated code nor the integrator under test takes part in making them. Each study runs on its
//! own and writes one page of `docs/`; the program `hyzer-studies` has a command for each.

pub mod bodies;
mod bounded_fit;
mod contact;
pub mod cuts;
pub mod discovery;
mod error;
pub mod fits;
pub mod identification;
pub mod oracle_flights;
pub mod others;
pub mod own_models;
mod page;
pub mod paper;
pub mod real_data;
pub mod seeded;
pub mod sensors;
pub mod spoiled;
mod statistics;
pub mod takes;
pub mod throws;

pub use error::StudyError;
pub use page::Page;
