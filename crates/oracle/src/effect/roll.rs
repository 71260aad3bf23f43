//! Moments about d1.

use super::{Load, Scene};
use crate::scalar::Real;

/// The low angles end here, degrees, within so many on either side.
const LOW: (f64, f64) = (10.0, 2.0);

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Roll {
    /// Damping of the rate about d1.
    Damping,
    /// By the angle of attack.
    ByAngle,
    /// By the spin ratio.
    BySpinRatio,
    /// By the spin ratio, at low angles of attack.
    AtLowAngle,
}

impl Roll {
    pub fn load<T: Real>(self, values: &[T], scene: &Scene<'_, T>) -> Load<T> {
        let [forward, _] = scene.forward_and_left();
        let by = match self {
            Self::Damping => scene.at.angular_velocity.dot(&forward),
            Self::ByAngle => scene.alpha(),
            Self::BySpinRatio => scene.spin_ratio(),
            Self::AtLowAngle => {
                // (1 - tanh x) / 2 is 1 / (1 + exp 2x).
                let [end, width] = [LOW.0, LOW.1].map(|degrees: f64| T::lit(degrees.to_radians()));
                let x = (scene.alpha() - end) / width;
                scene.spin_ratio() / (T::one() + (x + x).exp())
            }
        };
        Load::moment(scene.turned(values[0] * by, forward))
    }
}
