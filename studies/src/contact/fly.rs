//! Simulates a disc's flight over level ground at height 0, with an impulse at each ground contact.

use model_spec::model::Model;
use oracle::{Physical, Point, Reference};

use super::impulse::{Disc, Surface};
use crate::oracle_flights::integrate;

/// Time between successive tests of a simulated flight for ground contact, s.
const STEP: f64 = 1.0 / 1200.0;

/// A simulated flight, with its first contact with the ground.
#[derive(Clone, Debug)]
pub(crate) struct Touched {
    /// States of the body (position, attitude, velocities) at the requested sample times.
    pub(crate) states: Vec<Physical<f64>>,
    /// Time of the first contact, s, and the downward speed of the rim's lowest point at that time, m/s; `None` if the
    /// disc does not touch the ground.
    pub(crate) first: Option<(f64, f64)>,
}

/// Simulates a disc from the state `start` at time 0, sampled at `times` (s, increasing). Each ground contact applies
/// an impulse.
pub(crate) fn fly(
    model: &Model,
    (reference, constants): (&Reference, &Point<f64>),
    start: Physical<f64>,
    surface: Surface,
    times: &[f64],
) -> Touched {
    let parameter = |name: &str| {
        let index = model.params.iter().position(|p| p.name == name);
        index.map_or(f64::NAN, |index| constants.params[index])
    };
    let disc = Disc {
        mass: parameter("m"),
        axial_inertia: parameter("I_a"),
        diametral_inertia: parameter("I_d"),
        radius: parameter("d") / 2.0,
    };
    let (mut body, mut now, mut first) = (start, 0.0, None);
    let states = times.iter().map(|&time| {
        while now < time {
            let step = STEP.min(time - now);
            body = integrate(reference, constants, body, &[step])[0];
            now += step;
            let arm = disc.lowest_point(&body);
            let falling = (body.velocity + body.angular_velocity.cross(&arm)).z;
            if body.position.z + arm.z < 0.0 && falling < 0.0 {
                body = disc.after_impulse(&body, surface);
                first = first.or(Some((now, -falling)));
            }
            // Avoids a tiny extra step if rounding leaves the last step of an interval just before the sample time.
            if time - now < 1e-9 {
                now = time;
            }
        }
        body
    });
    let states = states.collect();
    Touched { states, first }
}
