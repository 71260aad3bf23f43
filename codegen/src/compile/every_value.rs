//! All values of a model in one program, for the comparison of two models.

use super::scheduled_values;
use crate::lower::{Lowered, lower};
use crate::program::Program;
use model_spec::layout::Layout;
use model_spec::model::Model;

/// Program of all values of a model: state derivatives, observation, limits, auxiliary variables, in this order.
#[derive(Clone, Debug)]
pub struct EveryValue {
    /// Order of the states and parameters.
    pub layout: Layout,
    /// The program, without hoisting.
    pub program: Program,
    /// Number of outputs of the observation: 3, or 0 without one.
    pub observed: usize,
    /// Number of limits.
    pub limits: usize,
    /// Number of components of each auxiliary variable: 1 or 3.
    pub lets: Vec<usize>,
}

/// Compiles all values of a model, without Jacobians.
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
