//! Compares derivatives and observation with the reference implementation and with the model's vector expressions.

use super::function_rows::{reference_column, tree_column};
use super::precision::{Finding, Tally, bounded_by, decide, exact_values};
use crate::options::{Options, TOLERANCE};
use crate::random::Random;
use crate::row::{Row, Worst};
use crate::sample;
use crate::subject::{Equations, Subject};
use model_spec::model::Model;
use oracle::scalar::ErrorBound;
use oracle::{Point, Reference, Unsupported};
use std::cell::OnceCell;
use std::collections::{BTreeMap, BTreeSet};

/// Name in reports of the check of the state derivatives and the observation against the reference implementation.
pub const REFERENCE: &str = "reference";
/// Name in reports of the check against the model's vector expressions, as evaluated by the reference simulator.
pub const TREE: &str = "vector tree";

/// Compares derivatives and observation with the reference law; coefficients that it lacks have their null values.
pub fn reference(subject: &Subject<'_>, options: &Options) -> Row {
    if let Some(why) = &subject.unbound {
        return Row::counted(REFERENCE, 1, &[why.to_string()], "");
    }
    let Some(reference) = &subject.reference else {
        return subject.without_reference(REFERENCE);
    };
    let model = subject.model;
    // The reference law does not contain added states; the vector tree does.
    let added = model.added_states();
    let mut random = Random::new(options.seed, REFERENCE);
    let mut worst = Worst::default();
    let mut refused: Vec<String> = Vec::new();
    for _ in 0..options.cases {
        let point = subject.without_extras(sample::point(model, &mut random));
        let mut found = subject.flight_rates(&point);
        found.extend(subject.equations.observation(&point).iter().flatten());
        let expected = reference_column(reference, model, &point.lift());
        compare(model, &expected, &found, &added, |error, name| {
            if error > TOLERANCE && !refused.contains(&name) {
                refused.push(name.clone());
            }
            worst.update(error, || name);
        });
    }
    let row = Row::judged(REFERENCE, options.cases, &worst, TOLERANCE);
    if refused.is_empty() {
        let still =
            (!reference.has_wind()).then_some("in still air: the model has no input `wind`");
        let row = still.map_or(row.clone(), |words| row.with_detail(words));
        return match uncovered(subject, reference, options) {
            None => row,
            // Whatever the author's coefficients are, the loads of a body are checked by the balance of its momentum.
            Some(lines) if model.body.is_some() => row.with_remark(lines.join("\n")),
            Some(lines) => Row::unverified(REFERENCE, lines.join("\n")),
        };
    }
    row.with_detail(format!(
        "differ from the reference implementation: {}",
        refused.join(", ")
    ))
}

/// A line for each coefficient of the author that makes the equations differ from the reference law.
fn uncovered(
    subject: &Subject<'_>,
    reference: &Reference,
    options: &Options,
) -> Option<Vec<String>> {
    let model = subject.model;
    let added = model.added_states();
    let mut random = Random::new(options.seed, "terms of the author");
    let mut found: BTreeMap<usize, BTreeSet<String>> = BTreeMap::new();
    for _ in 0..options.cases.div_ceil(4) {
        let full = sample::point(model, &mut random);
        let without = subject.without_extras(full.clone());
        for coefficient in subject.own_coefficients() {
            for value in [
                full.coefficients[coefficient],
                model.coefficients[coefficient].value,
            ] {
                let mut point = without.clone();
                point.coefficients[coefficient] = value;
                let expected = reference.derivatives(&point.lift::<ErrorBound>());
                let got = subject.flight_rates(&point);
                let rows = got.iter().zip(&expected).enumerate();
                let moved = rows.filter(|(i, (got, expected))| {
                    let error = expected.relative_error(**got);
                    !added.contains(i) && (error.is_nan() || error > TOLERANCE)
                });
                let names = moved.map(|(i, _)| format!("der({})", model.states[i].name));
                let names: Vec<String> = names.collect();
                if !names.is_empty() {
                    found.entry(coefficient).or_default().extend(names);
                }
            }
        }
    }
    if found.is_empty() {
        return None;
    }
    let lines = found.into_iter().map(|(coefficient, rows)| {
        let rows: Vec<String> = rows.into_iter().collect();
        let name = &model.coefficients[coefficient].name;
        format!(
            "NOT IN THE LAW: `{name}`, which changes {}; the reference holds only with `{name}` at its null value",
            rows.join(", ")
        )
    });
    Some(lines.collect())
}

/// Compares state derivatives and observation with those of the oracle's vector tree, all coefficients being random.
pub fn tree(subject: &Subject<'_>, options: &Options) -> Row {
    let model = subject.model;
    let mut random = Random::new(options.seed, TREE);
    let mut tally = Tally::default();
    for _ in 0..options.cases {
        let point = sample::point(model, &mut random);
        let errors = |finding, name| tally.add(finding, || name);
        if let Err(why) = with_tree(model, subject.equations, &point, errors) {
            return Row::unverified(TREE, why.to_string());
        }
    }
    tally.row(TREE, options.cases, options.cases)
}

/// Passes the finding on every state derivative and component of the observation to `errors`, with its name. Values that
/// differ are compared in 256 bits.
pub(super) fn with_tree(
    model: &Model,
    equations: &dyn Equations,
    point: &Point<f64>,
    mut errors: impl FnMut(Finding, String),
) -> Result<(), Unsupported> {
    let expected = tree_column(model, &point.lift::<ErrorBound>())?;
    let mut found = equations.rates(point);
    found.extend(equations.observation(point).iter().flatten());
    let exact = OnceCell::new();
    let of_code = OnceCell::new();
    for (i, expected) in expected.iter().enumerate() {
        let found = found.get(i).copied();
        let error = found.map_or(f64::INFINITY, |found| expected.relative_error(found));
        let is_known = error <= TOLERANCE && expected.magnitude.is_finite();
        // Evaluated only where the two differ: 256 bits take most of the time of a check.
        let exact = |found| {
            let exact = exact.get_or_init(|| exact_values(model, point)).as_ref()?;
            Some((found, exact[i]))
        };
        let finding = match found.filter(|_| !is_known).and_then(exact) {
            None => Finding::Error(error),
            Some((found, exact)) => {
                let of_code = of_code.get_or_init(|| equations.magnitudes(point));
                let of_code = of_code.get(i).copied().unwrap_or(0.0);
                let expected = bounded_by(expected.value, expected.magnitude);
                let in_256_bits = || equations.overflowing(point)?.get(i).copied();
                decide(found, expected, of_code, exact, in_256_bits)
            }
        };
        errors(finding, value_name(model, i));
    }
    Ok(())
}

/// Passes the error of each value, except the derivatives of the states `except`, to `errors`, relative to the sum of
/// the magnitudes of the terms of the expected value.
fn compare(
    model: &Model,
    expected: &[ErrorBound],
    found: &[f64],
    except: &[usize],
    mut errors: impl FnMut(f64, String),
) {
    for (i, expected) in expected.iter().enumerate() {
        if !except.contains(&i) {
            let error = |&found: &f64| expected.relative_error(found);
            errors(
                found.get(i).map_or(f64::INFINITY, error),
                value_name(model, i),
            );
        }
    }
}

/// Name of a state derivative or of a component of the observation.
fn value_name(model: &Model, row: usize) -> String {
    match model.states.get(row) {
        Some(state) => format!("der({})", state.name),
        None => String::from("the observation"),
    }
}
