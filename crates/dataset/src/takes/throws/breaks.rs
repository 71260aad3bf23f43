//! Decision whether a deviation from a followed flight ends the flight.
//!
//! A strong lift that changes with the attitude, a wobble or a fast spin deviates from a local prediction too. The
//! flight therefore ends only where the motion outside it is one that air cannot cause.

use nalgebra::{DVector, Vector3};

use super::GRAVITY;
use super::cut::{CUBIC, Fit, FlightEnd, HINGES, JUMPS};
use super::path::REACH;
use super::windows::{SLOW, allowed};

/// Standard errors by which a fitted jump or acceleration must exceed its bound, as [`TOUCH`], for the flight to end.
const CERTAIN: f64 = 4.5;
/// Minimum jump of the velocity at an impact, m/s; air changes the velocity by less within a sample or two.
const IMPACT: f64 = 1.0;
/// Minimum upward jump of the velocity at the ground, m/s; small, as a body on its edge turns more than it rises.
const TOUCH: f64 = 0.2;
/// Height above the lowest level, m, below which an upward jump of the velocity is a support by the ground.
const LOW: f64 = 0.05;
/// Minimum upward jump, m/s, that counts as support below `LOW`, to be exceeded by `LIKELY` standard errors.
const SLIGHT: f64 = 0.1;
const LIKELY: f64 = 2.0;

impl FlightEnd<'_> {
    /// Whether the flight ends here, because the body moves beyond it in a way that the air cannot cause.
    pub fn is_break(&self) -> bool {
        let Some(changed) = self.best(&HINGES) else {
            return false;
        };
        let times = &self.path.track.times;
        let outmost = times[match self.early {
            true => self.samples.start,
            false => self.samples.end - 1,
        }];
        let smooth = self.smooth();
        let smooth = smooth.filter(|smooth| smooth.criterion <= changed.criterion);
        let motion = smooth.unwrap_or(changed);
        if let Some((jump, error)) = motion.velocity_jump() {
            let bound = match !self.early && self.is_touch(&motion, jump) {
                true => TOUCH,
                false => IMPACT,
            };
            if jump.norm() > bound + CERTAIN * error {
                return true;
            }
        }
        let beyond = 0.5 * (outmost - motion.time).abs();
        let (velocity, _) = motion.derivative(self.early, beyond, 1);
        let (acceleration, error) = motion.derivative(self.early, beyond, 2);
        let air = acceleration + Vector3::z() * GRAVITY;
        let rests = velocity.norm() <= SLOW && air.norm() >= 0.5 * GRAVITY;
        rests || !allowed(velocity, air, CERTAIN * error)
    }

    fn height(&self) -> f64 {
        self.path.points[self.last].z - self.path.lowest
    }

    /// Whether the `jump` of the velocity (m/s) pushes a falling body upwards where it may touch the ground.
    fn is_touch(&self, motion: &Fit, jump: Vector3<f64>) -> bool {
        motion.coefficient(1).z < 0.0 && jump.z > 0.5 * jump.norm() && self.height() < REACH
    }

    /// Whether the ground supports a falling body here; true only near the lowest level of the trajectory. This detects
    /// slight touches in succession, each of which deviates too little from the prediction to end the flight.
    pub fn touches(&self) -> bool {
        if self.height() > LOW {
            return false;
        }
        let Some(changed) = self.best(&JUMPS) else {
            return false;
        };
        let smooth = self.smooth();
        let is_smooth = smooth.is_some_and(|smooth| smooth.criterion <= changed.criterion);
        !is_smooth
            && changed.velocity_jump().is_some_and(|(jump, error)| {
                self.is_touch(&changed, jump) && jump.z > SLIGHT + LIKELY * error
            })
    }
}

impl Fit {
    /// Jump of the velocity and its standard error on one axis, m/s; `None` without one. The velocity is the derivative
    /// by the time outwards from the flight, which at its beginning runs backwards.
    fn velocity_jump(&self) -> Option<(Vector3<f64>, f64)> {
        let error = || self.covariance[(CUBIC, CUBIC)].max(0.0).sqrt();
        (self.hinge.first() == Some(&1)).then(|| (self.coefficient(CUBIC), error()))
    }

    /// Derivative of the given `order` with respect to time, evaluated `beyond` seconds (≥ 0) before the beginning of
    /// the flight if `early`, otherwise after its end; and the standard error of one component.
    fn derivative(&self, early: bool, beyond: f64, order: i32) -> (Vector3<f64>, f64) {
        let sign: f64 = if early { -1.0 } else { 1.0 };
        let term = |power: i32, time: f64| -> f64 {
            let factors: f64 = (0..order).map(|k| f64::from(power - k)).product();
            if power < order {
                0.0
            } else {
                factors * time.powi(power - order)
            }
        };
        let own = (0..CUBIC as i32).map(|power| term(power, sign * beyond));
        // The hinge grows with the time outside the flight, which runs against `t` at the beginning of a flight.
        let hinge = self
            .hinge
            .iter()
            .map(|&power| sign.powi(order) * term(power, beyond));
        let weights = own.chain(hinge);
        self.sum(&DVector::from_iterator(CUBIC + self.hinge.len(), weights))
    }
}
