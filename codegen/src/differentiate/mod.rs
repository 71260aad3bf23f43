//! Exact sparse Jacobians: partial derivatives on the edges of a linearized computational graph, whose vertices are
//! eliminated one by one.

mod eliminate;
mod linearized;
pub(crate) mod partials;
mod vertices;

pub(crate) use eliminate::{EliminationOrder, Jacobian};
pub(crate) use linearized::{Labelled, LinearizedGraph};
pub(crate) use vertices::share_values;
