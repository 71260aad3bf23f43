//! The angular momentum of a body, which moments turn slowly and what is steady in the body turns with it.

use nalgebra::{DMatrix, Matrix3, UnitQuaternion, Vector3};

/// The misfit of another convention of the readings, in squares relative to what is expected, must be smaller: by this
/// ratio, and at most this, as moments turn some bodies.
const BETTER_BY: (f64, f64) = (4.0, 0.15);

/// Rotation between two compared angular momenta, rad: enough to see a direction that turns with the body.
const COMPARED_ROTATION: f64 = 1.5;

/// Whether readings are meant otherwise than stated, by the misfits of both.
pub fn is_clearly_better(other: f64, stated: f64) -> bool {
    other < BETTER_BY.1 && BETTER_BY.0 * other < stated
}

/// Angular momenta by attitudes and their times, s, and the rotation of the body, rad.
pub fn momenta(
    poses: impl Iterator<Item = (f64, UnitQuaternion<f64>)>,
    inertia: &Matrix3<f64>,
) -> (Vec<Vector3<f64>>, f64) {
    let poses: Vec<(f64, UnitQuaternion<f64>)> = poses.collect();
    let (mut momenta, mut turned) = (Vec::new(), 0.0);
    for pair in poses.windows(2) {
        let turn = (pair[0].1.inverse() * pair[1].1).scaled_axis();
        let rate = turn / (pair[1].0 - pair[0].0);
        momenta.push(pair[0].1 * (inertia * rate));
        turned += turn.norm();
    }
    (momenta, turned)
}

/// Mean square change of a vector while the body turns by [`COMPARED_ROTATION`], relative to its mean square; flights are
/// inertial components over time, and the rotation of the body, rad.
pub fn unsteadiness(flights: impl Iterator<Item = (Vec<Vector3<f64>>, f64)>) -> Option<f64> {
    let (mut changes, mut squares) = (0.0, 0.0);
    for (vectors, turned) in flights {
        let Some(lag) = lag(vectors.len(), turned) else {
            continue;
        };
        for (before, after) in vectors.iter().zip(&vectors[lag..]) {
            changes += (after - before).norm_squared();
            squares += before.norm_squared();
        }
    }
    (squares > 0.0).then(|| changes / squares)
}

/// Number of samples between compared ones, of so many over a rotation, rad; `None` if the body turns by less.
pub fn lag(samples: usize, turned: f64) -> Option<usize> {
    let lag = (COMPARED_ROTATION * samples as f64 / turned).ceil();
    (lag >= 1.0 && lag < samples as f64).then_some(lag as usize)
}

/// Squares of what a polynomial of this degree leaves of vectors over their times, and the degrees of freedom.
pub fn beyond_polynomial(values: &[(f64, Vector3<f64>)], degree: usize) -> (f64, f64) {
    let terms = degree + 1;
    if values.len() <= 2 * terms {
        return (0.0, 0.0);
    }
    let [first, last] = [values[0].0, values[values.len() - 1].0];
    let past = |time: f64| (2.0 * time - first - last) / (last - first);
    let powers = DMatrix::from_fn(values.len(), terms, |row, power| {
        past(values[row].0).powi(power as i32)
    });
    let measured = DMatrix::from_fn(values.len(), 3, |row, axis| values[row].1[axis]);
    let basis = powers.qr().q();
    let left = &measured - &basis * (basis.transpose() * &measured);
    (left.norm_squared(), 3.0 * (values.len() - terms) as f64)
}
