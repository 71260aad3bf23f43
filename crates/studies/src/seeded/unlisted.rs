//! Effects that are in no catalogue, coded here alone.

use nalgebra::Vector3;
use oracle::effect::Scene;
use oracle::physical::Physical;
use oracle::reference::Law;

/// The time with which a lagging lift follows the angle of attack, s.
pub(super) const LAG: f64 = 0.15;
/// Climb at which the drag by climb is near its end, m/s.
const CLIMB: f64 = 2.0;
/// Frequency of the gusts, rad/s.
const GUSTS: f64 = 8.0;
/// Length over which a ball is pushed to and fro, m.
const SWERVE: f64 = 1.0;

/// An effect outside the catalogue.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outside {
    /// Its name.
    pub name: &'static str,
    /// The site that a diagnosis should name, as in the contract.
    pub site: &'static str,
    /// What it depends on, as in the contract.
    pub variables: &'static [&'static str],
    /// A size that is weak, and one that is strong.
    pub strength: [f64; 2],
    /// The laws it can change.
    pub laws: &'static [Law],
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
}

const DISCS: &[Law] = &[Law::Disc, Law::Discus];
const BALL: &[Law] = &[Law::Ball];
const ANY: &[Law] = &[Law::Disc, Law::Discus, Law::Ball];

const fn row(
    name: &'static str,
    site: &'static str,
    variables: &'static [&'static str],
    strength: [f64; 2],
    laws: &'static [Law],
    kind: Kind,
) -> Outside {
    Outside {
        name,
        site,
        variables,
        strength,
        laws,
        kind,
    }
}

/// All of them. Sizes: coefficients of the stream (of a lever d in moments) by what each goes with; N·m per m/s for
/// `spin_down_by_speed`; m/s for gusts and updraft; N for the swerve.
#[rustfmt::skip]
pub const ALL: &[Outside] = &[
    row("roll_by_angle_squared", "roll", &["alpha"], [0.02, 0.1], DISCS, Kind::RollByAngleSquared),
    row("drag_by_climb", "drag", &["attitude"], [0.005, 0.03], DISCS, Kind::DragByClimb),
    row("side_force_by_angle", "side", &["alpha"], [0.02, 0.1], DISCS, Kind::SideByAngle),
    row("lagging_lift", "lift", &["alpha", "time"], [0.5, 2.0], DISCS, Kind::LaggingLift),
    row("pitching_moment_by_time", "pitch", &["time"], [0.002, 0.01], DISCS, Kind::PitchByTime),
    row("spin_down_by_speed", "spin", &["speed"], [5e-5, 2e-4], DISCS, Kind::SpinDownBySpeed),
    row("lift_by_pitch_rate", "lift", &["rates"], [0.3, 2.0], DISCS, Kind::LiftByPitchRate),
    row("gusts", "wind", &["time"], [0.1, 0.5], ANY, Kind::Gusts),
    row("updraft", "wind", &["none"], [0.05, 0.3], ANY, Kind::Updraft),
    row("swerve", "unknown", &["position"], [0.005, 0.03], BALL, Kind::Swerve),
    row("drag_by_height", "drag", &["height"], [0.02, 0.1], BALL, Kind::DragByHeight),
];

/// The effect of that name.
pub fn by_name(name: &str) -> Option<&'static Outside> {
    ALL.iter().find(|outside| outside.name == name)
}

impl Outside {
    /// What it adds to the velocity of the air.
    pub(super) fn wind(&self, size: f64, _: &Physical<f64>, time: f64) -> Vector3<f64> {
        match self.kind {
            Kind::Gusts => Vector3::new(0.0, size * (GUSTS * time).sin(), 0.0),
            Kind::Updraft => Vector3::new(0.0, 0.0, size),
            _ => Vector3::zeros(),
        }
    }

    /// Force and moment that it adds; `memory` is the angle of attack that it remembers.
    pub(super) fn load(
        &self,
        size: f64,
        scene: &Scene<'_, f64>,
        memory: f64,
    ) -> (Vector3<f64>, Vector3<f64>) {
        let alpha = scene.alpha();
        let [forward, left] = scene.forward_and_left();
        let zero = Vector3::zeros();
        match self.kind {
            Kind::RollByAngleSquared => (zero, scene.turned(size * alpha * alpha, forward)),
            Kind::DragByClimb => {
                let climb = scene.at.velocity.z / CLIMB;
                (scene.dragged(size * climb.tanh()), zero)
            }
            Kind::SideByAngle => (scene.pressed(size * alpha, left), zero),
            Kind::LaggingLift => (scene.lifted(size * (memory - alpha)), zero),
            Kind::PitchByTime => (zero, scene.turned(size * scene.time, left)),
            Kind::SpinDownBySpeed => {
                let against = -scene.spin().signum();
                (zero, scene.normal() * (size * against * scene.speed()))
            }
            Kind::LiftByPitchRate => {
                let rate = scene.at.angular_velocity.dot(&left) * scene.constant("d");
                let ratio = rate / scene.speed().max(0.1);
                (scene.lifted(size * ratio), zero)
            }
            Kind::Swerve => {
                let push = size * (scene.at.position.x / SWERVE).sin();
                (Vector3::new(0.0, push, 0.0), zero)
            }
            Kind::DragByHeight => {
                let radius = scene.constant("radius");
                let area = std::f64::consts::PI * radius * radius;
                let pressed = scene.constant("rho") * area / 2.0 * scene.speed();
                let height = scene.at.position.z;
                (-scene.through_air() * (pressed * size * height), zero)
            }
            Kind::Gusts | Kind::Updraft => (zero, zero),
        }
    }
}
