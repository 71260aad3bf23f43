//! A flight over level ground at height 0.

use model_spec::model::Model;
use oracle::{Physical, Point, Reference};

use super::impulse::{Disc, Surface};
use crate::oracle_flights::integrate;

/// Time between checks for a touch, s.
const STEP: f64 = 1.0 / 1200.0;

/// A flight and its touches.
#[derive(Clone, Debug)]
pub(crate) struct Touched {
    /// Body states at the sample times.
    pub(crate) states: Vec<Physical<f64>>,
    /// Time of the first touch, s, and the speed at which the lowest point met the ground, m/s; `None` without a touch.
    pub(crate) first: Option<(f64, f64)>,
}

/// A flight of a disc from time 0, sampled at `times` (s, increasing), with an impulse at each touch.
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
            // The last step of an interval ends at the sample, whatever the rounding.
            if time - now < 1e-9 {
                now = time;
            }
        }
        body
    });
    let states = states.collect();
    Touched { states, first }
}
