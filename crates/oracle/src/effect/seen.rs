//! What is made of a position on the way to the dataset: markers, their instants, the axes, lengths.

use crate::attitude::Quaternion;
use crate::physical::Physical;
use crate::scalar::Real;
use nalgebra::Vector3;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Seen {
    /// The measured axes are turned.
    Tilted,
    /// Lengths are too long.
    Scale,
    /// The markers are seen one after the other.
    TimeOffset,
    /// The marker of this number, from 0, sits elsewhere.
    Misplaced(usize),
    /// All sit higher.
    Height,
    /// All sit further out.
    Radius,
}

impl Seen {
    /// How far off the marker sits, in the frame that is fixed in the body. `which` is 1 for the one that is seen.
    pub fn slip<T: Real>(self, values: &[T], marker: Vector3<T>, which: Vector3<T>) -> Vector3<T> {
        let zero = T::zero();
        match self {
            Self::Misplaced(k) => Vector3::new(values[0], values[1], values[2]) * which[k],
            Self::Height => Vector3::new(zero, zero, values[0]),
            Self::Radius => Vector3::new(marker.x, marker.y, zero) * values[0],
            Self::Tilted | Self::Scale | Self::TimeOffset => Vector3::zeros(),
        }
    }

    /// How far the place of the marker has moved when it is seen; `arm` leads to it from the mass centre.
    pub fn moved<T: Real>(
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
        // The turn to its second power: ω (ω·r) − r ω².
        let turned = omega * omega.dot(&arm) - arm * omega.dot(&omega);
        (at.velocity + omega.cross(&arm)) * later + turned * (later * later / T::lit(2.0))
    }

    /// A place as the observer reports it.
    pub fn reported<T: Real>(self, values: &[T], place: Vector3<T>) -> Vector3<T> {
        match self {
            Self::Tilted => {
                let axes = Quaternion::turn(1, values[0]).times(Quaternion::turn(2, values[1]));
                axes.bring_back(place)
            }
            Self::Scale => place + place * values[0],
            _ => place,
        }
    }
}
