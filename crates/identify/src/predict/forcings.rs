//! Normal equations with tested terms of the equations of motion: rates of states to which a function of time is added.

use nalgebra::{DMatrix, DVector};
use ode::DifferentiableRhs;

use super::term_products::TermProducts;
use super::weighted_rows::{self, WeightedRows};
use super::{FlightAt, JacobianColumns, Loss, TrajectoryPass};
use crate::error::FlightError;
use crate::ids::GlobalId;
use crate::least_squares::{GramAccumulator, NormalBlock, TestedParameters};
use crate::noise::NoiseModel;
use crate::observations::Observations;
use crate::problem::FitProblem;
use model_spec::layout::StateId;

/// Relative error of a term as a combination of the states' derivatives by the initial state, above which these do not
/// carry every change of the state.
const SPANNED: f64 = 0.01;

/// What a term is added to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Target {
    /// An estimated coefficient.
    Coefficient(GlobalId),
    /// The rate of a state.
    Rate(StateId),
}

/// Targets of a model: the estimated coefficients on which its equations of motion depend, and the states in whose rates
/// these occur.
pub(crate) fn targets(
    problem: &FitProblem,
    observations: &Observations,
    global: &DVector<f64>,
) -> Vec<Target> {
    let conditions = observations.bound(problem, global);
    let motion = conditions.rhs();
    let pattern = motion.parameter_jacobian_pattern();
    let globals = problem.globals.iter().enumerate();
    let moving = globals.filter(|(_, own)| pattern.iter().any(|(_, p)| *p == own.param.index()));
    let coefficients = moving.map(|(index, _)| Target::Coefficient(GlobalId::new(index)));
    let is_estimated = |parameter: usize| {
        let mut globals = problem.globals.iter();
        globals.any(|own| own.param.index() == parameter)
    };
    let rates = (0..motion.states()).filter(|state| {
        let mut entries = pattern.iter();
        entries.any(|&(row, parameter)| row == *state && is_estimated(parameter))
    });
    coefficients
        .chain(rates.map(|state| Target::Rate(StateId::new(state))))
        .collect()
}

/// Derivatives of one residual vector, by the local parameters and then the global ones.
struct Row {
    channel: usize,
    sample: usize,
    residual: [f64; 3],
    derivatives: [Vec<f64>; 3],
}

/// Terms that are added to the equations of motion: each of the targets changes by each of the functions.
pub(crate) struct Added<'a> {
    pub targets: &'a [Target],
    /// Number of functions.
    pub functions: usize,
    /// Values of the functions at a time, s, and a state.
    pub at: &'a mut dyn FnMut(f64, &[f64]) -> Vec<f64>,
}

/// Normal equations of a flight, whitened by `noise`, with the tested terms, target by target. `None` if the initial
/// state is not free.
///
/// A term g w(t) that is added to the rates changes the states by L(t) c(t) with dc/dt = L⁻¹ g w, where L are the
/// derivatives by the initial state; g is ∂f/∂p for a coefficient p. The integral is that of the trapezoidal rule at the
/// samples: a test of what it approximates, and none the less valid.
///
/// # Errors
/// [`FlightError::Integration`] if the trajectory cannot be computed.
pub(crate) fn linearise_with_terms(
    at: FlightAt<'_>,
    noise: &NoiseModel,
    added: Added<'_>,
) -> Result<Option<(NormalBlock, TestedParameters)>, FlightError> {
    let (problem, observations) = (at.problem, at.observations);
    let locals = observations.manifold.dimension();
    if locals == 0 {
        return Ok(None);
    }
    let conditions = at.bound();
    let parameters = problem.global_parameters();
    let mut motion = conditions.rhs();
    let columns = JacobianColumns::new(observations, &motion, &parameters);
    let pass = TrajectoryPass {
        at,
        tolerance: problem.tolerance * problem.sigma0 * observations.tolerance_factor,
        with_outliers: false,
    };
    let (mut rows, mut trajectory) = (Vec::new(), None);
    let layout =
        pass.each_residual(&mut motion, &columns, Some(&mut trajectory), &mut |point| {
            rows.push(Row {
                channel: point.channel,
                sample: point.sample,
                residual: point.residual,
                derivatives: point.rows.each_ref().map(|row| padded(row)),
            });
        })?;
    let trajectory = trajectory.unwrap_or_default();
    let mut terms = Terms::new(problem, &motion, added.targets);
    let terms_of = (added.targets.len(), added.functions);
    let sum = TermProducts::new((locals, parameters.len()), terms_of);
    let mut sum = WeightedRows::new(sum, &problem.channels, Loss::Whitened(noise));
    let size = trajectory.len() / observations.times.len().max(1);
    let mut rows = rows.into_iter().peekable();
    for (sample, &time) in observations.times.iter().enumerate() {
        let augmented = &trajectory[sample * size..][..size];
        let by_local = columns.states_by_local(layout, augmented);
        let state = layout.state(augmented);
        let tangent = observations.manifold.tangent(state);
        let Some(by_target) = terms.added(&mut motion, (time, state), &by_local, &tangent) else {
            return Ok(None);
        };
        let functions = (added.at)(time, state);
        sum.accumulator
            .begin(time, &by_target, functions.into_iter());
        while let Some(mut row) = rows.next_if(|row| row.sample == sample) {
            sum.add(row.channel, time, &mut row.derivatives, row.residual);
        }
    }
    let (mut block, tested) = sum.accumulator.finish();
    weighted_rows::add_priors(at, &mut block);
    Ok(Some((block, tested)))
}

/// A row as the sums need it.
fn padded(row: &[f64]) -> Vec<f64> {
    let mut padded = vec![0.0; GramAccumulator::width(row.len())];
    padded[..row.len()].copy_from_slice(row);
    padded
}

/// The tested terms as changes of the rates.
struct Terms {
    targets: usize,
    /// For each entry of ∂f/∂p: row, index in the pattern, and target.
    of_coefficients: Vec<(usize, usize, usize)>,
    /// State and target.
    of_rates: Vec<(usize, usize)>,
    derivatives: [Vec<f64>; 3],
}

impl Terms {
    fn new(problem: &FitProblem, motion: &dyn DifferentiableRhs, targets: &[Target]) -> Self {
        let pattern = motion.parameter_jacobian_pattern();
        let (mut of_coefficients, mut of_rates) = (Vec::new(), Vec::new());
        for (place, target) in targets.iter().enumerate() {
            match target {
                Target::Rate(state) => of_rates.push((state.index(), place)),
                Target::Coefficient(id) => {
                    let parameter = problem.globals[id.index()].param.index();
                    let entries = pattern.iter().enumerate();
                    let own = entries.filter(|(_, (_, of))| *of == parameter);
                    of_coefficients.extend(own.map(|(entry, (row, _))| (*row, entry, place)));
                }
            }
        }
        let derivatives = [
            motion.states(),
            motion.jacobian_pattern().len(),
            pattern.len(),
        ];
        Self {
            targets: targets.len(),
            of_coefficients,
            of_rates,
            derivatives: derivatives.map(|length| vec![0.0; length]),
        }
    }

    /// L⁻¹ g at a state (local parameters × targets), with L = `by_local`; `None` if L does not carry the terms.
    fn added(
        &mut self,
        motion: &mut dyn DifferentiableRhs,
        (time, state): (f64, &[f64]),
        by_local: &DMatrix<f64>,
        tangent: &[(usize, usize, f64)],
    ) -> Option<DMatrix<f64>> {
        let [rates, by_state, by_parameter] = &mut self.derivatives;
        motion.derivative_with_jacobians(time, state, rates, by_state, by_parameter);
        let mut added = DMatrix::zeros(by_local.nrows(), self.targets);
        for &(row, entry, target) in &self.of_coefficients {
            added[(row, target)] += by_parameter[entry];
        }
        for &(state, target) in &self.of_rates {
            added[(state, target)] = 1.0;
        }
        carried(by_local, &added, tangent)
    }
}

/// The matrix c with L c = `added`, where L is `by_local` and `tangent` are the entries of the manifold's tangent, out of
/// which the errors of the integration lead; `None` if there is none.
fn carried(
    by_local: &DMatrix<f64>,
    added: &DMatrix<f64>,
    tangent: &[(usize, usize, f64)],
) -> Option<DMatrix<f64>> {
    let along = |matrix: &DMatrix<f64>| {
        let mut found = DMatrix::zeros(by_local.ncols(), matrix.ncols());
        for &(state, direction, value) in tangent {
            for column in 0..matrix.ncols() {
                found[(direction, column)] += value * matrix[(state, column)];
            }
        }
        found
    };
    let found = along(by_local).lu().solve(&along(added))?;
    let mut left = by_local * &found - added;
    // Errors of a quaternion lie across the manifold; its entries of the tangent are at most 1/2.
    for &(state, _, value) in tangent {
        if value != 1.0 {
            left.row_mut(state).fill(0.0);
        }
    }
    let is_carried =
        (0..added.ncols()).all(|k| left.column(k).norm() <= SPANNED * added.column(k).norm());
    is_carried.then_some(found)
}

#[cfg(test)]
mod tests {
    use dataset::synthesize::{Plan, flights};
    use flight::release::{Release, Stop};

    use super::*;
    use crate::options::FitOptions;

    /// A stone on whose drag a second coefficient acts from 0.2 s on, and which a third one lifts.
    const STONE: &str = "
        model stone;
        param m = 0.5 kg;
        param g = 9.81 m/s^2;
        coefficient k = 0.02 kg/m;
        coefficient k_late = 0.05 kg/m;
        coefficient a_up = 0.01 m/s^2;
        frame N;
        state x = 0 m;
        state y = 0 m;
        state z = 2 m;
        state vx = 9 m/s;
        state vy = 1 m/s;
        state vz = 3 m/s;
        let v = (vx, vy, vz) in N;
        let late = (1 + tanh((time - 0.2 s)/(0.0001 s)))/2;
        let a = -(k + k_late*late)*norm(v)/m*v + (a_up - g)*N.3;
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
    fn tested_terms_act_as_the_coefficients_that_they_are() {
        let model = model_spec::load::from_text("stone.hyz", STONE, &[]).unwrap();
        let release = Release {
            stop: Stop::Duration(0.5),
            ..Release::of(&model)
        };
        let plan = Plan {
            rate: 400.0,
            ..Plan::default()
        };
        let dataset = flights(&model, &[release], &plan).unwrap().dataset;
        let problem = FitProblem::new(&model, &dataset, &FitOptions::default()).unwrap();
        let observations = Observations::new(&problem, &dataset.flights[0]).unwrap();
        let global = problem.model_values();
        let local = DVector::from_row_slice(&[0.0, 0.0, 2.0, 9.0, 1.0, 3.0]);
        let targets = targets(&problem, &observations, &global);
        let place = |name: &str| {
            let mut globals = problem.globals.iter();
            globals.position(|own| own.name == name).unwrap()
        };
        let [k, k_late, a_up] = ["k", "k_late", "a_up"].map(place);
        let rate_of_vz = Target::Rate(StateId::new(5));
        let test = |target| 2 * targets.iter().position(|own| *own == target).unwrap();
        let late_k = 1 + test(Target::Coefficient(GlobalId::new(k)));
        let constant = test(rate_of_vz);
        let late = |time: f64| 0.5 * (1.0 + ((time - 0.2) / 1e-4).tanh());
        let added = Added {
            targets: &targets,
            functions: 2,
            at: &mut |time, _| vec![1.0, late(time)],
        };
        let found = linearise_with_terms(
            FlightAt::new(&problem, &observations, (&global, &local)),
            &NoiseModel::white(1e-3, 1.0 / 400.0),
            added,
        );
        let (block, tested) = found.unwrap().unwrap();
        let samples = observations.times.len();
        assert_eq!(block.count, 3 * observations.channels * samples);
        // What begins between two samples is known less exactly.
        for (test, same, within) in [(late_k, k_late, 2e-2), (constant, a_up, 1e-3)] {
            for other in 0..3 {
                let ratio = tested.by_global[(other, test)] / block.global[(other, same)];
                assert!((ratio - 1.0).abs() < within, "{same} {other} {ratio}");
            }
            let ratio = tested.information[test] / block.global[(same, same)];
            assert!((ratio - 1.0).abs() < within, "{same} {ratio}");
            let cross = block.cross.column(same);
            let left = tested.by_local.column(test) - cross;
            assert!(left.norm() < within * cross.norm(), "{left}");
        }
    }
}
