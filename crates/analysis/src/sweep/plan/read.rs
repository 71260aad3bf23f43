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

/// Maximum number of flights of a sweep.
pub const MAX_FLIGHTS: u64 = 1 << 40;
/// Maximum number of normally distributed quantities that a sweep varies.
const MAX_NORMAL: usize = 256;
/// Maximum size of a file with a sweep plan, bytes.
const MAX_FILE_BYTES: u64 = 16 << 20;
/// Relative tolerance of the integration if none is specified in the plan; the same as in `hyzer simulate`.
const TOLERANCE: f64 = 1e-6;
/// Keys of a sweep plan that a release file does not have.
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

/// Reads a sweep plan (TOML) from a file; paths in the plan are relative to the folder of the file.
///
/// # Errors
/// [`ReleaseError`] with all faults of the file, or if the file cannot be read.
pub fn read_file(path: &Path) -> Result<Plan, ReleaseError> {
    let folder = path.parent().unwrap_or(Path::new("."));
    read_text(path, "a plan", MAX_FILE_BYTES, |file, text| {
        read(file, text, folder)
    })
}

/// Parses the text of a sweep plan (TOML): a release, with `effects`, `flights`, `seed`, `tolerance`, `method`,
/// `[vary]`, `[[correlations]]` and `[fit]`. Paths in the plan are relative to `folder`; `file` is the plan's name in
/// messages.
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
        let known = Known {
            model: Model::clone(&model),
            vocabulary,
            release,
        };
        plan(&mut reader, document.get_ref(), folder, known)
    });
    reader.finish(file, plan)
}

/// Resolves the name of a model or effect in a sweep plan: the path in the plan's folder if there is such a file,
/// otherwise `name` unchanged.
fn beside(name: &str, folder: &Path) -> String {
    let path: PathBuf = folder.join(name);
    if path.is_file() {
        path.display().to_string()
    } else {
        name.to_owned()
    }
}

/// The names in the list `effects` of a sweep plan, with paths resolved. Items that are not strings are skipped here
/// and reported later.
fn effects(document: &DeTable<'_>, folder: &Path) -> Vec<String> {
    let items = document.get("effects").and_then(|e| e.get_ref().as_array());
    let names = items
        .into_iter()
        .flatten()
        .filter_map(|item| item.get_ref().as_str());
    names.map(|name| beside(name, folder)).collect()
}

/// Parts of a plan that are read before its other keys, because a plan is an extended release file: the model, its
/// vocabulary, and the release.
struct Known {
    model: Model,
    vocabulary: Vocabulary,
    release: Release,
}

fn plan<'t>(
    reader: &mut Reader<'t>,
    document: &DeTable<'t>,
    folder: &Path,
    known: Known,
) -> Option<Plan> {
    let Known {
        model,
        vocabulary,
        mut release,
    } = known;
    if let Some(value) = document.get("effects") {
        let items = value.get_ref().as_array();
        if !items.is_some_and(|items| items.iter().all(|item| item.get_ref().is_str())) {
            reader.wrong_type(value, "effects", "a list of names, as in [\"wind\"]");
        }
    }
    let throw = throw(reader, document);
    let compiled = CompiledModel::new(&model);
    let draws = whole(reader, document, "flights", 1, MAX_FLIGHTS);
    let seed = whole(reader, document, "seed", 0, i64::MAX as u64);
    let options = options(reader, document, &compiled, &release);
    let parameters = compiled.release_parameters(&release);
    let names = Names {
        layout: compiled.layout(),
        vocabulary: &vocabulary,
        release: &release,
        throw: throw.as_ref(),
        parameters: &parameters,
    };
    let (mut axes, gusts) = axes::read(reader, document, &names);
    let (fitted, fixed) = fit::read(reader, document, folder, &names, &axes);
    // Coefficients of a fit that do not vary have their estimates.
    for (name, value) in &fixed {
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
    let is_random = gusts
        || axes
            .iter()
            .any(|axis| !matches!(axis.kind, AxisKind::Values(_)));
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
    })
}

/// Reads the table `[throw]` of a sweep plan, whose values were already checked when the release in the plan was read.
/// `None` if the plan has no such table.
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

/// Reads an integer key of a sweep plan within bounds; `None` if the key is absent, or after a fault, which is reported
/// to `reader`.
fn whole<'t>(
    reader: &mut Reader<'t>,
    document: &DeTable<'t>,
    key: &str,
    least: u64,
    greatest: u64,
) -> Option<u64> {
    let value = document.get(key)?;
    let number = reader.number(value, key)?;
    let is_whole = number.fract() == 0.0 && number >= least as f64 && number <= greatest as f64;
    if !is_whole {
        let message =
            format!("{key} is {number}; expected a whole number from {least} to {greatest}");
        reader.fault(value.span(), message);
        return None;
    }
    Some(number as u64)
}

/// Reads the integration method and tolerance from a sweep plan. Without the key `method`, selects the method that
/// needs fewer evaluations of the right-hand side for the plan's release. `None` after a fault, which is reported to
/// `reader`.
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
                reader.fault(value.span(), message);
                return None;
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
            Some(
                simulate(compiled, release, &options)
                    .ok()?
                    .stats
                    .evaluations,
            )
        };
        let both = evaluations(Method::Tsit5).zip(evaluations(Method::Dop853));
        if let Some((tsit5, dop853)) = both {
            options.method = match tsit5 <= dop853 {
                true => Method::Tsit5,
                false => Method::Dop853,
            };
        }
        return Some(options);
    };
    options.method = match value.get_ref().as_str() {
        Some("tsit5") => Method::Tsit5,
        Some("dop853") => Method::Dop853,
        _ => {
            reader.wrong_type(value, "method", "\"tsit5\" or \"dop853\"");
            return None;
        }
    };
    Some(options)
}

/// Reads `[[correlations]]`, adds the correlations of a fit, and returns the Cholesky factor of the correlation matrix
/// of the normally distributed quantities. `None` after a fault, which is reported to `reader`.
fn correlations<'t>(
    reader: &mut Reader<'t>,
    document: &DeTable<'t>,
    axes: &[Axis],
    fitted: &[(String, String, f64)],
) -> Option<Factor> {
    let normal: Vec<&str> = axes
        .iter()
        .filter(|axis| matches!(axis.kind, AxisKind::Normal { .. }))
        .map(|axis| axis.name.as_str())
        .collect();
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
        reader.wrong_type(given, "correlations", EXPECTED);
        return None;
    };
    for item in items {
        let table = item.get_ref().as_table();
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
        (matrix[i][j], matrix[j][i]) = (number, number);
    }
    factor(reader, given.span(), &matrix)
}

fn factor(
    reader: &mut Reader<'_>,
    span: std::ops::Range<usize>,
    matrix: &[Vec<f64>],
) -> Option<Factor> {
    let factor = Factor::of(matrix);
    if factor.is_none() {
        reader.fault(span, "no distribution has these correlations; expected a matrix without negative eigenvalues");
    }
    factor
}
