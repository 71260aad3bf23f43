//! Data types of the disc-golf study: discs, throws and tracks.

use nalgebra::Vector3;

use crate::real_data::wind_tunnel::Measured;

/// Conversion factor from degrees to radians.
pub(super) const RAD: f64 = std::f64::consts::PI / 180.0;

/// Names of the launch quantities of a filmed throw: speed, angles and wind components.
pub(crate) const LAUNCH_NAMES: [&str; 7] = [
    "speed",
    "pitch",
    "roll",
    "nose",
    "yaw",
    "tailwind",
    "crosswind",
];

/// Values of the launch quantities in the order of [`LAUNCH_NAMES`], m/s and rad.
pub(crate) type Launch = [f64; 7];

/// Published uncertainties (standard deviations) of the launch quantities, m/s and rad. The uncertainty of the
/// crosswind is not published; it is assumed equal to that of the tailwind.
pub(crate) const UNCERTAINTY: Launch = [0.6, RAD * 2.0, RAD * 5.0, RAD * 2.0, RAD * 2.0, 1.0, 1.0];

/// Assumed uncertainty of a measured horizontal position, m. The camera films from a height of about 100 m, so a disc
/// that flies 5 to 10 m above the ground appears 5 to 10 % too far from the point below the camera.
pub(super) const TRACK_UNCERTAINTY: f64 = 1.0;

/// Number of points of each measured track that are compared with the simulation. More points would not help, because
/// neighbouring points have nearly the same measurement error.
const POINTS: usize = 12;

/// Size, inertia and aerodynamic table of a disc.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Disc {
    /// Diameter of the disc, m.
    pub(super) diameter: f64,
    /// Moments of inertia divided by the mass, m²: about a diameter, and about the disc's axis.
    pub(super) inertia: [f64; 2],
    /// Table of the aerodynamic coefficients, one row per angle of attack.
    pub(super) table: Vec<Measured>,
}

/// Time (s) and horizontal position (x, y), m, of a point of a measured track. The origin is near the release. x points
/// in the direction from which the launch yaw is measured, y to its left.
pub(crate) type TrackPoint = (f64, [f64; 2]);

/// A filmed throw: published launch conditions and measured track.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Throw {
    /// Number of the throw in the published data set.
    pub(crate) number: u32,
    /// Launch quantities as published with the throw.
    pub(crate) launch: Launch,
    /// Magnitude of the disc's spin at release, rad/s.
    pub(crate) spin: f64,
    /// Height of the release above the ground, m.
    pub(crate) height: f64,
    /// Points of the measured track; the first has time 0.
    pub(crate) track: Vec<TrackPoint>,
}

impl Throw {
    /// Selects evenly spaced points of the measured track, which are compared with the simulation.
    pub(crate) fn points(&self) -> Vec<TrackPoint> {
        let last = self.track.len().saturating_sub(1);
        let points = (1..=POINTS).filter_map(|k| self.track.get(k * last / POINTS));
        points.copied().collect()
    }
}

/// Axis of the disc (unit vector) and velocity (m/s) at a launch, in axes with z up and x in the direction from which
/// the launch yaw is measured; positive yaw turns x towards y. As in the simulation of Giljarhus and others (2022), the
/// disc is first rolled, and the launch pitch then changes the attitude of the rolled disc.
pub(crate) fn axis_and_velocity(launch: &Launch) -> (Vector3<f64>, Vector3<f64>) {
    let [speed, pitch, roll, nose, yaw, ..] = *launch;
    let turned = |v: Vector3<f64>| {
        let (sin, cos) = yaw.sin_cos();
        Vector3::new(cos * v.x - sin * v.y, sin * v.x + cos * v.y, v.z)
    };
    let bank = roll + roll.sin() * nose.sin() * pitch;
    let rise = nose + roll.cos() * pitch;
    let axis = Vector3::new(
        -rise.sin(),
        bank.sin() * rise.cos(),
        bank.cos() * rise.cos(),
    );
    let velocity = Vector3::new(speed * pitch.cos(), 0.0, speed * pitch.sin());
    (turned(axis), turned(velocity))
}

/// RMS difference, per coordinate, between simulated horizontal positions and the positions of measured track points,
/// m.
pub(crate) fn rms_distance(positions: &[[f64; 2]], points: &[TrackPoint]) -> f64 {
    let pairs = positions.iter().zip(points);
    let differences = pairs.flat_map(|(a, (_, b))| [a[0] - b[0], a[1] - b[1]]);
    let squares: f64 = differences.map(|d| d * d).sum();
    (squares / (2 * points.len().max(1)) as f64).sqrt()
}
