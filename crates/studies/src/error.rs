//! Why a study cannot be run.

use std::path::PathBuf;

/// Why a study cannot be run.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum StudyError {
    /// A file of measured data cannot be read.
    #[error("{}: {source}", file.display())]
    Unreadable {
        /// The file.
        file: PathBuf,
        /// The system's reason.
        source: std::io::Error,
    },
    /// A line of a table is not as expected.
    #[error("{}:{line}: found {found:?}, expected {expected}", file.display())]
    Line {
        /// The file.
        file: PathBuf,
        /// Line number, from 1.
        line: usize,
        /// The line.
        found: String,
        /// The columns that it should have.
        expected: &'static str,
    },
    /// A file lacks something.
    #[error("{}: found no {expected}", file.display())]
    Absent {
        /// The file.
        file: PathBuf,
        /// What was expected.
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
    /// A template of a page does not go with the results.
    #[error("the page cannot be written: {0}")]
    Page(#[from] minijinja::Error),
}
