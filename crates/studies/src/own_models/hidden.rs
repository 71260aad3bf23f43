//! An effect that is hidden in the flights of a model.

use nalgebra::Vector3;

/// Where a body is, for a hidden load or wind: inertial vectors, SI.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scene {
    pub(super) time: f64,
    pub(super) position: Vector3<f64>,
    pub(super) velocity: Vector3<f64>,
    /// Axes of the body, as columns; the inertial ones for a point.
    pub(super) axes: nalgebra::Matrix3<f64>,
    pub(super) angular_velocity: Vector3<f64>,
}

/// Rate that is added to a state: a function of the time (s) and of the states by name.
type AddedRate = fn(f64, &dyn Fn(&str) -> f64) -> f64;

/// What a hidden effect of size 1 does.
#[derive(Clone, Copy, Debug)]
pub(super) enum Action {
    /// Acceleration of the mass centre, m/s².
    Force(fn(&Scene) -> Vector3<f64>),
    /// Angular acceleration, rad/s².
    Moment(fn(&Scene) -> Vector3<f64>),
    /// Velocity of the air, m/s.
    Wind(fn(&Scene) -> Vector3<f64>),
    /// Relative change of a parameter of the model, as a function of the time, s.
    Parameter(&'static str, fn(f64) -> f64),
    /// Rate that is added to a state, by the state's name.
    Rate(&'static str, AddedRate),
    /// The clock runs fast by a fraction.
    Clock,
    /// Displacement of a measured position (m) of a marker, by its index.
    Observation(fn(&Scene, Vector3<f64>, usize) -> Vector3<f64>),
}

/// An effect that is hidden in the flights of a model.
#[derive(Clone, Copy, Debug)]
pub struct Hidden {
    /// Name of the effect.
    pub name: &'static str,
    /// Sites at which it may be found, by the names of `report.json`.
    pub sites: &'static [&'static str],
    /// A weak and a strong size; the action is linear in it.
    pub sizes: [f64; 2],
    pub(super) action: Action,
}
