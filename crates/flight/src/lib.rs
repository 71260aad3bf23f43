//! Runtime of a flight model: the compiled model, its parameters, its measurement equation, and releases.
//!
//! - [`CompiledModel`] holds the functions of a model ([`ModelFunctions`]), from generated code or an interpreted tape.
//! - [`BoundModel`] adds values of the parameters. Its functions integrate it; it provides the right-hand side for the
//!   solver of [`ode`], with or without Jacobians, the limits of validity as events, and a [`ModelObserver`] for marker
//!   positions.
//! - [`release`] reads the initial conditions of a flight; [`simulate`] integrates them; [`trajectory_csv`] writes the
//!   result.
//! - [`throw`] describes the motion at release by the quantities that launch monitors report.
//!
//! ```
//! use flight::CompiledModel;
//! use ode::IntegrationOptions;
//!
//! let model = model_spec::load::load("ball", &[])?;
//! let compiled = CompiledModel::new(&model);
//! let bound = compiled.bind(compiled.layout().default_parameters());
//! // 5 m/s forward and upward from a height of 1 m.
//! let start = [0.0, 0.0, 1.0, 5.0, 0.0, 5.0];
//! let mut state = compiled.layout().default_states();
//! state[..6].copy_from_slice(&start);
//! let options = IntegrationOptions::default();
//! let flight = bound.integrate((0.0, &state.into()), 0.5, &options, &mut bound.limits())?;
//! let marker = bound.observer().position(0.5, &flight.end_state, &[0.0; 3]);
//! assert!(marker[0] > 1.0 && marker[2] > 2.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#![forbid(unsafe_code)]

mod basis_loads;
mod bound_model;
pub mod cancellation;
mod compiled_model;
mod constraints;
pub mod files;
mod functions;
mod initial_conditions;
mod input_derivatives;
mod inputs;
mod integrate;
mod lane_model;
mod lane_observer;
mod moore_penrose;
mod observer;
mod overruled;
pub mod parallel;
mod release_file;
mod rhs;
mod simulate;
mod single_flights;
mod switches;
pub mod table;
pub mod throw;
mod time_breaks;
mod toml_reader;
mod trajectory_csv;
pub mod wind;

pub use basis_loads::BasisLoads;
pub use bound_model::BoundModel;
pub use compiled_model::{CompiledModel, ModelState};
pub use constraints::{BoundConstraints, Constraints, take_lengths};
pub use functions::{EvaluationPoint, ModelFunctions, SparsityPatterns, Workspace};
pub use inputs::{FlightParameters, InputInterpolation, InputSeries, InputsOverTime, read_inputs};
pub use lane_model::LaneModel;
pub use lane_observer::LaneObserver;
pub use moore_penrose::moore_penrose;
pub use observer::{ModelObserver, ObservationJacobians};
pub use rhs::ModelRhs;
pub use simulate::simulate;
pub use trajectory_csv::trajectory_csv;

/// Releases: initial conditions and end of a flight, built in by name or read from a TOML file.
pub mod release {
    pub use crate::initial_conditions::{
        BUILT_IN, Release, Stop, Vocabulary, built_in, quaternion_fault,
    };
    pub use crate::overruled::{overruled, replaced};
    pub use crate::release_file::{read, read_file, read_in_wind, read_named};
    pub use crate::toml_reader::{
        Fault, Name, Reader, ReleaseError, Value, number_of, read_text, suggestion,
    };
}
