//! Flights of claimed bodies: the changes of position, momentum, angular momentum and energy are compared with the time
//! integrals of their causes.

use super::{
    Acting, DURATIONS, Flying, Found, MAX_STEPS, MOMENTA, OWN_CLOCK, RELEASES, TOLERANCE, decided,
    drawn_within, undecided_flights, unreleased,
};
use crate::integration::integrate;
use crate::options::Options;
use crate::random::Random;
use crate::row::{Row, Worst};
use crate::sample::{is_valid, typical, within_limits};
use crate::subject::Subject;
use nalgebra::Vector3;
use ode::{IntegrationError, IntegrationOptions};
use oracle::{ClaimedBody, Point, Quaternion, Tree};

/// Maximum deviation of a state from its default, relative to its typical magnitude.
const SPREAD: f64 = 0.2;

/// Compares changes of position, momenta and energy with the integrals of velocity, force, moment and power.
pub(super) fn momenta(subject: &Subject<'_>, options: &Options) -> Row {
    let mut random = Random::new(options.seed, "flight by momenta");
    let mut worst = Worst::default();
    let mut flown = 0;
    let mut undecided = 0;
    for _ in 0..RELEASES {
        let Some(point) = release(subject, &mut random) else {
            return unreleased(subject, MOMENTA);
        };
        if subject.clock(&point) != 1.0 {
            return Row::skipped(MOMENTA, OWN_CLOCK);
        }
        let Some(before) = body(subject, &point) else {
            return subject.without_meaning(MOMENTA);
        };
        let errors = |rtol| {
            let flight = fly(subject, &point, rtol)?;
            Some(errors(&before, &body(subject, &flight.end)?, &flight.sums))
        };
        match decided(errors) {
            Found::NotFlown => continue,
            Found::Undecided => undecided += 1,
            Found::Error(found) => worst.update(found.error, || found.place),
        }
        flown += 1;
    }
    if flown == 0 {
        return Row::skipped(MOMENTA, "its flights leave the limits of the model");
    }
    let row = Row::judged(MOMENTA, flown, &worst, TOLERANCE);
    match undecided {
        0 => row,
        _ => row.with_remark(undecided_flights(MOMENTA, undecided)),
    }
}

/// Maximum difference between a change of the body and the integral of its cause.
fn errors(before: &ClaimedBody<f64>, after: &ClaimedBody<f64>, sums: &[f64]) -> Worst {
    let mut worst = Worst::default();
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
    worst
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
        acting: load_of(&body),
        properties: None,
    })
}

/// Draws a release near the default state, with random inputs and without effects.
pub(super) fn release(subject: &Subject<'_>, random: &mut Random) -> Option<Point<f64>> {
    let model = subject.model;
    let draw = |random: &mut Random| {
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
        Some(subject.without_effects(point))
    };
    drawn_within(model, random, draw, within_limits)
}

pub(super) struct Flight {
    /// Final point.
    pub end: Point<f64>,
    /// Integrals of velocity, force, moment (three components each) and power.
    sums: Vec<f64>,
    /// Whether the same force acts all the time, and no moment.
    pub is_under_one_load: bool,
}

pub(super) fn fly(subject: &Subject<'_>, from: &Point<f64>, rtol: f64) -> Option<Flight> {
    if !is_valid(subject.model, from) {
        return None;
    }
    let mut flights = { DURATIONS.into_iter() }.flat_map(|d| fly_with_sums(subject, from, d, rtol));
    flights.find(|flight| is_valid(subject.model, &flight.end))
}

/// A flight of `duration`, s.
fn fly_with_sums(
    subject: &Subject<'_>,
    from: &Point<f64>,
    duration: f64,
    rtol: f64,
) -> Result<Flight, IntegrationError> {
    let count = from.states.len();
    let mut at = from.clone();
    let load = body(subject, from).map(|body| load_of(&body));
    let mut is_under_one_load = true;
    let mut moving = |t: f64, x: &[f64], dx: &mut [f64]| {
        at.time = t;
        at.states.copy_from_slice(&x[..count]);
        dx[..count].copy_from_slice(&subject.equations.rates(&at));
        let Some(body) = body(subject, &at) else {
            return;
        };
        let now = load_of(&body);
        is_under_one_load &= load.is_some_and(|load| load.is_the_force_of(&now));
        let causes = [body.velocity, now.force, now.moment];
        let components = causes.iter().flat_map(|cause| cause.iter());
        for (slot, cause) in dx[count..].iter_mut().zip(components) {
            *slot = *cause;
        }
        dx[count + 9] = body.power();
    };
    let mut start = from.states.clone();
    start.extend([0.0; 10]);
    let options = IntegrationOptions {
        max_steps: MAX_STEPS,
        ..IntegrationOptions::with_tolerance(rtol)
    };
    let mut end = integrate(&mut moving, &start, duration, &options)?;
    let sums = end.split_off(count);
    let end = Point {
        time: duration,
        states: end,
        ..from.clone()
    };
    Ok(Flight {
        end,
        sums,
        is_under_one_load,
    })
}

fn load_of(body: &ClaimedBody<f64>) -> Acting {
    Acting {
        force: body.force,
        moment: body.turning.map_or_else(Vector3::zeros, |t| t.moment),
    }
}
