//! A model's law of motion in the oracle, and the values of its coefficients.

use model_spec::model::Model;
use oracle::{Physical, Point, Reference};

/// Returns the oracle's law of motion for a built-in model. The oracle is the independent implementation of the laws of
/// motion.
///
/// # Panics
/// If the oracle has no law for the model.
pub(crate) fn reference_of(model: &Model) -> Reference {
    let bound = Reference::bind(model).expect("the model states its reference");
    bound.expect("the model has the names of its reference")
}

/// Sets those coefficients of a disc model that determine its curves of lift, drag and pitching moment over the angle
/// of attack.
pub(crate) struct CurveCoefficients {
    /// Indices of `C_L0`, `C_La`, `C_D0`, `C_Da` and `C_Ma` among the model's coefficients; `None` for each that the
    /// model does not have.
    indices: [Option<usize>; 5],
    /// Magnitude of the angle of attack (rad) below which the pitching-moment slope `C_Ma` is set to 0.
    min_alpha: f64,
}

impl CurveCoefficients {
    pub(crate) fn of(model: &Model, min_alpha: f64) -> Self {
        let index = |name| model.coefficients.iter().position(|c| c.name == name);
        Self {
            indices: ["C_L0", "C_La", "C_D0", "C_Da", "C_Ma"].map(index),
            min_alpha,
        }
    }

    /// Sets the coefficients so that the model's lift, drag and pitching-moment curves take the values `lift`, `drag`
    /// and `moment` (positive nose down) at the angle of attack `alpha` (rad). The model's moment is proportional to
    /// the angle of attack, so it is set to 0 at small angles.
    pub(crate) fn set(
        &self,
        constants: &mut Point<f64>,
        alpha: f64,
        [lift, drag, moment]: [f64; 3],
    ) {
        let slope = match alpha.abs() > self.min_alpha {
            true => moment / alpha,
            false => 0.0,
        };
        for (index, value) in self.indices.iter().zip([lift, 0.0, drag, 0.0, slope]) {
            if let Some(index) = *index {
                constants.coefficients[index] = value;
            }
        }
    }
}

/// Angle of attack (rad) of a body in air that moves with `wind` (m/s, inertial axes).
pub(crate) fn angle_of_attack(body: &Physical<f64>, wind: nalgebra::Vector3<f64>) -> f64 {
    let airspeed = body.attitude.bring_back(body.velocity - wind);
    (-airspeed.z).atan2(airspeed.x.hypot(airspeed.y))
}
