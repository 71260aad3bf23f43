//! Displacement of the centre of mass by aerodynamic forces that turn with a wobbling spin axis.
//!
//! The aerodynamic force on a body of revolution lies in the plane of velocity and spin axis. If the axis rotates about
//! the velocity, the force rotates with it: this part of the displacement is known. If the axis rotates towards the
//! velocity, the force changes by an amount that depends on the body's coefficients: this part is not known.

use nalgebra::{DMatrix, Vector3};

use super::smooth::Smooth;
use crate::takes::throws::GRAVITY;

/// Minimum sine of the angle between velocity and spin axis at which the displacement of the centre of mass by
/// aerodynamic forces is computed from the rotation of the spin axis about the velocity.
const MIN_SINE: f64 = 0.2;
/// Assumed standard deviation of the uncomputed part of the change of aerodynamic acceleration by the wobble of the
/// spin axis. It is a fraction of the product of lift acceleration and wobble angle (rad).
const UNKNOWN: f64 = 0.5;

/// Displacements of the centre of mass by the wobble, m: one row per sample, one column per axis.
pub(super) struct AirMotion {
    pub known: DMatrix<f64>,
    pub unknown: DMatrix<f64>,
}

/// Computes the displacements of the centre of mass by the forces that change with the wobble of the spin axis.
pub(super) fn air_motion(
    times: &[f64],
    smooth: &Smooth,
    path: &DMatrix<f64>,
    axes: &DMatrix<f64>,
) -> AirMotion {
    let [_, velocities, accelerations] = smooth.fitted(path);
    let [mean_axes, _, _] = smooth.fitted(axes);
    let row = |of: &DMatrix<f64>, i: usize| Vector3::new(of[(i, 0)], of[(i, 1)], of[(i, 2)]);
    let count = times.len();
    let [mut known, mut unknown] = [0; 2].map(|_| DMatrix::<f64>::zeros(count, 3));
    for i in 0..count {
        let mean = row(&mean_axes, i);
        let (Some(along), Some(mean)) = (
            row(&velocities, i).try_normalize(1e-6),
            mean.try_normalize(1e-6),
        ) else {
            continue;
        };
        let force = row(&accelerations, i) + Vector3::new(0.0, 0.0, GRAVITY);
        let lift = force - along * force.dot(&along);
        let wobble = row(axes, i) - row(&mean_axes, i);
        let sideways = along.cross(&mean);
        let sine = sideways.norm();
        if sine < MIN_SINE {
            unknown.set_row(i, &(wobble * lift.norm() * UNKNOWN).transpose());
            continue;
        }
        let side = sideways / sine;
        let angle = wobble.dot(&side) / sine;
        known.set_row(i, &(along.cross(&force) * angle).transpose());
        let fore = wobble - side * wobble.dot(&side);
        unknown.set_row(i, &(fore * lift.norm() * UNKNOWN).transpose());
    }
    AirMotion {
        known: twice_integrated(times, &known),
        unknown: twice_integrated(times, &unknown),
    }
}

/// Double integral over time of each column of `of` by the trapezoidal rule, after subtraction of the column's mean.
fn twice_integrated(times: &[f64], of: &DMatrix<f64>) -> DMatrix<f64> {
    let once = |of: &DMatrix<f64>| {
        let mut sums = DMatrix::<f64>::zeros(of.nrows(), of.ncols());
        for i in 1..of.nrows() {
            let step = 0.5 * (times[i] - times[i - 1]);
            let next = sums.row(i - 1) + (of.row(i) + of.row(i - 1)) * step;
            sums.set_row(i, &next);
        }
        sums
    };
    // A constant would become a parabola, whose rounding errors hide a small wobble.
    let mean = of.row_mean();
    let centred = DMatrix::from_fn(of.nrows(), of.ncols(), |i, k| of[(i, k)] - mean[k]);
    once(&once(&centred))
}
