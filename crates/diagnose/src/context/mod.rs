//! First stage of a diagnosis: its inputs, and the encompassing model with every candidate effect at its null value.

mod basis_load;
mod candidates;
mod encompassing;
mod ids;
mod library_terms;
mod linearize;
mod options;
mod partition;
mod refit;
mod score_test_model;
mod trajectory_cache;

use dataset::Dataset;
use model_spec::model::Model;

pub(crate) use basis_load::BasisLoads;
pub(crate) use candidates::{Candidate, CandidateParameter, display_name};
pub(crate) use encompassing::EncompassingModel;
pub(crate) use ids::{CandidateId, ColumnId, TermId};
pub(crate) use library_terms::LibraryTerms;
pub(crate) use partition::{Partition, select, select_vector};
pub(crate) use refit::Refitted;
pub(crate) use score_test_model::ScoreTestModel;
pub(crate) use trajectory_cache::{LinearizationPoint, TrajectoryCache};

pub use candidates::identifier;
pub use options::{DiagnosisOptions, OptionsError, ThrowRanges};

/// Inputs of one diagnosis: model, dataset and options.
#[derive(Clone, Copy)]
pub(crate) struct Context<'a> {
    /// The model under test.
    pub model: &'a Model,
    /// The dataset of measured flights, fitted and held out.
    pub dataset: &'a Dataset,
    /// Options of the diagnosis, including those of its fits.
    pub options: &'a DiagnosisOptions<'a>,
}

impl Context<'_> {
    /// Whether the dataset declares held-out flights.
    pub fn has_held_out(&self) -> bool {
        let mut flights = self.dataset.flights.iter();
        flights.any(|flight| flight.role == dataset::Role::HeldOut)
    }

    /// Whether the deadline set by the caller has passed.
    pub fn is_out_of_time(&self) -> bool {
        self.options.fit.is_past_deadline()
    }

    /// Returns [`identify::FitError::Interrupted`] if the caller cancelled the diagnosis.
    pub fn check_cancelled(&self) -> Result<(), identify::FitError> {
        match self.options.fit.is_cancelled() {
            true => Err(identify::FitError::Interrupted),
            false => Ok(()),
        }
    }
}
