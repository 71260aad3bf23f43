//! Evaluation of a model's functions in `f64`: one trait for all backends of the compiler.

use codegen::tape_model::{At, Scratch, TapeModel};

/// Scratch memory for evaluating the functions of a compiled model, reused between calls.
pub type Workspace = Scratch;

/// Point at which a model's functions are evaluated: time, state, parameters and the values computed from parameters.
pub type EvaluationPoint<'a> = At<'a>;

/// Sparsity patterns of a model's Jacobians: (row, column) of each stored entry, ordered by row.
#[derive(Clone, Copy, Debug, Default)]
pub struct SparsityPatterns<'a> {
    /// Pattern of the state Jacobian ∂f/∂x, where f = dx/dt is the right-hand side.
    pub jacobian: &'a [(u32, u32)],
    /// Pattern of the parameter Jacobian ∂f/∂p, where f = dx/dt is the right-hand side.
    pub parameter_jacobian: &'a [(u32, u32)],
    /// Pattern of ∂y/∂x, where y is the observed marker position.
    pub observation_by_state: &'a [(u32, u32)],
    /// Pattern of ∂y/∂p, where y is the observed marker position.
    pub observation_by_parameter: &'a [(u32, u32)],
    /// Pattern of the Jacobian of the observed marker position with respect to the marker's body-fixed coordinates.
    pub observation_by_marker: &'a [(u32, u32)],
}

/// Functions of a compiled model: the right-hand side of dx/dt = f(t, x, p) with its Jacobians, the observed position y
/// of a marker, auxiliary variables and limits of validity.
///
/// Results are written to slices that must have at least the size of the result; shorter slices cause a panic. The
/// entries of Jacobians are in the order of [`SparsityPatterns`].
pub trait ModelFunctions: Send + Sync {
    /// Number of invariants (values that depend on the parameters alone) that `prepare` computes.
    fn prepared_len(&self) -> usize;
    /// Sparsity patterns of the Jacobians that the functions compute.
    fn patterns(&self) -> SparsityPatterns<'_>;
    /// Computes the invariants, which are values that depend on the parameters `p` alone, and writes them to
    /// `prepared`.
    fn prepare(&self, p: &[f64], prepared: &mut [f64]);
    /// Computes the state derivative f = dx/dt, in state units per second.
    fn f(&self, at: EvaluationPoint<'_>, workspace: &mut Workspace, dx: &mut [f64]);
    /// Computes the state derivative f and the entries of its Jacobians ∂f/∂x and ∂f/∂p.
    fn f_jac_par(
        &self,
        at: EvaluationPoint<'_>,
        workspace: &mut Workspace,
        dx: &mut [f64],
        jacobian: &mut [f64],
        parameter_jacobian: &mut [f64],
    );
    /// Computes the position `y` of a marker in the inertial frame, m, from the marker's body-fixed coordinates, m.
    fn observe(
        &self,
        at: EvaluationPoint<'_>,
        marker: &[f64; 3],
        workspace: &mut Workspace,
        y: &mut [f64; 3],
    );
    /// Computes the position `y` of a marker in the inertial frame, m, and its Jacobians with respect to the state, the
    /// parameters and the body-fixed marker coordinates, in this order in `jacobians`.
    fn observe_jac(
        &self,
        at: EvaluationPoint<'_>,
        marker: &[f64; 3],
        workspace: &mut Workspace,
        y: &mut [f64; 3],
        jacobians: [&mut [f64]; 3],
    );
    /// Computes the auxiliary variables of the model, in the order of its [`Layout`](codegen::Layout).
    fn quantities(&self, at: EvaluationPoint<'_>, workspace: &mut Workspace, q: &mut [f64]);
    /// Computes the left-hand side of each limit of validity of the model; the model is valid where each left-hand side
    /// exceeds the lower bound of its limit.
    fn limits(&self, at: EvaluationPoint<'_>, workspace: &mut Workspace, l: &mut [f64]);
}

impl ModelFunctions for generated::Model {
    fn prepared_len(&self) -> usize {
        self.prepared.len()
    }

    fn patterns(&self) -> SparsityPatterns<'_> {
        SparsityPatterns {
            jacobian: self.j_pattern,
            parameter_jacobian: self.jp_pattern,
            observation_by_state: self.dy_dx_pattern,
            observation_by_parameter: self.dy_dp_pattern,
            observation_by_marker: self.dy_dmarker_pattern,
        }
    }

    fn prepare(&self, p: &[f64], prepared: &mut [f64]) {
        (self.prepare)(p, prepared);
    }

    fn f(&self, at: EvaluationPoint<'_>, _: &mut Workspace, dx: &mut [f64]) {
        (self.f)(at.t, at.x, at.p, at.prepared, dx);
    }

    fn f_jac_par(
        &self,
        at: EvaluationPoint<'_>,
        _: &mut Workspace,
        dx: &mut [f64],
        j: &mut [f64],
        jp: &mut [f64],
    ) {
        (self.f_jac_par)(at.t, at.x, at.p, at.prepared, dx, j, jp);
    }

    fn observe(
        &self,
        at: EvaluationPoint<'_>,
        marker: &[f64; 3],
        _: &mut Workspace,
        y: &mut [f64; 3],
    ) {
        (self.observe)(at.t, at.x, at.p, at.prepared, marker, y);
    }

    fn observe_jac(
        &self,
        at: EvaluationPoint<'_>,
        marker: &[f64; 3],
        _: &mut Workspace,
        y: &mut [f64; 3],
        [dy_dx, dy_dp, dy_dmarker]: [&mut [f64]; 3],
    ) {
        let EvaluationPoint { t, x, p, prepared } = at;
        (self.observe_jac)(t, x, p, prepared, marker, y, dy_dx, dy_dp, dy_dmarker);
    }

    fn quantities(&self, at: EvaluationPoint<'_>, _: &mut Workspace, q: &mut [f64]) {
        (self.quantities)(at.t, at.x, at.p, at.prepared, q);
    }

    fn limits(&self, at: EvaluationPoint<'_>, _: &mut Workspace, l: &mut [f64]) {
        (self.limits)(at.t, at.x, at.p, at.prepared, l);
    }
}

impl ModelFunctions for TapeModel {
    fn prepared_len(&self) -> usize {
        self.prepared
    }

    fn patterns(&self) -> SparsityPatterns<'_> {
        SparsityPatterns {
            jacobian: self.f_jac_par.pattern("j"),
            parameter_jacobian: self.f_jac_par.pattern("jp"),
            observation_by_state: self.observe_jac.pattern("dy_dx"),
            observation_by_parameter: self.observe_jac.pattern("dy_dp"),
            observation_by_marker: self.observe_jac.pattern("dy_dmarker"),
        }
    }

    fn prepare(&self, p: &[f64], prepared: &mut [f64]) {
        prepared.copy_from_slice(&TapeModel::prepare(self, p));
    }

    fn f(&self, at: EvaluationPoint<'_>, workspace: &mut Workspace, dx: &mut [f64]) {
        self.f.eval(at, &[], workspace, &mut [dx]);
    }

    fn f_jac_par(
        &self,
        at: EvaluationPoint<'_>,
        workspace: &mut Workspace,
        dx: &mut [f64],
        j: &mut [f64],
        jp: &mut [f64],
    ) {
        self.f_jac_par.eval(at, &[], workspace, &mut [dx, j, jp]);
    }

    fn observe(
        &self,
        at: EvaluationPoint<'_>,
        marker: &[f64; 3],
        workspace: &mut Workspace,
        y: &mut [f64; 3],
    ) {
        self.observe.eval(at, marker, workspace, &mut [y]);
    }

    fn observe_jac(
        &self,
        at: EvaluationPoint<'_>,
        marker: &[f64; 3],
        workspace: &mut Workspace,
        y: &mut [f64; 3],
        [dy_dx, dy_dp, dy_dmarker]: [&mut [f64]; 3],
    ) {
        let mut results = [&mut y[..], dy_dx, dy_dp, dy_dmarker];
        self.observe_jac.eval(at, marker, workspace, &mut results);
    }

    fn quantities(&self, at: EvaluationPoint<'_>, workspace: &mut Workspace, q: &mut [f64]) {
        self.quantities.eval(at, &[], workspace, &mut [q]);
    }

    fn limits(&self, at: EvaluationPoint<'_>, workspace: &mut Workspace, l: &mut [f64]) {
        self.limits.eval(at, &[], workspace, &mut [l]);
    }
}
