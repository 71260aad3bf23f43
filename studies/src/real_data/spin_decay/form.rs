//! Functional forms of the torque that slows a disc's spin, and of the resulting decay.

use nalgebra::DVector;

/// Law of the torque that slows a spin. The first two unknowns of every law are the spin at release, rad/s, and the
/// fraction of the spin lost per second at release.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// Torque that does not depend on the spin or the time.
    Constant,
    /// Torque proportional to the spin.
    Linear,
    /// Torque proportional to the square of the spin.
    Quadratic,
    /// Torque proportional to a power of the spin. The exponent is the third unknown.
    Power,
    /// Torque proportional to the spin and to a factor that falls linearly with time, as a decreasing airspeed would
    /// imply. The third unknown is the fraction of the factor lost per second.
    Falling,
}

impl Form {
    /// All torque laws, in the order in which the results are tabulated.
    pub(super) const ALL: [Form; 5] = [
        Form::Constant,
        Form::Linear,
        Form::Quadratic,
        Form::Power,
        Form::Falling,
    ];

    /// Name of the torque law, as printed on the page of results.
    pub(super) fn label(self) -> &'static str {
        match self {
            Form::Constant => "constant",
            Form::Linear => "∝ spin",
            Form::Quadratic => "∝ spin²",
            Form::Power => "∝ a power of the spin",
            Form::Falling => "∝ spin, falling with time",
        }
    }

    /// Initial guess of the torque law's unknowns, given the spin at release in rad/s.
    pub(super) fn initial_guess(self, spin: f64) -> DVector<f64> {
        match self {
            Self::Power => DVector::from_vec(vec![spin, 0.04, 1.5]),
            Self::Falling => DVector::from_vec(vec![spin, 0.04, 0.05]),
            _ => DVector::from_vec(vec![spin, 0.04]),
        }
    }

    /// Spin (rad/s) at a time (s) after the release, for given unknowns of the torque law.
    pub(super) fn at(self, unknowns: &DVector<f64>, time: f64) -> f64 {
        let (spin, loss) = (unknowns[0], unknowns[1]);
        // Solution of dr/dt = −loss r (r/spin)^(power − 1).
        let by_power = |power: f64| match (power - 1.0).abs() < 1e-9 {
            true => spin * (-loss * time).exp(),
            false => {
                let base = 1.0 + (power - 1.0) * loss * time;
                spin * base.max(1e-9).powf(-1.0 / (power - 1.0))
            }
        };
        match self {
            Self::Constant => by_power(0.0),
            Self::Linear => by_power(1.0),
            Self::Quadratic => by_power(2.0),
            Self::Power => by_power(unknowns[2]),
            Self::Falling => spin * (-loss * time * (1.0 - unknowns[2] * time / 2.0)).exp(),
        }
    }
}
