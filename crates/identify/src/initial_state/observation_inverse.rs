//! Finds the state with a given rigid-body motion, by Levenberg–Marquardt on the model's measurement equation.

use std::f64::consts::TAU;

use flight::{BoundModel, ModelState};
use model_spec::sort_by_number;
use nalgebra::{DMatrix, DVector, UnitQuaternion, Vector3};
use ode::OdeRhs;

use super::RigidMotion;
use crate::error::FlightError;
use crate::ids::LocalId;
use crate::observations::Observations;
use crate::problem::FitProblem;

/// Body-fixed points whose positions and velocities determine the motion: the origin and one point on each axis, m.
const PROBES: [[f64; 3]; 4] = [[0.0; 3], [0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]];

/// Distance of the probes from their targets, m, at which the search ends; velocities × `VELOCITY_WEIGHT` count, too.
const MAX_DISTANCE: f64 = 1e-6;

/// Maximum number of states from which the search for the state with a given motion is started.
const MAX_GUESSES: usize = 8;

/// Maximum number of states whose motion is compared with the given one before the search.
const MAX_COMPARED: usize = 4096;

/// Step size of the one-sided finite differences for the Jacobian, in the SI unit of each state.
const DIFFERENCE_STEP: f64 = 1e-6;

/// Time by which velocities of probes are multiplied, s, to be compared with positions.
const VELOCITY_WEIGHT: f64 = 0.02;

/// Returns the state that has the given motion at the first sample, as nearly as possible. Of `observations`, the
/// parameters and known states are used.
///
/// # Errors
/// [`FlightError::NoMatchingState`] if no search leads to a state within the model's domain of validity.
pub fn state_for_motion(
    problem: &FitProblem,
    observations: &Observations,
    motion: &RigidMotion,
) -> Result<DVector<f64>, FlightError> {
    let parameters = observations.parameters(problem, &problem.model_values());
    let conditions = problem.body.bind(parameters);
    let probes: &[[f64; 3]] = if problem.points.has_attitude {
        &PROBES
    } else {
        &PROBES[..1]
    };
    let target = target(motion, probes);
    let states = problem.body.layout().states.len();
    let time = observations.times.first().copied().unwrap_or(0.0);
    let mut shown = ProbeMotion::new(&conditions, states, probes, time);
    // In the order of the distance of the points from their targets; the sort is stable.
    let mut guesses: Vec<(f64, DVector<f64>)> = guesses(problem, observations)
        .into_iter()
        .map(|guess| (shown.distance(&guess, &target), guess))
        .collect();
    sort_by_number(&mut guesses, |guess| guess.0);
    let mut best: Option<(f64, DVector<f64>)> = None;
    for (_, guess) in guesses.into_iter().take(MAX_GUESSES) {
        let found = descend(problem, observations, &mut shown, &target, guess);
        let Some((distance, state)) = found else {
            continue;
        };
        let better = best.as_ref().is_none_or(|(least, _)| distance < *least);
        if better
            && conditions
                .observer()
                .is_within_limits(time, state.as_slice())
        {
            let near = distance < MAX_DISTANCE;
            best = Some((distance, state));
            if near {
                break;
            }
        }
    }
    // Known states may prevent an exact match; the fit judges that.
    let (_, state) = best.ok_or(FlightError::NoMatchingState)?;
    let unwound = unwound(problem, &state);
    let moved = shown.at(&unwound) - shown.at(&state);
    Ok(if moved.norm() < MAX_DISTANCE {
        unwound
    } else {
        state
    })
}

/// The state with every angle less the whole turns that lie between it and its default.
fn unwound(problem: &FitProblem, state: &DVector<f64>) -> DVector<f64> {
    let default = problem.body.layout().default_states();
    let mut unwound = state.clone();
    for angle in problem.model.angle_states() {
        unwound[angle] -= TAU * ((state[angle] - default[angle]) / TAU).round();
    }
    unwound
}

/// Positions of the probes in the given motion, m, followed by their velocities × `VELOCITY_WEIGHT`, m.
fn target(motion: &RigidMotion, probes: &[[f64; 3]]) -> DVector<f64> {
    let arm = |probe: &[f64; 3]| {
        let probe = Vector3::from(*probe);
        motion.attitude.map_or(probe, |attitude| attitude * probe)
    };
    let rates = motion.rates.unwrap_or_else(Vector3::zeros);
    let positions = probes.iter().map(|probe| motion.position + arm(probe));
    let velocities = probes
        .iter()
        .map(|probe| (motion.velocity + rates.cross(&arm(probe))) * VELOCITY_WEIGHT);
    let all: Vec<f64> = positions
        .chain(velocities)
        .flat_map(|v| [v.x, v.y, v.z])
        .collect();
    DVector::from_vec(all)
}

/// The default state, and its copies with every angle and orientation changed by quarter turns, if not too many.
fn guesses(problem: &FitProblem, observations: &Observations) -> Vec<DVector<f64>> {
    let default = DVector::from_vec(problem.body.layout().default_states());
    let quarters = [-1.0, 0.0, 1.0, 2.0].map(|k| k * std::f64::consts::FRAC_PI_2);
    let angles = problem.model.angle_states().into_iter();
    let angles = angles.map(|angle| quarters.map(|quarter| vec![(angle, quarter)]).to_vec());
    let quaternions = problem.model.quaternions().map(|states| {
        let turns = quarter_turns().into_iter();
        turns
            .map(|turn| states.into_iter().zip(turn).collect())
            .collect()
    });
    let mut guesses = vec![observations.with_known_states(default)];
    for turned in angles.chain(quaternions) {
        let turned: Vec<Vec<(usize, f64)>> = turned;
        if guesses.len() * turned.len() > MAX_COMPARED {
            break;
        }
        let all = guesses.iter().flat_map(|guess| {
            turned.iter().map(|places| {
                let mut guess = guess.clone();
                for &(place, value) in places {
                    guess[place] = value;
                }
                observations.with_known_states(guess)
            })
        });
        guesses = all.collect();
    }
    guesses
}

/// Unit quaternions of the 24 rotations that map a cube to itself.
fn quarter_turns() -> Vec<[f64; 4]> {
    let turn = |axis: Vector3<f64>, quarters: f64| {
        UnitQuaternion::from_scaled_axis(axis * (quarters * std::f64::consts::FRAC_PI_2))
    };
    let (x, y) = (Vector3::x(), Vector3::y());
    let over = [(x, 0.0), (x, 1.0), (y, 1.0), (x, -1.0), (y, -1.0), (x, 2.0)];
    let each = over.into_iter().flat_map(|(axis, quarters)| {
        let spun = [0.0, 1.0, 2.0, -1.0].map(|spin| turn(Vector3::z(), spin));
        spun.map(|spun| turn(axis, quarters) * spun)
    });
    each.map(|turn| [turn.w, turn.i, turn.j, turn.k]).collect()
}

/// Levenberg–Marquardt iteration from `state` for the state at which the probes are at `target`. Returns the norm of
/// the remaining difference, m, and the state; `None` if the iteration fails.
fn descend(
    problem: &FitProblem,
    observations: &Observations,
    shown: &mut ProbeMotion<'_>,
    target: &DVector<f64>,
    mut state: DVector<f64>,
) -> Option<(f64, DVector<f64>)> {
    // States that effects add do not follow from the motion and retain their values.
    let added = problem.model.added_states();
    if observations.manifold.is_held() {
        let still = DVector::zeros(observations.manifold.dimension());
        state = observations.manifold.plus(&state, &still);
    }
    let mut residual = shown.at(&state) - target;
    let mut damping = 1e-6;
    for _ in 0..60 {
        let before = residual.norm();
        if !before.is_finite() {
            return None;
        }
        if before < MAX_DISTANCE * 1e-3 {
            break;
        }
        let dimension = observations.manifold.dimension();
        let mut jacobian = DMatrix::zeros(target.len(), dimension);
        let mut step = DVector::zeros(dimension);
        for column in 0..dimension {
            let varied = observations.manifold.direct_state(LocalId::new(column));
            if varied.is_some_and(|state| added.contains(&state.index())) {
                continue;
            }
            step[column] = DIFFERENCE_STEP;
            let ahead = shown.at(&observations.manifold.plus(&state, &step)) - target;
            step[column] = 0.0;
            jacobian.set_column(column, &((ahead - &residual) / DIFFERENCE_STEP));
        }
        let mut normal = jacobian.tr_mul(&jacobian);
        for i in 0..dimension {
            normal[(i, i)] += damping * normal[(i, i)].max(1e-9);
        }
        let step = -normal.cholesky()?.solve(&jacobian.tr_mul(&residual));
        let candidate = observations.manifold.plus(&state, &step);
        let there = shown.at(&candidate) - target;
        if there.norm() < before {
            let gained = before - there.norm();
            (state, residual) = (candidate, there);
            damping = (damping * 0.1_f64).max(1e-12);
            if gained < 1e-12 * before {
                break;
            }
        } else if damping < 1e6 {
            damping *= 10.0;
        } else {
            break;
        }
    }
    let distance = residual.norm();
    distance.is_finite().then_some((distance, state))
}

/// Evaluates the positions and velocities of body-fixed points (probes) at a state of the model.
struct ProbeMotion<'a> {
    time: f64,
    observer: flight::ModelObserver<'a>,
    motion: flight::ModelRhs<'a>,
    state: ModelState,
    rates: ModelState,
    probes: &'a [[f64; 3]],
}

impl<'a> ProbeMotion<'a> {
    fn new(
        conditions: &'a BoundModel<'a>,
        states: usize,
        probes: &'a [[f64; 3]],
        time: f64,
    ) -> Self {
        Self {
            time,
            observer: conditions.observer(),
            motion: conditions.rhs(),
            state: vec![0.0; states].into(),
            rates: vec![0.0; states].into(),
            probes,
        }
    }

    /// Distance of the probes from their target positions, m; velocities are not compared.
    fn distance(&mut self, state: &DVector<f64>, target: &DVector<f64>) -> f64 {
        let mut squares = 0.0;
        for (probe, wanted) in self.probes.iter().zip(target.as_slice().chunks(3)) {
            let shown = self.observer.position(self.time, state.as_slice(), probe);
            squares += shown
                .iter()
                .zip(wanted)
                .map(|(a, b)| (a - b).powi(2))
                .sum::<f64>();
        }
        squares.sqrt()
    }

    fn at(&mut self, state: &DVector<f64>) -> DVector<f64> {
        self.state.as_mut().copy_from_slice(state.as_slice());
        self.motion
            .derivative(self.time, &self.state, &mut self.rates);
        let count = 3 * self.probes.len();
        let mut shown = DVector::zeros(2 * count);
        for (probe, position) in self.probes.iter().enumerate() {
            let (y, derivatives) =
                self.observer
                    .position_with_jacobians(self.time, &self.state, position);
            for axis in 0..3 {
                shown[3 * probe + axis] = y[axis];
            }
            let entries = derivatives
                .by_state_pattern
                .iter()
                .zip(derivatives.by_state);
            for (&(axis, state), value) in entries {
                shown[count + 3 * probe + axis] += value * self.rates[state] * VELOCITY_WEIGHT;
            }
        }
        shown
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::tests::simulated;
    use crate::initial_state::rigid_motion::first_motion;
    use crate::options::FitOptions;
    use dataset::synthesize::Plan;

    fn disc() -> (FitProblem, Observations) {
        let model = model_spec::load::load("disc", &[]).unwrap();
        let plan = Plan {
            flights: 1,
            duration: Some(0.3),
            ..Plan::default()
        };
        let dataset = simulated(&model, "backhand", &plan);
        let problem = FitProblem::new(&model, &dataset, &FitOptions::default()).unwrap();
        let observations = Observations::new(&problem, &dataset.flights[0]).unwrap();
        (problem, observations)
    }

    #[test]
    fn a_body_is_also_sought_upside_down_and_on_its_edges() {
        let (problem, observations) = disc();
        let guesses = guesses(&problem, &observations);
        for angle in problem.model.angle_states() {
            for turn in [-0.25, 0.0, 0.25, 0.5] {
                let mut turned = guesses.iter().map(|own| own[angle] - turn * TAU);
                assert!(turned.any(|off| off.abs() < 1e-12), "{angle} {turn}");
            }
        }
    }

    #[test]
    fn whole_turns_between_an_angle_and_its_default_are_taken_off() {
        let (problem, observations) = disc();
        let motion = first_motion(&problem, &observations).unwrap();
        let state = state_for_motion(&problem, &observations, &motion).unwrap();
        let mut turned = state.clone();
        for angle in problem.model.angle_states() {
            turned[angle] += 3.0 * TAU;
        }
        assert!((unwound(&problem, &turned) - state).norm() < 1e-9);
    }
}
