//! Errors of sweeps.

use std::io;
use std::path::PathBuf;

use flight::release::ReleaseError;
use flight::throw::ThrowError;
use parquet::errors::ParquetError;

/// Reason why a sweep cannot be flown or its results not be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SweepError {
    /// The plan has faults.
    #[error(transparent)]
    Plan(#[from] ReleaseError),
    /// The plan's own throw is not one of the model's.
    #[error(transparent)]
    Throw(#[from] ThrowError),
    /// A plan until the ground for a model without height.
    #[error(
        "the model {model} has no state z, whose fall to 0 is the landing; expected a plan with duration = … (s)"
    )]
    NoHeight {
        /// Name of the model.
        model: String,
    },
    /// The folder holds another sweep.
    #[error(
        "{} holds parts or results of another plan, model or machine; expected a new or empty folder, or the same plan to go on",
        path.display()
    )]
    OtherPlan {
        /// The folder.
        path: PathBuf,
    },
    /// The folder holds other files.
    #[error("{} holds files that are no sweep; expected a new or empty folder", path.display())]
    Foreign {
        /// The folder.
        path: PathBuf,
    },
    /// A part out of range.
    #[error("part {part} of {of}; expected one from 1 to {of}")]
    NoPart {
        /// Number that was found.
        part: u64,
        /// Number of parts.
        of: u64,
    },
    /// A file or folder cannot be read or written.
    #[error("{}: {source}", path.display())]
    Io {
        /// The file or folder.
        path: PathBuf,
        /// Its cause.
        source: io::Error,
    },
    /// A table cannot be read or written.
    #[error("{}: {source}", path.display())]
    Table {
        /// The file.
        path: PathBuf,
        /// Its cause.
        source: ParquetError,
    },
}
