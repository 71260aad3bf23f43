//! Fit of the model under test. The encompassing model, with all candidate effects, is composed in parallel.

use std::collections::BTreeMap;
use std::time::Instant;

use identify::{DataFault, FaultKind, Fit, FitError, FitOptions, fit};

use crate::context::{Context, EncompassingModel};
use crate::error::DiagnosisError;
use flight::parallel::join;

/// Fit of the model under test, and the encompassing model.
pub(crate) struct BaseFit {
    /// Computing time of the diagnosis, s, by stage, up to this fit.
    pub clock: Clock,
    /// Fit of the model under test to all flights with role `fit`.
    pub fit: Fit,
    /// The model extended by every candidate effect, each at the value at which it vanishes.
    pub encompassing: EncompassingModel,
    /// Whether every flight has a fault that an effect may explain, and they are used nevertheless.
    pub is_despite_faults: bool,
}

impl BaseFit {
    /// Fits the model under test and composes the encompassing model.
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

/// Whether an effect may be the reason of the faults: none is a wrong label, unit or axis.
fn may_be_an_effect(faults: &[DataFault]) -> bool {
    faults.iter().all(|fault| fault.fault == FaultKind::Other)
}

/// Stopwatch of a diagnosis: time from the start to the end of each stage (`fit`, `search`, `total`).
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

    /// Stores the time in s since [`Clock::start`] under the name `stage`.
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
    use dataset::Dataset;

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
