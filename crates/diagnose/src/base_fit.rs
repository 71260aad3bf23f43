//! The fit of the model under test, with the encompassing model in parallel.

use std::collections::BTreeMap;
use std::time::Instant;

use identify::{DataFault, FaultKind, Fit, FitError, FitOptions, fit};

use crate::context::{Context, EncompassingModel};
use crate::error::DiagnosisError;
use crate::parallel::join;

/// The fit of the model under test.
pub(crate) struct BaseFit {
    /// Computing time so far.
    pub clock: Clock,
    /// The fit.
    pub fit: Fit,
    /// The model with every candidate at its null value.
    pub encompassing: EncompassingModel,
    /// Whether all flights have a fault that an effect may explain, so that they are used all the same.
    pub is_despite_faults: bool,
}

impl BaseFit {
    /// Fits the model under test.
    ///
    /// # Errors
    /// [`DiagnosisError`] if the flights cannot be fitted, or the caller cancelled.
    pub fn new(context: Context<'_>) -> Result<Self, DiagnosisError> {
        let mut clock = Clock::start();
        let Context {
            model,
            dataset,
            options,
        } = context;
        let (encompassing, found) = join(
            options.fit.threads(),
            || EncompassingModel::new(model, options.without),
            || fit(model, dataset, &options.fit),
        );
        let mut is_despite_faults = false;
        let found = match found {
            Err(FitError::FaultyData(faults)) if may_be_an_effect(&faults) => {
                is_despite_faults = true;
                let trusting = FitOptions {
                    trust_data: true,
                    ..options.fit
                };
                fit(model, dataset, &trusting)
            }
            found => found,
        };
        let (fit, encompassing) = (found?, encompassing?);
        clock.record("fit");
        Ok(Self {
            clock,
            fit,
            encompassing,
            is_despite_faults,
        })
    }
}

/// Whether an effect of the measurement may explain the faults of all flights: no label, unit or axis is told to be wrong.
fn may_be_an_effect(faults: &[DataFault]) -> bool {
    faults.iter().all(|fault| fault.fault == FaultKind::Other)
}

/// Computing time by stage.
pub(crate) struct Clock {
    started: Instant,
    pub seconds: BTreeMap<String, f64>,
}

impl Clock {
    pub fn start() -> Self {
        Self {
            started: Instant::now(),
            seconds: BTreeMap::new(),
        }
    }

    /// Records the time since the stage's start under its name.
    pub fn record(&mut self, stage: &str) {
        let elapsed = self.started.elapsed().as_secs_f64();
        self.seconds.insert(stage.to_owned(), elapsed);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::context::DiagnosisOptions;
    use crate::test_support::mystery;
    use identify::dataset::Dataset;

    fn base_fit(dataset: &Dataset) -> Result<BaseFit, DiagnosisError> {
        let model = model_spec::load::load("disc", &[]).unwrap();
        BaseFit::new(Context {
            model: &model,
            dataset,
            options: &DiagnosisOptions::default(),
        })
    }

    #[test]
    fn a_fault_of_all_flights_ends_a_diagnosis_only_where_no_effect_can_explain_it() {
        let good = mystery(4);
        assert!(!base_fit(&good).unwrap().is_despite_faults);
        let mut misplaced = good.clone();
        for coordinate in &mut misplaced.markers[0].position {
            *coordinate *= 0.3;
        }
        let found = base_fit(&misplaced).unwrap();
        assert!(found.is_despite_faults);
        assert_eq!(found.fit.report.data_faults.len(), 4);
        let mut feet = good;
        for flight in &mut feet.flights {
            let points = flight.positions.iter_mut().flatten().flatten();
            points.for_each(|point| *point = point.map(|x| x / 0.3048));
        }
        let error = base_fit(&feet).err().unwrap();
        assert!(matches!(
            error,
            DiagnosisError::Fit(FitError::FaultyData(_))
        ));
    }
}
