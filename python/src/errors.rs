//! Errors as Python exceptions, with their place and hint; the classes are in `hyzer/_errors.py`.

use analysis::sweep::SweepError;
use anyhow::Error;
use dataset::InputError;
use dataset::synthesize::SynthesisError;
use diagnose::DiagnosisError;
use flight::files::ResultFolderError;
use flight::release::ReleaseError;
use identify::FitError;
use model_spec::LoadError;
use model_spec::diagnostic::{Diagnostic, Source};
use model_spec::location::line_and_column;
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
    let text = format!("{error:#}");
    let known = error.chain().find_map(about);
    build(known.unwrap_or_else(|| About::of(class)), &text)
}

/// The exception for an error whose message names options of the program; `names` are the keyword arguments instead.
pub fn raise_named(error: anyhow::Error, names: &[(&str, &str)]) -> PyErr {
    let text = format!("{error:#}");
    let named = with_keywords(&text, names);
    if named == text {
        return raise_or("InputError", error);
    }
    let about = error.chain().find_map(about);
    build(about.unwrap_or_else(|| About::of("InputError")), &named)
}

/// A text with keyword arguments in place of options of the program: `length=` for `the option --length`.
pub fn with_keywords(text: &str, names: &[(&str, &str)]) -> String {
    let mut text = text.to_owned();
    for (option, keyword) in names {
        for before in ["the option --", "option --", "--"] {
            text = text.replace(&format!("{before}{option}:"), &format!("{keyword}:"));
            text = text.replace(&format!("{before}{option}"), &format!("{keyword}="));
        }
    }
    text
}

/// The exception `InputError` for an argument: what was found and what was expected.
pub fn input(text: impl AsRef<str>) -> PyErr {
    build(About::of("InputError"), text.as_ref())
}

/// An exception of a class of `hyzer._errors`, without a place.
pub fn of_class(class: &'static str, text: &str) -> PyErr {
    build(About::of(class), text)
}

fn build(about: About, text: &str) -> PyErr {
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
        let hint = Some(format!("expected {}", error.expected));
        return Some(About {
            place,
            hint,
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
        || error.is::<analysis::design::DesignError>()
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
