//! Random throws of a disc, drawn from ranges of speed, angles and spin.

use nalgebra::{UnitQuaternion, Vector3};
use oracle::{Physical, Quaternion};
use rand::{Rng, RngExt};

/// Distribution of throws: each quantity is uniform over a range (minimum, maximum).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Throws {
    /// Range of the speed of the disc at release, m/s.
    pub speed: (f64, f64),
    /// Range of the launch angle (velocity above the horizontal), rad.
    pub launch: (f64, f64),
    /// Range of the angle of attack at release, positive nose up, rad.
    pub nose: (f64, f64),
    /// Range of the hyzer angle (tilt of the disc about its velocity), rad; positive if the right side is lower.
    pub hyzer: (f64, f64),
    /// Range of the magnitude of the disc's spin at release, rad/s.
    pub spin: (f64, f64),
    /// Fraction of the throws with positive spin about the disc's upward axis (counter-clockwise seen from above).
    pub counter_clockwise: f64,
    /// Maximum magnitude at release of the angular rate about each of two diameters of the disc, rad/s.
    pub wobble: f64,
}

impl Throws {
    /// Launch conditions of moderate variety, as a careful experimenter would choose.
    pub const SPREAD: Throws = Throws {
        speed: (9.0, 18.0),
        launch: (-0.05, 0.25),
        nose: (-0.08, 0.30),
        hyzer: (-0.4, 0.4),
        spin: (35.0, 65.0),
        counter_clockwise: 0.25,
        wobble: 2.0,
    };

    /// Draws a throw released 1.0 to 1.8 m above the origin. The order of the random draws must not change: it
    /// determines the flights of each seed.
    pub(crate) fn draw(&self, random: &mut impl Rng) -> Physical<f64> {
        let mut uniform = |(low, high): (f64, f64)| low + (high - low) * random.random::<f64>();
        let speed = uniform(self.speed);
        let heading = uniform((-0.3, 0.3));
        let (launch, nose, hyzer) = (
            uniform(self.launch),
            uniform(self.nose),
            uniform(self.hyzer),
        );
        let phase = uniform((-std::f64::consts::PI, std::f64::consts::PI));
        let sign = if uniform((0.0, 1.0)) < self.counter_clockwise {
            1.0
        } else {
            -1.0
        };
        let spin = sign * uniform(self.spin);
        let wobble = Vector3::new(
            uniform((-self.wobble, self.wobble)),
            uniform((-self.wobble, self.wobble)),
            0.0,
        );
        let height = uniform((1.0, 1.8));
        let about = UnitQuaternion::from_axis_angle;
        let path = about(&Vector3::z_axis(), heading) * about(&Vector3::y_axis(), -launch);
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
