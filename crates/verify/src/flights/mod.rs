//! Checks on integrated flights: conservation of energy and angular momentum without air, agreement with the reference
//! law integrated in momenta, and agreement of two models.

mod claimed;

use crate::integration;
use crate::options::Options;
use crate::random::Random;
use crate::row::{Row, Worst, relative_difference};
use crate::sample::{is_valid, moved_within_limits};
use crate::subject::{Subject, body_properties};
use model_spec::model::Model;
use nalgebra::{Matrix3, Vector3};
use ode::{IntegrationError, IntegrationOptions};
use oracle::{MassProperties, Physical, Point, Quaternion, Reference, Tree, inertia_in_n, solve};
use std::cell::Cell;

/// Name in reports of the check that energy and angular momentum are conserved in a flight without air.
pub const INVARIANTS: &str = "flight without air";
/// Name in reports of the check of flights against the reference law, with momenta as states.
pub const MOMENTA: &str = "flight: reference in momenta";
const FLIGHTS: &str = "flights";

/// Maximum allowed relative difference in the flight checks, such as that of two final states.
const TOLERANCE: f64 = 1e-8;
/// Relative tolerance with which the flights of the flight checks are integrated.
const RTOL: f64 = 1e-11;
/// Relative tolerance with which a flight is integrated again before its errors refute anything.
const RTOL_AGAIN: f64 = 1e-13;
/// Factor of the errors of the flight that is integrated again, below which they are those of the integration.
const OF_INTEGRATION: f64 = 0.3;
/// Reason for skipping a model whose recorded time is not that of the flight.
const OWN_CLOCK: &str = "its clock does not keep to the seconds of the flight";
const OTHER_LOADS: &str =
    "without air and with its coefficients at 0, loads are left that are not a constant force";
/// Number of simulated flights per flight check.
const RELEASES: usize = 3;
/// Maximum number of draws of a release until one is within the model's validity limits.
const MAX_DRAWS: usize = 100;
/// Duration of a simulated flight in the flight checks, s.
const DURATION: f64 = 1.0;
/// Maximum number of integration steps of a flight that may be replaced by a shorter one.
const MAX_STEPS: usize = 10_000;
/// Durations, s, of which the first is flown that ends within the limits of the model.
const DURATIONS: [f64; 4] = [DURATION, 0.3, 0.1, 0.03];

/// Checks that energy and angular momentum are conserved in flights without air.
pub fn invariants(subject: &Subject<'_>, options: &Options) -> Row {
    let mut random = Random::new(options.seed, INVARIANTS);
    let mut worst = Worst::default();
    let mut flown = 0;
    for _ in 0..RELEASES {
        let Some(mut point) = release(subject, &mut random) else {
            return unreleased(subject, INVARIANTS);
        };
        airless(subject, &mut point);
        if subject.clock(&point) != 1.0 {
            return Row::skipped(INVARIANTS, OWN_CLOCK);
        }
        let Some(before) = Flying::of(subject, &point, None) else {
            return Row::unverified(INVARIANTS, "neither loads nor a reference say what acts");
        };
        let (end, is_under_one_load) = match fly_within_limits(subject, &point, &before) {
            Ok(Some(end)) => end,
            Ok(None) => continue,
            Err(why) if subject.reference.is_none() => {
                return Row::unverified(INVARIANTS, format!("without air it cannot fly: {why}"));
            }
            Err(why) => return Row::counted(INVARIANTS, RELEASES, &[why.to_string()], ""),
        };
        let Some(after) = Flying::of(subject, &end, before.properties) else {
            return subject.without_meaning(INVARIANTS);
        };
        let is_known = is_under_one_load && before.acting.is_the_force_of(&after.acting);
        if subject.reference.is_none() && !is_known {
            return Row::skipped(INVARIANTS, OTHER_LOADS);
        }
        flown += 1;
        worst.update(before.acting.moment.norm(), || {
            String::from("a moment is left where there is no air")
        });
        before.compare_invariants(&after, &mut worst);
    }
    if flown == 0 {
        return Row::skipped(INVARIANTS, "without air it leaves the limits of the model");
    }
    Row::judged(INVARIANTS, flown, &worst, TOLERANCE)
}

/// Compares final states with those of the reference law, integrated in momenta and attitude quaternion; of a claimed
/// body, changes of momenta with the integrals of their causes.
pub fn momenta(subject: &Subject<'_>, options: &Options) -> Row {
    if subject.is_known_by_claim() {
        return claimed::momenta(subject, options);
    }
    let Some(reference) = &subject.reference else {
        return subject.without_reference(MOMENTA);
    };
    let mut random = Random::new(options.seed, "flight by momenta");
    let mut worst = Worst::default();
    for _ in 0..RELEASES {
        let Some(point) = release(subject, &mut random) else {
            return unreleased(subject, MOMENTA);
        };
        let point = subject.without_extras(point);
        if subject.clock(&point) != 1.0 {
            return Row::skipped(MOMENTA, OWN_CLOCK);
        }
        let (end, other) = match (fly(subject, &point), fly_by_momenta(reference, &point)) {
            (Ok(end), Ok(other)) => (reference.chart.physical(&end.states), other),
            (Err(why), _) | (_, Err(why)) => {
                return Row::counted(MOMENTA, RELEASES, &[why.to_string()], "");
            }
        };
        compare(&mut worst, &end, &other);
    }
    Row::judged(MOMENTA, RELEASES, &worst, TOLERANCE)
}

/// Compares the final physical states of two models in flights that start from equal physical states.
pub fn same_flights(a: &Subject<'_>, b: &Subject<'_>, options: &Options) -> Row {
    let mut random = Random::new(options.seed, FLIGHTS);
    let mut worst = Worst::default();
    for _ in 0..RELEASES {
        let here = release(a, &mut random);
        let there = here
            .as_ref()
            .and_then(|here| a.corresponding_point(b, here));
        let (Some(here), Some(there), Some(chart_a), Some(chart_b)) =
            (here, there, &a.chart, &b.chart)
        else {
            let why = "the states of one cannot be found from the other's";
            return Row::skipped(FLIGHTS, why);
        };
        match (fly(a, &here), fly(b, &there)) {
            (Ok(one), Ok(other)) => {
                let (one, other) = (&one.states, &other.states);
                compare(&mut worst, &chart_a.physical(one), &chart_b.physical(other));
            }
            (Err(why), _) | (_, Err(why)) => {
                return Row::counted(FLIGHTS, RELEASES, &[why.to_string()], "");
            }
        }
    }
    Row::judged(FLIGHTS, RELEASES, &worst, TOLERANCE)
}

/// Result of a flight check without a release.
fn unreleased(subject: &Subject<'_>, check: &'static str) -> Row {
    if subject.chart.is_none() && !subject.is_known_by_claim() {
        return subject.without_meaning(check);
    }
    Row::unverified(check, "no release was found within the limits of the model")
}

/// Errors of a flight.
enum Found {
    /// The model does not fly within its limits.
    NotFlown,
    /// The errors are above the tolerance, and those of the integration.
    Undecided,
    /// Maximum error.
    Error(Worst),
}

/// Errors of a flight, which `errors` integrates with a relative tolerance: a fault does not depend on the tolerance.
fn decided(errors: impl Fn(f64) -> Option<Worst>) -> Found {
    let Some(first) = errors(RTOL) else {
        return Found::NotFlown;
    };
    if first.error <= TOLERANCE {
        return Found::Error(first);
    }
    match errors(RTOL_AGAIN) {
        Some(again) if again.error <= TOLERANCE => Found::Error(again),
        Some(again) if again.error > OF_INTEGRATION * first.error => Found::Error(first),
        _ => Found::Undecided,
    }
}

/// Remark on flights whose errors are those of the integration.
fn undecided_flights(check: &str, count: usize) -> String {
    format!("INTEGRATION ({check}): {count} flights are not integrated well enough to decide")
}

/// Draws a release within the validity limits; `None` if none is found.
fn release(subject: &Subject<'_>, random: &mut Random) -> Option<Point<f64>> {
    if subject.is_known_by_claim() {
        return claimed::release(subject, random);
    }
    let draw = |random: &mut Random| any_release(subject, random);
    drawn_within(subject.model, random, draw, is_valid)
}

/// First of at most [`MAX_DRAWS`] points inside the validity limits, or the last one moved within them, if any.
fn drawn_within(
    model: &Model,
    random: &mut Random,
    draw: impl Fn(&mut Random) -> Option<Point<f64>>,
    is_inside: fn(&Model, &Point<f64>) -> bool,
) -> Option<Point<f64>> {
    let mut point = draw(random)?;
    for _ in 1..MAX_DRAWS {
        if is_inside(model, &point) {
            return Some(point);
        }
        point = draw(random)?;
    }
    moved_within_limits(model, &point, random)
}

/// Draws a release with random inputs: 12 ± 3 m/s along the first inertial axis, spin of −40 ± 10 rad/s about the third
/// body axis, all else small.
fn any_release(subject: &Subject<'_>, random: &mut Random) -> Option<Point<f64>> {
    let chart = subject.chart.as_ref()?;
    let mut point = Point::defaults(subject.model);
    let attitude = Quaternion::turn(1, random.within(0.2))
        .times(Quaternion::turn(2, random.within(0.2)))
        .times(Quaternion::turn(3, random.within(3.0)));
    let spin = Vector3::new(
        random.within(1.0),
        random.within(1.0),
        -40.0 + random.within(10.0),
    );
    point.states = chart.states(&Physical {
        position: Vector3::new(0.0, 0.0, 1.0),
        velocity: Vector3::new(
            12.0 + random.within(3.0),
            random.within(2.0),
            random.within(2.0),
        ),
        attitude,
        angular_velocity: attitude.carry(spin),
    })?;
    for input in &mut point.inputs {
        *input = Vector3::from_fn(|_, _| random.within(2.0));
    }
    Some(point)
}

/// Removes the air: `rho` is 0, extra coefficients are null, all others as close to 0 as their bounds allow.
fn airless(subject: &Subject<'_>, point: &mut Point<f64>) {
    for (constant, value) in subject.model.params.iter().zip(&mut point.params) {
        if constant.name == "rho" {
            *value = 0.0;
        }
    }
    let coefficients = subject.model.coefficients.iter();
    for (constant, value) in coefficients.zip(&mut point.coefficients) {
        let (low, high) = constant.bounds.unwrap_or((0.0, 0.0));
        *value = 0.0_f64.clamp(low.min(high), high);
    }
    for (index, value) in subject.extras() {
        point.coefficients[index] = value;
    }
}

fn fly(subject: &Subject<'_>, from: &Point<f64>) -> Result<Point<f64>, IntegrationError> {
    let rates = |at: &Point<f64>| subject.equations.rates(at);
    let options = IntegrationOptions::with_tolerance(RTOL);
    integration::fly(&rates, from, DURATION, &options)
}

/// Final point of the first flight of the [`DURATIONS`] that ends within the validity limits of the model, and whether
/// the body and its load are those of `before` all the time; `None` if every flight leaves them.
fn fly_within_limits(
    subject: &Subject<'_>,
    from: &Point<f64>,
    before: &Flying,
) -> Result<Option<(Point<f64>, bool)>, IntegrationError> {
    if subject.is_known_by_claim() {
        let flight = claimed::fly(subject, from, RTOL);
        return Ok(flight.map(|flight| (flight.end, flight.is_under_one_load)));
    }
    if !is_valid(subject.model, from) {
        return Ok(None);
    }
    let mut failed = None;
    for duration in DURATIONS {
        match fly_under_load(subject, from, before, duration) {
            Ok(None) => return Ok(Some((from.clone(), false))),
            Ok(Some(end)) if is_valid(subject.model, &end) => return Ok(Some((end, true))),
            Ok(_) => {}
            Err(why) => failed = failed.or(Some(why)),
        }
    }
    failed.map_or(Ok(None), Err)
}

/// Final point of a flight of a declared body; `None` unless the body and its load are those of `before` wherever the
/// integrator evaluates the equations. A reference law says by itself what acts.
fn fly_under_load(
    subject: &Subject<'_>,
    from: &Point<f64>,
    before: &Flying,
    duration: f64,
) -> Result<Option<Point<f64>>, IntegrationError> {
    let is_under_one_load = Cell::new(true);
    let rates = |at: &Point<f64>| {
        if subject.reference.is_none() && is_under_one_load.get() {
            let is_same = loads(subject, at).is_some_and(|(acting, properties)| {
                let is_same = |known| is_same_body(known, &properties);
                before.properties.as_ref().is_some_and(is_same)
                    && before.acting.is_the_force_of(&acting)
            });
            is_under_one_load.set(is_same);
        }
        if is_under_one_load.get() {
            subject.equations.rates(at)
        } else {
            // Nothing is compared: the flight is not integrated to its end.
            vec![0.0; at.states.len()]
        }
    };
    let mut options = IntegrationOptions::with_tolerance(RTOL);
    if subject.reference.is_none() {
        options.max_steps = MAX_STEPS;
    }
    let end = integration::fly(&rates, from, duration, &options);
    if is_under_one_load.get() {
        end.map(Some)
    } else {
        Ok(None)
    }
}

/// Final physical state by the reference law, integrated in position, momentum, attitude and angular momentum.
fn fly_by_momenta(
    reference: &Reference,
    point: &Point<f64>,
) -> Result<Physical<f64>, IntegrationError> {
    let properties = reference.mass_properties(point);
    let read = |y: &[f64]| -> Physical<f64> {
        let vector = |i: usize| Vector3::new(y[i], y[i + 1], y[i + 2]);
        let attitude = Quaternion::from_parts([y[6], y[7], y[8], y[9]]);
        let angular_velocity = properties
            .inertia
            .map(|inertia| solve(&inertia_in_n(&attitude.matrix(), &inertia), &vector(10)));
        Physical {
            position: vector(0),
            velocity: vector(3) / properties.mass,
            attitude,
            angular_velocity: angular_velocity.unwrap_or_else(Vector3::zeros),
        }
    };
    let at = reference.chart.physical(&point.states);
    let spatial =
        |inertia: &Matrix3<f64>| inertia_in_n(&at.attitude.matrix(), inertia) * at.angular_velocity;
    let angular_momentum = properties
        .inertia
        .as_ref()
        .map_or_else(Vector3::zeros, spatial);
    let mut start: Vec<f64> = at.position.iter().copied().collect();
    start.extend((at.velocity * properties.mass).iter());
    start.extend(at.attitude.parts());
    start.extend(angular_momentum.iter());
    let mut moving = |_: f64, y: &[f64], dy: &mut [f64]| {
        let body = read(y);
        let motion = reference.motion_at(&body, point);
        let rate = Quaternion {
            w: 0.0,
            v: body.angular_velocity,
        }
        .times(body.attitude);
        dy[0..3].copy_from_slice(body.velocity.as_slice());
        dy[3..6].copy_from_slice(motion.force.as_slice());
        dy[6..10].copy_from_slice(&rate.parts().map(|part| part / 2.0));
        dy[10..13].copy_from_slice(motion.moment.as_slice());
    };
    let options = IntegrationOptions::with_tolerance(RTOL);
    integration::integrate(&mut moving, &start, DURATION, &options).map(|end| read(&end))
}

fn compare(worst: &mut Worst, a: &Physical<f64>, b: &Physical<f64>) {
    let parts = [
        ("position", a.position, b.position),
        ("velocity", a.velocity, b.velocity),
        ("angular velocity", a.angular_velocity, b.angular_velocity),
        ("attitude", a.attitude.axis(1), b.attitude.axis(1)),
        ("attitude", a.attitude.axis(3), b.attitude.axis(3)),
    ];
    for (what, a, b) in parts {
        worst.update(relative_difference(a, b), || what.to_owned());
    }
}

/// Force, N, and moment, N·m, that act on a body, in inertial components.
#[derive(Clone, Copy)]
struct Acting {
    force: Vector3<f64>,
    moment: Vector3<f64>,
}

impl Acting {
    /// Whether the load is the same force at another instant, without a moment; other loads do unknown work.
    fn is_the_force_of(&self, other: &Self) -> bool {
        let size = self.force.norm() + other.force.norm();
        self.moment.norm() == 0.0
            && other.moment.norm() == 0.0
            && (self.force - other.force).norm() <= TOLERANCE * size
    }
}

/// Whether mass and inertia in the body frame are equal but for rounding.
fn is_same_body(a: &MassProperties<f64>, b: &MassProperties<f64>) -> bool {
    let inertias = [a, b].map(|body| body.inertia.unwrap_or_else(Matrix3::zeros));
    let size = inertias[0].norm() + inertias[1].norm();
    (a.mass - b.mass).abs() <= TOLERANCE * a.mass.abs()
        && (inertias[0] - inertias[1]).norm() <= TOLERANCE * size
}

/// A flying body at one instant, in inertial components and SI units.
struct Flying {
    position: Vector3<f64>,
    kinetic_energy: f64,
    angular_momentum: Vector3<f64>,
    acting: Acting,
    /// Mass properties of a body that is not claimed, in the body frame.
    properties: Option<MassProperties<f64>>,
}

impl Flying {
    /// The body of a model at a point, with the mass properties `known` or, if `None`, those at the point. `None` if
    /// nothing says what acts on the body.
    fn of(
        subject: &Subject<'_>,
        point: &Point<f64>,
        known: Option<MassProperties<f64>>,
    ) -> Option<Self> {
        if subject.is_known_by_claim() {
            return claimed::flying(subject, point);
        }
        let (acting, properties) = loads(subject, point)?;
        let properties = known.unwrap_or(properties);
        let body = subject.chart.as_ref()?.physical(&point.states);
        let axes = body.attitude.matrix();
        let angular_momentum = properties.inertia.map_or_else(Vector3::zeros, |inertia| {
            inertia_in_n(&axes, &inertia) * body.angular_velocity
        });
        let energy = properties.mass * body.velocity.norm_squared()
            + angular_momentum.dot(&body.angular_velocity);
        Some(Self {
            position: body.position,
            kinetic_energy: energy / 2.0,
            angular_momentum,
            acting,
            properties: Some(properties),
        })
    }

    /// Compares the energy, less the work F·Δr of the force, and the angular momentum.
    fn compare_invariants(&self, later: &Self, worst: &mut Worst) {
        let fall = self.acting.force.dot(&(later.position - self.position));
        let energies = (self.kinetic_energy, later.kinetic_energy);
        let size = (energies.0 + energies.1).max(f64::MIN_POSITIVE);
        let energy = (energies.1 - energies.0 - fall).abs() / size;
        worst.update(energy, || String::from("energy"));
        let size = self.angular_momentum.norm().max(f64::MIN_POSITIVE);
        let change = (later.angular_momentum - self.angular_momentum).norm();
        worst.update(change / size, || String::from("angular momentum"));
    }
}

/// What acts, and mass properties, of the reference law or, without one, of the body.
fn loads(subject: &Subject<'_>, point: &Point<f64>) -> Option<(Acting, MassProperties<f64>)> {
    if let Some(reference) = &subject.reference {
        let motion = reference.motion(point);
        let acting = Acting {
            force: motion.force,
            moment: motion.moment,
        };
        return Some((acting, reference.mass_properties(point)));
    }
    let model = subject.model;
    let body = model.body.as_ref()?;
    let tree = Tree::new(model, point);
    let acting = Acting {
        force: tree.total(&model.forces),
        moment: tree.total(&model.moments),
    };
    Some((acting, body_properties(&tree, body)))
}
