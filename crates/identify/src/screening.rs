//! Screening of the recordings that a fit uses, and the flights that it excludes.

use dataset::pose::RigidMotion;
use dataset::screening::{Body, marker_pairs};
use dataset::{DataFault, Dataset, Flight, PosePoints};
use flight::CompiledModel;
use model_spec::model::Model;

use crate::error::{ExcludedFlight, FlightError};
use crate::ids::FlightId;
use crate::initial_state::state_for_motion;
use crate::observations::Observations;
use crate::observers::ChannelConditions;
use crate::options::FitOptions;
use crate::problem::FitProblem;
use dataset::levels::ROUNDING;

impl Body for FitProblem {
    fn model(&self) -> &Model {
        &self.model
    }

    fn compiled(&self) -> &CompiledModel {
        &self.body
    }

    fn parameters(&self) -> &[f64] {
        &self.parameters
    }

    fn points(&self) -> &PosePoints {
        &self.points
    }

    fn sees_positions(&self) -> bool {
        FitProblem::sees_positions(self)
    }

    fn rigid_pairs(&self) -> Vec<bool> {
        rigid_pairs(self)
    }

    fn states(&self, flight: &Flight, motions: &[RigidMotion]) -> Vec<Option<Vec<f64>>> {
        let observations = Observations::new(self, flight).ok();
        let state = |motion| {
            let state = state_for_motion(self, observations.as_ref()?, motion).ok()?;
            Some(state.as_slice().to_vec())
        };
        motions.iter().map(state).collect()
    }
}

/// Whether each pair of [`marker_pairs`] has a distance that no estimated parameter changes.
fn rigid_pairs(problem: &FitProblem) -> Vec<bool> {
    let pairs = marker_pairs(problem.points.markers.len());
    let conditions = ChannelConditions::new(problem, &problem.parameters.clone().into());
    let mut observers = conditions.observers();
    // The default state may be at rest or level, where derivatives vanish.
    let states = problem.body.layout().default_states().into_iter();
    let state: Vec<f64> = states
        .enumerate()
        .map(|(index, value)| value + 0.3 + 0.1 * index as f64)
        .collect();
    let estimated = |param: usize| {
        let mut globals = problem.globals.iter();
        globals.position(|global| global.param.index() == param)
    };
    // Position of each marker and its derivatives with respect to the estimated parameters.
    let seen: Vec<([f64; 3], Vec<[f64; 3]>)> = (0..problem.points.markers.len())
        .map(|marker| {
            let (position, jacobians) = observers.observe(0.0, &state, marker);
            let mut by_global = vec![[0.0; 3]; problem.globals.len()];
            let entries = jacobians.by_parameter_pattern.iter();
            for (&(row, param), value) in entries.zip(jacobians.by_parameter) {
                if let Some(global) = estimated(param) {
                    by_global[global][row] = *value;
                }
            }
            (position, by_global)
        })
        .collect();
    let is_rigid = |&(i, j): &(usize, usize)| {
        let ((a, by_a), (b, by_b)) = (&seen[i], &seen[j]);
        by_a.iter().zip(by_b).all(|(by_a, by_b)| {
            let change = (0..3).map(|k| (b[k] - a[k]) * (by_b[k] - by_a[k]));
            let size = (0..3).map(|k| (b[k] - a[k]).abs() * (by_b[k].abs() + by_a[k].abs()));
            // The comparison is false if a value is not finite: the distance is then unknown.
            change.sum::<f64>().abs() <= ROUNDING * size.sum::<f64>()
        })
    };
    pairs.iter().map(is_rigid).collect()
}

/// Flights that a fit excludes because of their faults; empty with the option `trust_data`.
pub(crate) fn excluded(
    dataset: &Dataset,
    faults: &[DataFault],
    options: &FitOptions<'_>,
) -> Vec<ExcludedFlight> {
    let mut excluded = Vec::new();
    if options.trust_data {
        return excluded;
    }
    for (index, flight) in dataset.flights.iter().enumerate() {
        let fault = faults.iter().find(|fault| fault.file == flight.file);
        excluded.extend(fault.map(|fault| ExcludedFlight {
            flight: FlightId::new(index),
            file: flight.file.clone(),
            reason: FlightError::DataFault(fault.clone()),
        }));
    }
    excluded
}
