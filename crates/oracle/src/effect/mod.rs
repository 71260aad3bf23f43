//! Effects by hand: what each changes about a reference's law, written with vectors from the physics.
//!
//! Their texts in `model-spec/effects` are held against this; nothing here reads them. Names and coefficients are the
//! same, and so are the stated constants (the angle of stall, the height of the ground effect), which belong to an
//! effect as its form does.

mod air;
mod ball;
mod bound;
mod drag;
mod inertia;
mod lift;
mod pitch;
mod roll;
mod scene;
mod seen;
mod side;
mod spin;
mod table;
mod world;

pub use bound::Bound;
pub use scene::Scene;
pub use table::ALL;
pub use world::{Acting, World};

use crate::reference::Law;
use crate::scalar::Real;
use nalgebra::Vector3;

/// An effect.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effect {
    /// Its name in the catalogue.
    pub name: &'static str,
    /// Its coefficients, all of which vanish at 0.
    pub coefficients: &'static [&'static str],
    /// What it has of its own in each flight: states that stand still, 0 where it vanishes.
    pub states: &'static [&'static str],
    /// The laws it can change.
    pub laws: &'static [Law],
    kind: Kind,
}

impl Effect {
    /// How many numbers it takes: its coefficients, then its states.
    pub fn values(&self) -> usize {
        self.coefficients.len() + self.states.len()
    }
}

/// The effect of that name.
pub fn by_name(name: &str) -> Option<&'static Effect> {
    ALL.iter().find(|effect| effect.name == name)
}

/// What an effect is about.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Lift(lift::Lift),
    Drag(drag::Drag),
    Side(side::Side),
    Roll(roll::Roll),
    Pitch(pitch::Pitch),
    Spin(spin::Spin),
    Ball(ball::Ball),
    Air(air::Air),
    Inertia(inertia::Inertia),
    Seen(seen::Seen),
    /// The clock that measures runs fast, by a part of the time.
    Clock,
}

/// A force at the mass centre and a moment about it, in inertial components.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Load<T> {
    /// Force.
    pub force: Vector3<T>,
    /// Moment.
    pub moment: Vector3<T>,
}

impl<T: Real> Load<T> {
    fn nothing() -> Self {
        Self {
            force: Vector3::zeros(),
            moment: Vector3::zeros(),
        }
    }

    fn force(force: Vector3<T>) -> Self {
        Self {
            force,
            ..Self::nothing()
        }
    }

    fn moment(moment: Vector3<T>) -> Self {
        Self {
            moment,
            ..Self::nothing()
        }
    }
}
