//! Random throws for the experimental design.

use flight::throw::{Motion, RPM, Throw};
use identify::RigidMotion;
use nalgebra::{Rotation3, UnitQuaternion};
use rand::{Rng, RngExt};

use crate::context::ThrowRanges;

/// Draws a random throw, its launch conditions uniformly distributed within the ranges.
pub(super) fn draw(ranges: &ThrowRanges, random: &mut impl Rng) -> Throw {
    let mut uniform = |(low, high): (f64, f64)| low + (high - low) * random.random::<f64>();
    let headings = ranges.headings as f64;
    Throw {
        speed: uniform(ranges.speed),
        launch: uniform(ranges.launch).to_degrees(),
        nose: Some(uniform(ranges.nose).to_degrees()),
        hyzer: Some(uniform(ranges.hyzer).to_degrees()),
        heading: uniform((0.0, headings)).floor() / headings * 360.0,
        spin: Some(uniform(ranges.spin) / RPM * if uniform((0.0, 1.0)) < 0.5 { 1.0 } else { -1.0 }),
        height: ranges.height,
        wobble: None,
    }
}

/// Position, velocity, attitude and angular velocity of the body at release. Attitude and angular velocity are `None`
/// if `has_attitude` is false (a body modelled as a point mass).
pub(super) fn rigid_motion(throw: &Throw, has_attitude: bool) -> RigidMotion {
    let Motion {
        position,
        velocity,
        turning,
    } = throw.motion([0.0; 2], has_attitude);
    let attitude = turning.as_ref().map(|turning| {
        let rotation = Rotation3::from_matrix_unchecked(turning.axes);
        UnitQuaternion::from_rotation_matrix(&rotation)
    });
    RigidMotion {
        position,
        velocity,
        attitude,
        rates: turning.map(|turning| turning.rates),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::SeedableRng;
    use rand_chacha::ChaCha12Rng;

    #[test]
    fn throws_lie_within_their_ranges_and_have_their_angles() {
        let ranges = ThrowRanges::default();
        let mut random = ChaCha12Rng::seed_from_u64(1);
        for _ in 0..100 {
            let throw = draw(&ranges, &mut random);
            let within = |value: f64, (low, high): (f64, f64)| (low..=high).contains(&value);
            let (nose, spin) = (throw.nose.unwrap().to_radians(), throw.spin.unwrap() * RPM);
            assert!(within(throw.speed, ranges.speed) && within(nose, ranges.nose));
            assert!(within(spin.abs(), ranges.spin), "{throw:?}");
            let motion = rigid_motion(&throw, true);
            let velocity = motion.velocity;
            assert!((velocity.norm() - throw.speed).abs() < 1e-9);
            assert!((velocity.z - throw.speed * throw.launch.to_radians().sin()).abs() < 1e-9);
            // The angle of attack is the angle of the velocity in the body frame.
            let attitude = motion.attitude.unwrap();
            let in_body = attitude.inverse() * velocity;
            let attack = (-in_body.z).atan2(in_body.x);
            assert!((attack - nose).abs() < 1e-9, "{attack} {throw:?}");
            // The left edge is the lower one where the hyzer angle is positive.
            let left = attitude * nalgebra::Vector3::y();
            assert!(left.z * throw.hyzer.unwrap() <= 0.0, "{left} {throw:?}");
            // Clockwise as seen from above is a rotation about the downward direction.
            let upwards = motion
                .rates
                .unwrap()
                .dot(&(attitude * nalgebra::Vector3::z()));
            assert!((upwards + spin).abs() < 1e-9, "{upwards} {throw:?}");
        }
    }
}
