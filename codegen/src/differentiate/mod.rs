//! Exact sparse Jacobians: linearized computational graphs and vertex elimination.

mod eliminate;
mod linearized;
pub(crate) mod partials;

pub(crate) use eliminate::{EliminationOrder, Jacobian};
pub(crate) use linearized::{LinearizedGraph, share_values};
