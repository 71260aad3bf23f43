//! A small dataset for unit tests: flights of `examples/mystery`, generated with the effect `stall`.

use dataset::Dataset;
use identify::{Fit, FitOptions, Iterate, fit};

use crate::context::{CandidateId, Context, DiagnosisOptions, EncompassingModel, ScoreTestModel};

/// The model `disc`, which lacks the effect `stall`, fitted to three flights of the dataset `examples/mystery`.
pub(crate) struct Fixture {
    pub fit: Fit,
    pub model: ScoreTestModel<'static>,
    /// Fitted parameter values and initial states, as unknowns of the score-test model `model`.
    pub iterate: Iterate,
}

impl Fixture {
    /// Index of the candidate effect with the given display name; panics if there is none.
    pub fn candidate(&self, name: &str) -> CandidateId {
        let mut candidates = self.model.candidates();
        let found = candidates.find(|(_, candidate)| candidate.name == name);
        found.unwrap_or_else(|| panic!("no candidate {name}")).0
    }
}

pub(crate) fn mystery(flights: usize) -> Dataset {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/mystery");
    let mut dataset = dataset::load(folder.as_ref()).unwrap();
    dataset.flights.truncate(flights);
    dataset
}

/// Loads three flights of the dataset `examples/mystery`, fits the model `disc` to them, and creates the score-test
/// model of this fit.
pub(crate) fn fixture() -> Fixture {
    // The inputs of the score-test model are never freed.
    let context = Context {
        model: Box::leak(Box::new(model_spec::load::load("disc", &[]).unwrap())),
        dataset: Box::leak(Box::new(mystery(3))),
        options: Box::leak(Box::new(DiagnosisOptions::default())),
    };
    let fit = fit(context.model, context.dataset, &FitOptions::default()).unwrap();
    let encompassing = EncompassingModel::new(context.model, &[]).unwrap();
    let (model, iterate) = ScoreTestModel::new(encompassing, context, &fit).unwrap();
    Fixture {
        fit,
        model,
        iterate,
    }
}
