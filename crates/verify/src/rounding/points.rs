//! Points at which rounding is measured: random points, states along flights, and points with one state near 0.

use crate::random::Random;
use crate::sample::{self, is_valid, typical};
use crate::subject::Subject;
use ode::Method;
use oracle::Point;

/// Duration of each flight along which states are sampled, s.
const DURATION: f64 = 0.5;
/// Values that a state is set to in order to measure rounding near 0, relative to the state's typical magnitude.
const SMALL: [f64; 2] = [1e-3, 1e-7];

/// Draws `count` random points within the validity limits of the model.
pub fn random(subject: &Subject<'_>, count: usize, random: &mut Random) -> Vec<Point<f64>> {
    (0..count)
        .map(|_| sample::point(subject.model, random))
        .collect()
}

/// Points along `flights` simulated flights from random points, at most `each` per flight. A flight ends early if it
/// leaves the model's validity limits or its integration fails.
pub fn flown(
    subject: &Subject<'_>,
    flights: usize,
    each: usize,
    random: &mut Random,
) -> Vec<Point<f64>> {
    let mut points = Vec::new();
    for _ in 0..flights {
        let mut at = sample::point(subject.model, random);
        for _ in 0..each {
            match flown_on(subject, &at, DURATION / each as f64) {
                Some(next) if is_valid(subject.model, &next) => at = next,
                _ => break,
            }
            points.push(at.clone());
        }
    }
    points
}

/// Point reached by a flight `seconds` after the point `from`; `None` if the integration fails or a state is not
/// finite.
fn flown_on(subject: &Subject<'_>, from: &Point<f64>, seconds: f64) -> Option<Point<f64>> {
    let mut at = from.clone();
    let mut moving = ode::rhs_from_fn(&[], |t, x: &Vec<f64>, dx: &mut Vec<f64>| {
        at.time = from.time + t;
        at.states.copy_from_slice(x);
        dx.copy_from_slice(&subject.equations.rates(&at));
    });
    let options = ode::IntegrationOptions {
        method: Method::Tsit5,
        ..ode::IntegrationOptions::with_tolerance(1e-6)
    };
    let end = ode::integrate_to_end(&mut moving, (0.0, &from.states), seconds, &options, &mut []);
    let states = end.ok()?.state;
    states.iter().all(|v| v.is_finite()).then(|| Point {
        time: from.time + seconds,
        states,
        ..from.clone()
    })
}

/// Random points at which one state is near 0, each with a description. For every state there is one point per
/// relative magnitude in the constant `SMALL`. Points outside the model's validity limits are left out.
pub fn near_zero(subject: &Subject<'_>, random: &mut Random) -> Vec<(String, Point<f64>)> {
    let mut points = Vec::new();
    for (index, state) in subject.model.states.iter().enumerate() {
        for small in SMALL {
            let mut point = sample::point(subject.model, random);
            let value = small * typical(state.unit) * random.between(0.5, 1.0);
            point.states[index] = value;
            if is_valid(subject.model, &point) {
                points.push((format!("{} = {value:.1e}", state.name), point));
            }
        }
    }
    points
}
