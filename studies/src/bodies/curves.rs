//! Lift, drag and pitching-moment coefficients of the built-in discs over the angle of attack, computed by the oracle.

use oracle::{Point, Tree, Value};

use super::DISCS;
use crate::error::StudyError;

/// Airspeed at which the coefficients are evaluated, m/s. The coefficients do not depend on it.
const SPEED: f64 = 20.0;

/// Lift, drag and pitching-moment coefficients of one disc over the angle of attack.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Name of the built-in model of the disc.
    pub name: &'static str,
    /// Points of the curves: pairs of an angle of attack, deg, and the coefficients `[C_L, C_D, C_M]` at that angle
    /// (C_M positive nose up).
    pub points: Vec<(f64, [f64; 3])>,
}

/// Computes the coefficients of every disc in [`super::DISCS`] at whole degrees of angle of attack, `least` to
/// `greatest` inclusive.
///
/// # Errors
/// [`StudyError`] if a model lacks a coefficient.
pub fn curves(least: i32, greatest: i32) -> Result<Vec<Curve>, StudyError> {
    let of = |name: &'static str| {
        let model = model_spec::load::load(name, &[])?;
        let index = |wanted: &str| {
            let found = model.aux_variables.iter().position(|v| v.name == wanted);
            found.ok_or_else(|| StudyError::Name {
                of: "model of a disc",
                name: wanted.to_owned(),
            })
        };
        let indices = [index("C_L")?, index("C_D")?, index("C_M")?];
        let state = |wanted: &str| model.states.iter().position(|s| s.name == wanted);
        let points = (least..=greatest).map(|degrees| {
            let alpha = f64::from(degrees).to_radians();
            let mut point = Point::defaults(&model);
            for (name, value) in [("u", alpha.cos()), ("w", -alpha.sin())] {
                if let Some(state) = state(name) {
                    point.states[state] = SPEED * value;
                }
            }
            let tree = Tree::new(&model, &point);
            let value = |index: usize| match tree.aux_variables[index] {
                Value::Scalar(value) => value,
                Value::Vector(_) => f64::NAN,
            };
            (f64::from(degrees), indices.map(value))
        });
        Ok(Curve {
            name,
            points: points.collect(),
        })
    };
    DISCS.into_iter().map(of).collect()
}
