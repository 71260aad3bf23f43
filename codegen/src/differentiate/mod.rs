//! Exact sparse Jacobians: linearized computational graphs and vertex elimination.

mod eliminate;
mod linearized;
pub(crate) mod partials;
mod vertices;

pub(crate) use eliminate::{EliminationOrder, Jacobian};
pub(crate) use linearized::LinearizedGraph;
pub(crate) use vertices::share_values;
