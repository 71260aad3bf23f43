//! Tables of the hidden effects: twenty for a point mass, twenty for a rigid body, twenty for each model of stated
//! equations.

use nalgebra::Vector3;

use super::hidden::{Action, Hidden, Scene};
use super::subjects::Subject;

/// Gravitational acceleration, m/s². The forces that the study adds to simulated flights are specified in units of the
/// body's weight.
const G: f64 = 9.81;

/// Speed at which a speed-dependent force that the study adds to simulated flights has its nominal size, m/s.
const V_0: f64 = 12.0;

const fn hide(
    name: &'static str,
    sites: &'static [&'static str],
    sizes: [f64; 2],
    action: Action,
) -> Hidden {
    Hidden {
        name,
        sites,
        sizes,
        action,
    }
}

/// Returns the twenty physical effects that the study adds, one at a time, to simulated flights of a user model. The
/// diagnosed model does not contain them.
pub fn hidden_of(subject: &Subject) -> Vec<Hidden> {
    match subject.name {
        "glider" => [MEASURED, GLIDER].concat(),
        "kite" => [MEASURED, KITE].concat(),
        "shuttlecock" | "pendulum" => [MEASURED, ANY_BODY, POINT].concat(),
        _ => [MEASURED, ANY_BODY, TURNING].concat(),
    }
}

fn along(at: &Scene) -> Vector3<f64> {
    at.velocity
        .try_normalize(1e-9)
        .unwrap_or_else(Vector3::zeros)
}

/// Horizontal unit vector to the left of the velocity; zero for a vertical velocity.
fn left(at: &Scene) -> Vector3<f64> {
    let left = Vector3::z().cross(&at.velocity);
    left.try_normalize(1e-9).unwrap_or_else(Vector3::zeros)
}

fn speed(at: &Scene) -> f64 {
    at.velocity.norm() / V_0
}

/// Upward unit vector perpendicular to the velocity, in the vertical plane of the velocity.
fn up(at: &Scene) -> Vector3<f64> {
    along(at).cross(&left(at))
}

/// Quantities of a model that are accepted as a correct diagnosis of an added force. They apply to forces that cannot
/// be attributed to one quantity alone.
const FORCES: &[&str] = &[
    "drag", "lift", "side", "wind", "gravity", "vertical", "unknown",
];
const MOMENTS: &[&str] = &["pitch", "roll", "spin", "inertia", "unknown"];

#[rustfmt::skip]
const MEASURED: &[Hidden] = &[
    hide("clock", &["clock"], [0.002, 0.02], Action::Clock),
    hide("scale", &["scale"], [0.002, 0.02], Action::Observation(|_, p, _| p)),
    hide("tilt", &["vertical", "gravity"], [0.003, 0.03], Action::Observation(|_, p, _| Vector3::new(p.z, 0.0, -p.x))),
    hide("lens", &["scale", "unknown"], [3e-5, 3e-4], Action::Observation(|_, p, _| p * p.norm_squared())),
];

#[rustfmt::skip]
const ANY_BODY: &[Hidden] = &[
    hide("wind", &["wind", "drag", "side", "lift"], [0.2, 1.5], Action::Wind(|_| Vector3::new(0.6, 0.8, 0.0))),
    hide("updraft", &["wind", "lift", "gravity", "drag", "unknown"], [0.2, 1.5], Action::Wind(|_| Vector3::z())),
    hide("gusts", &["wind", "side", "unknown"], [0.3, 2.0], Action::Wind(|at| Vector3::y() * (8.0 * at.time).sin())),
    hide("gravity", &["gravity", "clock", "vertical", "inertia"], [0.003, 0.03], Action::Force(|_| Vector3::z() * -G)),
    hide("constant_push", FORCES, [0.01, 0.1], Action::Force(|_| Vector3::y() * G)),
    hide("linear_drag", &["drag", "inertia"], [0.02, 0.2], Action::Force(|at| -along(at) * (G * speed(at)))),
    hide("cubic_drag", &["drag", "inertia"], [0.02, 0.2], Action::Force(|at| -along(at) * (G * speed(at).powi(3)))),
    hide("side_force", &["side", "lift"], [0.02, 0.4], Action::Force(|at| left(at) * (G * speed(at).powi(2)))),
    hide("lift", &["lift", "side"], [0.02, 0.3], Action::Force(|at| up(at) * (G * speed(at).powi(2)))),
    hide("late_push", FORCES, [0.04, 0.4], Action::Force(|at| Vector3::y() * (G * at.time))),
];

#[rustfmt::skip]
const POINT: &[Hidden] = &[
    hide("drag_by_height", &["drag", "wind"], [0.02, 0.2], Action::Force(|at| -along(at) * (G * speed(at).powi(2) * (at.position.z - 1.0)))),
    hide("drag_by_time", &["drag", "unknown"], [0.05, 0.5], Action::Force(|at| -along(at) * (G * speed(at).powi(2) * at.time))),
    hide("swerve", FORCES, [0.02, 0.2], Action::Force(|at| Vector3::y() * (G * at.position.x.sin()))),
    hide("turning", &["side", "lift", "unknown"], [0.01, 0.1], Action::Force(|at| Vector3::z().cross(&at.velocity))),
    hide("climb_drag", &["drag", "lift", "wind"], [0.02, 0.2], Action::Force(|at| -along(at) * (G * speed(at).powi(2) * along(at).z))),
    hide("to_the_origin", FORCES, [0.005, 0.05], Action::Force(|at| -at.position * G)),
];

#[rustfmt::skip]
const TURNING: &[Hidden] = &[
    hide("marker_off", &["marker"], [0.002, 0.01], Action::Observation(|at, _, k| match k { 0 => at.axes.column(1).into_owned(), _ => Vector3::zeros() })),
    hide("marker_late", &["marker", "clock"], [3e-4, 3e-3], Action::Observation(|at, p, k| match k { 0 => at.velocity + at.angular_velocity.cross(&(p - at.position)), _ => Vector3::zeros() })),
    hide("constant_moment", MOMENTS, [0.5, 5.0], Action::Moment(|at| at.axes.column(0).into_owned())),
    hide("spin_loss", &["spin", "roll", "pitch"], [0.02, 0.2], Action::Moment(|at| -at.axes.column(0) * at.angular_velocity.dot(&at.axes.column(0)))),
    hide("vertical_moment", MOMENTS, [0.5, 5.0], Action::Moment(|_| Vector3::z())),
    hide("moment_by_speed", MOMENTS, [0.5, 5.0], Action::Moment(|at| at.axes.column(0).cross(&left(at)) * speed(at).powi(2))),
];

/// Quantities of a model that are accepted as a correct diagnosis of a term added to one of the model's differential
/// equations: the equation itself, or a quantity that enters it.
const RATES: &[&str] = &[
    "equation", "unknown", "drag", "lift", "wind", "gravity", "vertical",
];

#[rustfmt::skip]
const GLIDER: &[Hidden] = &[
    hide("head_wind", &["equation", "unknown", "wind", "clock", "scale"], [0.05, 0.5], Action::Rate("range", |_, _| -1.0)),
    hide("updraft", &["equation", "unknown", "wind"], [0.05, 0.5], Action::Rate("height", |_, _| 1.0)),
    hide("range_by_height", &["equation", "unknown", "wind"], [0.02, 0.2], Action::Rate("range", |_, of| of("height"))),
    hide("thrust", RATES, [0.03, 0.5], Action::Rate("V", |_, _| 1.0)),
    hide("linear_drag", RATES, [0.02, 0.3], Action::Rate("V", |_, of| -of("V"))),
    hide("cubic_drag", RATES, [0.001, 0.01], Action::Rate("V", |_, of| -of("V").powi(3))),
    hide("fading_thrust", RATES, [0.1, 1.0], Action::Rate("V", |t, _| (-2.0 * t).exp())),
    hide("pulsing_thrust", RATES, [0.1, 1.0], Action::Rate("V", |t, _| (6.0 * t).sin())),
    hide("drag_by_height", RATES, [0.005, 0.05], Action::Rate("V", |_, of| -of("V").powi(2) * (of("height") - 2.0))),
    hide("pull_up", RATES, [0.03, 0.3], Action::Rate("gamma", |_, _| 1.0)),
    hide("stability", RATES, [0.1, 1.0], Action::Rate("gamma", |_, of| -of("gamma"))),
    hide("flutter", RATES, [0.1, 1.0], Action::Rate("gamma", |t, _| (7.0 * t).sin())),
    hide("lift_by_speed", RATES, [0.005, 0.05], Action::Rate("gamma", |_, of| of("V").powi(2))),
    hide("lift_by_time", RATES, [0.1, 1.0], Action::Rate("gamma", |t, _| t)),
    hide("gravity", &["equation", "unknown", "gravity", "clock", "scale", "vertical"], [0.005, 0.05], Action::Parameter("g", |_| 1.0)),
    hide("thinning_air", RATES, [0.05, 0.5], Action::Parameter("rho", |t| -t)),
];

#[rustfmt::skip]
const KITE: &[Hidden] = &[
    hide("pull", RATES, [0.02, 0.2], Action::Rate("betadot", |_, _| 1.0)),
    hide("damping", RATES, [0.05, 0.5], Action::Rate("betadot", |_, of| -of("betadot"))),
    hide("quadratic_damping", RATES, [0.3, 3.0], Action::Rate("betadot", |_, of| -of("betadot") * of("betadot").abs())),
    hide("restoring", RATES, [0.05, 0.5], Action::Rate("betadot", |_, of| -of("beta"))),
    hide("double_angle", RATES, [0.05, 0.5], Action::Rate("betadot", |_, of| (2.0 * of("beta")).sin())),
    hide("shaking", RATES, [0.05, 0.5], Action::Rate("betadot", |t, _| (5.0 * t).sin())),
    hide("growing_pull", RATES, [0.02, 0.2], Action::Rate("betadot", |t, _| t)),
    hide("fading_pull", RATES, [0.1, 1.0], Action::Rate("betadot", |t, _| (-2.0 * t).exp())),
    hide("slipping", RATES, [0.005, 0.05], Action::Rate("beta", |_, _| 1.0)),
    hide("creeping", RATES, [0.005, 0.05], Action::Rate("beta", |_, of| of("beta"))),
    hide("gusts", RATES, [0.02, 0.2], Action::Parameter("W", |t| (4.0 * t).sin())),
    hide("rising_wind", RATES, [0.02, 0.2], Action::Parameter("W", |t| t)),
    hide("wind", RATES, [0.02, 0.2], Action::Parameter("W", |_| 1.0)),
    hide("gravity", &["equation", "unknown", "gravity", "clock"], [0.02, 0.2], Action::Parameter("g", |_| 1.0)),
    hide("heavy", &["equation", "unknown", "inertia", "gravity"], [0.02, 0.2], Action::Parameter("m", |_| 1.0)),
    hide("long_line", &["equation", "unknown", "scale", "clock"], [0.005, 0.05], Action::Parameter("l", |_| 1.0)),
];

#[cfg(test)]
mod tests {
    use super::super::subjects::SUBJECTS;
    use super::*;

    #[test]
    fn each_model_has_twenty_effects_of_different_names() {
        for subject in &SUBJECTS {
            let mut names: Vec<&str> = hidden_of(subject).iter().map(|h| h.name).collect();
            names.sort_unstable();
            names.dedup();
            assert_eq!(names.len(), 20, "{}", subject.name);
        }
    }
}
