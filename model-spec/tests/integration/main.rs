//! The language: what right models mean, what is said about broken ones, and that no text does harm.

mod advice;
mod broken;
mod effects;
mod files;
mod flight_axes;
mod general_effects;
mod inputs;
mod language;
mod meaning;
mod models;
mod robust;
mod small_things;
mod solve;
mod summary;
mod tables;
