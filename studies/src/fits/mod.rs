//! Study of the fit: how often, and how fast, a model with the right effects reaches the noise level from its default
//! initial values. Writes docs/studies/fits.md.

mod case;
mod page;
mod run;

pub use case::FitCase;
pub use page::fits_page;
pub use run::{FitOutcome, fit_outcome, fits};
