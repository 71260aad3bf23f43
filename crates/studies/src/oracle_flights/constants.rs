//! A model's law of motion in the oracle, and the values of its coefficients.

use model_spec::model::Model;
use oracle::{Physical, Point, Reference};

/// Returns the law of motion of a built-in model in the oracle, the independent implementation of the laws of motion.
///
/// # Panics
/// If the oracle has no law for the model.
pub(crate) fn reference_of(model: &Model) -> Reference {
    let bound = Reference::bind(model).expect("the model states its reference");
    bound.expect("the model has the names of its reference")
}

/// Sets the coefficient `name` in `constants` to `value` (SI); does nothing if the model has no coefficient of that
/// name.
pub(crate) fn set_coefficient(model: &Model, constants: &mut Point<f64>, name: &str, value: f64) {
    if let Some(index) = model.coefficients.iter().position(|c| c.name == name) {
        constants.coefficients[index] = value;
    }
}

/// Sets lift, drag and pitching-moment coefficients of the disc so that the model's curves take the given values at the
/// angle of attack `alpha` (rad). The model's moment is proportional to the angle, so it is set to 0 for |alpha| below
/// `min_alpha`.
pub(crate) fn set_curves(
    model: &Model,
    constants: &mut Point<f64>,
    alpha: f64,
    [lift, drag, moment]: [f64; 3],
    min_alpha: f64,
) {
    let slope = match alpha.abs() > min_alpha {
        true => moment / alpha,
        false => 0.0,
    };
    for (name, value) in [
        ("C_L0", lift),
        ("C_La", 0.0),
        ("C_D0", drag),
        ("C_Da", 0.0),
        ("C_Ma", slope),
    ] {
        set_coefficient(model, constants, name, value);
    }
}

/// Angle of attack (rad) of a body in air that moves with `wind` (m/s, inertial axes).
pub(crate) fn angle_of_attack(body: &Physical<f64>, wind: nalgebra::Vector3<f64>) -> f64 {
    let airspeed = body.attitude.bring_back(body.velocity - wind);
    (-airspeed.z).atan2(airspeed.x.hypot(airspeed.y))
}
