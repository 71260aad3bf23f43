//! Motion of a body before its release, by a hand, and after its end, in a net.

use nalgebra::{UnitQuaternion, Vector3};
use oracle::{Physical, Quaternion};
use rand::{Rng, RngExt};

/// Motion of the hand up to the release: the body is held, then pushed along the release velocity with a sinusoidal
/// acceleration.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hand {
    release: Physical<f64>,
    /// Time for which the body is held in the hand before it is pushed, s.
    held: f64,
    /// Half period of the sinusoidal acceleration by which the hand pushes the body, s.
    half: f64,
    /// Fraction of the half period of the acceleration after which the body is released.
    part: f64,
}

/// Amplitude, m, of the sway of the body while it is held in the hand, and angular frequency of this sway, rad/s.
const SWAY: (f64, f64) = (0.003, 4.0);

impl Hand {
    /// Draws a random hand motion that ends in the state `release`.
    pub fn draw(release: Physical<f64>, random: &mut impl Rng) -> Self {
        Self {
            release,
            held: random.random_range(0.3..0.6),
            half: random.random_range(0.12..0.3),
            part: random.random_range(0.55..0.85),
        }
    }

    /// Duration of the motion from its start to the release, s.
    pub fn seconds(&self) -> f64 {
        self.held + self.push()
    }

    fn push(&self) -> f64 {
        self.part * self.half
    }

    /// State of the body at a time (s) after the start of the hand's motion. Times after the release give the state at
    /// the release.
    pub fn at(&self, time: f64) -> Physical<f64> {
        let since = (time - self.held).clamp(0.0, self.push());
        let rate = std::f64::consts::PI / self.half;
        // Displacement of the push relative to the speed at the release.
        let size = 1.0 - (std::f64::consts::PI * self.part).cos();
        let way = |t: f64| (t - (rate * t).sin() / rate) / size;
        let back = self.release.velocity * (way(since) - way(self.push()));
        let sway = match time < self.held {
            true => SWAY.0 * (SWAY.1 * (time - self.held)).sin(),
            false => 0.0,
        };
        // The spin grows linearly during the push.
        let turned = (since * since / self.push() - self.push()) / 2.0;
        Physical {
            position: self.release.position + back + Vector3::new(sway, 0.0, sway),
            attitude: rotated(&self.release, turned),
            ..self.release
        }
    }
}

/// State of a body `since` seconds after a net caught it in the state `taken`; the net stops the body with the constant
/// `deceleration` (m/s²).
pub(super) fn in_net(taken: &Physical<f64>, deceleration: f64, since: f64) -> Physical<f64> {
    let stop = taken.velocity.norm() / deceleration;
    let t = since.min(stop);
    let way = t - t * t / (2.0 * stop);
    Physical {
        position: taken.position + taken.velocity * way,
        attitude: rotated(taken, way),
        ..*taken
    }
}

/// Attitude of the body after it has rotated for `seconds` at its constant angular velocity; the angle is negative for
/// negative `seconds`.
fn rotated(body: &Physical<f64>, seconds: f64) -> Quaternion<f64> {
    let turn = UnitQuaternion::from_scaled_axis(body.angular_velocity * seconds);
    let turn = Quaternion {
        w: turn.w,
        v: turn.imag(),
    };
    turn.times(body.attitude)
}
