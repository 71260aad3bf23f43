//! Comparison of two versions of a model: which statements differ, which derivatives remain the same function, the
//! operations of the generated code, and where named releases land. States, parameters and inputs correspond by name.
//!
//! ```
//! let old = model_spec::load::load("ball", &[]).unwrap();
//! let text = old.sources[0].text.replace("V^2/2", "V^3/2").replace("param m", "param  m");
//! let text = text.replace("C_D;", "C_D/(1 [m/s]);");
//! let new = model_spec::load::from_text("new", &text, &[]).unwrap();
//! let difference = verify::difference::compare(&old, &new);
//! assert!(difference.is_changed());
//! assert_eq!(difference.changed_rows(), ["der(vx)", "der(vy)", "der(vz)"]);
//! ```

pub(crate) mod function;
mod landings;
mod reach;
mod statements;
mod terms;
mod text;
pub(crate) mod values;

pub use function::Sameness;
pub use landings::{End, Flown, Landing, LandingError, landing, landing_of_text};
pub use statements::{Change, Statement};

use function::Compared;
use model_spec::model::Model;
use reach::Reach;
use serde::Serialize;
use statements::Key;
use std::collections::BTreeMap;
use values::Everything;

/// A quantity of the old and of the new version of a model.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Pair<T> {
    /// Value of the quantity for the old model.
    pub old: T,
    /// Value of the quantity for the new model.
    pub new: T,
}

/// Comparison of a row: a state derivative, a component of the observation, or a validity limit.
#[derive(Clone, Debug, Default, Serialize)]
pub struct RowChange {
    /// Name of the row: `der(u)`, `observation x`, `limit 1`.
    pub row: String,
    /// Result of the comparison; `None` for a row of one model only.
    pub sameness: Option<Sameness>,
    /// Whether only the new model has the row.
    pub added: bool,
    /// Maximum difference, relative to the sum of the magnitudes of the terms; 0 for a row of one model only.
    pub error: f64,
    /// Statements that cause the difference, each with the terms that differ.
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
    /// Comparison of every row: rows of the new model in its order, then the rows that only the old model has.
    pub rows: Vec<RowChange>,
    /// Statements that differ between the two model files.
    pub statements: Vec<Statement>,
    /// Unit errors of only one of the models; empty in the result of [`compare`].
    pub unit_faults: Pair<Vec<String>>,
    /// Operations of the generated code, see [`operations`]; empty in the result of [`compare`].
    pub operations: BTreeMap<&'static str, Pair<usize>>,
    /// Ends of the flights from named releases, see [`landing`]; empty in the result of [`compare`].
    pub landings: Vec<Landing>,
}

impl Difference {
    /// Whether any state derivative, component of the observation or validity limit differs between the models.
    pub fn is_changed(&self) -> bool {
        self.changed
    }

    /// Sets the unit errors of both models; common messages are dropped.
    pub fn set_unit_faults(&mut self, old: &[String], new: &[String]) {
        let only = |list: &[String], other: &[String]| -> Vec<String> {
            let lines = list.iter().filter(|line| !other.contains(line));
            lines.cloned().collect()
        };
        self.unit_faults = Pair {
            old: only(old, new),
            new: only(new, old),
        };
    }

    /// Names of the rows that differ or that only one of the models has.
    pub fn changed_rows(&self) -> Vec<&str> {
        let rows = self.rows.iter().filter(|row| row.is_changed());
        rows.map(|row| row.row.as_str()).collect()
    }
}

impl RowChange {
    /// Whether the row differs, or only one of the models has it.
    pub fn is_changed(&self) -> bool {
        self.sameness.is_none_or(|s| s == Sameness::Changed)
    }
}

/// Compares the functions and statements of an old and a new version of a model.
pub fn compare(old: &Model, new: &Model) -> Difference {
    let (a, b) = (Everything::of(old), Everything::of(new));
    let compared = function::compare(&a, &b);
    let mut rows: Vec<RowChange> = b
        .rows()
        .into_iter()
        .map(|row| of_row(row, &compared))
        .collect();
    let removed = a.rows().into_iter().filter(|row| !b.rows().contains(row));
    rows.extend(removed.map(|row| RowChange {
        row,
        ..RowChange::default()
    }));
    let all_same = !compared.values().any(|c| c.is_changed());
    let is_same = |key: &Key| match key.0 {
        "let" | "force" | "moment" | "der" => {
            let compared = compared.get(&statements::title(key))?;
            Some(!compared.is_changed())
        }
        "constant" | "state" => Some(true),
        "input" => Some(all_same || has_same_frame(old, new, &key.1)),
        _ => Some(all_same),
    };
    let statements = statements::compare(&old.tree, &new.tree, &is_same);
    let reach = [Reach::of(old, &a.rows()), Reach::of(new, &b.rows())];
    for row in rows.iter_mut().filter(|row| row.is_changed()) {
        row.causes = reach::causes(&statements, &reach, &row.row);
    }
    Difference {
        schema: "hyzer.diff/2",
        models: Pair {
            old: old.name.clone(),
            new: new.name.clone(),
        },
        changed: rows.iter().any(RowChange::is_changed),
        rows,
        statements,
        unit_faults: Pair::default(),
        operations: BTreeMap::new(),
        landings: Vec::new(),
    }
}

/// Comparison of the row `row` of the new model, without its causes.
fn of_row(row: String, compared: &BTreeMap<String, Compared>) -> RowChange {
    let found = compared.get(&row);
    RowChange {
        sameness: found.map(|compared| compared.sameness),
        added: found.is_none(),
        error: found.map_or(0.0, |compared| compared.error),
        causes: Vec::new(),
        row,
    }
}

/// Whether an input has its components in frames of the same name in both models.
fn has_same_frame(old: &Model, new: &Model, name: &str) -> bool {
    let frame = |model: &Model| {
        let input = model.inputs.iter().find(|input| input.name == name)?;
        Some(model.frames[input.frame].name.clone())
    };
    frame(old) == frame(new)
}

/// Numbers of elementary operations of `f`, `f_jac` and `f_jac_par`, in both models.
pub fn operations(old: &Model, new: &Model) -> BTreeMap<&'static str, Pair<usize>> {
    let (a, b) = (codegen::compile(old), codegen::compile(new));
    let count = |name| {
        let pair = Pair {
            old: a.count(name).total(),
            new: b.count(name).total(),
        };
        (name, pair)
    };
    ["f", "f_jac", "f_jac_par"].map(count).into()
}
