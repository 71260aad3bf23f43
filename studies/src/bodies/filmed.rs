//! Three throws of a driver, filmed from above (Giljarhus and others 2022), and their simulation with the model
//! `golf_driver` by hyzer's own integrator.

use std::path::Path;

use analysis::design::{ThrowFlightError, ThrownBody};
use model_spec::{EffectTree, ModelTree};
use nalgebra::Vector3;
use ode::IntegrationOptions;
use serde::Serialize;

use super::horizontal_position;
use crate::error::StudyError;
use crate::real_data::{
    LAUNCH_NAMES, Launch, UNCERTAINTY, axis_and_velocity, filmed_throws, rms_distance,
};

/// A filmed throw, compared with the flight that is simulated from its published launch.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Filmed {
    /// Number of the throw in the published data.
    pub number: u32,
    /// Horizontal position (x, y), m, of the last measured point of the filmed path, in the axes of the published data.
    /// The simulated throw starts at their origin.
    pub track_end: [f64; 2],
    /// Simulated horizontal position (x, y), m, at the time of the last measured point of the filmed path; the landing
    /// position if the simulated flight ends earlier.
    pub flight_end: [f64; 2],
    /// Horizontal distance, m, between the last measured point of the filmed path and the simulated position at that
    /// time (the landing position if the simulated flight ends earlier).
    pub miss: f64,
    /// RMS difference, per coordinate, between simulated and measured positions at the measured points of the filmed
    /// path, m.
    pub rms: f64,
    /// For each launch quantity: its name, its published uncertainty as text, and the distance by which the simulated
    /// end of the flight moves if the quantity changes by that uncertainty, m.
    pub moves: Vec<(&'static str, String, f64)>,
    /// Root of the sum of the squared distances in `moves`, m: uncertainty of the simulated end of the flight that is
    /// due to the uncertain launch quantities.
    pub all_moves: f64,
}

/// Simulates the filmed throws of a folder that contains `throw_params.csv` (launch conditions) and the tracks
/// (measured paths).
///
/// # Errors
/// [`StudyError`] if a file cannot be read or a throw cannot be simulated.
pub fn filmed(folder: &Path) -> Result<Vec<Filmed>, StudyError> {
    let wind = EffectTree::parse("log_wind.hyz", include_str!("log_wind.hyz"))?;
    let model = ModelTree::load("golf_driver")?.with(&wind)?.check()?;
    let body = ThrownBody::new(model)?;
    let throws = filmed_throws(folder)?;
    let all = throws.iter().map(|throw| {
        let points = throw.points();
        let times: Vec<f64> = points.iter().map(|(time, _)| *time).collect();
        let flown = |launch: &Launch| track(&body, launch, throw.spin, throw.height, &times);
        let stated = flown(&throw.launch)?;
        let end = |track: &[[f64; 2]]| track[track.len() - 1];
        let distance = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
        let (track_end, flight_end) = (points[points.len() - 1].1, end(&stated));
        let mut moves = Vec::new();
        for (k, name) in LAUNCH_NAMES.into_iter().enumerate() {
            let at = |sign: f64| {
                let mut launch = throw.launch;
                launch[k] += sign * UNCERTAINTY[k];
                flown(&launch).map(|track| end(&track))
            };
            let by = distance(at(1.0)?, at(-1.0)?) / 2.0;
            let size = match name {
                "speed" | "tailwind" | "crosswind" => format!("{} m/s", UNCERTAINTY[k]),
                _ => format!("{:.0}°", UNCERTAINTY[k].to_degrees()),
            };
            moves.push((name, size, by));
        }
        let squares: f64 = moves.iter().map(|(_, _, by)| by * by).sum();
        Ok(Filmed {
            number: throw.number,
            track_end,
            flight_end,
            miss: distance(track_end, flight_end),
            rms: rms_distance(&stated, &points),
            moves,
            all_moves: squares.sqrt(),
        })
    });
    all.collect()
}

/// Simulated horizontal positions (x, y), m, of a disc at `times` (s after the release). Times after the landing give
/// the landing position.
fn track(
    body: &ThrownBody,
    launch: &Launch,
    spin: f64,
    height: f64,
    times: &[f64],
) -> Result<Vec<[f64; 2]>, StudyError> {
    let [.., tailwind, crosswind] = *launch;
    let layout = body.compiled.layout();
    let mut parameters = layout.default_parameters();
    if let Some([x, y, _]) = layout.components("wind") {
        parameters[x.index()] = tailwind;
        parameters[y.index()] = crosswind;
    }
    let (axis, velocity) = axis_and_velocity(launch);
    // The axis is (sin theta, -sin phi cos theta, cos phi cos theta).
    let (theta, phi) = (axis[0].asin(), (-axis[1]).atan2(axis[2]));
    let ((st, ct), (sp, cp)) = (theta.sin_cos(), phi.sin_cos());
    let first = Vector3::new(ct, sp * st, -cp * st);
    let second = Vector3::new(0.0, cp, sp);
    let values = [
        ("z", height),
        ("u", first.dot(&velocity)),
        ("v", second.dot(&velocity)),
        ("w", axis.dot(&velocity)),
        ("phi", phi),
        ("theta", theta),
        // A right-hander's backhand: clockwise, seen from above.
        ("gammadot", -spin),
    ];
    let mut state = layout.default_states();
    for (name, value) in values {
        if let Some(place) = layout.state(name) {
            state[place.index()] = value;
        }
    }
    let flights = body.with_parameters(parameters);
    let path = flights.trajectory(&state, &IntegrationOptions::default());
    let path = path.map_err(ThrowFlightError::from)?;
    let (x, y) = horizontal_position(layout);
    let at = |time: &f64| {
        let state = path.sample(time.min(path.end));
        let state = state.unwrap_or_else(|| path.end_state.clone());
        [state[x], state[y]]
    };
    Ok(times.iter().map(at).collect())
}
