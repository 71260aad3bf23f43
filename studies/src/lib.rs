//! Studies of the accuracy and reliability of fits and diagnoses, on flights simulated by the oracle and on measured
//! flights.
//!
//! Synthetic flights come from the oracle's vector mechanics and an integrator of this crate ([`oracle_flights`]), so
//! neither the generated code nor the integrator under test takes part in making them. Each study runs independently
//! and writes one page of `docs/studies/`; the program `hyzer-studies` has one subcommand per study.

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
mod progress;
pub mod real_data;
pub mod seeded;
pub mod sensors;
pub mod spoiled;
mod statistics;
pub mod takes;
pub mod throws;
pub mod wild;

pub use error::StudyError;
pub use page::Page;
pub use progress::Progress;
