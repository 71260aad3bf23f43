//! Normal equations by global parameters that act from a time of the flight on alone.

use std::ops::Range;

use model_spec::layout::ParamId;
use nalgebra::{DMatrix, DVector};
use ode::{DifferentiableRhs, SensitivityLayout};

use super::weighted_rows::{self, WeightedRows};
use super::{JacobianColumns, Loss, TrajectoryPass};
use crate::error::FlightError;
use crate::least_squares::{GramAccumulator, NormalBlock};
use crate::noise::NoiseModel;
use crate::observations::Observations;
use crate::problem::FitProblem;

/// Relative error of a state's derivatives as a combination of those by the initial state, above which these do not
/// carry every change of the state.
const SPANNED: f64 = 1e-5;

/// Derivatives of one residual vector, by the local parameters and then the global ones.
struct Row {
    channel: usize,
    sample: usize,
    residual: [f64; 3],
    derivatives: [Vec<f64>; 3],
}

/// Normal equations of a flight, whitened by `noise`: by the local parameters, and by each global parameter as it acts
/// from the first sample of each span on, parameter by parameter. `None` if the initial state is not free.
///
/// Before a parameter acts, the state is that of the whole flight. Its derivatives by a parameter that acts from t₁ on
/// are thus G(t) − L(t) c with L(t₁) c = G(t₁), where L and G are those by the initial state and by the parameter.
///
/// # Errors
/// [`FlightError::Integration`] if the trajectory cannot be computed.
pub(crate) fn linearise_by_spans(
    problem: &FitProblem,
    observations: &Observations,
    (global, local): (&DVector<f64>, &DVector<f64>),
    noise: &NoiseModel,
    spans: &[Range<usize>],
) -> Result<Option<NormalBlock>, FlightError> {
    let conditions = problem.body.bind(observations.parameters(problem, global));
    let parameters: Vec<ParamId> = problem.globals.iter().map(|global| global.param).collect();
    let mut motion = conditions.rhs();
    let columns = JacobianColumns::new(observations, motion.jacobian_pattern(), &parameters);
    let pass = TrajectoryPass {
        problem,
        observations,
        global,
        local,
        samples: observations.times.len(),
        tolerance: problem.tolerance * problem.sigma0 * observations.tolerance_factor,
        with_outliers: false,
    };
    let order = columns.local_then_parameters();
    let (mut rows, mut trajectory) = (Vec::new(), None);
    let layout = pass.each_point(&mut motion, &columns, Some(&mut trajectory), |point| {
        let in_order = |row: &Vec<f64>| order.iter().map(|&column| row[column]).collect();
        rows.push(Row {
            channel: point.channel,
            sample: point.sample,
            residual: point.residual,
            derivatives: [0, 1, 2].map(|axis| in_order(&point.rows[axis])),
        });
    })?;
    let trajectory = trajectory.unwrap_or_default();
    let size = trajectory.len() / observations.times.len().max(1);
    let mut before = Vec::new();
    for span in spans {
        let augmented = &trajectory[span.start * size..][..size];
        match combination(&columns, layout, augmented, span.start) {
            Some(own) => before.push(own),
            None => return Ok(None),
        }
    }
    let locals = order.len() - parameters.len();
    let count = parameters.len() * spans.len();
    let accumulator =
        GramAccumulator::new((0..locals).collect(), (locals..locals + count).collect());
    let mut sum = WeightedRows::new(accumulator, &problem.channels, Loss::Whitened(noise));
    let mut by_spans = [0; 3].map(|_| vec![0.0; GramAccumulator::width(locals + count)]);
    for row in &rows {
        for (to, from) in by_spans.iter_mut().zip(&row.derivatives) {
            let (by_local, by_global) = from.split_at(locals);
            to[..locals].copy_from_slice(by_local);
            let mut places = to[locals..].iter_mut();
            for (parameter, own) in by_global.iter().enumerate() {
                for ((span, before), to) in spans.iter().zip(&before).zip(&mut places) {
                    let carried = before.column(parameter);
                    let carried = carried.iter().zip(by_local).map(|(c, l)| c * l);
                    *to = match row.sample < span.start {
                        true => 0.0,
                        false => own - carried.sum::<f64>(),
                    };
                }
            }
        }
        let time = observations.times[row.sample];
        sum.add(row.channel, time, &mut by_spans, row.residual);
    }
    let mut block = sum.accumulator.block();
    weighted_rows::add_priors(problem, observations, local, &mut block);
    Ok(Some(block))
}

/// The matrix c with L c = G at a sample, (local parameters × global parameters); `None` if there is none.
fn combination(
    columns: &JacobianColumns<'_>,
    layout: SensitivityLayout,
    augmented: &[f64],
    sample: usize,
) -> Option<DMatrix<f64>> {
    let derivatives = columns.of_states(layout, augmented);
    let count = columns.parameters.len();
    let locals = derivatives.ncols() - count;
    if sample == 0 {
        return Some(DMatrix::zeros(locals, count));
    }
    let mut by_local = derivatives.columns(0, locals).into_owned();
    let by_global = derivatives.columns(locals, count);
    let norms: Vec<f64> = by_local.column_iter().map(|own| own.norm()).collect();
    for (mut column, norm) in by_local.column_iter_mut().zip(&norms) {
        column.unscale_mut(norm.max(f64::MIN_POSITIVE));
    }
    let mut found = by_local
        .clone()
        .svd(true, true)
        .solve(&by_global, 0.0)
        .ok()?;
    let left = &by_local * &found - by_global;
    let is_spanned = left.iter().all(|own| own.is_finite())
        && (0..count).all(|k| left.column(k).norm() <= SPANNED * by_global.column(k).norm());
    for (mut row, norm) in found.row_iter_mut().zip(&norms) {
        row.unscale_mut(norm.max(f64::MIN_POSITIVE));
    }
    is_spanned.then_some(found)
}

#[cfg(test)]
mod tests {
    use dataset::synthesize::{Plan, flights};
    use flight::release::{Release, Stop};

    use super::*;
    use crate::options::FitOptions;

    /// A stone on whose drag a second coefficient acts from 0.2 s on.
    const STONE: &str = "
        model stone;
        param m = 0.5 kg;
        param g = 9.81 m/s^2;
        coefficient k = 0.02 kg/m;
        coefficient k_late = 0.05 kg/m;
        frame N;
        state x = 0 m;
        state y = 0 m;
        state z = 2 m;
        state vx = 9 m/s;
        state vy = 1 m/s;
        state vz = 3 m/s;
        let v = (vx, vy, vz) in N;
        let late = (1 + tanh((time - 0.2 s)/(0.0001 s)))/2;
        let a = -(k + k_late*late)*norm(v)/m*v - g*N.3;
        der(x) = vx;
        der(y) = vy;
        der(z) = vz;
        der(vx) = dot(a, N.1);
        der(vy) = dot(a, N.2);
        der(vz) = dot(a, N.3);
        marker s in N;
        observe place = (x, y, z) in N + s;
    ";

    #[test]
    fn a_parameter_of_a_span_acts_as_one_that_is_switched_on() {
        let model = model_spec::load::from_text("stone.hyz", STONE, &[]).unwrap();
        let release = Release {
            stop: Stop::Duration(0.5),
            ..Release::of(&model)
        };
        let plan = Plan {
            rate: 100.0,
            ..Plan::default()
        };
        let dataset = flights(&model, &[release], &plan).unwrap().dataset;
        let problem = FitProblem::new(&model, &dataset, &FitOptions::default()).unwrap();
        let observations = Observations::new(&problem, &dataset.flights[0]).unwrap();
        let samples = observations.times.len();
        let (global, local) = (problem.model_values(), [0.0, 0.0, 2.0, 9.0, 1.0, 3.0]);
        let block = linearise_by_spans(
            &problem,
            &observations,
            (&global, &DVector::from_row_slice(&local)),
            &NoiseModel::white(1e-3, 0.01),
            &[0..20, 20..samples],
        );
        let block = block.unwrap().unwrap();
        // By column: `k` and `k_late`, each over the whole flight and from 0.2 s on.
        let [from_late, late] = [1, 2];
        assert!(block.global[(late, late)] < 0.9 * block.global[(0, 0)]);
        for other in 0..4 {
            let [a, b] = [from_late, late].map(|own| block.global[(own, other)]);
            assert!((a / b - 1.0).abs() < 1e-2, "{a} {b}");
        }
        let [a, b] = [from_late, late].map(|own| block.cross.column(own).into_owned());
        assert!((&a - &b).norm() < 1e-2 * a.norm(), "{a} {b}");
    }
}
