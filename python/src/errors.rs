//! Errors as Python exceptions, with their place and hint; the classes are in `hyzer/_errors.py`.

use std::ffi::CString;

use analysis::design::DesignError;
use analysis::sweep::SweepError;
use anyhow::Error;
use dataset::InputError;
use dataset::synthesize::SynthesisError;
use dataset::takes::{Location, TakeError};
use diagnose::DiagnosisError;
use flight::files::ResultFolderError;
use flight::release::ReleaseError;
use identify::FitError;
use model_spec::LoadError;
use model_spec::diagnostic::{Diagnostic, Source};
use model_spec::location::line_and_column;
use pyo3::exceptions::PyUserWarning;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Where an error is: file, line and column, from 1.
type Place = (Option<String>, Option<(usize, usize)>);

/// What an exception has besides its message.
struct About {
    class: &'static str,
    place: Place,
    hint: Option<String>,
    faults: Vec<(Place, String, Option<String>)>,
}

impl About {
    fn of(class: &'static str) -> About {
        About {
            class,
            place: (None, None),
            hint: None,
            faults: Vec::new(),
        }
    }

    fn with_faults(mut self, faults: Vec<(Place, String, Option<String>)>) -> About {
        if let Some((place, _, hint)) = faults.first() {
            (self.place, self.hint) = (place.clone(), hint.clone());
        }
        self.faults = faults;
        self
    }
}

/// The exception for an error of the library.
pub fn raise(error: impl Into<Error>) -> PyErr {
    raise_or("Error", error)
}

/// The exception for an error of the library; of the class `class` where the error says no other.
pub fn raise_or(class: &'static str, error: impl Into<Error>) -> PyErr {
    let error = error.into();
    let text = hyzer::program::chain(&error);
    let known = error.chain().find_map(about);
    build(known.unwrap_or_else(|| About::of(class)), &text)
}

/// Options of the program in its messages, with the keyword arguments that stand for them.
const KEYWORDS: [(&str, &str); 27] = [
    ("centre-height", "centre_height="),
    ("fit", "fit="),
    ("format", "format="),
    ("free", "free="),
    ("held-out", "held_out="),
    ("hold", "fixed="),
    ("label", "labels="),
    ("left-handed", "left_handed=True"),
    ("length", "length="),
    ("markers", "markers="),
    ("max-seconds", "max_seconds="),
    ("model", "model="),
    ("noise-ar1", "noise_ar1="),
    ("noise-sigma", "noise_sigma="),
    ("out", "out="),
    ("outlier-size", "outlier_size="),
    ("prior", "priors="),
    ("profile", "profiles="),
    ("rate", "rate="),
    ("target", "target="),
    ("threads", "threads="),
    ("time", "time="),
    ("trust-data", "trust_data=True"),
    ("unbounded", "unbounded=True"),
    ("up", "up="),
    ("wind", "wind="),
    ("without", "without="),
];

/// A text with keyword arguments in place of options of the program: `length=` for `the option --length`, `up='+z'` for
/// `--up +z`, `noise_sigma:` for `noise-sigma:` at its beginning.
pub fn with_keywords(text: &str) -> String {
    let keyword = |option: &str| KEYWORDS.iter().find(|(own, _)| *own == option);
    let mut parts = text.split("--");
    let first = parts.next().unwrap_or_default();
    let mut named = match first.split_once(": ") {
        Some((option, rest)) if option.contains('-') && keyword(option).is_some() => {
            format!("{}: {rest}", option.replace('-', "_"))
        }
        _ => first.to_owned(),
    };
    for part in parts {
        let end = part.find(|c: char| !(c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-'));
        let (option, rest) = part.split_at(end.unwrap_or(part.len()));
        let Some((_, keyword)) = keyword(option) else {
            named += "--";
            named += part;
            continue;
        };
        for words in ["the option ", "option "] {
            named.truncate(named.strip_suffix(words).unwrap_or(&named).len());
        }
        let axis = rest
            .get(1..3)
            .filter(|axis| option == "up" && axis.starts_with(['+', '-']));
        named += &match axis {
            Some(axis) => format!("up='{axis}'{}", &rest[3..]),
            None if rest.starts_with(':') => format!("{}{rest}", keyword.trim_end_matches('=')),
            None => format!("{keyword}{rest}"),
        };
    }
    named
}

/// Options of a dict that Python states; a wrong one is named as the argument that it is.
pub fn options<'py, T: FromPyObjectOwned<'py>>(from: &Bound<'py, PyAny>) -> PyResult<T> {
    from.extract::<T>().map_err(|error| {
        let error: PyErr = error.into();
        let text = error.value(from.py()).to_string();
        let Some((_, name)) = text.rsplit_once('.') else {
            return error;
        };
        let found = from.get_item(name).and_then(|found| found.repr());
        let found = found.map_or_else(|_| "?".into(), |found| found.to_string());
        let why = error
            .cause(from.py())
            .map(|why| why.value(from.py()).to_string());
        let why = why.unwrap_or_else(|| text.clone());
        input(format!("{name} is {found}: {why}"))
    })
}

/// Warns of what the caller may not expect.
pub fn warn(py: Python<'_>, notes: &[String]) -> PyResult<()> {
    let class = py.get_type::<PyUserWarning>();
    for note in notes {
        let text = CString::new(note.as_str()).unwrap_or_default();
        PyErr::warn(py, &class, &text, 2)?;
    }
    Ok(())
}

/// The exception `InputError` for an argument: what was found and what was expected.
pub fn input(text: impl AsRef<str>) -> PyErr {
    build(About::of("InputError"), text.as_ref())
}

/// An exception of a class of `hyzer._errors`, without a place.
pub fn of_class(class: &'static str, text: &str) -> PyErr {
    build(About::of(class), text)
}

fn build(mut about: About, text: &str) -> PyErr {
    let text = &with_keywords(text);
    // Messages say what was expected last.
    let expected = text.rsplit_once(", expected ");
    about.hint = about
        .hint
        .or_else(|| Some(format!("expected {}", expected?.1)));
    Python::attach(|py| exception(py, about, text).unwrap_or_else(|error| error))
}

fn exception(py: Python<'_>, about: About, text: &str) -> PyResult<PyErr> {
    let class = py.import("hyzer._errors")?.getattr(about.class)?;
    let value = class.call1((text,))?;
    let (file, at) = about.place;
    value.setattr("file", file)?;
    value.setattr("line", at.map(|at| at.0))?;
    value.setattr("column", at.map(|at| at.1))?;
    value.setattr("hint", about.hint)?;
    let faults = about.faults.into_iter().map(|((file, at), message, hint)| {
        let fault = PyDict::new(py);
        fault.set_item("message", message)?;
        fault.set_item("file", file)?;
        fault.set_item("line", at.map(|at| at.0))?;
        fault.set_item("column", at.map(|at| at.1))?;
        fault.set_item("hint", hint)?;
        Ok(fault)
    });
    value.setattr("faults", faults.collect::<PyResult<Vec<_>>>()?)?;
    Ok(PyErr::from_value(value))
}

fn about(error: &(dyn std::error::Error + 'static)) -> Option<About> {
    if let Some(error) = error.downcast_ref::<LoadError>() {
        return Some(About::of("ModelError").with_faults(faults(error)));
    }
    if let Some(error) = error.downcast_ref::<hyzer::Error>() {
        return of_library(error);
    }
    match error.downcast_ref::<SweepError>() {
        Some(SweepError::Plan(error)) => return about(error),
        Some(SweepError::Folder(_) | SweepError::Table { .. }) => {
            return Some(About::of("FolderError"));
        }
        Some(_) => return Some(About::of("FlightError")),
        None => {}
    }
    if let Some(DiagnosisError::Load(error)) = error.downcast_ref() {
        return about(error);
    }
    if let Some(error) = error.downcast_ref::<InputError>() {
        let place = (Some(error.file.display().to_string()), error.place);
        return Some(About {
            place,
            ..About::of("InputError")
        });
    }
    if let Some(error) = error.downcast_ref::<TakeError>() {
        let is_placed = matches!(error.location, Location::Line(_) | Location::Cell(..));
        let at = is_placed.then(|| error.location.place());
        return Some(About {
            place: (Some(error.file.display().to_string()), at),
            ..About::of("InputError")
        });
    }
    if let Some(error) = error.downcast_ref::<ReleaseError>() {
        let each = error.faults.iter();
        let faults = each.map(|fault| {
            let place = (Some(error.file.clone()), fault.location);
            (place, fault.message.clone(), None)
        });
        return Some(About::of("InputError").with_faults(faults.collect()));
    }
    class_of(error).map(About::of)
}

/// Errors of the facade wrap those of its crates without being their source.
fn of_library(error: &hyzer::Error) -> Option<About> {
    match error {
        hyzer::Error::Load(error) => about(error),
        hyzer::Error::Release(error) => about(error),
        hyzer::Error::Dataset(error) => about(error),
        hyzer::Error::Fit(error) => about(error),
        hyzer::Error::Diagnosis(error) => about(error),
        _ => None,
    }
}

fn class_of(error: &(dyn std::error::Error + 'static)) -> Option<&'static str> {
    let fit = |error: &FitError| match error {
        FitError::UnknownName { .. }
        | FitError::NotEstimated { .. }
        | FitError::InvalidOption { .. } => "InputError",
        _ => "FitError",
    };
    if let Some(error) = error.downcast_ref::<FitError>() {
        return Some(fit(error));
    }
    if let Some(error) = error.downcast_ref::<DiagnosisError>() {
        return Some(match error {
            DiagnosisError::Fit(error) => fit(error),
            _ => "InputError",
        });
    }
    if let Some(DesignError::NotFinite(_)) = error.downcast_ref() {
        return Some("InputError");
    }
    if let Some(error) = error.downcast_ref::<SynthesisError>() {
        let is_flight = matches!(error, SynthesisError::Flight { .. });
        return Some(if is_flight {
            "FlightError"
        } else {
            "InputError"
        });
    }
    if error.is::<ResultFolderError>()
        || error.is::<analysis::sweep::folder::FolderError>()
        || error.is::<std::io::Error>()
    {
        return Some("FolderError");
    }
    let is_flight = error.is::<ode::IntegrationError>()
        || error.is::<flight::throw::ThrowError>()
        || error.is::<analysis::design::ThrowFlightError>()
        || error.is::<DesignError>()
        || error.is::<analysis::stability::StabilityError>();
    is_flight.then_some("FlightError")
}

/// Place, message and hint of each fault in the text of a model.
fn faults(error: &LoadError) -> Vec<(Place, String, Option<String>)> {
    let LoadError::Faults {
        diagnostics,
        sources,
    } = error
    else {
        return Vec::new();
    };
    let each = diagnostics.iter();
    each.map(|fault| {
        (
            place(fault, sources),
            fault.message.clone(),
            fault.help.clone(),
        )
    })
    .collect()
}

fn place(fault: &Diagnostic, sources: &[Source]) -> Place {
    let Some(source) = sources.get(usize::from(fault.span.source)) else {
        return (None, None);
    };
    let at = line_and_column(&source.text, fault.span.range().start);
    (Some(source.name.clone()), Some(at))
}
