//! Errors of sweeps.

use std::path::PathBuf;

use flight::release::ReleaseError;
use flight::throw::ThrowError;
use parquet::errors::ParquetError;

use crate::folder::FolderError;

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
    /// The folder cannot hold this sweep.
    #[error(transparent)]
    Folder(#[from] FolderError),
    /// A table cannot be read or written.
    #[error("{}: {source}", path.display())]
    Table {
        /// The file.
        path: PathBuf,
        /// Its cause.
        source: ParquetError,
    },
}
