//! Charts of the reference laws, by the state names that the model contract fixes.

use crate::chart::{Attitude, Chart, Turn, defaults};
use crate::error::BindError;
use model_spec::model::Model;

fn states<const N: usize>(
    model: &Model,
    names: [&'static str; N],
) -> Result<[usize; N], BindError> {
    let mut indices = [0; N];
    for (index, name) in indices.iter_mut().zip(names) {
        *index = model
            .states
            .iter()
            .position(|s| s.name == name)
            .ok_or(BindError::MissingState { name })?;
    }
    Ok(indices)
}

/// Coordinate chart of a body with attitude. The attitude is a quaternion if the model has a state `q0`. Otherwise it
/// consists of the angles phi, theta and gamma about the axes 1, 2 and 3, with the rates phidot, thetadot and gammadot;
/// the velocity components u, v and w are in the frame after the first two rotations.
pub(super) fn with_attitude(model: &Model) -> Result<Chart, BindError> {
    if model.states.iter().any(|s| s.name == "q0") {
        return quaternion(model);
    }
    let [phi, theta, gamma] = states(model, ["phi", "theta", "gamma"])?;
    let [phidot, thetadot, gammadot] = states(model, ["phidot", "thetadot", "gammadot"])?;
    let turn = |axis, angle, rate| Turn { axis, angle, rate };
    Ok(Chart {
        velocity_after: 2,
        attitude: Attitude::Turns([
            turn(1, phi, phidot),
            turn(2, theta, thetadot),
            turn(3, gamma, gammadot),
        ]),
        ..in_inertial_axes(model, ["u", "v", "w"])?
    })
}

/// Coordinate chart of a body with the attitude quaternion q0, q1, q2, q3. The velocity vx, vy, vz is in inertial
/// components, the angular velocity p, q, r in components of the body frame.
fn quaternion(model: &Model) -> Result<Chart, BindError> {
    Ok(Chart {
        attitude: Attitude::Quaternion(
            states(model, ["q0", "q1", "q2", "q3"])?,
            (states(model, ["p", "q", "r"])?, 1),
        ),
        ..point_mass(model)?
    })
}

/// Coordinate chart of a point mass: the states x, y, z and vx, vy, vz, in inertial components.
pub(super) fn point_mass(model: &Model) -> Result<Chart, BindError> {
    in_inertial_axes(model, ["vx", "vy", "vz"])
}

fn in_inertial_axes(model: &Model, velocity: [&'static str; 3]) -> Result<Chart, BindError> {
    Ok(Chart {
        defaults: defaults(model),
        position: states(model, ["x", "y", "z"])?,
        velocity: states(model, velocity)?,
        velocity_after: 0,
        attitude: Attitude::Point,
    })
}
