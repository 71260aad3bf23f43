//! Reference implementations of the built-in effects: the change that each effect makes to a reference law, formulated
//! in vectors from the physics.
//!
//! The texts in `model-spec/effects` are checked against these implementations, which do not read them. Names,
//! coefficients and the fixed constants of an effect's form (stall angle, height of the ground effect) are the same in
//! both.
//!
//! A new effect is a row of `EFFECTS` and a variant with its law in the file of its kind; a new kind is a file, listed
//! in `Kind` and in `KINDS`.

mod air;
mod ball;
mod clock;
mod drag;
mod extended_law;
mod extended_reference;
mod flow;
mod inertia;
mod lift;
mod observation;
mod pitch;
mod roll;
mod side;
mod spin;

pub use extended_law::{ActiveEffect, ExtendedLaw};
pub use extended_reference::ExtendedReference;
pub use flow::Flow;

use crate::physical::Load;
use crate::reference::Law;

/// Built-in effects (optional additions to a model), one slice per kind of quantity that they change, such as drag or
/// lift.
static KINDS: [&[Effect]; 11] = [
    drag::EFFECTS,
    pitch::EFFECTS,
    roll::EFFECTS,
    spin::EFFECTS,
    side::EFFECTS,
    lift::EFFECTS,
    air::EFFECTS,
    inertia::EFFECTS,
    observation::EFFECTS,
    ball::EFFECTS,
    clock::EFFECTS,
];

/// A built-in effect (an optional addition to a model) with its reference implementation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effect {
    /// Name of the effect (optional addition to a model) in the model language.
    pub name: &'static str,
    /// Names of the coefficients of the effect (optional addition to a model). The effect is absent if all its
    /// coefficients and states are 0.
    pub coefficients: &'static [&'static str],
    /// Names of the states that the effect (optional addition to a model) adds. They are constant during a flight and
    /// estimated for each flight. The effect is absent if all its coefficients and states are 0.
    pub states: &'static [&'static str],
    /// Reference laws (independent implementations of laws of motion) to which the effect (optional addition to a
    /// model) can be applied.
    pub laws: &'static [Law],
    kind: Kind,
}

/// Kind of quantity, such as drag or lift, that an effect (optional addition to a model) changes. The inner value
/// selects the formula of the change.
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
    Observation(observation::Observation),
    Clock,
}

const DISC: [Law; 1] = [Law::Disc];
const DISCS: [Law; 2] = [Law::Disc, Law::Discus];
const BALL: [Law; 1] = [Law::Ball];
const ANY: [Law; 3] = [Law::Disc, Law::Discus, Law::Ball];

const fn effect(
    name: &'static str,
    coefficients: &'static [&'static str],
    laws: &'static [Law],
    kind: Kind,
) -> Effect {
    Effect {
        name,
        coefficients,
        states: &[],
        laws,
        kind,
    }
}

impl Effect {
    /// Number of values of the effect (optional addition to a model): coefficients plus states.
    pub fn values(&self) -> usize {
        self.coefficients.len() + self.states.len()
    }
}

/// All built-in effects (optional additions to a model) that have a reference implementation.
pub fn all() -> impl Iterator<Item = &'static Effect> + Clone {
    KINDS.iter().copied().flatten()
}

/// Built-in effect (optional addition to a model) with the given name; `None` if there is none.
pub fn by_name(name: &str) -> Option<&'static Effect> {
    all().find(|effect| effect.name == name)
}
