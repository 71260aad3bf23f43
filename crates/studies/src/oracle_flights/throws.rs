//! Throws of a disc, drawn from a seed.

use nalgebra::{UnitQuaternion, Vector3};
use oracle::attitude::Quaternion;
use oracle::physical::Physical;
use rand::{Rng, RngExt};

/// The range that each quantity of a throw is drawn from, evenly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Throws {
    /// Speed, m/s.
    pub speed: (f64, f64),
    /// Climb of the path at the release, rad.
    pub climb: (f64, f64),
    /// Angle between the path and the disc's plane, nose up, rad.
    pub nose: (f64, f64),
    /// Lean of the disc's plane about the path, rad.
    pub hyzer: (f64, f64),
    /// Size of the spin, rad/s; its sign is drawn too.
    pub spin: (f64, f64),
    /// Part of the throws that spin to the left (seen from above, r > 0).
    pub left: f64,
    /// Rates about the disc's diameters, rad/s.
    pub wobble: f64,
}

impl Throws {
    /// A spread such as good experimenters would throw.
    pub const SPREAD: Throws = Throws {
        speed: (9.0, 18.0),
        climb: (-0.05, 0.25),
        nose: (-0.08, 0.30),
        hyzer: (-0.4, 0.4),
        spin: (35.0, 65.0),
        left: 0.25,
        wobble: 2.0,
    };

    /// Draws one.
    pub fn draw(&self, random: &mut impl Rng) -> Physical<f64> {
        let mut even = |(low, high): (f64, f64)| low + (high - low) * random.random::<f64>();
        let speed = even(self.speed);
        let heading = even((-0.3, 0.3));
        let (climb, nose, hyzer) = (even(self.climb), even(self.nose), even(self.hyzer));
        let phase = even((-std::f64::consts::PI, std::f64::consts::PI));
        let side = if even((0.0, 1.0)) < self.left {
            1.0
        } else {
            -1.0
        };
        let spin = side * even(self.spin);
        let wobble = Vector3::new(
            even((-self.wobble, self.wobble)),
            even((-self.wobble, self.wobble)),
            0.0,
        );
        let height = even((1.0, 1.8));
        let about = UnitQuaternion::from_axis_angle;
        let path = about(&Vector3::z_axis(), heading) * about(&Vector3::y_axis(), -climb);
        let attitude = path
            * about(&Vector3::x_axis(), hyzer)
            * about(&Vector3::y_axis(), -nose)
            * about(&Vector3::z_axis(), phase);
        let rates = attitude * (wobble + Vector3::new(0.0, 0.0, spin));
        Physical {
            position: Vector3::new(0.0, 0.0, height),
            velocity: path * Vector3::new(speed, 0.0, 0.0),
            attitude: Quaternion {
                w: attitude.w,
                v: attitude.imag(),
            },
            angular_velocity: rates,
        }
    }
}
