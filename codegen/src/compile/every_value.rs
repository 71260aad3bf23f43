//! Program that computes all values of a model, for the comparison of two models.

use super::scheduled_values;
use crate::lower::{Lowered, lower};
use crate::program::Program;
use model_spec::layout::Layout;
use model_spec::model::Model;

/// Program of all values of a model: state derivatives, observation, limits, auxiliary variables.
#[derive(Clone, Debug)]
pub struct EveryValue {
    /// Names and order of the states and parameters.
    pub layout: Layout,
    /// Program that computes all outputs, without `prepare`.
    pub program: Program,
    /// Number of components of the observation: 3, or 0 without one.
    pub observed: usize,
    /// Number of outputs that are left-hand sides `EXPR` of limits of validity (statements `limit EXPR > bound`).
    pub limits: usize,
    /// Number of components of each auxiliary variable, 1 or 3, in order.
    pub lets: Vec<usize>,
}

/// Compiles the values of a model, without Jacobians.
pub fn compile_every_value(model: &Model) -> EveryValue {
    let Lowered {
        mut graph,
        layout,
        dx,
        observation,
        limits,
        lets,
        ..
    } = lower(model);
    let observation: Vec<_> = observation.into_iter().flatten().collect();
    let mut wanted = dx;
    wanted.extend(&observation);
    wanted.extend(&limits);
    wanted.extend(lets.iter().flatten());
    EveryValue {
        program: scheduled_values(&mut graph, &layout, &wanted),
        layout,
        observed: observation.len(),
        limits: limits.len(),
        lets: lets.iter().map(Vec::len).collect(),
    }
}
