//! Quantities that vary in a sweep: the table `[vary]` of a plan.

use std::collections::BTreeSet;

use flight::release::{Name, Reader, Release, Value, Vocabulary, suggestion};
use flight::throw::{FIELDS, Throw};
use model_spec::layout::Layout;
use toml::de::DeTable;

/// Key in `[vary]` that requests different random gusts in every flight.
const GUSTS: &str = "gusts";
/// Maximum number of grid values of one quantity.
const MAX_VALUES: usize = 1_000_000;

/// A quantity that varies from flight to flight.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// Name of the quantity in the plan, and of its column in the table of flights.
    pub name: String,
    /// Input that the quantity sets.
    pub target: Target,
    /// Grid values or probability distribution.
    pub kind: AxisKind,
}

/// Input of a flight that a varied quantity sets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// Quantity of the throw, by its index in [`FIELDS`].
    Throw(usize),
    /// Initial state, by its index in the state vector.
    State(usize),
    /// Parameter, coefficient or component of an input, by its index among the parameters of the compiled model.
    Parameter(usize),
}

/// Grid values or probability distribution of a varied quantity.
#[derive(Clone, Debug, PartialEq)]
pub enum AxisKind {
    /// Grid: the sweep includes every combination of the values of all grid quantities.
    Values(Vec<f64>),
    /// Normal distribution.
    Normal {
        /// Mean.
        mean: f64,
        /// Standard deviation.
        sd: f64,
    },
    /// Uniform distribution.
    Uniform {
        /// Lower bound.
        low: f64,
        /// Upper bound.
        high: f64,
    },
}

/// Reason why a name in a plan denotes no input of a flight.
#[derive(Debug, thiserror::Error)]
enum NameError {
    #[error("found nothing called {name:?} to vary{hint}")]
    Unknown { name: String, hint: String },
    #[error(
        "{0} is both a number of the throw and a parameter of the model; expected a plan by [initial] to vary the parameter"
    )]
    Ambiguous(String),
    #[error("{0}")]
    Overruled(String),
}

/// What names of a plan are looked up in.
pub(super) struct Names<'a> {
    pub layout: &'a Layout,
    pub vocabulary: &'a Vocabulary,
    pub release: &'a Release,
    pub throw: Option<&'a Throw>,
    /// Parameter values of the release, in the order of the compiled model.
    pub parameters: &'a [f64],
}

impl Names<'_> {
    /// Input that a name denotes, and its value in the plan's throw or release.
    fn find(&self, name: &str) -> Result<(Target, f64), NameError> {
        if let Some(why) = self.release.overruled(name) {
            return Err(NameError::Overruled(why));
        }
        let mut found = Vec::new();
        if let Some(throw) = self.throw {
            if let Some(index) = FIELDS.iter().position(|(field, ..)| *field == name) {
                let own = throw.field(name).unwrap_or(0.0);
                found.push((Target::Throw(index), own));
            }
        } else if let Some(state) = self.layout.state(name) {
            let own = self.release.initial[state.index()].1;
            found.push((Target::State(state.index()), own));
        }
        if let Some(parameter) = self.layout.parameter(name) {
            let own = self.parameters[parameter.index()];
            found.push((Target::Parameter(parameter.index()), own));
        }
        match found[..] {
            [one] => Ok(one),
            [] => {
                let names = self.all();
                let hint = suggestion(name, names.iter().map(String::as_str));
                Err(NameError::Unknown {
                    name: name.to_owned(),
                    hint,
                })
            }
            _ => Err(NameError::Ambiguous(name.to_owned())),
        }
    }

    fn all(&self) -> Vec<String> {
        let throw = FIELDS.iter().map(|(field, ..)| (*field).to_owned());
        let states = self.vocabulary.states.iter().cloned();
        let first: Vec<String> = match self.throw {
            Some(_) => throw.collect(),
            None => states.collect(),
        };
        // The phases of gusts vary together, by `gusts = true`.
        let parameters = self.layout.parameters.iter().cloned();
        let parameters = parameters.filter(|name| !name.starts_with("gust_phase_"));
        first.into_iter().chain(parameters).collect()
    }

    /// Index of a parameter or coefficient in the layout.
    pub(super) fn parameter(&self, name: &str) -> Option<usize> {
        let parameter = self.layout.parameter(name);
        parameter.map(codegen::layout::ParamId::index)
    }

    /// Description of the valid values of a varied quantity if `value` is invalid.
    fn expected_instead_of(&self, name: &str, target: Target, value: f64) -> Option<String> {
        match target {
            Target::Throw(index) => {
                let (_, unit, least, greatest) = FIELDS[index];
                let is_speed = name == "speed" && value <= 0.0;
                let is_out = !(least..=greatest).contains(&value) || is_speed;
                is_out
                    .then(|| format!("a number from {least} to {greatest} {unit}, a speed above 0"))
            }
            Target::State(_) => None,
            Target::Parameter(_) => {
                constant(self.vocabulary, name).and_then(|known| known.expected_instead_of(value))
            }
        }
    }
}

/// Parameter or coefficient of this name, with its bounds.
pub(crate) fn constant<'v>(vocabulary: &'v Vocabulary, name: &str) -> Option<&'v Name> {
    let constants = vocabulary.parameters.iter().chain(&vocabulary.coefficients);
    constants.into_iter().find(|known| known.name == name)
}

/// Reads the table `[vary]`: varied quantities, and whether every flight has gusts of its own.
pub(super) fn read<'t>(
    reader: &mut Reader<'t>,
    document: &DeTable<'t>,
    names: &Names<'_>,
) -> (Vec<Axis>, bool) {
    let mut gusts = false;
    let mut entries = reader.table(document, "vary");
    entries.sort_by_key(|(_, span, _)| span.start);
    let mut axes: Vec<Axis> = Vec::new();
    let mut targets = BTreeSet::new();
    for (name, span, value) in entries {
        if name == GUSTS && names.layout.parameter(GUSTS).is_none() {
            gusts = own_gusts(reader, names, span, value);
            continue;
        }
        let (target, own) = match names.find(name) {
            Ok(found) => found,
            Err(error) => {
                reader.fault(span, error.to_string());
                continue;
            }
        };
        if !targets.insert(format!("{target:?}")) {
            continue;
        }
        let Some(kind) = kind(reader, name, own, value) else {
            continue;
        };
        let extremes = match &kind {
            AxisKind::Values(values) => values.clone(),
            AxisKind::Normal { mean, .. } => vec![*mean],
            AxisKind::Uniform { low, high } => vec![*low, *high],
        };
        let invalid = extremes.into_iter().find_map(|x| {
            let expected = names.expected_instead_of(name, target, x)?;
            Some(format!("{name} would be {x}; expected {expected}"))
        });
        match invalid {
            Some(message) => reader.fault(value.span(), message),
            None => axes.push(Axis {
                name: name.to_owned(),
                target,
                kind,
            }),
        }
    }
    (axes, gusts)
}

/// Reads the key `gusts` of `[vary]`; `false` after a fault.
fn own_gusts<'t>(
    reader: &mut Reader<'t>,
    names: &Names<'_>,
    span: std::ops::Range<usize>,
    value: &Value<'t>,
) -> bool {
    let field = names.release.wind_field.as_ref();
    if field.is_none_or(|field| field.gusts.is_none()) {
        let message = "found gusts to vary and no [wind.gusts]; expected them";
        reader.fault(span, message);
        return false;
    }
    let Some(varies) = value.get_ref().as_bool() else {
        reader.wrong_type(value, GUSTS, "true, for gusts of its own in every flight");
        return false;
    };
    varies
}

/// Reads how a quantity varies; with `sd` the mean is `own`, its value in the throw or release.
fn kind<'t>(reader: &mut Reader<'t>, name: &str, own: f64, value: &Value<'t>) -> Option<AxisKind> {
    const EXPECTED: &str = "a table, as in { values = [1.0, 2.0] }, { range = [0.0, 1.0], count = 5 }, { normal = [0.0, 1.0] }, \
         { sd = 1.0 } or { uniform = [0.0, 1.0] }";
    let Some(table) = value.get_ref().as_table() else {
        return reader.refuse_type(value, name, EXPECTED);
    };
    let keys = ["values", "range", "count", "normal", "sd", "uniform"];
    reader.known_keys(table, &format!(" for {name}"), keys.into_iter());
    let ways = ["values", "range", "normal", "sd", "uniform"];
    let given = ways.into_iter().filter(|way| table.contains_key(*way));
    let given: Vec<&str> = given.collect();
    let [way] = given[..] else {
        let found = match given.is_empty() {
            true => "nothing".to_owned(),
            false => given.join(" and "),
        };
        let message = format!("{name} has {found}; expected one of {}", ways.join(", "));
        return reader.refuse(value.span(), message);
    };
    let given = table.get(way)?;
    if let Some(count) = table.get("count").filter(|_| way != "range") {
        let message = format!("found count with {way}; expected it only with range");
        return reader.refuse(count.span(), message);
    }
    match way {
        "values" => list(reader, name, given, 1..=MAX_VALUES).map(AxisKind::Values),
        "range" => {
            let ends = list(reader, name, given, 2..=2)?;
            let Some(count_value) = table.get("count") else {
                let message = format!("found no count with the range of {name}");
                return reader.refuse(given.span(), message);
            };
            let count = reader.whole(count_value, "count", (2, MAX_VALUES as u64))?;
            let last = (count - 1) as f64;
            let at = |k: u64| {
                let k = k as f64;
                (ends[0] * (last - k) + ends[1] * k) / last
            };
            Some(AxisKind::Values((0..count).map(at).collect()))
        }
        "uniform" => {
            let ends = list(reader, name, given, 2..=2)?;
            let (low, high) = (ends[0], ends[1]);
            if low >= high {
                let message = format!(
                    "{name} is uniform from {low} to {high}; expected the lower bound first"
                );
                return reader.refuse(given.span(), message);
            }
            Some(AxisKind::Uniform { low, high })
        }
        _ => {
            let (mean, sd) = match way {
                "normal" => {
                    let both = list(reader, name, given, 2..=2)?;
                    (both[0], both[1])
                }
                _ => (own, reader.number(given, "sd")?),
            };
            if sd <= 0.0 {
                let message =
                    format!("the standard deviation of {name} is {sd}; expected a number above 0");
                return reader.refuse(given.span(), message);
            }
            Some(AxisKind::Normal { mean, sd })
        }
    }
}

/// Reads a list of finite numbers whose length is in `lens`; `None` after a fault.
fn list<'t>(
    reader: &mut Reader<'t>,
    name: &str,
    value: &Value<'t>,
    lens: std::ops::RangeInclusive<usize>,
) -> Option<Vec<f64>> {
    let items = value.get_ref().as_array();
    let Some(items) = items.filter(|items| lens.contains(&items.len())) else {
        let expected = match lens.end() {
            2 => "two numbers, as in [0.0, 1.0]".to_owned(),
            most => format!("a list of 1 to {most} numbers"),
        };
        return reader.refuse_type(value, name, &expected);
    };
    items.iter().map(|item| reader.number(item, name)).collect()
}
