//! Projection of states onto what the equations keep, such as constraints, from which steps and dense output drift.

use std::fmt;
use std::sync::Arc;

/// Projection of states onto the set on which what the equations keep holds, such as a constraint.
///
/// The solver projects the state at the end of each step, and every state that is read from dense output.
pub trait Project: fmt::Debug + Send + Sync {
    /// Moves the state at time `t` onto the set; returns whether it has moved. Where the set is not found, the state
    /// stays.
    ///
    /// The shift must be of the size of the error of a step.
    fn project(&self, t: f64, x: &mut [f64]) -> bool;

    /// Takes from `directions`, each as long as the state and one after another, the parts that leave the set at its
    /// state `x`.
    fn project_directions(&self, t: f64, x: &[f64], directions: &mut [f64]);

    /// Whether the set changes with a parameter of the equations, by its index.
    fn depends_on(&self, parameter: usize) -> bool;
}

/// Projection that trajectories share.
pub type Projection = Arc<dyn Project>;
