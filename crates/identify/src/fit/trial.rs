//! Faults of all flights that screening infers from their accelerations, which it compares with loads of usual kinds. The
//! user's model may have others: a trial fit of the data as they are decides.

use model_spec::model::Model;

use super::{Fit, FitError, fit_within};
use crate::data_fault::{DataFault, FaultKind};
use crate::options::FitOptions;
use dataset::statistics::median_of;
use dataset::{Dataset, Flight, Role};

/// Number of flights of the trial fit.
const FLIGHTS: usize = 4;

/// Acceleration that corresponds to the residuals of the trial fit, m/s², below which the data are as the model says.
/// Axes, units or times that are wrong leave accelerations of the order of gravity.
const MAX_ACCELERATION: f64 = 2.0;

/// Root mean square of a parabola a·t²/2 about its best straight line over a time T, in units of a·T²: 1/√720.
const BENDING: f64 = 0.0373;

/// Removes from `faults` those that all flights to be fitted have in common, if they rest on accelerations and the model
/// describes the recorded flights as they are.
///
/// # Errors
/// [`FitError::Interrupted`] if the work is cancelled.
pub fn remove_refuted(
    model: &Model,
    dataset: &Dataset,
    options: &FitOptions<'_>,
    faults: &mut Vec<DataFault>,
) -> Result<(), FitError> {
    let is_common = |flight: &Flight| {
        let mut own = faults.iter().filter(|fault| fault.file == flight.file);
        own.clone().next().is_some() && own.all(|fault| rests_on_loads(fault.fault))
    };
    let to_fit = dataset.flights.iter().filter(|f| f.role == Role::Fit);
    if options.trust_data || !to_fit.clone().all(is_common) {
        return Ok(());
    }
    let tried = Dataset {
        flights: to_fit.take(FLIGHTS).cloned().collect(),
        ..dataset.clone()
    };
    let as_they_are = FitOptions {
        known_faults: Some(&[]),
        profiles: &[],
        ..*options
    };
    match fit_within(model, &tried, &as_they_are, None) {
        Ok(fit) => {
            if flies_as_recorded(&fit) {
                faults.retain(|fault| !rests_on_loads(fault.fault));
            }
            Ok(())
        }
        Err(FitError::Interrupted) => Err(FitError::Interrupted),
        Err(_) => Ok(()),
    }
}

/// Whether a fault is inferred from loads that screening assumes.
fn rests_on_loads(fault: FaultKind) -> bool {
    matches!(
        fault,
        FaultKind::Axes | FaultKind::TimeUnit | FaultKind::Units
    )
}

/// Whether the accelerations that the fit leaves are small compared with those that wrong data leave.
fn flies_as_recorded(fit: &Fit) -> bool {
    let flights = fit.fitted();
    let durations = flights.filter_map(|flight| {
        let times = &flight.observations.times;
        Some(times.last()? - times.first()?)
    });
    let left = fit.report.position_rms();
    median_of(durations)
        .zip(left)
        .is_some_and(|(duration, left)| left < BENDING * MAX_ACCELERATION * duration * duration)
}
