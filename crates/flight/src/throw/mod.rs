//! Throws: the motion of a body at release, given by speed, angles and spin, and the states of a model that have this
//! motion.
//!
//! The angles are those that launch monitors report. The velocity determines `heading` (over the ground, from +x to the
//! left) and `launch` (above the horizontal). The body axis d3 (the axis of its spin, by default the third of the
//! body-fixed frame) is initially normal to the velocity, in the vertical plane; `hyzer` rotates it about the velocity,
//! positive to the left, and `nose` then rotates it about the body's left axis, positive nose-up. Without wind, `nose` is
//! the angle of attack. A body that flies along the axis of its spin has that axis along the velocity; `nose` lifts it,
//! in the plane that `hyzer` has tilted.

mod flown;
mod gradient;
mod inverse;
mod motion;
mod near;
mod observed;

use std::f64::consts::PI;

use motion::spin_axis;
use nalgebra::{Matrix3, Rotation3, Vector3};

pub use flown::FlownThrow;
pub use motion::{BoundMotion, Motion, ThrownModel, Turning, release_axes, speed_and_spin};
pub use near::NearThrows;
pub use observed::MotionVector;

/// Angular velocity of 1 rpm, rad/s.
pub const RPM: f64 = PI / 30.0;

/// Motion of a body at release, by the quantities that launch monitors report.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Throw {
    /// Speed of the mass centre relative to the ground, m/s.
    pub speed: f64,
    /// Horizontal direction of the velocity relative to the ground, deg; measured from +x to the left (towards +y).
    pub heading: f64,
    /// Angle of the velocity above the horizontal, deg.
    pub launch: f64,
    /// Height of the mass centre at release, m.
    pub height: f64,
    /// Angle of attack over the ground, positive nose-up, deg; `None` is 0, and needed without attitude.
    pub nose: Option<f64>,
    /// Tilt about the velocity, deg, positive with the left edge, from behind, lower; `None` as for `nose`.
    pub hyzer: Option<f64>,
    /// Spin about the axis of the body, positive clockwise as seen from above, or from behind if the body flies along
    /// it, rpm; `None` as for `nose`.
    pub spin: Option<f64>,
    /// Angle between body axis and angular momentum, deg: for a body of revolution without moments, half the opening
    /// angle of the axis's cone, whose own axis is ahead at release, towards the nose. `None` as for `nose`.
    pub wobble: Option<f64>,
}

/// Name, unit, minimum and maximum value of each field of a [`Throw`], the motion of a body at release. The speed and the
/// spin of a bullet are within them: that of a rifle leaves the barrel at some 900 m/s and 300,000 rpm.
pub const FIELDS: [(&str, &str, f64, f64); 8] = [
    ("speed", "m/s", 0.0, 2000.0),
    ("heading", "deg", -360.0, 360.0),
    ("launch", "deg", -90.0, 90.0),
    ("nose", "deg", -90.0, 90.0),
    ("hyzer", "deg", -180.0, 180.0),
    ("spin", "rpm", -500_000.0, 500_000.0),
    ("height", "m", -1000.0, 10000.0),
    ("wobble", "deg", 0.0, 60.0),
];

/// Reason why no state of a model has the motion of a throw.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ThrowError {
    /// A field of the throw has a value outside its range.
    #[error("{name} is {value}; expected {expected}")]
    Range {
        /// Name of the field of the throw.
        name: &'static str,
        /// Value of the field, outside the allowed range.
        value: f64,
        /// Description of the valid values.
        expected: String,
    },
    /// An angle of attack, a hyzer angle, a spin or a wobble is specified for a body without attitude.
    #[error(
        "found {name}, but the model {model} is a point mass, which has no attitude; expected speed, heading, launch and \
         height alone"
    )]
    NoAttitude {
        /// Name of the field of the throw that is specified although the body has no attitude.
        name: &'static str,
        /// Name of the model, which describes a point mass.
        model: String,
    },
    /// The throw has a wobble other than 0, but no spin, without which the axis does not move along a cone.
    #[error(
        "found wobble without spin; expected a spin other than 0, about which the axis can turn"
    )]
    NoSpin,
    /// The model neither declares a body nor states that its equations describe one.
    #[error(
        "the model {0} has neither a body nor a claim of one, so that its states cannot be found from a throw; expected \
         [initial] with every state"
    )]
    NoBody(String),
    /// No state within the model's domain of validity has the motion of the throw.
    #[error(
        "no state of the model {0} within its limits has this motion; expected a throw that it can have, as by another \
         nose or hyzer"
    )]
    NoState(String),
}

impl ThrowError {
    /// Name of the field of the throw that causes the error; `None` if the error is not caused by a single field.
    pub fn field(&self) -> Option<&'static str> {
        match self {
            ThrowError::Range { name, .. } | ThrowError::NoAttitude { name, .. } => Some(name),
            ThrowError::NoSpin => Some("wobble"),
            ThrowError::NoBody(_) | ThrowError::NoState(_) => None,
        }
    }
}

impl Throw {
    /// Height of the mass centre at release, m, if a throw specifies none.
    pub const DEFAULT_HEIGHT: f64 = 1.0;

    /// Horizontal throw along +x at a speed (m/s), from the default height, without a stated attitude or spin.
    pub fn at_speed(speed: f64) -> Throw {
        Throw {
            speed,
            heading: 0.0,
            launch: 0.0,
            height: Self::DEFAULT_HEIGHT,
            nose: None,
            hyzer: None,
            spin: None,
            wobble: None,
        }
    }

    /// Value of the field of this name, in the unit of [`FIELDS`]; `None` if it is not stated or the name is unknown.
    pub fn field(&self, name: &str) -> Option<f64> {
        match name {
            "speed" => Some(self.speed),
            "heading" => Some(self.heading),
            "launch" => Some(self.launch),
            "height" => Some(self.height),
            "nose" => self.nose,
            "hyzer" => self.hyzer,
            "spin" => self.spin,
            "wobble" => self.wobble,
            _ => None,
        }
    }

    /// Sets the field of this name, in the unit of [`FIELDS`]; an unknown name is ignored.
    pub fn set(&mut self, name: &str, value: f64) {
        match name {
            "speed" => self.speed = value,
            "heading" => self.heading = value,
            "launch" => self.launch = value,
            "height" => self.height = value,
            "nose" => self.nose = Some(value),
            "hyzer" => self.hyzer = Some(value),
            "spin" => self.spin = Some(value),
            "wobble" => self.wobble = Some(value),
            _ => {}
        }
    }

    /// Checks that every field is in [`FIELDS`]' range, the speed above 0, and a throw with a wobble has a spin.
    ///
    /// # Errors
    /// [`ThrowError::Range`] for the first field outside its range; [`ThrowError::NoSpin`] for a wobble without spin.
    pub fn check(&self) -> Result<(), ThrowError> {
        for (name, ..) in FIELDS {
            self.field(name)
                .map_or(Ok(()), |value| Self::check_field(name, value))?;
        }
        let wobbles = self.wobble.is_some_and(|wobble| wobble != 0.0);
        if wobbles && self.spin.unwrap_or(0.0) == 0.0 {
            return Err(ThrowError::NoSpin);
        }
        Ok(())
    }

    /// Checks that the value of one field is in its range in [`FIELDS`], and a speed above 0; ignores other names.
    ///
    /// # Errors
    /// [`ThrowError::Range`] if the value is out of range.
    #[doc(hidden)]
    pub fn check_field(field: &str, value: f64) -> Result<(), ThrowError> {
        let Some((name, unit, least, greatest)) = FIELDS.into_iter().find(|(n, ..)| *n == field)
        else {
            return Ok(());
        };
        let is_speed = name == "speed";
        if (least..=greatest).contains(&value) && !(is_speed && value <= 0.0) {
            return Ok(());
        }
        let expected = match is_speed {
            true => format!("a number above 0 and up to {greatest} {unit}"),
            false => format!("a number from {least} to {greatest} {unit}"),
        };
        Err(ThrowError::Range {
            name,
            value,
            expected,
        })
    }

    /// Motion at release, with the mass centre above `ground` (x, y), m, and without wobble: the angular velocity is
    /// along the axis of the spin. Without `has_attitude`, there is none; `is_along`, that axis points ahead.
    #[doc(hidden)]
    pub fn motion(&self, ground: [f64; 2], has_attitude: bool, is_along: bool) -> Motion {
        let axes = self.attitude().into_inner();
        Motion {
            position: Vector3::new(ground[0], ground[1], self.height),
            velocity: self.course() * Vector3::x() * self.speed,
            turning: has_attitude.then(|| Turning {
                axes,
                rates: spin_axis(&axes, is_along) * self.rotation_rate(),
                is_along,
            }),
        }
    }

    /// Component of the angular velocity along [`Turning::axis`], rad/s, of opposite sign to `spin`; 0 without a spin.
    #[doc(hidden)]
    pub fn rotation_rate(&self) -> f64 {
        -self.spin.unwrap_or(0.0) * RPM
    }

    /// Angular velocity in the inertial frame, rad/s, of a body with the body axes `axes` as columns.
    fn rates(
        &self,
        axes: &Matrix3<f64>,
        is_along: bool,
        inertia: impl FnOnce() -> Option<Matrix3<f64>>,
    ) -> Option<Vector3<f64>> {
        let (axis, spin) = (spin_axis(axes, is_along), self.rotation_rate());
        let side = axes.column(if is_along { 2 } else { 0 });
        let wobble = self.wobble.unwrap_or(0.0).to_radians();
        if wobble == 0.0 {
            return Some(axis * spin);
        }
        let cone = axis * wobble.cos() + side * wobble.sin();
        let along = inertia()?.try_inverse()? * cone;
        Some(along * (spin / along.dot(&axis)))
    }

    /// Rotation to the inertial frame from the velocity's axes: forward along it, to its left, and upwards.
    fn course(&self) -> Rotation3<f64> {
        Rotation3::from_axis_angle(&Vector3::z_axis(), self.heading.to_radians())
            * Rotation3::from_axis_angle(&Vector3::y_axis(), -self.launch.to_radians())
    }

    /// Attitude of the body: rotation to the inertial frame from the body axes forward, left and up.
    fn attitude(&self) -> Rotation3<f64> {
        let angle = |of: Option<f64>| -of.unwrap_or(0.0).to_radians();
        self.course()
            * Rotation3::from_axis_angle(&Vector3::x_axis(), angle(self.hyzer))
            * Rotation3::from_axis_angle(&Vector3::y_axis(), angle(self.nose))
    }
}

impl ThrownModel {
    /// Computes the state of the model that has the motion of a throw, with the mass centre above the point `ground`
    /// (x, y), m. The body's first axis points forward. `parameters` are in the order of the model's
    /// [`Layout`](codegen::Layout); states that the motion does not determine have their default values.
    ///
    /// # Errors
    /// [`ThrowError`] if the throw is invalid, specifies an attitude for a body without one, or is not the motion of
    /// any state.
    pub fn state(
        &self,
        throw: &Throw,
        ground: [f64; 2],
        parameters: &[f64],
    ) -> Result<Vec<f64>, ThrowError> {
        self.search(throw, ground, parameters, None)
    }

    /// As [`state`](Self::state), from `near`, the state of a similar throw: faster, and of several states with the
    /// motion the one near `near`.
    ///
    /// # Errors
    /// [`ThrowError`] as for [`state`](Self::state).
    pub fn state_near(
        &self,
        throw: &Throw,
        ground: [f64; 2],
        parameters: &[f64],
        near: &[f64],
    ) -> Result<Vec<f64>, ThrowError> {
        self.search(throw, ground, parameters, Some(near))
            .or_else(|_| self.search(throw, ground, parameters, None))
    }

    fn search(
        &self,
        throw: &Throw,
        ground: [f64; 2],
        parameters: &[f64],
        near: Option<&[f64]>,
    ) -> Result<Vec<f64>, ThrowError> {
        self.check(throw)?;
        let bound = self.bind(parameters);
        let find = |wanted: &Motion, near: Option<&[f64]>| {
            inverse::state(&bound, wanted, near).ok_or_else(|| self.no_state())
        };
        let mut wanted = throw.motion(ground, self.has_attitude(), self.is_along);
        let state = find(&wanted, near)?;
        let wobble = throw.wobble.unwrap_or(0.0);
        let Some(turning) = wanted.turning.as_mut().filter(|_| wobble != 0.0) else {
            return Ok(state);
        };
        let rates = throw.rates(&turning.axes, self.is_along, || bound.inertia(&state));
        turning.rates = rates.ok_or_else(|| self.no_state())?;
        find(&wanted, Some(&state))
    }

    /// Checks a throw, and that it specifies no attitude for a point mass.
    fn check(&self, throw: &Throw) -> Result<(), ThrowError> {
        throw.check()?;
        let mut names = ["nose", "hyzer", "spin", "wobble"].into_iter();
        match names.find(|name| !self.has_attitude() && throw.field(name).is_some()) {
            None => Ok(()),
            Some(name) => {
                let model = self.name.clone();
                Err(ThrowError::NoAttitude { name, model })
            }
        }
    }

    /// Motion of the body at a state; `parameters` are in the order of the model's [`Layout`](codegen::Layout).
    pub fn motion(&self, state: &[f64], parameters: &[f64]) -> Motion {
        self.bind(parameters).motion(state)
    }

    /// Inertia tensor about the mass centre in inertial axes at a state, kg m²; `None` for a point mass.
    pub fn inertia(&self, state: &[f64], parameters: &[f64]) -> Option<Matrix3<f64>> {
        self.bind(parameters).inertia(state)
    }

    /// State that has a given motion; the search starts at `near` if it is given.
    ///
    /// # Errors
    /// [`ThrowError::NoState`] if no state within the model's limits has the motion.
    pub fn state_of(
        &self,
        motion: &Motion,
        parameters: &[f64],
        near: Option<&[f64]>,
    ) -> Result<Vec<f64>, ThrowError> {
        inverse::state(&self.bind(parameters), motion, near).ok_or_else(|| self.no_state())
    }

    fn no_state(&self) -> ThrowError {
        ThrowError::NoState(self.name.clone())
    }

    /// Point on the ground below the mass centre at a state, (x, y), m.
    pub fn ground(&self, state: &[f64], parameters: &[f64]) -> [f64; 2] {
        let position = self.bind(parameters).motion(state).position;
        [position.x, position.y]
    }

    /// Converts a state of the model to the throw with the same motion: speed, direction, angles, spin and wobble.
    pub fn throw(&self, state: &[f64], parameters: &[f64]) -> Throw {
        let bound = self.bind(parameters);
        let Motion {
            position,
            velocity,
            turning,
        } = bound.motion(state);
        let mut throw = Throw {
            height: position.z,
            heading: velocity.y.atan2(velocity.x).to_degrees(),
            launch: velocity.z.atan2(velocity.xy().norm()).to_degrees(),
            ..Throw::at_speed(velocity.norm())
        };
        let Some(turning) = turning else {
            return throw;
        };
        let axis = turning.axis();
        let (nose, hyzer) = angles(&throw.course(), &turning);
        let spin = turning.rates.dot(&axis);
        throw.nose = Some(nose.to_degrees());
        throw.hyzer = Some(hyzer.to_degrees());
        throw.spin = Some(-spin / RPM);
        let wobble = bound.inertia(state).map(|inertia| {
            let momentum = inertia * turning.rates * spin.signum();
            momentum.cross(&axis).norm().atan2(momentum.dot(&axis))
        });
        throw.wobble = Some(wobble.filter(|_| spin != 0.0).unwrap_or(0.0).to_degrees());
        throw
    }
}

/// Angle between axis and velocity, rad, below which the plane of the two is not determined.
const ALONG: f64 = 1e-9;

/// Nose and hyzer angles of a body, rad, from its axes and those of the velocity.
fn angles(course: &Rotation3<f64>, turning: &Turning) -> (f64, f64) {
    let [ahead, up] = [0, 2].map(|k| course.inverse() * turning.axes.column(k).into_owned());
    let across = ahead.yz().norm();
    if !turning.is_along || across < ALONG {
        return ((-up.x).atan2(up.yz().norm()), up.y.atan2(up.z));
    }
    // The axis turns about itself: its plane with the velocity counts, and the smaller hyzer of the two that it has.
    let sign = if ahead.z < 0.0 { -1.0 } else { 1.0 };
    let nose = sign * across.atan2(ahead.x);
    (nose, (sign * ahead.y).atan2(sign * ahead.z))
}
