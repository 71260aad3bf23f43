//! Compares the cost of two models: operations, nonzero entries of the Jacobians, computing time of the derivatives.

use super::pairing::Pairing;
use super::values::Everything;
use crate::engine::inputs;
use crate::random::Random;
use crate::sample;
use codegen::Compiled;
use codegen::tape::Tape;
use oracle::Point;
use serde::Serialize;
use std::collections::BTreeSet;
use std::time::Instant;

/// Values of one quantity, such as an operation count, for the old and for the new version of a model.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Pair<T> {
    /// Value of the quantity for the old model.
    pub old: T,
    /// Value of the quantity for the new model.
    pub new: T,
}

/// Operation counts and numbers of nonzero Jacobian entries of the old and the new version of a model.
#[derive(Clone, Debug, Serialize)]
pub struct Cost {
    /// Number of elementary operations of each compiled function: `f` (state derivatives), `f_jac` (with their Jacobian
    /// with respect to the states), `f_jac_par` (also with respect to the parameters).
    pub operations: Vec<(&'static str, Pair<usize>)>,
    /// Number of nonzero entries of J, the Jacobian of the state derivatives with respect to the states.
    pub j: Pair<usize>,
    /// Number of nonzero entries of Jp, the Jacobian of the state derivatives with respect to the parameters.
    pub jp: Pair<usize>,
    /// Jacobian entries that are nonzero only in the new model, each written with the variable names of the new model.
    pub entries_added: Vec<String>,
    /// Jacobian entries that are nonzero only in the old model, each written with the variable names of the old model.
    pub entries_removed: Vec<String>,
}

/// Compiles the old and the new model, and compares the operation counts of their functions and the nonzero entries of
/// their Jacobians.
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

/// A nonzero entry of a Jacobian of a compiled model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Entry {
    by_state: bool,
    row: usize,
    column: usize,
}

impl Entry {
    /// Converts this Jacobian entry of the new model to the corresponding entry of the old model; `None` if its row (a
    /// state derivative) or column (a state or parameter) has no counterpart in the old model.
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

/// Computing time of one evaluation of the state derivatives by the bytecode interpreter.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Time {
    /// Median over the time measurements of the time per evaluation, for the old and for the new model, ns.
    pub nanoseconds: Pair<f64>,
    /// Median, over pairs of successive measurements (old model, new model), of the ratio of the new model's time to
    /// the old model's time.
    pub ratio: f64,
}

/// Number of pairs of measurements (old model, new model) of the computing time.
const ROUNDS: usize = 201;
/// Number of points at which the state derivatives are evaluated in one time measurement.
const POINTS: usize = 64;

/// Measures the computing time of the state derivatives of the old and the new model. The models are measured in
/// alternation, so that a disturbance of the machine affects both.
pub fn time(old: &Everything<'_>, new: &Everything<'_>, pairing: &Pairing) -> Time {
    let mut random = Random::new(0, "time");
    let here = sample::points(old.model, POINTS, &mut random);
    let there = here
        .iter()
        .map(|point| pairing.carry(point, &sample::point(new.model, &mut random)))
        .collect();
    let mut a = Derivatives::new(&codegen::compile(old.model), here);
    let mut b = Derivatives::new(&codegen::compile(new.model), there);
    let rounds: Vec<(f64, f64)> = (0..ROUNDS).map(|_| (a.measure(), b.measure())).collect();
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

/// State derivatives of a model as a program of the bytecode interpreter, with the points for measuring time and the
/// parameter-only values computed in advance for each point.
struct Derivatives {
    tape: Tape,
    points: Vec<(Point<f64>, Vec<f64>, Vec<f64>)>,
    scratch: Vec<f64>,
    out: Vec<f64>,
}

impl Derivatives {
    fn new(compiled: &Compiled, points: Vec<Point<f64>>) -> Self {
        let prepare = Tape::new(&compiled.prepare.program);
        let prepared = |point: Point<f64>| {
            let p = point.parameters();
            let mut out = vec![0.0; prepare.outputs()];
            prepare.eval(inputs(&point, &p, &[]), &mut Vec::new(), &mut out);
            (point, p, out)
        };
        let tape = Tape::new(&compiled.f.program);
        Self {
            points: points.into_iter().map(prepared).collect(),
            scratch: Vec::new(),
            out: vec![0.0; tape.outputs()],
            tape,
        }
    }

    /// Mean computing time of one evaluation of the state derivatives over all points, ns.
    fn measure(&mut self) -> f64 {
        let start = Instant::now();
        for (point, p, prepared) in &self.points {
            let inputs = std::hint::black_box(inputs(point, p, prepared));
            self.tape.eval(inputs, &mut self.scratch, &mut self.out);
            std::hint::black_box(&mut self.out);
        }
        start.elapsed().as_secs_f64() * 1e9 / self.points.len() as f64
    }
}
