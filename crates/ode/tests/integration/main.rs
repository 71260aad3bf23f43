//! Integration: accuracy, events, sensitivities and batches.

mod analytic;
mod batch;
mod disc;
mod events;
mod methods;
mod sensitivity;
