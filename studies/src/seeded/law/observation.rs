//! Effects on the observation: marker positions on the body, sampling times, axes and scale of the measurement.

use nalgebra::Vector3;
use oracle::Physical;
use oracle::Quaternion;
use oracle::scalar::Real;

/// Vector from the measured position `marker` of a marker on the body to its true position by the effect called `name`,
/// in the body frame, m. `which` has a 1 at the index of the observed marker.
pub(super) fn displacement<T: Real>(
    name: &str,
    values: &[T],
    marker: Vector3<T>,
    which: Vector3<T>,
) -> Vector3<T> {
    let zero = T::zero();
    let misplaced = |k: usize| Vector3::new(values[0], values[1], values[2]) * which[k];
    match name {
        "marker_1_misplaced" => misplaced(0),
        "marker_2_misplaced" => misplaced(1),
        "marker_3_misplaced" => misplaced(2),
        "marker_height" => Vector3::new(zero, zero, values[0]),
        "marker_radius" => Vector3::new(marker.x, marker.y, zero) * values[0],
        _ => Vector3::zeros(),
    }
}

/// Displacement of a marker by the motion of the body during the `delays` (s) with which the second and the third marker
/// are sampled after the first, m. `arm` points from the mass centre to the marker; vectors are in inertial components. `which`
/// has a 1 at the index of the observed marker.
pub(super) fn motion_until_sampled<T: Real>(
    delays: [T; 2],
    at: &Physical<T>,
    arm: Vector3<T>,
    which: Vector3<T>,
) -> Vector3<T> {
    let later = delays[0] * which.y + delays[1] * which.z;
    let omega = at.angular_velocity;
    // Second-order term of the rotation: ω (ω·r) − r ω².
    let centripetal = omega * omega.dot(&arm) - arm * omega.dot(&omega);
    (at.velocity + omega.cross(&arm)) * later + centripetal * (later * later / T::lit(2.0))
}

/// Position that a measurement with the effect called `name` reports for a marker at the true position `position`, m,
/// in inertial components. A tilt rotates the axes of the measurement about x, then about the rotated y axis.
pub(super) fn reported<T: Real>(name: &str, values: &[T], position: Vector3<T>) -> Vector3<T> {
    match name {
        "tilted_vertical" => {
            let axes = Quaternion::turn(1, values[0]).times(Quaternion::turn(2, values[1]));
            axes.bring_back(position)
        }
        "scale" => position + position * values[0],
        _ => position,
    }
}
