//! Points at which rounding is measured: random points, states along flights, and points with one state near 0.

use crate::integration;
use crate::random::Random;
use crate::sample::{self, is_valid, typical};
use crate::subject::Subject;
use ode::IntegrationOptions;
use oracle::Point;

/// Duration of each flight along which states are sampled, s.
const DURATION: f64 = 0.5;
/// Maximum number of integration steps between two points; a few random points need over 100,000.
const MAX_STEPS: usize = 2_000;
/// Maximum number of starts that are tried for each flight.
const MAX_STARTS: usize = 4;
/// Values of a state near 0, relative to its typical magnitude.
const NEAR_ZERO: [f64; 2] = [1e-3, 1e-7];

/// Points along flights from random points, at most `each` per flight, within the validity limits.
pub fn flown(
    subject: &Subject<'_>,
    flights: usize,
    each: usize,
    random: &mut Random,
) -> Vec<Point<f64>> {
    let mut points = Vec::new();
    for _ in 0..flights {
        let flight = (0..MAX_STARTS)
            .map(|_| flight(subject, sample::point(subject.model, random), each))
            .find(|flight| !flight.is_empty());
        points.extend(flight.unwrap_or_default());
    }
    points
}

/// Points along a flight at intervals of `DURATION / count`, without the start, until it fails or leaves the limits.
fn flight(subject: &Subject<'_>, mut at: Point<f64>, count: usize) -> Vec<Point<f64>> {
    let points = (0..count).map_while(|_| {
        at = flown_on(subject, &at, DURATION / count as f64)?;
        is_valid(subject.model, &at).then(|| at.clone())
    });
    points.collect()
}

/// Point reached after `seconds`; `None` if the integration fails or a state is not finite.
fn flown_on(subject: &Subject<'_>, from: &Point<f64>, seconds: f64) -> Option<Point<f64>> {
    let options = IntegrationOptions {
        max_steps: MAX_STEPS,
        ..IntegrationOptions::with_tolerance(1e-6)
    };
    let rates = |at: &Point<f64>| subject.equations.rates(at);
    let end = integration::fly(&rates, from, seconds, &options).ok()?;
    end.states.iter().all(|v| v.is_finite()).then_some(end)
}

/// Random points, with descriptions, at which one state is near 0.
pub fn near_zero(subject: &Subject<'_>, random: &mut Random) -> Vec<(String, Point<f64>)> {
    let mut points = Vec::new();
    for (index, state) in subject.model.states.iter().enumerate() {
        for small in NEAR_ZERO {
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
