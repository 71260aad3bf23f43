//! The effects of the catalogue, written by hand: the change that each effect makes to a law of motion of the oracle,
//! formulated in vectors from the physics.
//!
//! Flights with hidden effects are simulated with these formulas and not with the texts in `model-spec/effects`, so that
//! a diagnosis is not tested with the text that it looks for. A test compares the two.

mod extended_law;
mod flow;
mod inertia;
mod loads;
mod observation;
mod surroundings;

pub use extended_law::{ActiveEffect, ExtendedLaw};
pub use flow::Flow;

use oracle::Law;

/// An effect of the catalogue with a hand-written formula. The effect is absent if all its coefficients and states are 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effect {
    /// Name of the effect in the model language.
    pub name: &'static str,
    /// Names of the coefficients of the effect.
    pub coefficients: &'static [&'static str],
    /// Names of the states that the effect adds. They are constant during a flight and estimated for each flight.
    pub states: &'static [&'static str],
    /// Laws of motion to which the effect can be applied.
    pub laws: &'static [Law],
}

const DISC: [Law; 1] = [Law::Disc];
const DISCS: [Law; 2] = [Law::Disc, Law::Discus];
const BALL: [Law; 1] = [Law::Ball];
const ANY: [Law; 3] = [Law::Disc, Law::Discus, Law::Ball];

const fn effect(
    name: &'static str,
    coefficients: &'static [&'static str],
    laws: &'static [Law],
) -> Effect {
    Effect {
        name,
        coefficients,
        states: &[],
        laws,
    }
}

static EFFECTS: [Effect; 39] = [
    effect("zero_lift_drag_angle", &["alpha_0"], &DISC),
    effect("drag_by_spin", &["C_DS"], &DISCS),
    effect("drag_by_reynolds", &["C_DRe"], &DISCS),
    effect("constant_pitching_moment", &["C_M0"], &DISCS),
    effect("cubic_pitching_moment", &["C_Maaa"], &DISC),
    effect("pitching_moment_by_spin", &["C_MS"], &DISCS),
    effect("roll_damping", &["C_Rp"], &DISCS),
    effect("rolling_moment_by_angle", &["C_Ra"], &DISCS),
    effect("rolling_moment_by_spin_ratio", &["C_RS"], &DISCS),
    effect("rolling_moment_at_low_angle", &["C_Rg"], &DISCS),
    effect("quadratic_spin_down", &["C_Nrr"], &DISCS),
    effect("spin_down_by_pressure", &["C_Np"], &DISCS),
    effect("spin_down_by_angle", &["C_Na"], &DISCS),
    effect("side_force_by_spin", &["C_YS"], &DISCS),
    effect("side_force_by_spin_and_angle", &["C_YSa"], &DISCS),
    effect("stall", &["C_Ls"], &DISC),
    effect("lift_by_spin", &["C_LS"], &DISCS),
    effect("ground_effect", &["C_Lg"], &DISCS),
    effect("wind", &["W_x", "W_y"], &ANY),
    Effect {
        states: &["gust_x", "gust_y"],
        ..effect("wind_of_each_flight", &[], &ANY)
    },
    effect("wind_by_height", &["shear_x", "shear_y"], &ANY),
    effect("air_density", &["rho_error"], &ANY),
    effect("gravity", &["g_error"], &ANY),
    effect("added_mass", &["m_v"], &DISCS),
    effect("mass_imbalance", &["I_13", "I_23"], &DISCS),
    effect("unequal_diametral_inertias", &["dI"], &DISCS),
    effect("tilted_vertical", &["tilt_x", "tilt_y"], &ANY),
    effect("scale", &["scale_error"], &ANY),
    effect("marker_time_offset", &["later_2", "later_3"], &DISCS),
    effect(
        "marker_1_misplaced",
        &["slip_1_1", "slip_1_2", "slip_1_3"],
        &DISCS,
    ),
    effect(
        "marker_2_misplaced",
        &["slip_2_1", "slip_2_2", "slip_2_3"],
        &DISCS,
    ),
    effect(
        "marker_3_misplaced",
        &["slip_3_1", "slip_3_2", "slip_3_3"],
        &DISCS,
    ),
    effect("marker_height", &["mark_up"], &DISCS),
    effect("marker_radius", &["radius_error"], &DISCS),
    effect("magnus", &["C_Lw"], &BALL),
    effect("spin_decay", &["C_Lwt"], &BALL),
    effect("drag_crisis", &["C_Dc"], &BALL),
    effect("buoyancy", &["displaced"], &BALL),
    effect("clock_rate", &["clock_error"], &ANY),
];

impl Effect {
    /// Number of values of the effect: coefficients plus states.
    pub fn values(&self) -> usize {
        self.coefficients.len() + self.states.len()
    }
}

/// All effects that have a hand-written formula.
pub fn all() -> impl Iterator<Item = &'static Effect> + Clone {
    EFFECTS.iter()
}

/// Effect with the given name; `None` if it has no hand-written formula.
pub fn by_name(name: &str) -> Option<&'static Effect> {
    all().find(|effect| effect.name == name)
}
