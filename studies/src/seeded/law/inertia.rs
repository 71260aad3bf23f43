//! Effects on mass and inertia of a disc.

use super::Flow;
use nalgebra::{Matrix3, Vector3};
use oracle::scalar::Real;

/// Inertia tensor that the effect called `name` adds to that of the disc, in the body frame, kg·m²; 0 for an effect on
/// something else. `values` are those of the effect's coefficients.
pub(super) fn added<T: Real>(name: &str, values: &[T]) -> Matrix3<T> {
    let mut inertia = Matrix3::zeros();
    match name {
        "mass_imbalance" => {
            for (k, value) in values.iter().enumerate() {
                inertia[(k, 2)] = *value;
                inertia[(2, k)] = *value;
            }
        }
        "unequal_diametral_inertias" => {
            inertia[(0, 0)] = values[0];
            inertia[(1, 1)] = -values[0];
        }
        _ => {}
    }
    inertia
}

/// Force on a body of mass `mass` by the reaction of the added mass μ of the surrounding air, N; `force` is the sum of
/// all other forces, N.
///
/// The momentum of the air is p = μ (v·n) n with the velocity v relative to the air and the unit vector n along the
/// axis of the body. The force −dp/dt depends on the acceleration to which it contributes, so the equation is solved
/// for the component of the acceleration along n.
pub(super) fn added_mass_force<T: Real>(
    air: T,
    flow: &Flow<'_, T>,
    force: Vector3<T>,
    mass: T,
) -> Vector3<T> {
    let (normal, v) = (flow.normal(), flow.through_air());
    let normal_rate = flow.at.angular_velocity.cross(&normal);
    let (along, drift) = (v.dot(&normal), v.dot(&normal_rate));
    // m a·n = F·n − μ (a·n + v·ṅ)
    let acceleration = (force.dot(&normal) - air * drift) / (mass + air);
    -(normal * (acceleration + drift) + normal_rate * along) * air
}
