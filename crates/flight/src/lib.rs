//! Runtime of a flight model: the compiled model with its parameters, its measurement equation, releases.

#![forbid(unsafe_code)]

pub mod batch;
mod bound_model;
mod compiled_model;
mod functions;
mod observer;
pub mod release;
mod rhs;
mod simulate;
mod trajectory_csv;

pub use bound_model::BoundModel;
pub use compiled_model::{CompiledModel, ModelState};
pub use functions::{EvaluationPoint, ModelFunctions, SparsityPatterns, Workspace};
pub use observer::{ModelObserver, ObservationJacobians};
pub use rhs::{DifferentiableModelRhs, ModelRhs};
pub use simulate::simulate;
pub use trajectory_csv::{trajectory_csv, write_atomic};
