//! Effects on mass and inertia of a disc.

use super::{DISCS, Effect, Flow, Kind, effect};
use crate::scalar::Real;
use nalgebra::{Matrix3, Vector3};

/// Built-in effects (optional additions to a model) that change the mass and inertia of a disc.
pub(super) const EFFECTS: &[Effect] = &[
    effect(
        "added_mass",
        &["m_v"],
        &DISCS,
        Kind::Inertia(Inertia::AddedMass),
    ),
    effect(
        "mass_imbalance",
        &["I_13", "I_23"],
        &DISCS,
        Kind::Inertia(Inertia::Imbalance),
    ),
    effect(
        "unequal_diametral_inertias",
        &["dI"],
        &DISCS,
        Kind::Inertia(Inertia::UnequalDiameters),
    ),
];

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Inertia {
    /// Products of inertia I₁₃ and I₂₃ caused by an imbalance of the disc, kg·m².
    Imbalance,
    /// Unequal moments of inertia about two perpendicular diameters of the disc: one larger and one smaller by the same
    /// amount.
    UnequalDiameters,
    /// Added mass of the air for motion along the disc's axis.
    AddedMass,
}

impl Inertia {
    /// Inertia tensor that this effect (optional addition to a model) adds to that of the disc, in the body frame,
    /// kg·m²; 0 for the added mass. `values` are those of the effect's coefficients and states.
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

    /// Force on a body of mass `mass` by the reaction of the added mass μ of the surrounding air, N; `force` is the sum
    /// of all other forces, N.
    ///
    /// The momentum of the air is p = μ (v·n) n with the velocity v relative to the air and the unit vector n along the
    /// axis of the body. The force −dp/dt depends on the acceleration to which it contributes, so the equation is
    /// solved for the component of the acceleration along n.
    pub fn added_mass_force<T: Real>(
        self,
        values: &[T],
        flow: &Flow<'_, T>,
        force: Vector3<T>,
        mass: T,
    ) -> Vector3<T> {
        if self != Self::AddedMass {
            return Vector3::zeros();
        }
        let (air, normal, v) = (values[0], flow.normal(), flow.through_air());
        let normal_rate = flow.at.angular_velocity.cross(&normal);
        let (along, drift) = (v.dot(&normal), v.dot(&normal_rate));
        // m a·n = F·n − μ (a·n + v·ṅ)
        let acceleration = (force.dot(&normal) - air * drift) / (mass + air);
        -(normal * (acceleration + drift) + normal_rate * along) * air
    }
}
