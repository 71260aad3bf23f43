//! Compiled code: its values and derivatives on every backend, and its text.

mod at;
mod backends;
mod code;
mod derivatives;
mod expansion;
mod functions;
mod ir;
mod lookups;
mod simplify;
mod support;
