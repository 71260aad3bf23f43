//! Models by name or path, with effects switched on.

use std::collections::HashSet;
use std::fmt;
use std::path::Path;

use crate::check::{self, Checked};
use crate::diagnostic::{Diagnostic, Kind, Span, render};
use crate::effect;
use crate::model::{Model, Source};
use crate::suggest;
use crate::syntax::ast::{Effect, File, ItemKind};
use crate::syntax::{self, MAX_SOURCE_BYTES, Parsed};

/// A table of the texts of a folder, by name.
macro_rules! texts {
    ($folder:literal: $($name:literal),*) => {
        &[$(($name, include_str!(concat!("../", $folder, "/", $name, ".hyz")))),*]
    };
}

/// The models that are built in, by name.
pub const MODELS: &[(&str, &str)] =
    texts!("models": "ball", "disc", "disc_appendix", "disc_quaternion", "discus");

/// The effects that are built in, by name.
pub const EFFECTS: &[(&str, &str)] = texts!("effects":
    "added_mass",
    "air_density",
    "buoyancy",
    "clock_rate",
    "constant_pitching_moment",
    "cubic_pitching_moment",
    "drag_by_reynolds",
    "drag_by_spin",
    "drag_crisis",
    "gravity",
    "ground_effect",
    "lift_by_spin",
    "magnus",
    "marker_1_misplaced",
    "marker_2_misplaced",
    "marker_3_misplaced",
    "marker_height",
    "marker_radius",
    "marker_time_offset",
    "mass_imbalance",
    "pitching_moment_by_spin",
    "quadratic_spin_down",
    "roll_damping",
    "rolling_moment_at_low_angle",
    "rolling_moment_by_angle",
    "rolling_moment_by_spin_ratio",
    "scale",
    "side_force_by_spin",
    "side_force_by_spin_and_angle",
    "spin_decay",
    "spin_down_by_angle",
    "spin_down_by_pressure",
    "stall",
    "tilted_vertical",
    "unequal_diametral_inertias",
    "wind",
    "wind_by_height",
    "wind_of_each_flight",
    "zero_lift_drag_angle"
);

/// Models that are wrong on purpose, by name: the checks must refute them.
pub const REFUTED: &[(&str, &str)] = texts!("refuted": "disc_appendix_printed");

/// So many effects of a model's own file are checked before they are switched on.
const MOST_OFFERS: usize = 50;

/// Why there is no model.
#[derive(Clone, Debug)]
pub struct LoadError {
    /// What is wrong in the texts; empty where there is no text.
    pub diagnostics: Vec<Diagnostic>,
    /// The texts.
    pub sources: Vec<Source>,
    /// All of it for people, without colour.
    pub message: String,
}

impl fmt::Display for LoadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.message.trim_end())
    }
}

impl std::error::Error for LoadError {}

impl LoadError {
    fn new(diagnostics: Vec<Diagnostic>, sources: Vec<Source>) -> LoadError {
        let message = render(&diagnostics, &sources, false);
        LoadError {
            diagnostics,
            sources,
            message,
        }
    }

    fn told(message: String) -> LoadError {
        LoadError {
            diagnostics: Vec::new(),
            sources: Vec::new(),
            message,
        }
    }
}

/// What came of loading: as [`Checked`], with the texts.
#[derive(Clone, Debug)]
pub struct Loaded {
    /// The model, where there are no faults or only faults of units.
    pub model: Option<Model>,
    /// The tree, with the effects applied.
    pub file: File,
    /// What is wrong.
    pub diagnostics: Vec<Diagnostic>,
    /// The texts.
    pub sources: Vec<Source>,
}

/// Loads a model that is right in every respect. A path wins over a built-in name; `with` names effects to
/// switch on, from the model's own file, from the built-in ones or by path.
pub fn load(name_or_path: &str, with: &[&str]) -> Result<Model, LoadError> {
    let (name, text) = text_of_model(name_or_path)?;
    from_text(&name, &text, with)
}

/// As [`load`], for a text that is at hand.
pub fn from_text(name: &str, text: &str, with: &[&str]) -> Result<Model, LoadError> {
    let loaded = inspect_text(name, text, with)?;
    match loaded.model {
        Some(model) if loaded.diagnostics.is_empty() => Ok(model),
        _ => Err(LoadError::new(loaded.diagnostics, loaded.sources)),
    }
}

/// Loads a model and everything that is wrong with it; an error only where there is no text to speak of.
/// Models that are refuted on purpose are found by name too.
pub fn inspect(name_or_path: &str, with: &[&str]) -> Result<Loaded, LoadError> {
    let (name, text) = text_of_model(name_or_path)?;
    inspect_text(&name, &text, with)
}

/// As [`inspect`], for a text that is at hand.
pub fn inspect_text(name: &str, text: &str, with: &[&str]) -> Result<Loaded, LoadError> {
    let Parsed {
        mut file,
        source,
        mut diagnostics,
    } = syntax::parse(name, text);
    let mut sources = vec![source];
    for wanted in with {
        let effect = match find_effect(wanted, &file, &mut sources) {
            Ok(effect) => effect,
            Err(faults) => {
                diagnostics.extend(faults);
                return Err(LoadError::new(diagnostics, sources));
            }
        };
        let effect = effect.ok_or_else(|| no_effect(wanted, &file))?;
        match effect::apply(&file, &effect) {
            Ok(changed) => file = changed,
            Err(faults) => diagnostics.extend(faults),
        }
    }
    // A tree with holes would be reported a second time for what is missing from it.
    if !diagnostics.is_empty() {
        return Ok(Loaded {
            model: None,
            file,
            diagnostics,
            sources,
        });
    }
    let Checked {
        model,
        mut diagnostics,
    } = check::check(&file, &sources);
    if diagnostics.is_empty() {
        diagnostics = faults_of_offers(&file, &sources);
    }
    Ok(Loaded {
        model,
        file,
        diagnostics,
        sources,
    })
}

/// Faults of the effects that a model's own file offers, each switched on alone.
fn faults_of_offers(file: &File, sources: &[Source]) -> Vec<Diagnostic> {
    let model = file.items.iter().find_map(|i| match &i.kind {
        ItemKind::Model(name) => Some(name.text.as_str()),
        _ => None,
    });
    let mut diagnostics = Vec::new();
    let mut seen: HashSet<&str> = HashSet::new();
    for offered in effects_of(file) {
        let name = &offered.name;
        if !seen.insert(&name.text) {
            let message = format!("there are two effects `{}`", name.text);
            diagnostics.push(
                Diagnostic::new(Kind::Duplicate, name.span, message).help("rename one of them"),
            );
            continue;
        }
        let applied = file.applied.iter().any(|a| a.name.text == name.text);
        let elsewhere =
            !offered.on.is_empty() && offered.on.iter().all(|on| Some(on.text.as_str()) != model);
        // Every effect is checked on the whole model; a file with very many is taken at its word.
        if applied || elsewhere || seen.len() > MOST_OFFERS {
            continue;
        }
        match effect::apply(file, offered) {
            Ok(changed) => diagnostics.extend(check::check(&changed, sources).diagnostics),
            Err(faults) => diagnostics.extend(faults),
        }
    }
    diagnostics.sort_by_key(|d| d.span);
    diagnostics
}

/// Name and text of a model.
fn text_of_model(name_or_path: &str) -> Result<(String, String), LoadError> {
    if Path::new(name_or_path).is_file() {
        return Ok((name_or_path.to_owned(), read(name_or_path)?));
    }
    let name = name_or_path.replace('-', "_");
    if let Some((name, text)) = MODELS.iter().chain(REFUTED).find(|(n, _)| *n == name) {
        return Ok((format!("{name}.hyz"), (*text).to_owned()));
    }
    if Path::new(name_or_path).exists() {
        return Err(LoadError::told(format!(
            "`{name_or_path}` is a folder, not a model file"
        )));
    }
    let names: Vec<&str> = MODELS.iter().map(|m| m.0).collect();
    let mut message =
        format!("there is no model `{name_or_path}`: no such file, and no such model is built in");
    if let Some(near) = suggest::nearest(&name, names.iter().copied()) {
        message += &format!("\ndid you mean `{near}`?");
    }
    message += &format!("\nbuilt in are {}", names.join(", "));
    Err(LoadError::told(message))
}

/// The text of a file, which must be UTF-8 and of a sensible length.
fn read(path: &str) -> Result<String, LoadError> {
    let told = |e: std::io::Error| LoadError::told(format!("`{path}` cannot be read: {e}"));
    let length = std::fs::metadata(path).map_err(told)?.len();
    if length > MAX_SOURCE_BYTES as u64 {
        let parsed = syntax::too_long(path, usize::try_from(length).unwrap_or(usize::MAX), 0);
        return Err(LoadError::new(parsed.diagnostics, vec![parsed.source]));
    }
    let bytes = std::fs::read(path).map_err(told)?;
    decode(path, bytes)
}

/// Bytes as text; a fault with its place where they are none.
pub fn decode(name: &str, bytes: Vec<u8>) -> Result<String, LoadError> {
    let error = match String::from_utf8(bytes) {
        Ok(text) => return Ok(text),
        Err(error) => error,
    };
    let at = error.utf8_error().valid_up_to();
    let bytes = error.as_bytes();
    let line = bytes[..at].iter().filter(|&&b| b == b'\n').count() + 1;
    let start = bytes[..at]
        .iter()
        .rposition(|&b| b == b'\n')
        .map_or(0, |i| i + 1);
    let column = String::from_utf8_lossy(&bytes[start..at]).chars().count() + 1;
    let message = format!(
        "the file is not UTF-8: byte {at} (0x{:02X}), line {line} column {column}, begins no character",
        bytes[at]
    );
    let mut fault =
        Diagnostic::new(Kind::Lexical, Span::default(), message).help("save the file as UTF-8");
    fault.notes = match bytes[..at.min(2)] {
        [] if bytes.starts_with(&[0xFF, 0xFE]) || bytes.starts_with(&[0xFE, 0xFF]) => {
            vec!["it begins like a file in UTF-16".to_owned()]
        }
        _ => Vec::new(),
    };
    let source = Source {
        name: name.to_owned(),
        text: String::new(),
    };
    Err(LoadError::new(vec![fault], vec![source]))
}

/// The effect of a name or path, its text added to the sources.
fn find_effect(
    wanted: &str,
    file: &File,
    sources: &mut Vec<Source>,
) -> Result<Option<Effect>, Vec<Diagnostic>> {
    let name = wanted.replace('-', "_");
    let is_path = Path::new(wanted).is_file();
    if !is_path && let Some(effect) = effects_of(file).find(|e| e.name.text == name) {
        return Ok(Some(effect.clone()));
    }
    let index = u16::try_from(sources.len()).unwrap_or(u16::MAX);
    let parsed = if is_path {
        match read(wanted) {
            Ok(text) => syntax::parse_as(wanted, &text, index),
            Err(error) => {
                // The fault of another text takes its place among the sources.
                let mut faults = error.diagnostics;
                faults.iter_mut().for_each(|f| f.span.source = index);
                sources.push(Source {
                    name: wanted.to_owned(),
                    text: String::new(),
                });
                return Err(faults);
            }
        }
    } else if let Some((name, text)) = EFFECTS.iter().find(|(n, _)| *n == name) {
        syntax::parse_as(&format!("{name}.hyz"), text, index)
    } else {
        return Ok(None);
    };
    sources.push(parsed.source);
    if !parsed.diagnostics.is_empty() {
        return Err(parsed.diagnostics);
    }
    let mut found: Vec<&Effect> = effects_of(&parsed.file).collect();
    if found.len() > 1 {
        found.retain(|e| e.name.text == name);
    }
    match found.first() {
        Some(effect) => Ok(Some((*effect).clone())),
        None => Err(vec![
            Diagnostic::new(Kind::Missing, parsed.file.end, "the file has no effect")
                .help("write `effect NAME { … }`"),
        ]),
    }
}

fn effects_of(file: &File) -> impl Iterator<Item = &Effect> {
    file.items.iter().filter_map(|i| match &i.kind {
        ItemKind::Effect(effect) => Some(effect),
        _ => None,
    })
}

fn no_effect(wanted: &str, file: &File) -> LoadError {
    let name = wanted.replace('-', "_");
    let own = effects_of(file).map(|e| e.name.text.as_str());
    let names: Vec<&str> = own.chain(EFFECTS.iter().map(|e| e.0)).collect();
    let mut message = format!(
        "there is no effect `{wanted}`: not in the model, not among the built-in ones, and no such file"
    );
    if let Some(near) = suggest::nearest(&name, names.iter().copied()) {
        message += &format!("\ndid you mean `{near}`?");
    }
    if !names.is_empty() {
        message += &format!("\nknown are {}", names.join(", "));
    }
    LoadError::told(message)
}
