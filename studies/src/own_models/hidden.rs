//! An effect that is added to simulated flights without the knowledge of the diagnosed model.

use nalgebra::Vector3;

/// Time, position and motion of a simulated body (inertial axes, SI), from which the change of its motion or
/// measurement by a hidden effect (absent from the diagnosed model) is computed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scene {
    pub(super) time: f64,
    pub(super) position: Vector3<f64>,
    pub(super) velocity: Vector3<f64>,
    /// Columns: the body axes as unit vectors in inertial axes; the identity for a point mass.
    pub(super) axes: nalgebra::Matrix3<f64>,
    pub(super) angular_velocity: Vector3<f64>,
}

/// Term that is added to the time derivative of a state, in the state's unit per second. The arguments are the time (s)
/// and a function that returns the value of a state by its name.
type AddedRate = fn(f64, &dyn Fn(&str) -> f64) -> f64;

/// How a physical effect that is absent from the diagnosed model changes the simulated motion or measurement, for an
/// effect of size 1.
#[derive(Clone, Copy, Debug)]
pub(super) enum Action {
    /// Additional acceleration of the centre of mass, m/s², inertial axes.
    Force(fn(&Scene) -> Vector3<f64>),
    /// Additional angular acceleration, rad/s², inertial axes.
    Moment(fn(&Scene) -> Vector3<f64>),
    /// Velocity that is added to the velocity of the air, m/s, inertial axes.
    Wind(fn(&Scene) -> Vector3<f64>),
    /// Name of a parameter of the model, and the relative change of this parameter as a function of the time, s.
    Parameter(&'static str, fn(f64) -> f64),
    /// Name of a state, and the term that is added to the time derivative of this state.
    Rate(&'static str, AddedRate),
    /// The time stamps of the measurements run faster than true time, by a fraction equal to the size of the effect.
    Clock,
    /// Displacement (m) of a marker's measured position, as a function of the body's motion, the marker's undisplaced
    /// position (m) and the marker's index (from 0). Both vectors are in inertial axes.
    Observation(fn(&Scene, Vector3<f64>, usize) -> Vector3<f64>),
}

/// A physical effect that the study adds to simulated flights, but not to the diagnosed model. The diagnosis should
/// detect it.
#[derive(Clone, Copy, Debug)]
pub struct Hidden {
    /// Name of this physical effect, such as `"gusts"`.
    pub name: &'static str,
    /// Quantities of the model on which the diagnosis may locate this effect: naming any of them counts as correct.
    /// Names as in the diagnosis report, such as "drag".
    pub sites: &'static [&'static str],
    /// A weak and a strong size of this physical effect. The change of the motion or the measurement is proportional to
    /// the size.
    pub sizes: [f64; 2],
    pub(super) action: Action,
}
