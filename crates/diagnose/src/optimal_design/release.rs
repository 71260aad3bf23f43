//! Random releases for simulated throws.

use identify::RigidMotion;
use nalgebra::{UnitQuaternion, Vector3};
use rand::{Rng, RngExt};

use crate::context::ThrowRanges;

/// Launch conditions of a simulated throw: speed, angles and spin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Release {
    /// Speed of the body at release, m/s.
    pub speed: f64,
    /// Launch angle: angle of the velocity above the horizontal, rad.
    pub launch: f64,
    /// Nose angle: angle of attack at release, positive nose up, rad.
    pub nose: f64,
    /// Hyzer angle: tilt of the body about the velocity, rad; positive if the right edge, seen from behind, is the
    /// lower one.
    pub hyzer: f64,
    /// Spin rate about the axis of symmetry, rad/s; the sign is that of the rotation about the third body axis.
    pub spin: f64,
    /// Heading of the velocity in the horizontal plane, measured from the x axis towards the y axis, rad.
    pub heading: f64,
}

impl Release {
    /// Draws random launch conditions, uniformly distributed within the ranges.
    pub fn draw(ranges: &ThrowRanges, random: &mut impl Rng) -> Self {
        let mut uniform = |(low, high): (f64, f64)| low + (high - low) * random.random::<f64>();
        let headings = ranges.headings as f64;
        Self {
            speed: uniform(ranges.speed),
            launch: uniform(ranges.launch),
            nose: uniform(ranges.nose),
            hyzer: uniform(ranges.hyzer),
            heading: uniform((0.0, headings)).floor() / headings * std::f64::consts::TAU,
            spin: uniform(ranges.spin) * if uniform((0.0, 1.0)) < 0.5 { -1.0 } else { 1.0 },
        }
    }

    /// Position, velocity, attitude and angular velocity of the body when it is released at `height`, m, above the
    /// ground. Attitude and angular velocity are `None` if `has_attitude` is false (a body modelled as a point mass).
    pub fn motion(&self, height: f64, has_attitude: bool) -> RigidMotion {
        let about = UnitQuaternion::from_axis_angle;
        let path =
            about(&Vector3::z_axis(), self.heading) * about(&Vector3::y_axis(), -self.launch);
        let attitude =
            path * about(&Vector3::x_axis(), self.hyzer) * about(&Vector3::y_axis(), -self.nose);
        RigidMotion {
            position: Vector3::new(0.0, 0.0, height),
            velocity: path * Vector3::new(self.speed, 0.0, 0.0),
            attitude: has_attitude.then_some(attitude),
            rates: has_attitude.then(|| self.angular_velocity(attitude)),
        }
    }

    /// Angular velocity vector, rad/s: the spin about the third body axis, in inertial components.
    fn angular_velocity(&self, attitude: UnitQuaternion<f64>) -> Vector3<f64> {
        attitude * Vector3::new(0.0, 0.0, self.spin)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::SeedableRng;
    use rand_chacha::ChaCha12Rng;

    #[test]
    fn releases_lie_within_their_ranges_and_have_their_angles() {
        let ranges = ThrowRanges::default();
        let mut random = ChaCha12Rng::seed_from_u64(1);
        for _ in 0..100 {
            let release = Release::draw(&ranges, &mut random);
            let within = |value: f64, (low, high): (f64, f64)| (low..=high).contains(&value);
            assert!(within(release.speed, ranges.speed) && within(release.nose, ranges.nose));
            assert!(within(release.spin.abs(), ranges.spin), "{release:?}");
            let motion = release.motion(1.5, true);
            let velocity = motion.velocity;
            assert!((velocity.norm() - release.speed).abs() < 1e-9);
            assert!((velocity.z - release.speed * release.launch.sin()).abs() < 1e-9);
            // The angle of attack is the angle of the velocity in the body frame.
            let in_body = motion.attitude.unwrap().inverse() * velocity;
            let attack = (-in_body.z).atan2(in_body.x);
            assert!((attack - release.nose).abs() < 1e-9, "{attack} {release:?}");
        }
    }
}
