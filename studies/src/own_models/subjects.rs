//! The user models of the study, with their random throws and marker positions.

use model_spec::model::Model;
use nalgebra::{UnitQuaternion, Vector3};
use rand::{Rng, RngExt};

/// Function that draws a random value uniformly between its two arguments, the lower and the upper limit.
type Uniform<'u> = &'u mut dyn FnMut(f64, f64) -> f64;

/// A model that a user of hyzer could write, with the distribution of its simulated throws and its marker positions.
#[derive(Clone, Copy, Debug)]
pub struct Subject {
    /// Name of the user model, such as "glider".
    pub name: &'static str,
    text: &'static str,
    /// Kind of model, such as "a rigid body, quaternion", as printed on the page of results.
    pub kind: &'static str,
    /// Factor by which all coefficients of the model are multiplied in the simulation, so that the true values differ
    /// from the initial values of a fit.
    pub(crate) truth: f64,
    /// Positions of the markers in the body frame, m.
    pub(super) markers: &'static [[f64; 3]],
    /// Time span of each flight that is simulated and measured, s.
    pub(super) duration: f64,
    draw: fn(Uniform<'_>) -> Vec<(&'static str, f64)>,
}

const POINT: &[[f64; 3]] = &[[0.0, 0.0, 0.0]];
const BALL: &[[f64; 3]] = &[[0.12, 0.0, 0.0], [-0.05, 0.08, 0.0], [-0.05, -0.04, 0.07]];
const DART: &[[f64; 3]] = &[[0.05, 0.0, 0.0], [-0.06, 0.03, 0.0], [-0.06, -0.015, 0.026]];

/// The six user models on whose simulated flights the study tests the diagnosis.
pub const SUBJECTS: [Subject; 6] = [
    Subject {
        name: "shuttlecock",
        text: include_str!("../../models/shuttlecock.hyz"),
        kind: "a point",
        truth: 1.2,
        markers: POINT,
        duration: 1.0,
        draw: shuttlecock,
    },
    Subject {
        name: "spinning_ball",
        text: include_str!("../../models/spinning_ball.hyz"),
        kind: "a rigid body, three angles",
        truth: 0.85,
        markers: BALL,
        duration: 1.0,
        draw: spinning_ball,
    },
    Subject {
        name: "quaternion_dart",
        text: include_str!("../../models/quaternion_dart.hyz"),
        kind: "a rigid body, quaternion",
        truth: 1.15,
        markers: DART,
        duration: 0.8,
        draw: dart,
    },
    Subject {
        name: "pendulum",
        text: include_str!("../../models/pendulum.hyz"),
        kind: "a point on a cord",
        truth: 1.3,
        markers: POINT,
        duration: 2.0,
        draw: pendulum,
    },
    Subject {
        name: "glider",
        text: include_str!("../../models/glider.hyz"),
        kind: "stated equations",
        truth: 1.2,
        markers: POINT,
        duration: 1.5,
        draw: glider,
    },
    Subject {
        name: "kite",
        text: include_str!("../../models/kite.hyz"),
        kind: "stated equations, oscillating",
        truth: 0.9,
        markers: POINT,
        duration: 2.5,
        draw: kite,
    },
];

impl Subject {
    /// Loads the model of this subject.
    ///
    /// # Panics
    /// If the model's text has an error.
    pub fn model(&self) -> Model {
        model_spec::load::from_text(self.name, self.text, &[]).expect("a model without errors")
    }

    /// Draws the initial values of the states of a random throw, in the order of the model's states. States that are
    /// not drawn have the default value of the model.
    pub(super) fn start(&self, model: &Model, random: &mut impl Rng) -> Vec<f64> {
        let mut uniform = |low: f64, high: f64| low + (high - low) * random.random::<f64>();
        let drawn = (self.draw)(&mut uniform);
        let value = |name: &str| {
            drawn
                .iter()
                .find(|(n, _)| *n == name)
                .map(|(_, value)| *value)
        };
        let each = model.states.iter();
        each.map(|state| value(&state.name).unwrap_or(state.value))
            .collect()
    }
}

/// Draws the velocity of a throw, m/s, in inertial axes with z up. `speed` (m/s) and `launch` (angle of the velocity
/// above the horizontal, rad) are ranges (minimum, maximum). The heading lies within 0.6 rad of the x axis.
fn velocity(uniform: Uniform<'_>, speed: (f64, f64), launch: (f64, f64)) -> [f64; 3] {
    let (speed, launch) = (uniform(speed.0, speed.1), uniform(launch.0, launch.1));
    let heading = uniform(-0.6, 0.6);
    [
        speed * launch.cos() * heading.cos(),
        speed * launch.cos() * heading.sin(),
        speed * launch.sin(),
    ]
}

fn shuttlecock(uniform: Uniform<'_>) -> Vec<(&'static str, f64)> {
    let [vx, vy, vz] = velocity(uniform, (8.0, 30.0), (0.0, 0.9));
    vec![("z", 1.5), ("vx", vx), ("vy", vy), ("vz", vz)]
}

fn spinning_ball(uniform: Uniform<'_>) -> Vec<(&'static str, f64)> {
    let [vx, vy, vz] = velocity(uniform, (12.0, 25.0), (0.1, 0.7));
    let (yaw, pitch) = (uniform(-0.25, 0.25), uniform(-0.25, 0.25));
    vec![
        ("z", 1.5),
        ("vx", vx),
        ("vy", vy),
        ("vz", vz),
        ("psi", vy.atan2(vx) + yaw),
        ("theta", -vz.atan2(vx.hypot(vy)) + pitch),
        ("phi", uniform(-3.0, 3.0)),
        ("phidot", uniform(25.0, 60.0)),
        ("psidot", uniform(-0.5, 0.5)),
        ("thetadot", uniform(-0.5, 0.5)),
    ]
}

fn dart(uniform: Uniform<'_>) -> Vec<(&'static str, f64)> {
    let [vx, vy, vz] = velocity(uniform, (9.0, 17.0), (0.0, 0.5));
    let about = UnitQuaternion::from_axis_angle;
    let attitude = about(&Vector3::z_axis(), vy.atan2(vx) + uniform(-0.2, 0.2))
        * about(
            &Vector3::y_axis(),
            -vz.atan2(vx.hypot(vy)) + uniform(-0.2, 0.2),
        )
        * about(&Vector3::x_axis(), uniform(-3.0, 3.0));
    vec![
        ("z", 1.5),
        ("vx", vx),
        ("vy", vy),
        ("vz", vz),
        ("q0", attitude.w),
        ("q1", attitude.i),
        ("q2", attitude.j),
        ("q3", attitude.k),
        ("p", uniform(-15.0, 15.0)),
        ("q", uniform(-2.0, 2.0)),
        ("r", uniform(-2.0, 2.0)),
    ]
}

fn pendulum(uniform: Uniform<'_>) -> Vec<(&'static str, f64)> {
    let (tilt, heading) = (uniform(0.3, 1.1), uniform(-3.1, 3.1));
    let length = 2.5 + uniform(0.0, 0.004);
    let out = Vector3::new(
        tilt.sin() * heading.cos(),
        tilt.sin() * heading.sin(),
        -tilt.cos(),
    );
    let along = Vector3::new(-heading.sin(), heading.cos(), 0.0) * uniform(-2.5, 2.5);
    let place = out * length;
    vec![
        ("x", place.x),
        ("y", place.y),
        ("z", place.z),
        ("vx", along.x),
        ("vy", along.y),
        ("vz", along.z),
    ]
}

fn glider(uniform: Uniform<'_>) -> Vec<(&'static str, f64)> {
    vec![
        ("height", uniform(2.0, 4.0)),
        ("V", uniform(2.5, 6.0)),
        ("gamma", uniform(-0.5, 0.4)),
    ]
}

fn kite(uniform: Uniform<'_>) -> Vec<(&'static str, f64)> {
    vec![("beta", uniform(0.4, 1.1)), ("betadot", uniform(-0.3, 0.3))]
}
