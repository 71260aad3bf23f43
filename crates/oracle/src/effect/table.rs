//! The effects by hand, one row each.

use super::air::Air;
use super::ball::Ball;
use super::drag::Drag;
use super::inertia::Inertia;
use super::lift::Lift;
use super::pitch::Pitch;
use super::roll::Roll;
use super::seen::Seen;
use super::side::Side;
use super::spin::Spin;
use super::{Effect, Kind};
use crate::reference::Law;

const DISC: [Law; 1] = [Law::Disc];
const DISCS: [Law; 2] = [Law::Disc, Law::Discus];
const BALL: [Law; 1] = [Law::Ball];
const ANY: [Law; 3] = [Law::Disc, Law::Discus, Law::Ball];

/// Every effect that is written by hand.
pub const ALL: &[Effect] = &[
    effect(
        "zero_lift_drag_angle",
        &["alpha_0"],
        &DISC,
        Kind::Drag(Drag::ZeroLiftAngle),
    ),
    effect("drag_by_spin", &["C_DS"], &DISCS, Kind::Drag(Drag::BySpin)),
    effect(
        "drag_by_reynolds",
        &["C_DRe"],
        &DISCS,
        Kind::Drag(Drag::ByReynolds),
    ),
    effect(
        "constant_pitching_moment",
        &["C_M0"],
        &DISCS,
        Kind::Pitch(Pitch::Constant),
    ),
    effect(
        "cubic_pitching_moment",
        &["C_Maaa"],
        &DISC,
        Kind::Pitch(Pitch::Cubic),
    ),
    effect(
        "pitching_moment_by_spin",
        &["C_MS"],
        &DISCS,
        Kind::Pitch(Pitch::BySpin),
    ),
    effect("roll_damping", &["C_Rp"], &DISCS, Kind::Roll(Roll::Damping)),
    effect(
        "rolling_moment_by_angle",
        &["C_Ra"],
        &DISCS,
        Kind::Roll(Roll::ByAngle),
    ),
    effect(
        "rolling_moment_by_spin_ratio",
        &["C_RS"],
        &DISCS,
        Kind::Roll(Roll::BySpinRatio),
    ),
    effect(
        "rolling_moment_at_low_angle",
        &["C_Rg"],
        &DISCS,
        Kind::Roll(Roll::AtLowAngle),
    ),
    effect(
        "quadratic_spin_down",
        &["C_Nrr"],
        &DISCS,
        Kind::Spin(Spin::Quadratic),
    ),
    effect(
        "spin_down_by_pressure",
        &["C_Np"],
        &DISCS,
        Kind::Spin(Spin::ByPressure),
    ),
    effect(
        "spin_down_by_angle",
        &["C_Na"],
        &DISCS,
        Kind::Spin(Spin::ByAngle),
    ),
    effect(
        "side_force_by_spin",
        &["C_YS"],
        &DISCS,
        Kind::Side(Side::BySpin),
    ),
    effect(
        "side_force_by_spin_and_angle",
        &["C_YSa"],
        &DISCS,
        Kind::Side(Side::BySpinAndAngle),
    ),
    effect("stall", &["C_Ls"], &DISC, Kind::Lift(Lift::Stall)),
    effect("lift_by_spin", &["C_LS"], &DISCS, Kind::Lift(Lift::BySpin)),
    effect(
        "ground_effect",
        &["C_Lg"],
        &DISCS,
        Kind::Lift(Lift::NearGround),
    ),
    effect("wind", &["W_x", "W_y"], &ANY, Kind::Air(Air::Wind)),
    Effect {
        states: &["gust_x", "gust_y"],
        ..effect("wind_of_each_flight", &[], &ANY, Kind::Air(Air::Wind))
    },
    effect(
        "wind_by_height",
        &["shear_x", "shear_y"],
        &ANY,
        Kind::Air(Air::WindByHeight),
    ),
    effect("air_density", &["rho_error"], &ANY, Kind::Air(Air::Density)),
    effect("gravity", &["g_error"], &ANY, Kind::Air(Air::Gravity)),
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
    effect(
        "tilted_vertical",
        &["tilt_x", "tilt_y"],
        &ANY,
        Kind::Seen(Seen::Tilted),
    ),
    effect("scale", &["scale_error"], &ANY, Kind::Seen(Seen::Scale)),
    effect(
        "marker_time_offset",
        &["offset"],
        &DISCS,
        Kind::Seen(Seen::TimeOffset),
    ),
    effect(
        "marker_1_misplaced",
        &["slip_1_1", "slip_1_2", "slip_1_3"],
        &DISCS,
        Kind::Seen(Seen::Misplaced(0)),
    ),
    effect(
        "marker_2_misplaced",
        &["slip_2_1", "slip_2_2", "slip_2_3"],
        &DISCS,
        Kind::Seen(Seen::Misplaced(1)),
    ),
    effect(
        "marker_3_misplaced",
        &["slip_3_1", "slip_3_2", "slip_3_3"],
        &DISCS,
        Kind::Seen(Seen::Misplaced(2)),
    ),
    effect(
        "marker_height",
        &["mark_up"],
        &DISCS,
        Kind::Seen(Seen::Height),
    ),
    effect(
        "marker_radius",
        &["radius_error"],
        &DISCS,
        Kind::Seen(Seen::Radius),
    ),
    effect("magnus", &["C_Lw"], &BALL, Kind::Ball(Ball::Magnus)),
    effect("spin_decay", &["C_Lwt"], &BALL, Kind::Ball(Ball::SpinDecay)),
    effect(
        "drag_crisis",
        &["C_Dc"],
        &BALL,
        Kind::Ball(Ball::DragCrisis),
    ),
    effect(
        "buoyancy",
        &["displaced"],
        &BALL,
        Kind::Ball(Ball::Buoyancy),
    ),
    effect("clock_rate", &["clock_error"], &ANY, Kind::Clock),
];

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
