//! Parser of plans; it reports all faults of a file at once.

use std::path::{Path, PathBuf};

use flight::release::{Reader, Release, ReleaseError, Vocabulary, read_in_wind, read_text};
use flight::throw::{FIELDS, Throw};
use flight::{CompiledModel, simulate};
use model_spec::load::load;
use model_spec::model::Model;
use ode::{IntegrationOptions, Method};
use toml::de::DeTable;

use super::axes::{self, Axis, AxisKind, Names};
use super::correlation::Factor;
use super::{Plan, fit};

/// Maximum number of flights.
pub const MAX_FLIGHTS: u64 = 1 << 40;
const MAX_NORMAL: usize = 256;
const MAX_FILE_BYTES: u64 = 16 << 20;
/// Relative tolerance if the plan has none; the same as in `hyzer simulate`.
const TOLERANCE: f64 = 1e-6;
/// Keys that a release file does not have.
const OWN_KEYS: [&str; 8] = [
    "effects",
    "flights",
    "seed",
    "tolerance",
    "method",
    "vary",
    "correlations",
    "fit",
];

/// Reads a plan (TOML); paths in it are relative to the folder of the file.
///
/// # Errors
/// [`ReleaseError`] with all faults of the file, or if the file cannot be read.
pub fn read_file(path: &Path) -> Result<Plan, ReleaseError> {
    let folder = path.parent().unwrap_or(Path::new("."));
    read_text(path, "a plan", MAX_FILE_BYTES, |file, text| {
        read(file, text, folder)
    })
}

/// Parses the text of a plan: a release, with `effects`, `flights`, `seed`, `tolerance`, `method`, `[vary]`,
/// `[[correlations]]` and `[fit]`. Paths are relative to `folder`; `file` is the plan's name in messages.
///
/// # Errors
/// [`ReleaseError`] with all faults of the text.
pub fn read(file: &str, text: &str, folder: &Path) -> Result<Plan, ReleaseError> {
    let parsed = DeTable::parse(text).ok();
    let effects = parsed.as_ref().map(|d| effects(d.get_ref(), folder));
    let (release, vocabulary) = read_in_wind(file, text, &OWN_KEYS, |name| {
        let effects = effects.clone().unwrap_or_default();
        let effects: Vec<&str> = effects.iter().map(String::as_str).collect();
        load(&beside(name, folder), &effects).map(|model| Vocabulary::of(&model))
    })?;
    // The model of the vocabulary includes the wind of the plan.
    let model = vocabulary.model.clone();
    let mut reader = Reader::new(text);
    let plan = parsed.zip(model).and_then(|(document, model)| {
        let (reader, document) = (&mut reader, document.get_ref());
        plan(
            reader,
            document,
            folder,
            &vocabulary,
            (Model::clone(&model), release),
        )
    });
    reader.finish(file, plan)
}

/// Path of a model or effect in the plan's folder if there is such a file, otherwise the name itself.
fn beside(name: &str, folder: &Path) -> String {
    let path: PathBuf = folder.join(name);
    if path.is_file() {
        path.display().to_string()
    } else {
        name.to_owned()
    }
}

/// The list `effects`, with paths resolved. Items that are not strings are reported later.
fn effects(document: &DeTable<'_>, folder: &Path) -> Vec<String> {
    let items = document.get("effects").and_then(|e| e.get_ref().as_array());
    let items = items.into_iter().flatten();
    let names = items.filter_map(|item| item.get_ref().as_str());
    names.map(|name| beside(name, folder)).collect()
}

/// Reads the keys of its own; the others are those of a release file.
fn plan<'t>(
    reader: &mut Reader<'t>,
    document: &DeTable<'t>,
    folder: &Path,
    vocabulary: &Vocabulary,
    (model, mut release): (Model, Release),
) -> Option<Plan> {
    if let Some(value) = document.get("effects") {
        let items = value.get_ref().as_array();
        if !items.is_some_and(|items| items.iter().all(|item| item.get_ref().is_str())) {
            reader.wrong_type(value, "effects", "a list of names, as in [\"wind\"]");
        }
    }
    let throw = throw(reader, document);
    let compiled = CompiledModel::new(&model);
    let mut whole = |key, bounds| reader.whole(document.get(key)?, key, bounds);
    let draws = whole("flights", (1, MAX_FLIGHTS));
    let seed = whole("seed", (0, i64::MAX as u64));
    let options = options(reader, document, &compiled, &release);
    let parameters = compiled.release_parameters(&release).constants;
    let names = Names {
        layout: compiled.layout(),
        vocabulary,
        release: &release,
        throw: throw.as_ref(),
        parameters: &parameters,
    };
    let (mut axes, gusts) = axes::read(reader, document, &names);
    let fitted = fit::read(reader, document, folder, &names, &axes).unwrap_or_default();
    // Coefficients of a fit that do not vary have their estimates.
    for (name, value) in &fitted.fixed {
        release = release.with_coefficient(name, *value);
    }
    axes.extend(fitted.axes);
    let factor = correlations(reader, document, &axes, &fitted.correlations)?;
    let mut grid: u64 = 1;
    for axis in &axes {
        if let AxisKind::Values(values) = &axis.kind {
            grid = grid.saturating_mul(values.len() as u64);
        }
    }
    let is_grid = |axis: &Axis| matches!(axis.kind, AxisKind::Values(_));
    let is_random = gusts || !axes.iter().all(is_grid);
    if is_random && draws.is_none() {
        reader.missing("found no number of flights; expected one, as in flights = 10000");
        return None;
    }
    let flights = grid.saturating_mul(draws.unwrap_or(1));
    if flights > MAX_FLIGHTS {
        reader.missing(format!(
            "the grid has {grid} points, with {} flights at each; expected at most {MAX_FLIGHTS} flights",
            draws.unwrap_or(1)
        ));
        return None;
    }
    Some(Plan {
        model,
        release,
        throw,
        axes,
        gusts,
        grid,
        flights,
        seed: seed.unwrap_or(1),
        options: options?,
        factor,
        doubt: fitted.doubt,
    })
}

/// Reads the table `[throw]`, whose values were checked when the release was read.
fn throw<'t>(reader: &mut Reader<'t>, document: &DeTable<'t>) -> Option<Throw> {
    document.get("throw")?;
    let mut throw = Throw::at_speed(0.0);
    for (name, _, value) in reader.table(document, "throw") {
        if FIELDS.iter().any(|(field, ..)| *field == name) {
            throw.set(name, reader.number(value, name)?);
        }
    }
    Some(throw)
}

/// Reads method and tolerance; by default the method that needs fewer evaluations for the release.
fn options<'t>(
    reader: &mut Reader<'t>,
    document: &DeTable<'t>,
    compiled: &CompiledModel,
    release: &Release,
) -> Option<IntegrationOptions> {
    let tolerance = match document.get("tolerance") {
        None => TOLERANCE,
        Some(value) => {
            let tolerance = reader.number(value, "tolerance")?;
            if !(1e-13..=0.1).contains(&tolerance) {
                let message =
                    format!("tolerance is {tolerance}; expected a number from 1e-13 to 0.1");
                return reader.refuse(value.span(), message);
            }
            tolerance
        }
    };
    let mut options = IntegrationOptions::with_tolerance(tolerance);
    let Some(value) = document.get("method") else {
        let evaluations = |method| {
            let options = IntegrationOptions {
                method,
                ..options.clone()
            };
            let flight = simulate(compiled, release, &options).ok()?;
            Some(flight.stats.evaluations)
        };
        let both = evaluations(Method::Tsit5).zip(evaluations(Method::Dop853));
        if let Some((tsit5, dop853)) = both {
            let is_less = tsit5 <= dop853;
            options.method = if is_less {
                Method::Tsit5
            } else {
                Method::Dop853
            };
        }
        return Some(options);
    };
    options.method = match value.get_ref().as_str() {
        Some("tsit5") => Method::Tsit5,
        Some("dop853") => Method::Dop853,
        _ => return reader.refuse_type(value, "method", "\"tsit5\" or \"dop853\""),
    };
    Some(options)
}

/// Reads `[[correlations]]`, adds those of a fit, and factors the matrix of the normal quantities.
fn correlations<'t>(
    reader: &mut Reader<'t>,
    document: &DeTable<'t>,
    axes: &[Axis],
    fitted: &[(String, String, f64)],
) -> Option<Factor> {
    let is_normal = |axis: &&Axis| matches!(axis.kind, AxisKind::Normal { .. });
    let normal = axes.iter().filter(is_normal);
    let normal: Vec<&str> = normal.map(|axis| axis.name.as_str()).collect();
    if normal.len() > MAX_NORMAL {
        reader.missing(format!(
            "found {} normal quantities; expected at most {MAX_NORMAL}",
            normal.len()
        ));
        return None;
    }
    let place = |name: &str| normal.iter().position(|own| *own == name);
    let mut matrix = vec![vec![0.0; normal.len()]; normal.len()];
    for (k, row) in matrix.iter_mut().enumerate() {
        row[k] = 1.0;
    }
    for (a, b, value) in fitted {
        if let (Some(a), Some(b)) = (place(a), place(b)) {
            (matrix[a][b], matrix[b][a]) = (*value, *value);
        }
    }
    let Some(given) = document.get("correlations") else {
        return factor(reader, 0..0, &matrix);
    };
    const EXPECTED: &str =
        "tables, as in [[correlations]] with of = [\"speed\", \"spin\"] and value = 0.5";
    let Some(items) = given.get_ref().as_array() else {
        return reader.refuse_type(given, "correlations", EXPECTED);
    };
    let mut stated = Vec::new();
    for item in items {
        let table = item.get_ref().as_table();
        if let Some(table) = table {
            let keys = ["of", "value"].into_iter();
            reader.known_keys(table, " in [[correlations]]", keys);
        }
        let Some((of, value)) = table.and_then(|t| Some((t.get("of")?, t.get("value")?))) else {
            reader.wrong_type(item, "a correlation", EXPECTED);
            continue;
        };
        let names = of.get_ref().as_array().map(|items| {
            let texts = items.iter().filter_map(|item| item.get_ref().as_str());
            texts.collect::<Vec<&str>>()
        });
        let Some([a, b]) = names.as_deref() else {
            reader.wrong_type(of, "of", "two names, as in [\"speed\", \"spin\"]");
            continue;
        };
        let (Some(i), Some(j)) = (place(a), place(b)) else {
            let message = format!(
                "found a correlation of {a} and {b}; expected two of the normal quantities: {}",
                normal.join(", ")
            );
            reader.fault(of.span(), message);
            continue;
        };
        let Some(number) = reader.number(value, "value") else {
            continue;
        };
        if i == j || number.abs() > 1.0 {
            let message = format!(
                "the correlation of {a} and {b} is {number}; expected that of two quantities, from -1 to 1"
            );
            reader.fault(value.span(), message);
            continue;
        }
        let pair = [i.min(j), i.max(j)];
        if stated.contains(&pair) {
            let message = format!("found a second correlation of {a} and {b}; expected one");
            reader.fault(of.span(), message);
        }
        stated.push(pair);
        (matrix[i][j], matrix[j][i]) = (number, number);
    }
    factor(reader, given.span(), &matrix)
}

fn factor(
    reader: &mut Reader<'_>,
    span: std::ops::Range<usize>,
    matrix: &[Vec<f64>],
) -> Option<Factor> {
    let message =
        "no distribution has these correlations; expected a matrix without negative eigenvalues";
    Factor::of(matrix).or_else(|| reader.refuse(span, message))
}
