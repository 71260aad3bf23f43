//! Forces on a ball in addition to its drag.

use super::{BALL, Effect, Flow, Kind, Load, effect};
use crate::scalar::Real;
use nalgebra::Vector3;
use std::f64::consts::PI;

/// Kinematic viscosity of air at 20 °C, m²/s.
const VISCOSITY: f64 = 1.5e-5;
/// Critical Reynolds number of the drag crisis, and half-width of the transition around it (both dimensionless).
const CRISIS: (f64, f64) = (1e5, 2e4);

/// Built-in effects (optional additions to a model) that change the motion of a ball.
pub(super) const EFFECTS: &[Effect] = &[
    effect("magnus", &["C_Lw"], &BALL, Kind::Ball(Ball::Magnus)),
    effect("spin_decay", &["C_Lwt"], &BALL, Kind::Ball(Ball::SpinDecay)),
    effect(
        "drag_crisis",
        &["C_Dc"],
        &BALL,
        Kind::Ball(Ball::DragCrisis),
    ),
    effect(
        "buoyancy",
        &["displaced"],
        &BALL,
        Kind::Ball(Ball::Buoyancy),
    ),
];

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Ball {
    /// Magnus force, proportional to the cross product of the angular velocity and the velocity relative to the air.
    Magnus,
    /// Linear decrease of the Magnus force with the time since release.
    SpinDecay,
    /// Lower drag of the ball above the critical Reynolds number.
    DragCrisis,
    /// Buoyancy of the displaced air.
    Buoyancy,
}

impl Ball {
    pub fn load<T: Real>(self, values: &[T], flow: &Flow<'_, T>) -> Load<T> {
        let value = values[0];
        let [radius, rho] = ["radius", "rho"].map(|name| flow.constant(name));
        let area = T::lit(PI) * radius * radius;
        // ρ V² A / 2 · (R ω / V), perpendicular to spin and path: the vector product contains one V.
        let by_spin = flow.omega.cross(&flow.through_air()) * (rho * area * radius / T::lit(2.0));
        Load::force(match self {
            Self::Magnus => by_spin * value,
            Self::SpinDecay => by_spin * (-value * flow.time),
            Self::DragCrisis => {
                let reynolds = flow.speed() * T::lit(2.0) * radius / T::lit(VISCOSITY);
                let beyond = (reynolds - T::lit(CRISIS.0)) / T::lit(CRISIS.1);
                let turbulent = T::one() / (T::one() + (-(beyond + beyond)).exp());
                let pressure = rho * area * flow.speed() / T::lit(2.0);
                flow.through_air() * (pressure * value * turbulent)
            }
            Self::Buoyancy => {
                let volume = T::lit(4.0 / 3.0 * PI) * radius.powi(3);
                let up = value * rho * volume * flow.constant("g");
                Vector3::new(T::zero(), T::zero(), up)
            }
        })
    }
}
