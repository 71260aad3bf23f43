//! Samples that are not of free flight: in the hand before the release, after the catch, or at rest.

use nalgebra::Vector3;

use super::track::{MIN_POINTS, Parabola, Track, parabola};
use crate::Flight;
use crate::fault::{DataFault, FaultKind};
use crate::statistics::median_of;

/// Lengths, in points, of the intervals at the ends of a flight that are examined.
const LENGTHS: [usize; 8] = [6, 9, 13, 20, 32, 52, 90, 160];
/// Forward force per mass of a push: in units of gravity, and as a part of its magnitude; aerodynamic forces in
/// moderate wind do not exceed both.
const PUSH: (f64, f64) = (1.0, 0.5);
/// Standard errors by which a force must exceed its limit.
const SIGNIFICANT: f64 = 6.0;
/// A body at rest: maximum speed, m/s, and as a part of the flight's median speed, and minimum force per mass, in units
/// of gravity, as a support carries its weight.
const AT_REST: (f64, f64, f64) = (0.5, 0.08, 0.7);

/// Maximum extent of the track of a body that does not move, in units of its noise: that of noise alone is 6 to 8, and
/// differences of samples show a third of correlated noise.
const STILL: f64 = 25.0;

/// Force per mass of a catch: in units of gravity, and of the force earlier in the flight, scaled by the square of the
/// speed.
const CATCH: (f64, f64) = (3.0, 5.0);

/// Fault of a flight that starts or ends with samples that are not of free flight.
pub fn check(track: &Track, gravity: Vector3<f64>, flight: &Flight) -> Option<DataFault> {
    let examined = Examined::new(track, gravity)?;
    let fault = |detail: &str, correction| {
        DataFault::new(flight, FaultKind::NotFreeFlight, detail, correction)
    };
    if examined.is_at_rest_throughout() {
        return Some(fault(
            "the body does not move",
            "remove the flight, or its samples before the release",
        ));
    }
    if let Some(time) = examined.held_until() {
        return Some(fault(
            &format!(
                "the body is pushed or held until t = {time:.3} s, as in the hand before the release"
            ),
            "begin the table at the release",
        ));
    }
    examined.stopped_from().map(|time| {
        fault(
            &format!("the body is stopped or at rest from t = {time:.3} s, as after a catch or on the ground"),
            "end the table before the body is touched",
        )
    })
}

struct Examined<'a> {
    track: &'a Track,
    gravity: Vector3<f64>,
    /// Median speed of the body over the time windows into which its path is divided, m/s.
    speed: f64,
}

impl<'a> Examined<'a> {
    fn new(track: &'a Track, gravity: Vector3<f64>) -> Option<Self> {
        let windows = track.windows();
        let speeds = windows.iter().map(|(_, motion)| motion.velocity.norm());
        Some(Self {
            track,
            gravity,
            speed: median_of(speeds)?,
        })
    }

    fn motion(&self, from: usize, to: usize) -> Option<Parabola> {
        parabola(&self.track.points[from..to], self.track.noise)
    }

    /// Force per mass other than gravity, m/s².
    fn force(&self, motion: &Parabola) -> Vector3<f64> {
        motion.acceleration - self.gravity
    }

    /// Component of this force along the velocity, m/s²; negative if it brakes.
    fn forward(&self, motion: &Parabola) -> f64 {
        let along = motion
            .velocity
            .try_normalize(1e-9)
            .unwrap_or_else(Vector3::zeros);
        self.force(motion).dot(&along)
    }

    fn is_rest(&self, motion: &Parabola, greatest: f64) -> bool {
        let slow = motion.velocity.norm() < AT_REST.0.min(AT_REST.1 * greatest);
        slow && self.force(motion).norm()
            > AT_REST.2 * self.gravity.norm() + SIGNIFICANT * motion.error
    }

    fn is_pushed(&self, motion: &Parabola) -> bool {
        let (forward, force) = (self.forward(motion), self.force(motion).norm());
        let least = (PUSH.0 * self.gravity.norm()).max(PUSH.1 * force);
        // If the displacement is below the noise, the velocity has no meaningful direction.
        let moved = motion.velocity.norm() * motion.half > 3.0 * self.track.noise;
        moved && forward > least + SIGNIFICANT * motion.error
    }

    fn is_at_rest_throughout(&self) -> bool {
        let Some(motion) = self.motion(0, self.track.points.len()) else {
            return false;
        };
        let g = self.gravity.norm();
        let fall = 0.5 * g * (2.0 * motion.half).powi(2);
        // The flight must be so long that an error of the acceleration cannot hide a fall.
        self.is_rest(&motion, f64::INFINITY)
            && self.track.extent() <= STILL * self.track.noise
            && fall > 20.0 * motion.deviation
            && self.speed < AT_REST.0
    }

    fn lengths(&self) -> impl Iterator<Item = usize> {
        let half = self.track.points.len() / 2;
        LENGTHS
            .into_iter()
            .take_while(move |length| *length <= half)
    }

    /// Time until which the body is held or pushed at the start, s.
    fn held_until(&self) -> Option<f64> {
        let count = self.track.points.len();
        // Forward forces in the second half come from the body itself or a strong wind, not from a hand.
        let rest = self.motion(count / 2, count)?;
        if self.forward(&rest) > 0.3 * self.gravity.norm() + SIGNIFICANT * rest.error {
            return None;
        }
        let mut until = None;
        for length in self.lengths() {
            let Some(motion) = self.motion(0, length) else {
                continue;
            };
            if self.is_pushed(&motion) || self.is_rest(&motion, self.speed) {
                until = Some(self.track.points[length - 1].time);
            }
        }
        until
    }

    /// Time from which the body is caught or at rest, s.
    fn stopped_from(&self) -> Option<f64> {
        let count = self.track.points.len();
        let mut from = None;
        for length in self.lengths() {
            let Some(motion) = self.motion(count - length, count) else {
                continue;
            };
            if self.is_rest(&motion, self.speed) || self.is_caught(&motion, count - length) {
                from = Some(self.track.points[count - length].time);
            }
        }
        from
    }

    /// Whether the body is braked from point `first` to the end as in a [`CATCH`]; `motion` is that of these points.
    fn is_caught(&self, motion: &Parabola, first: usize) -> bool {
        let g = self.gravity.norm();
        let force = self.force(motion).norm();
        if force < CATCH.0 * g + SIGNIFICANT * motion.error || self.forward(motion) > -0.5 * force {
            return false;
        }
        let before = motion.velocity - motion.acceleration * motion.half;
        let length = self.track.points.len() - first;
        let mut usual: f64 = 0.0;
        let mut end = first;
        while end >= length.max(MIN_POINTS) {
            if let Some(earlier) = self.motion(end - length.max(MIN_POINTS), end) {
                let ratio = (before.norm() / earlier.velocity.norm().max(0.1)).powi(2);
                usual = usual.max(self.force(&earlier).norm() * ratio.max(0.2));
            }
            end -= length.max(MIN_POINTS);
        }
        usual > 0.0 && force > CATCH.1 * usual
    }
}
