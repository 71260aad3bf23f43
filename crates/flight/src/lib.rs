//! Flying a model: integration with dense output, events, wind and batches.

#![forbid(unsafe_code)]

pub mod aligned;
pub mod batch;
pub mod body;
mod control;
mod dynamics;
mod error;
mod event;
mod flight;
mod integrate;
mod method;
pub mod release;
mod root;
pub mod sensitivity;
mod table;
pub mod wind;

pub use dynamics::{Dynamics, Equations, Storage, equations};
pub use error::{Cause, FlightError};
pub use event::{Event, Occurrence};
pub use flight::{Flight, fly, fly_at, fly_past, fly_to_end, fly_to_event};
pub use integrate::{End, Options, Work};
pub use method::Method;
pub use table::{trajectory_csv, write_whole};
