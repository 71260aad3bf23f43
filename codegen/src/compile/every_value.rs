//! Program that computes all values of a model, for the comparison of two models.

use super::scheduled_values;
use crate::lower::{Lowered, lower};
use crate::program::Program;
use model_spec::layout::Layout;
use model_spec::model::Model;

/// Program of all values of a model. Its outputs are the time derivatives of the states, the observed marker position,
/// the left-hand sides `EXPR` of the limits of validity (statements `limit EXPR > bound`) and the auxiliary variables,
/// in this order.
#[derive(Clone, Debug)]
pub struct EveryValue {
    /// Names and order of the states and parameters.
    pub layout: Layout,
    /// Program that computes all outputs; expressions of parameters alone are not moved to a separate function
    /// `prepare`, which would run once per flight.
    pub program: Program,
    /// Number of outputs that are components of the observed marker position: 3, or 0 if the model has no measurement
    /// equation.
    pub observed: usize,
    /// Number of outputs that are left-hand sides `EXPR` of limits of validity (statements `limit EXPR > bound`).
    pub limits: usize,
    /// Number of components of each auxiliary variable, 1 or 3, in the order of declaration, which is also the order of
    /// the outputs.
    pub lets: Vec<usize>,
}

/// Compiles a program that computes the state derivatives, the observed marker position, the left-hand sides `EXPR` of
/// the limits of validity (statements `limit EXPR > bound`) and all auxiliary variables of a model, without Jacobians.
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
