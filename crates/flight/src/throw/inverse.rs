//! Search for the state with a given motion: damped Gauss–Newton method on the differences between the motions.

use std::f64::consts::FRAC_PI_2;

use nalgebra::{DMatrix, DVector};

use super::motion::{BoundMotion, Motion, with_offset};

/// Norm of the differences between two motions of a body, below which the motions count as equal.
const SAME: f64 = 1e-9;
const MAX_STEPS: usize = 100;
/// Maximum number of starting states from which the search for a state with a given motion is run.
const MAX_STARTS: usize = 16;
/// Maximum number of starting states that are generated in the search for a state with a given motion.
const MAX_COMPARED: usize = 4096;
/// Offset of a state to either side in the central differences for the Jacobian, in the unit of the state.
const DIFFERENCE_STEP: f64 = 1e-5;
/// Least weight of a state in the damping, in units of the greatest.
const LEAST_WEIGHT: f64 = 1e-9;

/// State within the model's limits at which the body has the motion `wanted`. The search starts at `near` or, if it is
/// `None`, at default states whose frames are rotated by multiples of a quarter turn. `None` if no such state is found.
pub fn state(bound: &BoundMotion<'_>, wanted: &Motion, near: Option<&[f64]>) -> Option<Vec<f64>> {
    let mut starts = match near {
        Some(state) => vec![state.to_vec()],
        None => starts(bound),
    };
    // The sort is stable.
    starts.sort_by_cached_key(|start| norm(&bound.differences(start, wanted)).to_bits());
    starts.into_iter().take(MAX_STARTS).find_map(|start| {
        let mut found = descend(bound, wanted, start)?;
        bound.model.normalise(&mut found);
        let is_same = norm(&bound.differences(&found, wanted)) < SAME;
        (is_same && bound.is_within_limits(&found)).then_some(found)
    })
}

/// Starting states: copies of the default state with each frame rotated by multiples of a quarter turn.
fn starts(bound: &BoundMotion<'_>) -> Vec<Vec<f64>> {
    let half = 0.5_f64;
    let root = half.sqrt();
    let turns = [
        [1.0, 0.0, 0.0, 0.0],
        [root, 0.0, 0.0, root],
        [0.0, 0.0, 0.0, 1.0],
        [root, 0.0, 0.0, -root],
        [0.0, 1.0, 0.0, 0.0],
        [half, half, half, half],
        [half, -half, -half, half],
        [half, half, -half, -half],
    ];
    let mut all = vec![bound.default_state()];
    let mut vary = |places: &[usize], values: &[Vec<f64>]| {
        if all.len() * values.len() > MAX_COMPARED {
            return;
        }
        let varied = |start: &Vec<f64>, value: &Vec<f64>| {
            let mut start = start.clone();
            for (place, value) in places.iter().zip(value) {
                start[*place] = *value;
            }
            start
        };
        all = all
            .iter()
            .flat_map(|start| values.iter().map(move |value| varied(start, value)))
            .collect();
    };
    for angle in &bound.model.angles {
        vary(
            &[*angle],
            &[0.0, 1.0, -1.0, 2.0].map(|k| vec![k * FRAC_PI_2]),
        );
    }
    for quaternion in &bound.model.quaternions {
        vary(quaternion, &turns.map(|turn| turn.to_vec()));
    }
    all
}

/// Searches for a state with the motion `wanted` by the damped Gauss–Newton method.
fn descend(bound: &BoundMotion<'_>, wanted: &Motion, start: Vec<f64>) -> Option<Vec<f64>> {
    let free: Vec<usize> = (0..start.len())
        .filter(|state| !bound.model.added.contains(state))
        .collect();
    let at = |state: &[f64]| DVector::from_vec(bound.differences(state, wanted));
    let mut state = start;
    let mut differences = at(&state);
    let mut damping = 1e-3;
    for _ in 0..MAX_STEPS {
        let before = differences.norm();
        if !before.is_finite() {
            return None;
        }
        if before < 1e-14 {
            break;
        }
        let mut jacobian = DMatrix::zeros(differences.len(), free.len());
        for (column, place) in free.iter().enumerate() {
            let ahead = with_offset(&mut state, *place, DIFFERENCE_STEP, at);
            let behind = with_offset(&mut state, *place, -DIFFERENCE_STEP, at);
            jacobian.set_column(column, &((ahead - behind) / (2.0 * DIFFERENCE_STEP)));
        }
        let normal = jacobian.tr_mul(&jacobian);
        let gradient = jacobian.tr_mul(&differences);
        let greatest = normal.diagonal().max();
        let mut gained = false;
        while damping < 1e9 {
            let mut damped = normal.clone();
            for i in 0..free.len() {
                // The motion may not depend on a state at all, as on the length of a quaternion.
                damped[(i, i)] += damping * normal[(i, i)].max(LEAST_WEIGHT * greatest);
            }
            let Some(factor) = damped.cholesky() else {
                damping = damping.max(1e-12) * 10.0;
                continue;
            };
            let step = factor.solve(&gradient);
            let mut candidate = state.clone();
            for (place, step) in free.iter().zip(step.iter()) {
                candidate[*place] -= step;
            }
            let there = at(&candidate);
            if there.norm() < before {
                (state, differences) = (candidate, there);
                damping = (damping * 0.1).max(1e-15);
                gained = true;
                break;
            }
            damping *= 10.0;
        }
        if !gained {
            break;
        }
    }
    Some(state)
}

fn norm(values: &[f64]) -> f64 {
    values.iter().map(|v| v * v).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::{MAX_COMPARED, starts};
    use crate::throw::ThrownModel;

    /// Turns of all angles and of the frame would be eight times as many.
    #[test]
    fn the_turns_that_are_tried_are_bounded() {
        let body = "model spool;
param m = 0.02 kg;
frame N;
frame C = N by quaternion (q0, q1, q2, q3);
body spool {
  mass m; inertia diag(1e-6, 4e-4, 4e-4) [kg*m^2] in C; fixed in C;
  position (x, y, z) in N; velocity (vx, vy, vz) in N; angular velocity (p, q, r) in C;
}
";
        let wheel = |k: usize| {
            format!(
                "state a{k} = 0 rad;\nframe D{k} = C turned a{k} about 1;\nder(a{k}) = 1 [rad/s];\n"
            )
        };
        let text = body.to_owned() + &(0..5).map(wheel).collect::<String>();
        let model = model_spec::load::from_text("spool.hyz", &text, &[]);
        let model = model.unwrap_or_else(|error| panic!("{error}"));
        let thrown = ThrownModel::new(&model).expect("a body");
        let tried = starts(&thrown.bind(&[0.02])).len();
        assert!((1000..=MAX_COMPARED).contains(&tried), "{tried}");
    }
}
