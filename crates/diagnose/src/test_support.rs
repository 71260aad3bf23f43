//! A small dataset for unit tests: flights of `examples/mystery`, made with the effect `stall`.

use identify::dataset::{self, Dataset};
use identify::{Fit, FitOptions, Iterate, fit};

use crate::context::{CandidateId, Context, DiagnosisOptions, EncompassingModel, ScoreTestModel};

/// The model `disc`, which lacks the effect, fitted to three flights.
pub(crate) struct Fixture {
    /// The fit of the model under test.
    pub fit: Fit,
    /// The score-test model.
    pub model: ScoreTestModel,
    /// The fit in the score-test model.
    pub iterate: Iterate,
}

impl Fixture {
    /// A candidate by its display name.
    pub fn candidate(&self, name: &str) -> CandidateId {
        let mut candidates = self.model.candidates();
        let found = candidates.find(|(_, candidate)| candidate.name == name);
        found.unwrap_or_else(|| panic!("no candidate {name}")).0
    }
}

/// The first flights of `examples/mystery`.
pub(crate) fn mystery(flights: usize) -> Dataset {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/mystery");
    let mut dataset = dataset::load(folder.as_ref()).unwrap();
    dataset.flights.truncate(flights);
    dataset
}

/// The fixture.
pub(crate) fn fixture() -> Fixture {
    let dataset = mystery(3);
    let model = model_spec::load::load("disc", &[]).unwrap();
    let options = DiagnosisOptions::default();
    let fit = fit(&model, &dataset, &FitOptions::default()).unwrap();
    let context = Context {
        model: &model,
        dataset: &dataset,
        options: &options,
    };
    let encompassing = EncompassingModel::new(&model, &[]).unwrap();
    let (model, iterate) = ScoreTestModel::new(encompassing, context, &fit).unwrap();
    Fixture {
        fit,
        model,
        iterate,
    }
}
