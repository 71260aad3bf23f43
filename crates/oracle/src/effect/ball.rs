//! Forces on a ball beside its drag.

use super::{Load, Scene};
use crate::scalar::Real;
use nalgebra::Vector3;
use std::f64::consts::PI;

/// Kinematic viscosity of air at 20 degrees, m²/s.
const VISCOSITY: f64 = 1.5e-5;
/// The Reynolds number at which the drag falls, and within how much of it on either side.
const CRISIS: (f64, f64) = (1e5, 2e4);

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Ball {
    /// Lift by spin.
    Magnus,
    /// Lift by spin that is lost with time.
    SpinDecay,
    /// Less drag above a Reynolds number.
    DragCrisis,
    /// The weight of the air that it displaces.
    Buoyancy,
}

impl Ball {
    pub fn load<T: Real>(self, values: &[T], scene: &Scene<'_, T>) -> Load<T> {
        let value = values[0];
        let [radius, rho] = ["radius", "rho"].map(|name| scene.constant(name));
        let area = T::lit(PI) * radius * radius;
        // ρ V² A / 2 times R ω / V, across the spin and the path: one V is in the vector product.
        let by_spin = scene.omega.cross(&scene.through_air()) * (rho * area * radius / T::lit(2.0));
        Load::force(match self {
            Self::Magnus => by_spin * value,
            Self::SpinDecay => by_spin * (-value * scene.time),
            Self::DragCrisis => {
                let reynolds = scene.speed() * T::lit(2.0) * radius / T::lit(VISCOSITY);
                let beyond = (reynolds - T::lit(CRISIS.0)) / T::lit(CRISIS.1);
                let turbulent = T::one() / (T::one() + (-(beyond + beyond)).exp());
                let pressure = rho * area * scene.speed() / T::lit(2.0);
                scene.through_air() * (pressure * value * turbulent)
            }
            Self::Buoyancy => {
                let volume = T::lit(4.0 / 3.0 * PI) * radius.powi(3);
                let up = value * rho * volume * scene.constant("g");
                Vector3::new(T::zero(), T::zero(), up)
            }
        })
    }
}
