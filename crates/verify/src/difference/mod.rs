//! Comparison of two versions of a model: which statements differ, which derivatives remain the same function, the
//! computational cost of the change, and the shift of simulated flights.
//!
//! ```
//! let old = model_spec::load::load("ball", &[]).unwrap();
//! let text = old.sources[0].text.replace("V^2/2", "V^3/2").replace("param m", "param  m");
//! let text = text.replace("C_D;", "C_D/(1 [m/s]);");
//! let new = model_spec::load::from_text("new", &text, &[]).unwrap();
//! let difference = verify::difference::compare(&old, &new, &Default::default());
//! assert!(difference.is_changed());
//! assert_eq!(difference.changed_rows(), ["der(vx)", "der(vy)", "der(vz)"]);
//! ```

mod cost;
mod flights;
mod function;
mod markdown;
mod names;
mod pairing;
mod renaming;
mod restated;
mod rows;
mod statements;
mod text;
mod values;

pub use cost::{Cost, Pair, Time};
pub use flights::FlightShift;
pub use function::Sameness;
pub use pairing::Renamed;
pub use restated::Restated;
pub use statements::{Change, Statement};

use function::Compared;
use model_spec::model::Model;
use pairing::Pairing;
use renaming::{renamed, same_frame, same_named};
use restated::restated;
use serde::Serialize;
use statements::{Key, Reach};
use values::Everything;

/// Options of a comparison of an old and a new version of a model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DifferenceOptions {
    /// Duration, s, of the flights that are simulated with both models and compared.
    pub seconds: f64,
    /// Whether to measure the computing time of the state derivatives.
    pub time: bool,
    /// Whether to compare the operation counts, the Jacobian entries and simulated flights of the models.
    pub consequences: bool,
}

impl Default for DifferenceOptions {
    fn default() -> Self {
        Self {
            seconds: 2.0,
            time: false,
            consequences: true,
        }
    }
}

/// Comparison of one row, that is, one scalar function of the models: a state derivative, a component of the
/// observation, or a validity limit.
#[derive(Clone, Debug, Default, Serialize)]
pub struct RowChange {
    /// Name of the compared scalar function in the new model, or in the old model if it was removed: `der(u)`,
    /// `observation x`, `limit 1`.
    pub row: String,
    /// Result of the comparison; `None` for a scalar function that only one of the models has.
    pub sameness: Option<Sameness>,
    /// Whether only the new model has the compared scalar function.
    pub added: bool,
    /// Maximum difference between the scalar function in the old and in the new model at random points, relative to the
    /// sum of the magnitudes of its terms; 0 for a function that only one of the models has.
    pub error: f64,
    /// Whether the scalar function is the same in both models once each parameter that only one of the models has is
    /// fixed at the default value stated in its model file; false for a function that only one of the models has.
    pub same_at_stated_values: bool,
    /// Statements (added, removed or changed) that cause the difference of the scalar function, each described with the
    /// terms that differ.
    pub causes: Vec<String>,
}

/// Comparison of an old and a new version of a model.
#[derive(Clone, Debug, Serialize)]
pub struct Difference {
    /// Name and version of the JSON format of the comparison.
    pub schema: &'static str,
    /// Names of the old and the new version of the model.
    pub models: Pair<String>,
    /// Whether any state derivative, component of the observation or validity limit differs between the models.
    pub changed: bool,
    /// Comparison of every row (state derivative, component of the observation, validity limit): rows of the new model
    /// in its order, then the rows that only the old model has.
    pub rows: Vec<RowChange>,
    /// States and parameters that have different names in the old and the new model.
    pub renamed: Vec<Renamed>,
    /// Statements that differ between the two model files.
    pub statements: Vec<Statement>,
    /// For each model, the unit errors that the language checker reports for it but not for the other model.
    pub unit_faults: Pair<Vec<String>>,
    /// Units, default values and bounds of constants, inputs and states that differ between the two model files.
    pub restated: Vec<Restated>,
    /// Operation counts and nonzero Jacobian entries of the models; `None` if not requested.
    pub cost: Option<Cost>,
    /// Computing time of the state derivatives of both models; `None` if not requested.
    pub time: Option<Time>,
    /// Differences between simulated flights of the two models; empty if not requested.
    pub flights: Vec<FlightShift>,
}

impl Difference {
    /// Whether any state derivative, component of the observation or validity limit differs between the models.
    pub fn is_changed(&self) -> bool {
        self.changed
    }

    /// Adds the unit errors that the language checker reports for the old and for the new model. Messages common to
    /// both are dropped.
    pub fn with_unit_faults(mut self, old: &[String], new: &[String]) -> Self {
        let only = |list: &[String], other: &[String]| -> Vec<String> {
            let lines = list.iter().filter(|line| !other.contains(line));
            lines.cloned().collect()
        };
        self.unit_faults = Pair {
            old: only(old, new),
            new: only(new, old),
        };
        self
    }

    /// Names of the rows (state derivatives, components of the observation, validity limits) that differ or that only
    /// one of the models has.
    pub fn changed_rows(&self) -> Vec<&str> {
        let rows = self.rows.iter().filter(|row| row.is_changed());
        rows.map(|row| row.row.as_str()).collect()
    }
}

impl RowChange {
    /// Whether the compared scalar function differs between the two models, or only one of the models has it.
    pub fn is_changed(&self) -> bool {
        self.sameness.is_none_or(|s| s == Sameness::Changed)
    }
}

/// Compares the functions, statements and simulated flights of an old and a new version of a model.
pub fn compare(old: &Model, new: &Model, options: &DifferenceOptions) -> Difference {
    let (a, b) = (Everything::of(old), Everything::of(new));
    let pairing = Pairing::of(&a, &b);
    let (names_a, names_b) = (a.rows(), b.rows());
    let pairs = row_pairs(&a, &b, &pairing);
    let compared = function::compare(&a, &b, &pairing, &pairs, false);
    let complete = pairing.is_complete(old, new);
    let stated = match complete {
        true => compared.clone(),
        false => function::compare(&a, &b, &pairing, &pairs, true),
    };
    let names = renamed(&a, &b, &pairing);
    let of_row = |old: usize, new: usize| {
        let at = pairs.iter().position(|&pair| pair == (old, new));
        at.map(|at| !compared[at].is_changed())
    };
    let all_same = !compared.iter().any(|c| c.is_changed());
    let same = |was: &Key, is: &Key| match was.0 {
        "let" | "force" | "moment" => same_named(&a, &b, &pairing, was, is),
        "der" => {
            let old = a.code.layout.states.iter().position(|s| *s == was.1)?;
            let new = b.code.layout.states.iter().position(|s| *s == is.1)?;
            of_row(old, new)
        }
        "constant" | "state" => Some(true),
        "input" => Some(same_frame(old, new, &names, &was.1, &is.1)),
        _ => Some(all_same),
    };
    let statements = statements::compare(&old.tree, &new.tree, &names, &same);
    let reach_a = Reach::of_file(&old.tree, &rows::kinds(old, &names_a));
    let reach_b = Reach::of_file(&new.tree, &rows::kinds(new, &names_b));
    let reached = [&reach_a, &reach_b];
    let results = pairs.iter().zip(compared.iter().zip(&stated));
    let results = results.map(|(&(old, new), (&compared, stated))| ComparedRow {
        old,
        new,
        compared,
        is_same_at_stated_values: !stated.is_changed(),
    });
    let results: Vec<ComparedRow> = results.collect();
    let rows = row_changes([&names_a, &names_b], &results, &statements, reached);
    let (cost, flights) = match options.consequences {
        true => (
            Some(cost::cost(&a, &b, &pairing)),
            flights::shifts(&a, &b, &pairing, options.seconds),
        ),
        false => (None, Vec::new()),
    };
    Difference {
        schema: "hyzer.diff/1",
        models: Pair {
            old: old.name.clone(),
            new: new.name.clone(),
        },
        changed: rows.iter().any(RowChange::is_changed),
        rows,
        renamed: pairing.renamed(&a, &b),
        statements,
        unit_faults: Pair {
            old: Vec::new(),
            new: Vec::new(),
        },
        restated: restated(&a, &b, &pairing),
        cost,
        time: options.time.then(|| cost::time(&a, &b, &pairing)),
        flights,
    }
}

/// Pairs of indices (in the old model, in the new model) of corresponding rows, that is, scalar functions: derivatives
/// of paired states, components of the observation, and validity limits in the order of the files.
fn row_pairs(a: &Everything<'_>, b: &Everything<'_>, pairing: &Pairing) -> Vec<(usize, usize)> {
    let states = pairing.states.iter().enumerate();
    let mut pairs: Vec<(usize, usize)> = states
        .filter_map(|(new, old)| Some(((*old)?, new)))
        .collect();
    let (m, n) = (a.code.layout.states.len(), b.code.layout.states.len());
    let seen = a.code.observed.min(b.code.observed);
    pairs.extend((0..seen).map(|k| (m + k, n + k)));
    let limits = a.code.limits.min(b.code.limits);
    let (m, n) = (m + a.code.observed, n + b.code.observed);
    pairs.extend((0..limits).map(|k| (m + k, n + k)));
    pairs
}

/// Comparison of a row (state derivative, component of the observation or validity limit) that both models have.
struct ComparedRow {
    /// Index, in the old model, of the compared scalar function, such as a state derivative.
    old: usize,
    /// Index, in the new model, of the compared scalar function, such as a state derivative.
    new: usize,
    /// Result of comparing the scalar function of the two models; parameters that only one model has are random.
    compared: Compared,
    /// Whether the scalar functions are the same if parameters that only one model has are set to their default values.
    is_same_at_stated_values: bool,
}

/// Changes of the rows (state derivatives, components of the observation, validity limits) of the new model, followed
/// by the rows that only the old model has. `names` are the names of the rows of the old and of the new model;
/// `compared` are the rows that both have.
fn row_changes(
    names: [&[String]; 2],
    compared: &[ComparedRow],
    statements: &[Statement],
    reach: [&Reach; 2],
) -> Vec<RowChange> {
    let causes = |old: &str, new: &str| {
        let mut all = statements::causes(statements, reach[0], reach[1], old, new);
        all.dedup();
        all
    };
    let mut rows = Vec::new();
    for (new, name) in names[1].iter().enumerate() {
        let row = compared.iter().find(|row| row.new == new);
        let mut change = RowChange {
            row: name.clone(),
            sameness: row.map(|row| row.compared.sameness),
            added: row.is_none(),
            error: row.map_or(0.0, |row| row.compared.error),
            same_at_stated_values: row.is_some_and(|row| row.is_same_at_stated_values),
            causes: Vec::new(),
        };
        if change.is_changed() {
            let old = row.map_or("", |row| names[0][row.old].as_str());
            change.causes = causes(old, name);
        }
        rows.push(change);
    }
    for (old, name) in names[0].iter().enumerate() {
        if compared.iter().all(|row| row.old != old) {
            rows.push(RowChange {
                row: name.clone(),
                causes: causes(name, ""),
                ..RowChange::default()
            });
        }
    }
    rows
}
