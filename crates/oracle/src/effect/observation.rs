//! Effects on the observation: marker positions on the body, sampling times, axes and scale of the measurement.

use super::{ANY, DISCS, Effect, Kind, effect};
use crate::attitude::Quaternion;
use crate::physical::Physical;
use crate::scalar::Real;
use nalgebra::Vector3;

/// Built-in effects (optional additions to a model) that change the measured marker positions.
pub(super) const EFFECTS: &[Effect] = &[
    effect(
        "tilted_vertical",
        &["tilt_x", "tilt_y"],
        &ANY,
        Kind::Observation(Observation::Tilted),
    ),
    effect(
        "scale",
        &["scale_error"],
        &ANY,
        Kind::Observation(Observation::Scale),
    ),
    effect(
        "marker_time_offset",
        &["offset"],
        &DISCS,
        Kind::Observation(Observation::TimeOffset),
    ),
    effect(
        "marker_1_misplaced",
        &["slip_1_1", "slip_1_2", "slip_1_3"],
        &DISCS,
        Kind::Observation(Observation::Misplaced(0)),
    ),
    effect(
        "marker_2_misplaced",
        &["slip_2_1", "slip_2_2", "slip_2_3"],
        &DISCS,
        Kind::Observation(Observation::Misplaced(1)),
    ),
    effect(
        "marker_3_misplaced",
        &["slip_3_1", "slip_3_2", "slip_3_3"],
        &DISCS,
        Kind::Observation(Observation::Misplaced(2)),
    ),
    effect(
        "marker_height",
        &["mark_up"],
        &DISCS,
        Kind::Observation(Observation::Height),
    ),
    effect(
        "marker_radius",
        &["radius_error"],
        &DISCS,
        Kind::Observation(Observation::Radius),
    ),
];

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Observation {
    /// The axes of the measurement are rotated relative to the inertial frame, first about the x axis, then about the
    /// rotated y axis.
    Tilted,
    /// All measured lengths have a common relative error.
    Scale,
    /// Each marker is sampled later than the preceding one by the same delay: the second marker by one delay after the
    /// first, the third by two. The value of the effect is the delay, s.
    TimeOffset,
    /// The true position on the body of the marker with this index, from 0, differs from the measured one.
    Misplaced(usize),
    /// The measured positions of all markers on the body have a common error along the body axis, m.
    Height,
    /// The measured distances of all markers from the body axis have a common relative error.
    Radius,
}

impl Observation {
    /// Vector from the measured position `marker` of a marker on the body to its true position according to this effect
    /// (optional addition to a model), in the body frame, m. `which` has a 1 at the index of the observed marker.
    pub fn displacement<T: Real>(
        self,
        values: &[T],
        marker: Vector3<T>,
        which: Vector3<T>,
    ) -> Vector3<T> {
        let zero = T::zero();
        match self {
            Self::Misplaced(k) => Vector3::new(values[0], values[1], values[2]) * which[k],
            Self::Height => Vector3::new(zero, zero, values[0]),
            Self::Radius => Vector3::new(marker.x, marker.y, zero) * values[0],
            Self::Tilted | Self::Scale | Self::TimeOffset => Vector3::zeros(),
        }
    }

    /// Displacement of a marker by the motion of the body during the delay with which the marker is sampled, m; 0 for
    /// effects other than a delay. `arm` points from the mass centre to the marker; vectors are in inertial components.
    /// `values` are those of the effect's coefficients and states; `which` has a 1 at the index of the observed
    /// marker.
    pub fn motion_until_sampled<T: Real>(
        self,
        values: &[T],
        at: &Physical<T>,
        arm: Vector3<T>,
        which: Vector3<T>,
    ) -> Vector3<T> {
        if self != Self::TimeOffset {
            return Vector3::zeros();
        }
        let later = values[0] * (which.y + which.z + which.z);
        let omega = at.angular_velocity;
        // Second-order term of the rotation: ω (ω·r) − r ω².
        let centripetal = omega * omega.dot(&arm) - arm * omega.dot(&omega);
        (at.velocity + omega.cross(&arm)) * later + centripetal * (later * later / T::lit(2.0))
    }

    /// Converts the true position of a marker, m, in inertial components, to the position that a measurement with this
    /// effect reports. `values` are those of the effect's coefficients and states.
    pub fn reported<T: Real>(self, values: &[T], position: Vector3<T>) -> Vector3<T> {
        match self {
            Self::Tilted => {
                let axes = Quaternion::turn(1, values[0]).times(Quaternion::turn(2, values[1]));
                axes.bring_back(position)
            }
            Self::Scale => position + position * values[0],
            _ => position,
        }
    }
}
