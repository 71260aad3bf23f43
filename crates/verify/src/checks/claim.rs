//! Checks stated equations against the body that the model claims: rate of position = velocity, rate of attitude by
//! angular velocity, rate of momentum = force, rate of angular momentum = moment. Time derivatives are exact, by dual
//! numbers along the model's own equations. States need not be recovered from physical quantities, so the equations may
//! have any number of states in any parametrization.

use super::precision::{Tally, overflow};
use crate::options::Options;
use crate::random::Random;
use crate::row::{Row, Verdict, Worst};
use crate::sample;
use crate::subject::{Subject, along, errors, is_fault};
use oracle::scalar::{ErrorBound, Field};
use oracle::{BalanceLaw, Tree, claimed_rates};
use std::collections::BTreeMap;

/// Name of this check in reports: stated equations against the laws of motion of the claimed body.
pub const CLAIM: &str = "claimed body";

/// Advice for a model with stated equations and neither a claim nor a reference law.
const ADVICE: &str = "\
NOT VERIFIED: nothing says what these equations are about, so nothing can say that they are wrong. Add
    claim body NAME { mass …; inertia … in …; fixed in …; position …; velocity …; angular velocity …; force …; moment …; }
or, of a body that does not turn,
    claim point NAME { mass …; position …; velocity …; force …; }
Then it is checked that the position changes by the velocity, the attitude by the angular velocity, the momentum by the
force and the angular momentum by the moment; energy, flights and symmetries; and a wrong equation is named with its term.";

/// Axes of the inertial frame.
const AXES: [u8; 3] = [1, 2, 3];

/// Checks whether stated equations obey the laws of the claimed body, without effects; `None` for a declared body.
pub fn check(subject: &Subject<'_>, options: &Options) -> Option<Row> {
    let model = subject.model;
    if model.body.is_some() {
        return None;
    }
    if model.claim.is_none() {
        return Some(match &subject.reference {
            Some(_) => Row::skipped(CLAIM, "its equations are held to a reference"),
            None if !model.balances.is_empty() => Row::skipped(CLAIM, "the model claims balances"),
            None => subject.without_meaning(CLAIM).with_remark(ADVICE),
        });
    }
    let mut random = Random::new(options.seed, CLAIM);
    let mut tally = Tally::default();
    let mut broken: BTreeMap<BalanceLaw, (f64, u8)> = BTreeMap::new();
    for _ in 0..options.cases {
        let point = subject.without_effects(sample::point(model, &mut random));
        let Some(body) = along(subject, &point) else {
            return Some(Row::unverified(CLAIM, "there are no equations to evaluate"));
        };
        let mut worst = Worst::default();
        for balance in body.balances() {
            let is_finite = errors(&balance).iter().all(|error| error.is_finite());
            let overflows = !is_finite && overflow(model, &point).is_some();
            for (error, axis) in errors(&balance).into_iter().zip(AXES) {
                worst.update(error, || balance.law.formula().to_owned());
                let so_far = broken.entry(balance.law).or_insert((0.0, axis));
                if !overflows && is_fault(error) && error > so_far.0 {
                    *so_far = (error, axis);
                }
            }
        }
        tally.add_point(model, &point, worst);
    }
    broken.retain(|_, (error, _)| *error > 0.0);
    let row = tally.row(CLAIM, options.cases, options.cases);
    if broken.is_empty() {
        return Some(match row.verdict {
            Verdict::Holds => row.with_detail("the equations obey the laws of the claimed body"),
            _ => row,
        });
    }
    let inertial = &model.frames[0].name;
    let lines = broken.into_iter().map(|(law, (error, axis))| {
        let law = law.formula();
        format!("{law}: off by {error:.0e} of its terms, along {inertial}.{axis}")
    });
    let lines = lines.chain(unsatisfied(subject, options));
    let lines: Vec<String> = lines.collect();
    Some(row.with_detail(lines.join("\n")))
}

/// A line for each law that no rates of the states satisfy: the claim then contradicts itself, whatever the equations.
fn unsatisfied(subject: &Subject<'_>, options: &Options) -> Vec<String> {
    let mut random = Random::new(options.seed, CLAIM);
    let point = subject.without_effects(sample::point(subject.model, &mut random));
    let lifted = point.lift::<ErrorBound>();
    let pace = Tree::new(subject.model, &lifted).clock();
    let implied = claimed_rates(subject.model, &lifted, ErrorBound::integer(1) / pace);
    let laws = implied.map_or_else(Vec::new, |i| i.unsatisfied);
    let line = |(law, error): (BalanceLaw, f64)| {
        format!(
            "no equations of these states could obey {} (off by {error:.0e}): what is claimed contradicts itself",
            law.formula()
        )
    };
    laws.into_iter().map(line).collect()
}
