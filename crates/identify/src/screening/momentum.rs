//! The angular momentum of a body, which moments turn slowly and what is steady in the body turns with it.

use nalgebra::{Matrix3, UnitQuaternion};

/// The misfit of another convention of the readings, in squares relative to what is expected, must be smaller: by this
/// ratio, and at most this, as moments turn some bodies.
const BETTER_BY: (f64, f64) = (4.0, 0.15);

/// Rotation between two compared angular momenta, rad: enough to see a direction that turns with the body.
const COMPARED_ROTATION: f64 = 1.5;

/// Whether readings are meant otherwise than stated, by the misfits of both.
pub fn is_clearly_better(other: f64, stated: f64) -> bool {
    other < BETTER_BY.1 && BETTER_BY.0 * other < stated
}

/// Mean square change of the angular momentum while the body turns by [`COMPARED_ROTATION`], relative to its mean square;
/// flights are times, s, and attitudes.
pub fn unsteadiness<F>(flights: impl Iterator<Item = F>, inertia: &Matrix3<f64>) -> Option<f64>
where
    F: Iterator<Item = (f64, UnitQuaternion<f64>)>,
{
    let (mut changes, mut squares) = (0.0, 0.0);
    for poses in flights {
        let poses: Vec<(f64, UnitQuaternion<f64>)> = poses.collect();
        let (mut momenta, mut turned) = (Vec::new(), 0.0);
        for pair in poses.windows(2) {
            let turn = (pair[0].1.inverse() * pair[1].1).scaled_axis();
            let rate = turn / (pair[1].0 - pair[0].0);
            momenta.push(pair[0].1 * (inertia * rate));
            turned += turn.norm();
        }
        let lag = (COMPARED_ROTATION * momenta.len() as f64 / turned).ceil();
        if !(lag >= 1.0 && lag < momenta.len() as f64) {
            continue;
        }
        for (before, after) in momenta.iter().zip(&momenta[lag as usize..]) {
            changes += (after - before).norm_squared();
            squares += before.norm_squared();
        }
    }
    (squares > 0.0).then(|| changes / squares)
}
