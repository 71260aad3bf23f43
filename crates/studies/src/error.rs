//! Why a study cannot be run.

use std::path::PathBuf;

/// Why a study cannot be run.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum StudyError {
    /// A file of measured data cannot be read.
    #[error("{}: {source}", file.display())]
    Unreadable {
        /// File that cannot be read.
        file: PathBuf,
        /// Error of the operating system.
        source: std::io::Error,
    },
    /// A line of a table is not as expected.
    #[error("{}:{line}: found {found:?}, expected {expected}", file.display())]
    Line {
        /// The file.
        file: PathBuf,
        /// Line number, from 1.
        line: usize,
        /// Text of the line.
        found: String,
        /// Expected columns of the line.
        expected: &'static str,
    },
    /// A required part of a file is missing.
    #[error("{}: found no {expected}", file.display())]
    Absent {
        /// The file.
        file: PathBuf,
        /// Description of the missing part.
        expected: String,
    },
    /// A name that a built-in model, effect or release should have.
    #[error("the built-in {of} has no {name}")]
    Name {
        /// Model or collection.
        of: &'static str,
        /// The missing name.
        name: String,
    },
    /// A model or an effect does not load.
    #[error(transparent)]
    Model(#[from] model_spec::load::LoadError),
    /// A release of the paper does not read.
    #[error(transparent)]
    Release(#[from] flight::release::ReleaseError),
    /// A dataset does not read.
    #[error(transparent)]
    Dataset(#[from] identify::InputError),
    /// A fit failed.
    #[error(transparent)]
    Fit(#[from] identify::FitError),
    /// A diagnosis failed.
    #[error(transparent)]
    Diagnosis(#[from] diagnose::DiagnosisError),
    /// A throw cannot be flown.
    #[error(transparent)]
    Throw(#[from] design::ThrowFlightError),
    /// A throw cannot be searched for.
    #[error(transparent)]
    Design(#[from] design::DesignError),
    /// A template of a page does not go with the results.
    #[error("the page cannot be written: {0}")]
    Page(#[from] minijinja::Error),
}
