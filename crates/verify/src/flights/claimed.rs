//! Flights of claimed bodies: the changes of position, momentum, angular momentum and energy are compared with the time
//! integrals of their causes.

use super::{
    DURATION, Flying, MAX_DRAWS, MOMENTA, OWN_CLOCK, RELEASES, TOLERANCE, integrate, unreleased,
};
use crate::options::Options;
use crate::random::Random;
use crate::row::{Row, Worst};
use crate::sample::{is_valid, typical, within_limits};
use crate::subject::Subject;
use nalgebra::Vector3;
use ode::IntegrationError;
use oracle::{ClaimedBody, Point, Quaternion, Tree};

/// Maximum deviation of a state from its default, relative to its typical magnitude.
const SPREAD: f64 = 0.2;

/// Compares the changes of position, momentum, angular momentum and energy with the integrals of velocity, force,
/// moment and power.
pub(super) fn momenta(subject: &Subject<'_>, options: &Options) -> Row {
    let mut random = Random::new(options.seed, "flight by momenta");
    let mut worst = Worst::default();
    let mut flown = 0;
    for _ in 0..RELEASES {
        let Some(point) = release(subject, &mut random) else {
            return unreleased(subject, MOMENTA);
        };
        if subject.clock(&point) != 1.0 {
            return Row::skipped(MOMENTA, OWN_CLOCK);
        }
        let Some((end, sums)) = fly(subject, &point) else {
            continue;
        };
        let (Some(before), Some(after)) = (body(subject, &point), body(subject, &end)) else {
            return subject.without_meaning(MOMENTA);
        };
        flown += 1;
        let vector = |i: usize| Vector3::new(sums[i], sums[i + 1], sums[i + 2]);
        for (what, before, after, sum) in [
            ("position", before.position, after.position, vector(0)),
            ("momentum", before.momentum(), after.momentum(), vector(3)),
            (
                "angular momentum",
                before.angular_momentum(),
                after.angular_momentum(),
                vector(6),
            ),
            (
                "energy",
                Vector3::repeat(before.kinetic_energy()),
                Vector3::repeat(after.kinetic_energy()),
                Vector3::repeat(sums[9]),
            ),
        ] {
            let size = before.norm() + after.norm() + sum.norm();
            let error = (after - before - sum).norm() / size.max(f64::MIN_POSITIVE);
            worst.update(error, || {
                format!("{what} against the integral of its cause")
            });
        }
    }
    if flown == 0 {
        return Row::skipped(MOMENTA, "its flights leave the limits of the model");
    }
    Row::judged(MOMENTA, flown, &worst, TOLERANCE)
}

/// The claimed body at a point.
fn body(subject: &Subject<'_>, point: &Point<f64>) -> Option<ClaimedBody<f64>> {
    ClaimedBody::of(&Tree::new(subject.model, point))
}

/// The claimed body at a point; `None` if the model makes no such claim.
pub(super) fn flying(subject: &Subject<'_>, point: &Point<f64>) -> Option<Flying> {
    let body = body(subject, point)?;
    Some(Flying {
        position: body.position,
        kinetic_energy: body.kinetic_energy(),
        angular_momentum: body.angular_momentum(),
        force: body.force,
        moment: body.turning.map_or_else(Vector3::zeros, |t| t.moment),
        properties: None,
    })
}

/// Draws a release near the default state, with random inputs and without effects.
pub(super) fn release(subject: &Subject<'_>, random: &mut Random) -> Option<Point<f64>> {
    let model = subject.model;
    (0..MAX_DRAWS).find_map(|_| {
        let mut point = Point::defaults(model);
        for (state, value) in model.states.iter().zip(&mut point.states) {
            *value += random.within(SPREAD * typical(state.unit));
        }
        for states in model.quaternions() {
            let parts = states.map(|i| point.states[i]);
            let norm = parts.iter().map(|part| part * part).sum::<f64>().sqrt();
            let attitude = Quaternion::from_parts(parts.map(|part| part / norm));
            for (i, part) in states.into_iter().zip(attitude.parts()) {
                point.states[i] = part;
            }
        }
        for input in &mut point.inputs {
            *input = Vector3::from_fn(|_, _| random.within(2.0));
        }
        let point = subject.without_effects(point);
        within_limits(model, &point).then_some(point)
    })
}

/// First flight of 1, 0.3, 0.1 and 0.03 times [`DURATION`] that ends within the limits: final point, and integrals of
/// velocity, force, moment (three components each) and power.
pub(super) fn fly(subject: &Subject<'_>, from: &Point<f64>) -> Option<(Point<f64>, Vec<f64>)> {
    if !is_valid(subject.model, from) {
        return None;
    }
    let durations = [1.0, 0.3, 0.1, 0.03].map(|part| part * DURATION);
    let mut flights = { durations.into_iter() }.flat_map(|d| fly_with_sums(subject, from, d));
    flights.find(|(end, _)| is_valid(subject.model, end))
}

/// Final point after `duration`, s, and the ten integrals of [`fly`].
fn fly_with_sums(
    subject: &Subject<'_>,
    from: &Point<f64>,
    duration: f64,
) -> Result<(Point<f64>, Vec<f64>), IntegrationError> {
    let count = from.states.len();
    let mut at = from.clone();
    let mut moving = |t: f64, x: &[f64], dx: &mut [f64]| {
        at.time = t;
        at.states.copy_from_slice(&x[..count]);
        dx[..count].copy_from_slice(&subject.equations.rates(&at));
        let Some(body) = body(subject, &at) else {
            return;
        };
        let moment = body.turning.map_or_else(Vector3::zeros, |t| t.moment);
        let causes = [body.velocity, body.force, moment];
        let components = causes.iter().flat_map(|cause| cause.iter());
        for (slot, cause) in dx[count..].iter_mut().zip(components) {
            *slot = *cause;
        }
        dx[count + 9] = body.power();
    };
    let mut start = from.states.clone();
    start.extend([0.0; 10]);
    let mut end = integrate(&mut moving, &start, duration)?;
    let sums = end.split_off(count);
    let at = Point {
        time: duration,
        states: end,
        ..from.clone()
    };
    Ok((at, sums))
}
