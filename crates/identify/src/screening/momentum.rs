//! The angular momentum of a body, which moments turn slowly and what is steady in the body turns with it.

use nalgebra::{Matrix3, UnitQuaternion, Vector3};

/// The misfit of another convention of the readings, in squares relative to what is expected, must be smaller: by this
/// ratio, and at most this, as moments turn some bodies.
const BETTER_BY: (f64, f64) = (4.0, 0.15);

/// Rotation between two compared angular momenta, rad: enough to see a direction that turns with the body.
const COMPARED_ROTATION: f64 = 1.5;

/// Attitude over a time, s, and rotation in it, in body components.
pub struct Turn {
    attitude: UnitQuaternion<f64>,
    rotation: Vector3<f64>,
    time: f64,
}

/// Whether readings are meant otherwise than stated, by the misfits of both.
pub fn is_clearly_better(other: f64, stated: f64) -> bool {
    other < BETTER_BY.1 && BETTER_BY.0 * other < stated
}

/// Turns between successive attitudes.
pub fn turns(poses: impl Iterator<Item = (f64, UnitQuaternion<f64>)>) -> Vec<Turn> {
    let poses: Vec<(f64, UnitQuaternion<f64>)> = poses.collect();
    let each = poses.windows(2).map(|pair| Turn {
        attitude: pair[0].1,
        rotation: (pair[0].1.inverse() * pair[1].1).scaled_axis(),
        time: pair[1].0 - pair[0].0,
    });
    each.collect()
}

/// Mean square change of the angular momentum while the body turns by [`COMPARED_ROTATION`], relative to its mean square.
pub fn unsteadiness(
    flights: impl Iterator<Item = Vec<Turn>>,
    inertia: &Matrix3<f64>,
) -> Option<f64> {
    let (mut changes, mut squares) = (0.0, 0.0);
    for turns in flights {
        let momenta = turns
            .iter()
            .map(|turn| turn.attitude * (inertia * turn.rotation / turn.time));
        let momenta: Vec<Vector3<f64>> = momenta.collect();
        let turned: f64 = turns.iter().map(|turn| turn.rotation.norm()).sum();
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
