//! What a change costs: operations, nonzero entries of the Jacobians, time of the derivatives.

use super::pairing::{Pairing, parameters};
use super::values::Everything;
use crate::random::Random;
use crate::sample;
use crate::subject::Equations;
use crate::values::Values;
use codegen::Compiled;
use serde::Serialize;
use std::collections::BTreeSet;
use std::time::Instant;

/// A number in the old and in the new model.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Pair<T> {
    /// In the old model.
    pub old: T,
    /// In the new model.
    pub new: T,
}

/// Operations and entries of the functions of both models.
#[derive(Clone, Debug, Serialize)]
pub struct Cost {
    /// Operations by function: `f`, `f_jac`, `f_jac_par`.
    pub operations: Vec<(&'static str, Pair<usize>)>,
    /// Nonzero entries of the state Jacobian J.
    pub j: Pair<usize>,
    /// Nonzero entries of the parameter Jacobian Jp.
    pub jp: Pair<usize>,
    /// Entries that only the new model has, in the names of the new model.
    pub entries_added: Vec<String>,
    /// Entries that only the old model has, in the names of the old model.
    pub entries_removed: Vec<String>,
}

/// Compares operations and entries; compiles both models.
pub fn cost(old: &Everything<'_>, new: &Everything<'_>, pairing: &Pairing) -> Cost {
    let (a, b) = (codegen::compile(old.model), codegen::compile(new.model));
    let functions = ["f", "f_jac", "f_jac_par"];
    let operations = functions.map(|name| {
        let pair = Pair {
            old: a.count(name).total(),
            new: b.count(name).total(),
        };
        (name, pair)
    });
    let (before, after) = (entries(&a), entries(&b));
    let mapped: BTreeSet<Entry> = after.iter().filter_map(|e| e.mapped(pairing)).collect();
    let added = after
        .iter()
        .filter(|e| e.mapped(pairing).is_none_or(|m| !before.contains(&m)));
    let removed = before.iter().filter(|e| !mapped.contains(e));
    let count = |entries: &BTreeSet<Entry>, by_state| {
        entries.iter().filter(|e| e.by_state == by_state).count()
    };
    Cost {
        operations: operations.into(),
        j: Pair {
            old: count(&before, true),
            new: count(&after, true),
        },
        jp: Pair {
            old: count(&before, false),
            new: count(&after, false),
        },
        entries_added: added.map(|e| e.name(&b)).collect(),
        entries_removed: removed.map(|e| e.name(&a)).collect(),
    }
}

/// A nonzero entry of a Jacobian.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Entry {
    by_state: bool,
    row: usize,
    column: usize,
}

impl Entry {
    /// The corresponding entry of the old model.
    fn mapped(self, pairing: &Pairing) -> Option<Self> {
        let columns = match self.by_state {
            true => &pairing.states,
            false => &pairing.parameters,
        };
        Some(Self {
            row: (*pairing.states.get(self.row)?)?,
            column: (*columns.get(self.column)?)?,
            ..self
        })
    }

    fn name(self, compiled: &Compiled) -> String {
        let layout = &compiled.layout;
        let columns = match self.by_state {
            true => &layout.states,
            false => &layout.parameters,
        };
        format!(
            "∂der({})/∂{}",
            layout.states[self.row], columns[self.column]
        )
    }
}

fn entries(compiled: &Compiled) -> BTreeSet<Entry> {
    let of = |name, by_state| {
        let pattern = compiled.f_jac_par.pattern(name).iter();
        pattern.map(move |&(row, column)| Entry {
            by_state,
            row: row as usize,
            column: column as usize,
        })
    };
    of("j", true).chain(of("jp", false)).collect()
}

/// Nanoseconds of one evaluation of the derivatives on the tape.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Time {
    /// Median of each model, ns.
    pub nanoseconds: Pair<f64>,
    /// Median of the ratios new/old of neighbouring measurements.
    pub ratio: f64,
}

/// Number of pairs of measurements.
const ROUNDS: usize = 201;
/// Number of points of one measurement.
const POINTS: usize = 64;

/// Measures both models in turns, so that what slows the machine slows both.
pub fn time(old: &Everything<'_>, new: &Everything<'_>, pairing: &Pairing) -> Time {
    let (a, b) = (Values::of(old.model), Values::of(new.model));
    let mut random = Random::new(0, "time");
    let here: Vec<_> = (0..POINTS)
        .map(|_| sample::point(old.model, &mut random))
        .collect();
    let there: Vec<_> = here
        .iter()
        .map(|point| pairing.carry(point, &sample::point(new.model, &mut random)))
        .collect();
    debug_assert!(
        here.iter()
            .all(|p| !parameters(p).is_empty() || p.params.is_empty())
    );
    let measure = |values: &Values, points: &[oracle::Point<f64>]| {
        let start = Instant::now();
        for point in points {
            std::hint::black_box(values.rates(std::hint::black_box(point)));
        }
        start.elapsed().as_secs_f64() * 1e9 / POINTS as f64
    };
    let rounds: Vec<(f64, f64)> = (0..ROUNDS)
        .map(|_| (measure(&a, &here), measure(&b, &there)))
        .collect();
    let median = |value: &dyn Fn(&(f64, f64)) -> f64| {
        let mut values: Vec<f64> = rounds.iter().map(value).collect();
        values.sort_by(f64::total_cmp);
        values[ROUNDS / 2]
    };
    Time {
        nanoseconds: Pair {
            old: median(&|r| r.0),
            new: median(&|r| r.1),
        },
        ratio: median(&|r| r.1 / r.0),
    }
}
