//! First stage of a diagnosis: its inputs, and the encompassing model with every candidate effect at its null value.

mod columns;
mod encompassing;
mod library_terms;
mod linearize;
mod options;
mod refit;
mod score_test_model;

use model_spec::model::Model;

pub(crate) use columns::{CandidateId, ColumnId, Partition, TermId, select, select_vector};
use dataset::Dataset;
pub use encompassing::identifier;
pub(crate) use encompassing::{
    Candidate, CandidateParameter, EncompassingModel, display_name, of_missing_poses,
    of_stated_inputs,
};
pub(crate) use library_terms::LibraryTerms;
pub(crate) use linearize::{LinearizationPoint, TrajectoryCache};
pub use options::{DiagnosisOptions, OptionsError, ThrowRanges};
pub(crate) use refit::Refitted;
pub(crate) use score_test_model::ScoreTestModel;

/// Inputs of one diagnosis: model, dataset and options.
#[derive(Clone, Copy)]
pub(crate) struct Context<'a> {
    pub model: &'a Model,
    /// The dataset of measured flights, fitted and held out.
    pub dataset: &'a Dataset,
    pub options: &'a DiagnosisOptions<'a>,
}

impl Context<'_> {
    pub fn has_held_out(&self) -> bool {
        let mut flights = self.dataset.flights.iter();
        flights.any(|flight| flight.role == dataset::Role::HeldOut)
    }

    /// Whether the deadline has passed, or the caller cancelled the diagnosis.
    pub fn is_out_of_time(&self) -> bool {
        self.options.fit.is_past_deadline()
    }
}
