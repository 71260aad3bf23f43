//! Equations of motion of a rigid body under given loads, for scalars of any field.

use crate::dynamics::{newton_euler, state_derivatives};
use crate::error::Unsupported;
use crate::frames::place_frames;
use crate::physical::MassProperties;
use crate::point::Point;
use crate::scalar::Field;
use model_spec::model::{Body, Expr, ExprKind, Model};
use nalgebra::{Matrix3, Vector3};

/// Computes the derivative of every state under a given force (N) and moment (N·m) in inertial components. `sin_cos`
/// returns the sine and cosine of the state with a given index.
///
/// # Errors
/// [`Unsupported::StatedEquations`] if the model has no body, [`Unsupported::IrrationalMass`] if mass or inertia
/// depends on more than sums, products, quotients and integer powers of constants, and the errors of
/// [`derivatives`](crate::derivatives).
pub fn free_load_derivatives<T: Field>(
    model: &Model,
    point: &Point<T>,
    sin_cos: impl Fn(usize) -> (T, T),
    force: Vector3<T>,
    moment: Vector3<T>,
) -> Result<Vec<T>, Unsupported> {
    let body = model.body.as_ref().ok_or(Unsupported::StatedEquations)?;
    let frames = place_frames(model, &point.states, sin_cos);
    let properties = mass_properties(model, body, point).ok_or(Unsupported::IrrationalMass)?;
    let motion = newton_euler(body, &frames, &properties, force, moment);
    state_derivatives(model, body, &point.states, &frames, &motion)
}

fn mass_properties<T: Field>(
    model: &Model,
    body: &Body,
    point: &Point<T>,
) -> Option<MassProperties<T>> {
    let inertia = match &body.rotation {
        None => None,
        Some(rotation) => {
            let mut matrix = Matrix3::zeros();
            for (row, expressions) in rotation.inertia.iter().enumerate() {
                for (column, e) in expressions.iter().enumerate() {
                    matrix[(row, column)] = rational(model, e, point)?;
                }
            }
            Some(matrix)
        }
    };
    Some(MassProperties {
        mass: rational(model, &body.mass, point)?,
        inertia,
    })
}

/// Value at a point of an expression that is a rational function of the model's constants; `None` for any other
/// expression.
fn rational<T: Field>(model: &Model, e: &Expr, point: &Point<T>) -> Option<T> {
    let part = |e: &Expr| rational(model, e, point);
    Some(match &e.kind {
        ExprKind::Number { value, exact } => T::literal(*value, *exact)?,
        ExprKind::Param(i) => point.params[*i],
        ExprKind::Coefficient(i) => point.coefficients[*i],
        ExprKind::AuxVariable(i) => part(&model.aux_variables[*i].value)?,
        ExprKind::Neg(a) => -part(a)?,
        ExprKind::Add(a, b) => part(a)? + part(b)?,
        ExprKind::Sub(a, b) => part(a)? - part(b)?,
        ExprKind::Mul(a, b) => part(a)? * part(b)?,
        ExprKind::Div(a, b) => part(a)? / part(b)?,
        ExprKind::Pow(a, doubled) if doubled % 2 == 0 => {
            let a = part(a)?;
            let power = (0..doubled.unsigned_abs() / 2).fold(T::one(), |product, _| product * a);
            if *doubled < 0 {
                T::one() / power
            } else {
                power
            }
        }
        _ => return None,
    })
}
