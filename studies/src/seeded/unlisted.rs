//! Effects that are not in the catalogue. They are implemented only in this file.

use nalgebra::Vector3;
use oracle::Law;

use super::law::Flow;

/// Time constant of the first-order lag with which the lift of the effect `lagging_lift` follows the angle of attack,
/// s.
pub(super) const LAG: f64 = 0.15;
/// Scale of the climb rate, m/s, above which the additional drag of the effect `drag_by_climb` saturates.
const CLIMB_SCALE: f64 = 2.0;
/// Angular frequency of the wind in the effect `gusts`, rad/s.
const GUST_FREQUENCY: f64 = 8.0;
/// Airspeed at which the effect `drag_by_power_of_speed` leaves the drag unchanged, m/s.
const REFERENCE_SPEED: f64 = 14.0;
/// Exponent of the airspeed in the drag coefficient of the effect `drag_by_power_of_speed`.
const SPEED_POWER: f64 = -0.4;
/// Distance along x over which the phase of the sinusoidal side force of the effect `swerve` advances by one radian, m.
const SWERVE_LENGTH: f64 = 1.0;

/// A physical effect that can be added to simulated flights, but is not in the effects catalogue from which the
/// diagnosis takes its candidates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UnlistedEffect {
    /// Name of the effect in the discovery study, which adds it to simulated flights.
    pub name: &'static str,
    /// Quantity of the model on which the effect acts (its site, such as "drag"), by its name in the diagnosis report.
    pub site: &'static str,
    /// A weak and a strong size of the effect, in the effect's own unit, such as m/s for a wind; the units are listed
    /// at [`UNLISTED`].
    pub strength: [f64; 2],
    /// Laws of motion (kinds of bodies) on which the effect can act.
    pub laws: &'static [Law],
    /// Name of an effect of the built-in effects catalogue that is so similar that it counts as correct if the
    /// diagnosis names it; `None` if there is none.
    pub near: Option<&'static str>,
    kind: Kind,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    RollByAngleSquared,
    DragByClimb,
    SideByAngle,
    LaggingLift,
    PitchByTime,
    SpinDownBySpeed,
    LiftByPitchRate,
    Gusts,
    Updraft,
    Swerve,
    DragByHeight,
    DragByPower,
}

const DISCS: &[Law] = &[Law::Disc, Law::Discus];
const BALL: &[Law] = &[Law::Ball];
const ANY: &[Law] = &[Law::Disc, Law::Discus, Law::Ball];

const fn row(
    name: &'static str,
    site: &'static str,
    strength: [f64; 2],
    laws: &'static [Law],
    kind: Kind,
) -> UnlistedEffect {
    UnlistedEffect {
        name,
        site,
        strength,
        laws,
        near: None,
        kind,
    }
}

/// All effects outside the built-in effects catalogue. Units of their sizes: 1 for aerodynamic coefficients (the moment
/// arm is the diameter d), 1/s for `pitching_moment_by_time`, N·m·s/m for `spin_down_by_speed`, 1/m for
/// `drag_by_height`, m/s for `gusts` and `updraft`, N for `swerve`.
#[rustfmt::skip]
pub const UNLISTED: &[UnlistedEffect] = &[
    row("roll_by_angle_squared", "roll", [0.02, 0.1], DISCS, Kind::RollByAngleSquared),
    row("drag_by_climb", "drag", [0.005, 0.03], DISCS, Kind::DragByClimb),
    row("side_force_by_angle", "side", [0.02, 0.1], DISCS, Kind::SideByAngle),
    row("lagging_lift", "lift", [0.5, 2.0], DISCS, Kind::LaggingLift),
    row("pitching_moment_by_time", "pitch", [0.002, 0.01], DISCS, Kind::PitchByTime),
    row("spin_down_by_speed", "spin", [5e-5, 2e-4], DISCS, Kind::SpinDownBySpeed),
    row("lift_by_pitch_rate", "lift", [0.3, 2.0], DISCS, Kind::LiftByPitchRate),
    row("gusts", "wind", [0.1, 0.5], ANY, Kind::Gusts),
    row("updraft", "wind", [0.05, 0.3], ANY, Kind::Updraft),
    row("swerve", "unknown", [0.005, 0.03], BALL, Kind::Swerve),
    UnlistedEffect {
        near: Some("drag_by_reynolds"),
        ..row("drag_by_power_of_speed", "drag", [0.02, 0.1], DISCS, Kind::DragByPower)
    },
    row("drag_by_height", "drag", [0.02, 0.1], BALL, Kind::DragByHeight),
];

/// Looks up an effect outside the built-in effects catalogue by name; `None` for an unknown name.
pub fn unlisted(name: &str) -> Option<&'static UnlistedEffect> {
    UNLISTED.iter().find(|effect| effect.name == name)
}

impl UnlistedEffect {
    /// Velocity that the effect adds to the air at `time` (s), m/s, inertial axes; zero for an effect that is not a
    /// wind.
    pub(super) fn wind(&self, size: f64, time: f64) -> Vector3<f64> {
        match self.kind {
            Kind::Gusts => Vector3::new(0.0, size * (GUST_FREQUENCY * time).sin(), 0.0),
            Kind::Updraft => Vector3::new(0.0, 0.0, size),
            _ => Vector3::zeros(),
        }
    }

    /// Force (N) and moment (N·m) that the effect adds, inertial axes. `lagged_alpha` (rad) is the angle of attack
    /// after a first-order lag with the time constant [`LAG`].
    pub(super) fn load(
        &self,
        size: f64,
        flow: &Flow<'_, f64>,
        lagged_alpha: f64,
    ) -> (Vector3<f64>, Vector3<f64>) {
        let alpha = flow.alpha();
        let [forward, left] = flow.forward_and_left();
        let zero = Vector3::zeros();
        match self.kind {
            Kind::RollByAngleSquared => (zero, flow.pressure_moment(size * alpha * alpha, forward)),
            Kind::DragByClimb => {
                let climb = flow.at.velocity.z / CLIMB_SCALE;
                (flow.drag(size * climb.tanh()), zero)
            }
            Kind::DragByPower => {
                let ratio = flow.speed() / REFERENCE_SPEED;
                (flow.drag(size * (ratio.powf(SPEED_POWER) - 1.0)), zero)
            }
            Kind::SideByAngle => (flow.pressure_force(size * alpha, left), zero),
            Kind::LaggingLift => (flow.lift(size * (lagged_alpha - alpha)), zero),
            Kind::PitchByTime => (zero, flow.pressure_moment(size * flow.time, left)),
            Kind::SpinDownBySpeed => {
                let against = -flow.spin().signum();
                (zero, flow.normal() * (size * against * flow.speed()))
            }
            Kind::LiftByPitchRate => {
                let rate = flow.at.angular_velocity.dot(&left) * flow.constant("d");
                let ratio = rate / flow.speed().max(0.1);
                (flow.lift(size * ratio), zero)
            }
            Kind::Swerve => {
                let push = size * (flow.at.position.x / SWERVE_LENGTH).sin();
                (Vector3::new(0.0, push, 0.0), zero)
            }
            Kind::DragByHeight => {
                let radius = flow.constant("radius");
                let area = std::f64::consts::PI * radius * radius;
                let pressed = flow.constant("rho") * area / 2.0 * flow.speed();
                let height = flow.at.position.z;
                (-flow.through_air() * (pressed * size * height), zero)
            }
            Kind::Gusts | Kind::Updraft => (zero, zero),
        }
    }
}
