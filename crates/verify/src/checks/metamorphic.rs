//! Metamorphic relations: the laws of motion are invariant under translation, delay, heading, Galilean boosts, rotation
//! of a body of revolution about its axis, and reflection.
//!
//! Under reflection of y, the y components of positions, velocities, forces and wind change sign, and so do the x and z
//! components of angular velocities and moments. No coefficient changes sign. A coefficient that would have to
//! describes a law with handedness and is reported. A model that claims no reference law may break a relation on
//! purpose: the broken relations are then reported, but refute nothing. Only such a model, whose observation nothing else
//! is compared with, is also asked whether the observed marks move with the body.

use std::collections::BTreeSet;

use super::observed;
use super::precision::overflow;
use crate::meaning::Meaning;
use crate::options::Options;
use crate::random::Random;
use crate::row::{Row, Worst, rate_differences};
use crate::sample::{self, is_velocity};
use crate::subject::Subject;
use model_spec::model::{FrameKind, Model};
use model_spec::unit::Base;
use nalgebra::{Matrix3, Vector3};
use oracle::{Physical, PhysicalRate, Point, Quaternion, Tree};

/// Name of this check in reports: invariance of the motion under transformations, such as a translation.
pub const METAMORPHIC: &str = "metamorphic relations";

/// Maximum relative error: arcsines lose digits near ±1.
const TOLERANCE: f64 = 1e-10;

/// Index of the inertial frame.
const INERTIAL: usize = 0;

/// A transformation, such as a translation, under which the laws of motion are invariant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Relation {
    Translation,
    Delay,
    Heading,
    Mirror,
    Galilean,
    SpinAngle,
}

impl Relation {
    const ALL: [(Self, &'static str); 6] = [
        (Self::Translation, "translation"),
        (Self::Delay, "delay"),
        (Self::Heading, "heading"),
        (Self::Mirror, "mirror image with opposite spin"),
        (Self::Galilean, "steady motion of air and body together"),
        (Self::SpinAngle, "turn about the axis of symmetry"),
    ];
}

/// Checks that the motion is invariant under every transformation that applies. Coefficients that the reference law
/// does not contain have their null values; the detail lists the relations that each breaks, which is no fault.
pub fn check(subject: &Subject<'_>, options: &Options) -> Row {
    let Some(meaning) = Meaning::of(subject) else {
        return subject.without_meaning(METAMORPHIC);
    };
    let axis = axis_of_revolution(subject.model)
        .or_else(|| meaning.axis_of_revolution())
        .or_else(|| stated_axis(subject.model))
        .or(subject.reference.as_ref().map(|_| 3));
    let apply: Vec<_> = Relation::ALL
        .into_iter()
        .filter(|(relation, _)| match relation {
            Relation::SpinAngle => meaning.has_attitude() && axis.is_some(),
            Relation::Galilean => has_wind(subject.model),
            _ => true,
        })
        .collect();
    let mut random = Random::new(options.seed, "symmetries");
    let mut worst = Worst::default();
    let extras = subject.extras().into_iter();
    let mut broken: Vec<(usize, Vec<&'static str>)> =
        extras.map(|(index, _)| (index, Vec::new())).collect();
    let mut of_model: BTreeSet<&str> = BTreeSet::new();
    // Names of the relations whose transformed states were found at some point, and missing at some point.
    let (mut seen, mut unseen) = (BTreeSet::new(), BTreeSet::new());
    let mut asymmetric = false;
    let mut observed: BTreeSet<&str> = BTreeSet::new();
    for _ in 0..options.cases {
        let full = sample::point(subject.model, &mut random);
        let core = subject.without_extras(full.clone());
        let sizes = RandomSizes::new(&mut random, axis.unwrap_or(3));
        let symmetric = is_symmetric(subject.model, &core);
        asymmetric |= !symmetric;
        for &(relation, name) in &apply {
            if relation == Relation::Mirror && !symmetric {
                continue;
            }
            let transformation = Transformation {
                subject,
                meaning: &meaning,
                relation,
                sizes: &sizes,
            };
            let Some(error) = transformation.error(&core) else {
                if subject.is_known_by_claim() {
                    unseen.insert(name);
                    continue;
                }
                return subject.without_meaning(METAMORPHIC);
            };
            seen.insert(name);
            let is_broken = |error: f64| error.is_nan() || error > TOLERANCE;
            let observe = || transformation.observation_error(&core);
            if subject.reference.is_none() && observe().is_some_and(is_broken) {
                observed.insert(name);
            }
            worst.update(error, || name.to_owned());
            if is_broken(error) {
                of_model.insert(name);
            }
            for (index, names) in &mut broken {
                let mut point = core.clone();
                point.coefficients[*index] = full.coefficients[*index];
                let error = transformation.error(&point).unwrap_or(0.0);
                if error > TOLERANCE && !names.contains(&name) {
                    names.push(name);
                }
            }
        }
    }
    if subject.reference.is_none() && !(of_model.is_empty() && observed.is_empty()) {
        // A force may depend on position, heading or handedness by design, as that of a cord or of a bent wing does.
        let mut names: Vec<String> = of_model.into_iter().map(str::to_owned).collect();
        let observed = observed.into_iter();
        names.extend(observed.map(|name| format!("{name}, as observed")));
        let why = format!("the model claims no law; it breaks: {}", names.join(", "));
        return Row::skipped(METAMORPHIC, &why);
    }
    if seen.is_empty() {
        return Row::skipped(
            METAMORPHIC,
            "no states of the model stand for the claimed body shifted, turned or mirrored",
        );
    }
    let row = Row::judged(METAMORPHIC, options.cases, &worst, TOLERANCE);
    let mut lines = vec![row.detail.clone()];
    if !has_wind(subject.model) {
        lines.push(String::from(
            "steady motion of air and body together does not apply: no input is a velocity of the air",
        ));
    }
    let unseen: Vec<&str> = unseen.difference(&seen).copied().collect();
    if !unseen.is_empty() {
        lines.push(format!(
            "no states of the model stand for the body after: {}",
            unseen.join(", ")
        ));
    }
    if asymmetric {
        lines.push("reflection skipped: the body is not symmetric".to_owned());
    }
    for (index, names) in broken.into_iter().filter(|(_, names)| !names.is_empty()) {
        let coefficient = &subject.model.coefficients[index].name;
        lines.push(format!("{coefficient} breaks: {}", names.join(", ")));
    }
    row.with_detail(lines.join("\n").trim().to_owned())
}

/// Shift (m), boost (m/s), delay (s), and angle (rad) about the vertical or the axis of revolution.
struct RandomSizes {
    shift: Vector3<f64>,
    boost: Vector3<f64>,
    angle: f64,
    delay: f64,
    /// Axis of revolution of the body: 1, 2 or 3.
    axis: u8,
}

impl RandomSizes {
    fn new(random: &mut Random, axis: u8) -> Self {
        Self {
            shift: Vector3::from_fn(|_, _| random.within(10.0)),
            boost: Vector3::from_fn(|_, _| random.within(10.0)),
            angle: random.within(3.0),
            delay: random.between(0.0, 5.0),
            axis,
        }
    }
}

/// A relation that is checked, with the sizes of its transformation.
struct Transformation<'a> {
    subject: &'a Subject<'a>,
    meaning: &'a Meaning<'a>,
    relation: Relation,
    sizes: &'a RandomSizes,
}

impl Transformation<'_> {
    /// Maximum relative difference of the rates from the transformed ones; `None` if they cannot be determined.
    fn error(&self, point: &Point<f64>) -> Option<f64> {
        let change = self.rate(point)?;
        let (seen, expected) = self.of(point, change)?;
        let got = self.rate(&seen)?;
        let mut worst = Worst::default();
        for (_, error) in rate_differences(&got, &expected) {
            worst.update(error, String::new);
        }
        let mut both = [point, &seen].into_iter();
        if worst.error.is_infinite() && both.any(|at| overflow(self.subject.model, at).is_some()) {
            // The comparison with the vector tree names what overflows.
            return Some(0.0);
        }
        Some(worst.error)
    }

    /// Rate of the physical state at a point by the equations of motion.
    fn rate(&self, point: &Point<f64>) -> Option<PhysicalRate> {
        let rates = self.subject.flight_rates(point);
        self.meaning.rate(point, &rates, self.subject.clock(point))
    }

    /// Maximum relative difference of the observation from the transformed one, and, for a delay, of the distances of
    /// marks; `None` without an observation, and for a relation that does not move a mark with its body.
    fn observation_error(&self, point: &Point<f64>) -> Option<f64> {
        let (subject, sizes) = (self.subject, self.sizes);
        let zero = Vector3::zeros();
        let at_rest = PhysicalRate {
            velocity: zero,
            acceleration: zero,
            angular_velocity: zero,
            angular_acceleration: zero,
        };
        let (mut seen, _) = self.of(point, at_rest)?;
        let (mut turn, mut shift) = (Matrix3::identity(), zero);
        match self.relation {
            Relation::Translation => shift = sizes.shift,
            Relation::Heading => {
                turn = Quaternion::turn(3, sizes.angle).matrix();
                let marker = subject.model.marker.as_ref();
                if marker.is_some_and(|own| own.frame == INERTIAL) {
                    seen.marker = turn * point.marker;
                }
            }
            Relation::Delay => {
                let of_marks = observed::distance_difference(subject, point).unwrap_or(0.0);
                let of_time = observed::difference(subject, (point, &seen), &turn, &shift)?;
                return Some(of_marks.max(of_time));
            }
            Relation::Galilean => {}
            Relation::Mirror | Relation::SpinAngle => return None,
        }
        observed::difference(subject, (point, &seen), &turn, &shift)
    }

    /// The transformed point, and the rate at it by which the motion at `point` changes at the rate `change`; `None` if
    /// it has no such states.
    fn of(
        &self,
        point: &Point<f64>,
        mut change: PhysicalRate,
    ) -> Option<(Point<f64>, PhysicalRate)> {
        let sizes = self.sizes;
        let mut p = self.meaning.physical(point)?;
        let mut seen = point.clone();
        let inputs = self.subject.model.inputs.iter().zip(&mut seen.inputs);
        match self.relation {
            Relation::Delay => {}
            Relation::Translation => p.position += sizes.shift,
            Relation::Heading => {
                let heading = Quaternion::turn(3, sizes.angle);
                let turn = heading.matrix();
                let attitude = heading.times(p.attitude);
                map(&mut p, &mut change, turn, turn, attitude);
                inputs.for_each(|(_, v)| *v = turn * *v);
            }
            Relation::Mirror => {
                let polar = Matrix3::from_diagonal(&Vector3::new(1.0, -1.0, 1.0));
                // Conjugating a rotation matrix with a reflection gives a rotation; a symmetric body is mapped to itself.
                let attitude = Quaternion::from_matrix(&(polar * p.attitude.matrix() * polar));
                map(&mut p, &mut change, polar, -polar, attitude);
                for (input, v) in inputs {
                    *v = match input.unit.doubled[Base::Metre as usize] {
                        0 => -polar * *v,
                        _ => polar * *v,
                    };
                }
            }
            Relation::Galilean => {
                p.velocity += sizes.boost;
                change.velocity += sizes.boost;
                let of_air = inputs.filter(|(input, _)| is_velocity(input.unit));
                of_air.for_each(|(_, v)| *v += sizes.boost);
            }
            Relation::SpinAngle => {
                let turn = Quaternion::turn(sizes.axis, sizes.angle);
                p.attitude = p.attitude.times(turn);
            }
        }
        seen.states = self.meaning.states(&p, &seen)?;
        if self.relation == Relation::Delay {
            seen.time += sizes.delay;
        }
        Some((seen, change))
    }
}

/// Maps a physical state and its rate: polar vectors by `polar`, axial ones by `axial`.
fn map(
    p: &mut Physical<f64>,
    change: &mut PhysicalRate,
    polar: Matrix3<f64>,
    axial: Matrix3<f64>,
    attitude: Quaternion<f64>,
) {
    for v in [&mut p.position, &mut p.velocity] {
        *v = polar * *v;
    }
    for v in [&mut change.velocity, &mut change.acceleration] {
        *v = polar * *v;
    }
    p.attitude = attitude;
    p.angular_velocity = axial * p.angular_velocity;
    change.angular_velocity = axial * change.angular_velocity;
    change.angular_acceleration = axial * change.angular_acceleration;
}

/// Whether the body is its own mirror image: products of inertia 12 and 23 are 0.
fn is_symmetric(model: &Model, point: &Point<f64>) -> bool {
    let rotation = model.rotation();
    let claimed = model.claim.as_ref().and_then(|c| c.rotation.as_ref());
    let inertia = { rotation.map(|r| &r.inertia) }.or(claimed.map(|r| &r.inertia));
    inertia.is_none_or(|inertia| {
        let tree = Tree::new(model, point);
        [(0, 1), (1, 2)]
            .iter()
            .all(|&(i, j)| tree.scalar(&inertia[i][j]) == 0.0)
    })
}

/// Axis of revolution (1, 2 or 3): that of the rotation from the frame of the inertia to the body frame.
fn axis_of_revolution(model: &Model) -> Option<u8> {
    let rotation = model.rotation()?;
    match model.frames[rotation.body_frame].kind {
        FrameKind::Turned { axis, .. } if rotation.inertia_frame != rotation.body_frame => {
            Some(axis)
        }
        _ => None,
    }
}

/// Axis (1, 2 or 3) about which the body of a model states that it spins.
fn stated_axis(model: &Model) -> Option<u8> {
    let (_, axes) = model.flight_axes()?;
    axes.states_spin.then_some(axes.spin.number)
}

fn has_wind(model: &Model) -> bool {
    model.inputs.iter().any(|input| is_velocity(input.unit))
}
