//! Measurement equation of a model: marker positions and their Jacobians, auxiliary variables, limits of validity.

use crate::{BoundModel, Workspace};

/// Measurement equation of a bound model: marker positions, auxiliary variables and limits of validity.
pub struct ModelObserver<'a> {
    model: &'a BoundModel<'a>,
    workspace: Workspace,
    /// Parameters at the time of an evaluation.
    parameters: Vec<f64>,
    by_state: Vec<f64>,
    by_parameter: Vec<f64>,
    by_marker: Vec<f64>,
}

/// Sparse Jacobians of a marker position y, whose three rows are the components in the inertial frame.
pub struct ObservationJacobians<'o> {
    /// (row, state) indices of each entry of ∂y/∂x, where y is the marker position and x the state.
    pub by_state_pattern: &'o [(usize, usize)],
    /// Entries of ∂y/∂x, the derivatives of the marker position y with respect to the state x, m per state unit.
    pub by_state: &'o [f64],
    /// (row, parameter) of each entry of ∂y/∂p, with the parameters in the order of [`Layout`](codegen::Layout).
    pub by_parameter_pattern: &'o [(usize, usize)],
    /// Entries of ∂y/∂p, the derivatives of the marker position by the parameters, m per unit.
    pub by_parameter: &'o [f64],
}

impl BoundModel<'_> {
    /// The measurement equation of the model: marker positions and auxiliary variables by time and state.
    pub fn observer(&self) -> ModelObserver<'_> {
        let patterns = &self.model.patterns;
        ModelObserver {
            model: self,
            workspace: Workspace::default(),
            parameters: Vec::new(),
            by_state: vec![0.0; patterns.observation_by_state.len()],
            by_parameter: vec![0.0; patterns.observation_by_parameter.len()],
            by_marker: vec![0.0; patterns.observation_by_marker_len],
        }
    }
}

impl ModelObserver<'_> {
    /// Position, m, of a marker with the body-fixed position `marker`, m, at time `t` (s) and state `x`.
    pub fn position(&mut self, t: f64, x: &[f64], marker: &[f64; 3]) -> [f64; 3] {
        let at = self.model.at(t, x, &mut self.parameters);
        let mut y = [0.0; 3];
        self.model
            .functions()
            .observe(at, marker, &mut self.workspace, &mut y);
        y
    }

    /// [`position`](Self::position), and its sparse Jacobians with respect to state and parameters.
    pub fn position_with_jacobians(
        &mut self,
        t: f64,
        x: &[f64],
        marker: &[f64; 3],
    ) -> ([f64; 3], ObservationJacobians<'_>) {
        let at = self.model.at(t, x, &mut self.parameters);
        let mut y = [0.0; 3];
        let jacobians = [
            &mut self.by_state[..],
            &mut self.by_parameter,
            &mut self.by_marker,
        ];
        self.model
            .functions()
            .observe_jac(at, marker, &mut self.workspace, &mut y, jacobians);
        let patterns = &self.model.model.patterns;
        let jacobians = ObservationJacobians {
            by_state_pattern: &patterns.observation_by_state,
            by_state: &self.by_state,
            by_parameter_pattern: &patterns.observation_by_parameter,
            by_parameter: &self.by_parameter,
        };
        (y, jacobians)
    }

    /// Auxiliary variables at time `t` (s) and state `x`, in the order of [`Layout::quantities`](codegen::Layout).
    pub fn quantities(&mut self, t: f64, x: &[f64]) -> Vec<f64> {
        let at = self.model.at(t, x, &mut self.parameters);
        let mut q = vec![0.0; self.model.model.layout.quantities.len()];
        self.model
            .functions()
            .quantities(at, &mut self.workspace, &mut q);
        q
    }

    /// Whether the state is within the model's limits: every limited quantity is above its bound.
    pub fn is_within_limits(&mut self, t: f64, x: &[f64]) -> bool {
        self.passed_limit(t, x).is_none()
    }

    /// Reason of the first limit of the model's validity that the state has reached; `None` within all of them.
    pub fn passed_limit(&mut self, t: f64, x: &[f64]) -> Option<&str> {
        let at = self.model.at(t, x, &mut self.parameters);
        let limits = &self.model.model.limits;
        let mut values = vec![0.0; limits.len()];
        self.model
            .functions()
            .limits(at, &mut self.workspace, &mut values);
        let mut limits = limits.iter().zip(values);
        // A value that is not a number is not above its bound.
        let is_passed = |value: f64, bound: f64| value.is_nan() || value <= bound;
        let ((_, reason), _) = limits.find(|((bound, _), value)| is_passed(*value, *bound))?;
        Some(reason.as_str())
    }
}
