//! Error type of the studies.

use std::path::PathBuf;

/// Error that prevents a study from being run or its page from being rendered.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum StudyError {
    /// A file or folder of measured data, or a program, cannot be read or started.
    #[error("{}: {source}", file.display())]
    Unreadable {
        /// Path of the file, folder or program that cannot be read or started.
        file: PathBuf,
        /// Error of the operating system.
        source: std::io::Error,
    },
    /// A line of a data table does not have the expected form.
    #[error("{}:{line}: found {found:?}, expected {expected}", file.display())]
    Line {
        /// File of the data table with the malformed line.
        file: PathBuf,
        /// Number of the malformed line, from 1.
        line: usize,
        /// Text of the malformed line.
        found: String,
        /// Description of the columns that the line should have.
        expected: &'static str,
    },
    /// A required part of a file is missing.
    #[error("{}: found no {expected}", file.display())]
    Absent {
        /// File that lacks a required part.
        file: PathBuf,
        /// Description of the part that is missing in `file`.
        expected: String,
    },
    /// An expected name is missing in a model (such as a coefficient), in a fit, or in a list (such as that of the
    /// built-in releases).
    #[error("the {of} has no {name}")]
    Name {
        /// Description of the model, fit or list in which the name was looked up.
        of: &'static str,
        /// Name that was not found, such as the name of a coefficient or a scenario.
        name: String,
    },
    /// A model, or an effect (optional model extension), cannot be loaded.
    #[error(transparent)]
    Model(#[from] model_spec::load::LoadError),
    /// A built-in file with the launch conditions (release) of one of the flights of Hubbard & Hummel (2000) cannot be
    /// parsed.
    #[error(transparent)]
    Release(#[from] flight::release::ReleaseError),
    /// A dataset cannot be read.
    #[error(transparent)]
    Dataset(#[from] dataset::InputError),
    /// A take (recording) cannot be read.
    #[error(transparent)]
    Take(#[from] dataset::takes::TakeError),
    /// The import of a take (recording) does not track all of its markers; contains the labels of those that it tracks.
    #[error("the points {0:?} are followed")]
    Labels(Vec<String>),
    /// The marker template (positions of the markers on the body) cannot be estimated from the flights of a recording
    /// session.
    #[error(transparent)]
    Template(#[from] dataset::takes::TemplateError),
    /// A dataset cannot be fitted.
    #[error(transparent)]
    Fit(#[from] identify::FitError),
    /// A dataset cannot be diagnosed.
    #[error(transparent)]
    Diagnosis(#[from] diagnose::DiagnosisError),
    /// The flight of a specified throw cannot be simulated.
    #[error(transparent)]
    Throw(#[from] analysis::design::ThrowFlightError),
    /// The search for launch conditions that give a desired flight cannot be set up, or fails.
    #[error(transparent)]
    Design(#[from] analysis::design::DesignError),
    /// The text template of a documentation page cannot be rendered with the results of the study.
    #[error("the page cannot be written: {0}")]
    Page(#[from] minijinja::Error),
}
