//! Errors of sweeps.

use std::path::PathBuf;

use flight::release::ReleaseError;
use flight::throw::ThrowError;
use parquet::errors::ParquetError;

use crate::sweep::folder::FolderError;

/// Reason why the flights of a sweep cannot be computed or the results cannot be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SweepError {
    /// The plan of the sweep has faults; the message lists all of them.
    #[error(transparent)]
    Plan(#[from] ReleaseError),
    /// No state of the model has the motion that the table `[throw]` of the plan specifies.
    #[error(transparent)]
    Throw(#[from] ThrowError),
    /// The plan requires flights that end at the ground, but the model has no height state `z`.
    #[error(
        "the model {model} has no state z, whose fall to 0 is the landing; expected a plan with duration = … (s)"
    )]
    NoHeight {
        /// Name of the model that has no state `z`.
        model: String,
    },
    /// The output folder cannot be used, for example because it holds the results of another computation.
    #[error(transparent)]
    Folder(#[from] FolderError),
    /// A Parquet or CSV table of flights cannot be read or written.
    #[error("{}: {source}", path.display())]
    Table {
        /// Path of the table that cannot be read or written.
        path: PathBuf,
        /// Error that occurred while the table was read or written.
        source: ParquetError,
    },
}
