//! Impulse of the ground on a touching disc.

use nalgebra::{Matrix3, Vector3};
use oracle::Physical;

/// Contact properties of the ground.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Surface {
    /// Coefficient of restitution: rebound speed / impact speed of the contact point, along the vertical.
    pub(crate) restitution: f64,
    /// Coefficient of Coulomb friction.
    pub(crate) friction: f64,
}

/// Mass (kg), moments of inertia (kg m²) and radius (m) of a disc.
#[derive(Clone, Copy, Debug)]
pub(super) struct Disc {
    pub(super) mass: f64,
    pub(super) axial_inertia: f64,
    pub(super) diametral_inertia: f64,
    pub(super) radius: f64,
}

impl Disc {
    /// Position of the rim's lowest point relative to the centre of mass, m, in inertial axes; zero if the disc is
    /// level.
    pub(super) fn lowest_point(&self, body: &Physical<f64>) -> Vector3<f64> {
        let normal = body.attitude.carry(Vector3::z());
        let down = -Vector3::z() + normal * normal.z;
        let length = down.norm();
        match length > 1e-9 {
            true => down * (self.radius / length),
            false => Vector3::zeros(),
        }
    }

    /// Body state after the ground's impulse on the rim's lowest point, which must be moving downwards. The contact
    /// point sticks unless that requires more friction than the surface supplies; then it slides.
    pub(super) fn after_impulse(&self, body: &Physical<f64>, surface: Surface) -> Physical<f64> {
        let arm = self.lowest_point(body);
        let velocity = body.velocity + body.angular_velocity.cross(&arm);
        let axes = body.attitude.matrix();
        let compliances = [
            1.0 / self.diametral_inertia,
            1.0 / self.diametral_inertia,
            1.0 / self.axial_inertia,
        ];
        let compliance = axes * Matrix3::from_diagonal(&compliances.into()) * axes.transpose();
        let cross = arm.cross_matrix();
        let per_impulse = Matrix3::identity() / self.mass - cross * compliance * cross;
        let up = Vector3::z();
        let wanted = up * (-surface.restitution * velocity.z) - velocity;
        let sticking = per_impulse
            .try_inverse()
            .map_or_else(Vector3::zeros, |inverse| inverse * wanted);
        let tangential = sticking - up * sticking.z;
        let impulse = if tangential.norm() <= surface.friction * sticking.z {
            sticking
        } else {
            let slip = velocity - up * velocity.z;
            let against = slip.try_normalize(1e-12).unwrap_or_else(Vector3::zeros);
            let direction = up - against * surface.friction;
            let change = -(1.0 + surface.restitution) * velocity.z;
            direction * (change / (per_impulse * direction).z)
        };
        Physical {
            velocity: body.velocity + impulse / self.mass,
            angular_velocity: body.angular_velocity + compliance * arm.cross(&impulse),
            ..*body
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lowest_point_rises_as_restitution_says_and_energy_falls() {
        let disc = Disc {
            mass: 0.175,
            axial_inertia: 0.00235,
            diametral_inertia: 0.00122,
            radius: 0.135,
        };
        let tilt = nalgebra::UnitQuaternion::from_euler_angles(0.4, 0.2, 0.0);
        let body = Physical {
            attitude: oracle::Quaternion {
                w: tilt.w,
                v: tilt.imag(),
            },
            velocity: Vector3::new(6.0, 1.0, -3.0),
            angular_velocity: tilt * Vector3::new(0.0, 0.0, -50.0),
            ..Physical::rest()
        };
        let energy = |body: &Physical<f64>| {
            let spin = tilt.inverse() * body.angular_velocity;
            0.175 * body.velocity.norm_squared()
                + 0.00122 * (spin.x * spin.x + spin.y * spin.y)
                + 0.00235 * spin.z * spin.z
        };
        for friction in [0.0, 0.3, 10.0] {
            let surface = Surface {
                restitution: 0.4,
                friction,
            };
            let after = disc.after_impulse(&body, surface);
            let arm = disc.lowest_point(&body);
            let rise = |body: &Physical<f64>| (body.velocity + body.angular_velocity.cross(&arm)).z;
            assert!(
                (rise(&after) + 0.4 * rise(&body)).abs() < 1e-9,
                "{friction}"
            );
            assert!(energy(&after) < energy(&body), "{friction}");
        }
    }
}
