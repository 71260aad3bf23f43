//! Simulated flights of every disc from a level launch: the turn to one side and the fade back to the other.

use analysis::design::{ThrowFlightError, ThrownBody};
use flight::throw::Throw;
use ode::IntegrationOptions;
use serde::Serialize;

use super::{DISCS, horizontal_position};
use crate::error::StudyError;

/// Number of equal time intervals into which a simulated flight is divided for sampling.
const SAMPLES: usize = 1000;

/// Turn (drift to the right) and fade (later drift to the left) of one disc in a simulated flight down to the ground.
/// The launch angle is 10°, the hyzer and nose angles are zero. Right and left are those of a right-handed backhand;
/// they are not exchanged for the opposite spin.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct TurnAndFade {
    /// Name of the built-in model of the disc.
    pub disc: &'static str,
    /// Speed of the disc at release, m/s.
    pub speed: f64,
    /// Distance of the landing point along the launch direction, m.
    pub length: f64,
    /// Time of flight, s.
    pub time: f64,
    /// Maximum lateral displacement to the right of the launch direction, m.
    pub turn: f64,
    /// Lateral position of the landing point, m; positive to the left of the launch direction.
    pub landing: f64,
    /// Maximum deviation of the path's heading to the right of the launch direction, deg.
    pub turned: f64,
    /// Change of the heading back to the left between its rightmost value and the landing, deg.
    pub faded: f64,
}

/// Simulates every disc at several release speeds (m/s), with a launch angle of 10° and zero hyzer and nose angle.
/// `sign` is the sign of the spin: 1 for a right-handed backhand, -1 for the opposite spin.
///
/// # Errors
/// [`StudyError`] if a model does not load or a flight cannot be simulated.
pub fn turns_and_fades(speeds: &[f64], sign: f64) -> Result<Vec<TurnAndFade>, StudyError> {
    let mut rows = Vec::new();
    for disc in DISCS {
        let body = ThrownBody::new(model_spec::load::load(disc, &[])?)?;
        let flights = body.with_parameters(body.compiled.layout().default_parameters());
        for &speed in speeds {
            let throw = Throw {
                launch: 10.0,
                height: 1.5,
                nose: Some(0.0),
                hyzer: Some(0.0),
                // Spin grows with the speed: the rim moves at half the release speed.
                spin: Some(sign * speed / 0.21 * 30.0 / std::f64::consts::PI),
                ..Throw::at_speed(speed)
            };
            let state = flights
                .state(&throw, None)
                .map_err(ThrowFlightError::from)?;
            let path = flights.trajectory(&state, &IntegrationOptions::default());
            let path = path.map_err(ThrowFlightError::from)?;
            let (x, y) = horizontal_position(body.compiled.layout());
            let time = |k: usize| path.end * k as f64 / SAMPLES as f64;
            let points = (0..=SAMPLES).filter_map(|k| path.sample(time(k)));
            let points: Vec<[f64; 2]> = points.map(|state| [state[x], state[y]]).collect();
            let headings = points.windows(2).map(|pair| {
                let (dx, dy) = (pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]);
                dy.atan2(dx).to_degrees()
            });
            let headings: Vec<f64> = headings.collect();
            let turned = headings.iter().copied().fold(0.0, f64::min);
            let [length, landing] = points[points.len() - 1];
            rows.push(TurnAndFade {
                disc,
                speed,
                length,
                time: path.end,
                turn: -points.iter().map(|p| p[1]).fold(0.0, f64::min),
                landing,
                turned: -turned,
                faded: headings[headings.len() - 1] - turned,
            });
        }
    }
    Ok(rows)
}
