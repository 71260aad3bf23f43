//! How the body answers: its inertia, and the air that moves with it.

use super::Scene;
use crate::scalar::Real;
use nalgebra::{Matrix3, Vector3};

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Inertia {
    /// Products of inertia.
    Imbalance,
    /// Two diameters are unlike.
    UnequalDiameters,
    /// Air that moves along the axis with the body.
    AddedMass,
}

impl Inertia {
    /// What is added to the inertia in the frame that is fixed in the body.
    pub fn added<T: Real>(self, values: &[T]) -> Matrix3<T> {
        let mut inertia = Matrix3::zeros();
        match self {
            Self::Imbalance => {
                for (k, value) in values.iter().enumerate() {
                    inertia[(k, 2)] = *value;
                    inertia[(2, k)] = *value;
                }
            }
            Self::UnequalDiameters => {
                inertia[(0, 0)] = values[0];
                inertia[(1, 1)] = -values[0];
            }
            Self::AddedMass => {}
        }
        inertia
    }

    /// The force of the air that is carried along, where everything else pulls with `force` at the mass `mass`.
    ///
    /// Its momentum is p = μ (v·n) n, and the force −dp/dt, which holds the acceleration it has itself a part in. Along n
    /// the momenta of body and air change together.
    pub fn carried<T: Real>(
        self,
        values: &[T],
        scene: &Scene<'_, T>,
        force: Vector3<T>,
        mass: T,
    ) -> Vector3<T> {
        if self != Self::AddedMass {
            return Vector3::zeros();
        }
        let (air, normal, v) = (values[0], scene.normal(), scene.through_air());
        let turning = scene.at.angular_velocity.cross(&normal);
        let (along, drift) = (v.dot(&normal), v.dot(&turning));
        // m a·n = F·n − μ (a·n + v·ṅ)
        let answer = (force.dot(&normal) - air * drift) / (mass + air);
        -(normal * (answer + drift) + turning * along) * air
    }
}
