//! Checks the balance laws under arbitrary loads: dp/dt = F, dH/dt = M, dE/dt = F·v + M·ω, and dr/dt = v.

use super::precision::Tally;
use crate::options::Options;
use crate::random::Random;
use crate::row::{Row, Worst};
use crate::sample;
use crate::subject::{Bounded, Subject, along, body_properties, errors};
use nalgebra::Vector3;
use oracle::scalar::{ErrorBound, Real};
use oracle::{BalanceLaw, ClaimedBody, MassProperties, Motion, Point, Tree, Turning, inertia_in_n};

/// Name of this check in reports: balances of momentum, angular momentum and energy at random points.
pub const IDENTITIES: &str = "momentum and energy";

/// Checks the balances dp/dt = F, dH/dt = M, dE/dt = F·v + M·ω and dr/dt = v at random points.
pub fn check(subject: &Subject<'_>, options: &Options) -> Row {
    let model = subject.model;
    if subject.is_known_by_claim() {
        return of_claim(subject, options);
    }
    let Some(chart) = &subject.chart else {
        return subject.without_meaning(IDENTITIES);
    };
    let mut random = Random::new(options.seed, IDENTITIES);
    let mut tally = Tally::default();
    let own = subject.own_coefficients();
    for case in 0..options.cases {
        let full = sample::point(model, &mut random);
        let mut point = subject.without_extras(full.clone());
        // The loads are taken from the model's body, so the laws hold for any values of the author's coefficients.
        let with_own = case % 2 == 1 && model.body.is_some() && !own.is_empty();
        if with_own {
            own.iter()
                .for_each(|&i| point.coefficients[i] = full.coefficients[i]);
        }
        let Some((motion, properties)) = loads(subject, &point.lift(), with_own) else {
            return Row::unverified(IDENTITIES, "neither loads nor a reference say what acts");
        };
        let rates = subject.flight_rates(&point);
        if rates.len() != point.states.len() {
            return Row::unverified(IDENTITIES, "there are no equations to evaluate");
        }
        // Each state is seeded with its rate, so the dual parts are time derivatives.
        let bound = ErrorBound::lit;
        let along = point.states.iter().zip(&rates);
        let along = along.map(|(&value, &rate)| Bounded::new(bound(value), bound(rate)));
        let body = chart.physical(&along.collect::<Vec<_>>());
        let constant = Bounded::constant;
        let turning = properties.inertia.map(|inertia| {
            let axes = body.attitude.matrix();
            Turning {
                axis: None,
                inertia: inertia_in_n(&axes, &inertia.map(constant)),
                angular_velocity: body.angular_velocity,
                moment: motion.moment.map(constant),
                axes,
            }
        });
        let body = ClaimedBody {
            mass: constant(properties.mass),
            position: body.position,
            velocity: body.velocity,
            force: motion.force.map(constant),
            turning,
        };
        tally.add_point(model, &point, compare_balances(&body));
    }
    tally.row(IDENTITIES, options.cases, options.cases)
}

/// Checks the balances of a claimed body; effects have their null values, coefficients of the author random ones.
fn of_claim(subject: &Subject<'_>, options: &Options) -> Row {
    let mut random = Random::new(options.seed, IDENTITIES);
    let mut tally = Tally::default();
    for _ in 0..options.cases {
        let point = subject.without_effects(sample::point(subject.model, &mut random));
        let Some(body) = along(subject, &point) else {
            return Row::unverified(IDENTITIES, "there are no equations to evaluate");
        };
        tally.add_point(subject.model, &point, compare_balances(&body));
    }
    tally.row(IDENTITIES, options.cases, options.cases)
}

/// Maximum difference between both sides of each balance; derivatives are those with respect to time.
fn compare_balances(body: &ClaimedBody<Bounded>) -> Worst {
    let mut worst = Worst::default();
    for balance in body.balances() {
        let names = match balance.law {
            BalanceLaw::AngularMomentum => "dH/dt against M",
            BalanceLaw::Momentum => "dp/dt against F",
            BalanceLaw::Position => "dr/dt against v",
            BalanceLaw::Attitude => continue,
        };
        for error in errors(&balance) {
            worst.update(error, || names.to_owned());
        }
    }
    let energy = body.kinetic_energy().derivative - body.power().value;
    let name = || String::from("dE/dt against F·v + M·ω");
    worst.update(energy.relative_error(0.0), name);
    worst
}

/// Force (N) and moment (N·m) in inertial components, of the body or else the reference law, and mass properties, of
/// the reference law so that a wrong mass is detected, or else (`with_own`: coefficients of the author act) of the
/// body.
fn loads(
    subject: &Subject<'_>,
    point: &Point<ErrorBound>,
    with_own: bool,
) -> Option<(Motion<ErrorBound>, MassProperties<ErrorBound>)> {
    let reference = subject.reference.as_ref().filter(|_| !with_own);
    let of_reference = || Some((reference?.motion(point), reference?.mass_properties(point)));
    let Some(body) = &subject.model.body else {
        return of_reference();
    };
    let tree = Tree::new(subject.model, point);
    let motion = Motion {
        force: tree.total(&subject.model.forces),
        moment: tree.total(&subject.model.moments),
        acceleration: Vector3::zeros(),
        angular_acceleration: Vector3::zeros(),
    };
    let properties = reference.map_or_else(
        || body_properties(&tree, body),
        |reference| reference.mass_properties(point),
    );
    Some((motion, properties))
}
