//! What a simulation gets wrong, and why.
//!
//! [`diagnosis`] fits a model, looks for what is missing, and answers with the causes that the data do not reject. Every
//! effect of the [`catalogue`] is tried on one [`bench`] without a refit ([`scores`]); the noise is settled first
//! ([`leftover`]), and what chance does is drawn ([`chance`]). [`causes`] holds each cause against all others; where none leaves
//! only noise, [`agree`] asks what the flights agree on ([`common`]), and which of them contradict it. What could explain nearly
//! anything must predict (`confirm`). [`terms`]
//! and [`outside`] look beyond the catalogue; [`extend`] writes the model that has what was found, and [`gain`] measures it on flights
//! that it has not seen; [`throw`] says which flight would tell the remaining causes apart. [`report`] is what comes out.

pub mod agree;
pub mod bench;
mod beside;
pub mod catalogue;
pub mod causes;
pub mod chance;
pub mod common;
mod confirm;
pub mod curves;
pub mod detect;
pub mod diagnosis;
pub mod extend;
pub mod gain;
pub mod histories;
pub mod kept;
pub mod leftover;
pub mod outside;
pub mod report;
pub mod scores;
mod telling;
pub mod terms;
pub mod throw;
pub mod weighted;
mod words;
