//! Evaluation of a model's functions in `f64`, by generated code or by a tape.

use codegen::tape_model::{At, Scratch, TapeModel};

/// Scratch memory for evaluating the functions of a compiled model, reused between calls.
pub type Workspace = Scratch;

/// Point at which a model's functions are evaluated: time, state, parameters and the values computed from parameters.
pub type EvaluationPoint<'a> = At<'a>;

/// Functions of a compiled model: the right-hand side of dx/dt = f(t, x, p) with its Jacobians, the observed position y
/// of a marker, auxiliary variables and limits of validity.
///
/// Results are written to slices that must have at least the size of the result; shorter slices cause a panic.
pub enum ModelFunctions {
    /// Rust code that was generated from the model.
    Generated(Box<generated::Model>),
    /// Interpreted bytecode.
    Tape(Box<TapeModel>),
}

/// Sparsity of a model's Jacobians: (row, column) by row. x is the state, p the parameters, y the marker position.
#[derive(Clone, Debug)]
pub struct SparsityPatterns {
    /// Pattern of ∂f/∂x, where f = dx/dt.
    pub jacobian: Vec<(usize, usize)>,
    /// Pattern of ∂f/∂p.
    pub parameter_jacobian: Vec<(usize, usize)>,
    /// Pattern of ∂y/∂x.
    pub observation_by_state: Vec<(usize, usize)>,
    /// Pattern of ∂y/∂p.
    pub observation_by_parameter: Vec<(usize, usize)>,
    /// Number of entries of the derivative of y with respect to the body-fixed coordinates of the marker.
    pub(crate) observation_by_marker_len: usize,
}

impl ModelFunctions {
    /// Sparsity patterns of the Jacobians that the functions compute.
    pub fn patterns(&self) -> SparsityPatterns {
        let [j, jp, dy_dx, dy_dp, dy_dmarker] = match self {
            Self::Generated(code) => [
                code.j_pattern,
                code.jp_pattern,
                code.dy_dx_pattern,
                code.dy_dp_pattern,
                code.dy_dmarker_pattern,
            ],
            Self::Tape(tape) => [
                tape.f_jac_par.pattern("j"),
                tape.f_jac_par.pattern("jp"),
                tape.observe_jac.pattern("dy_dx"),
                tape.observe_jac.pattern("dy_dp"),
                tape.observe_jac.pattern("dy_dmarker"),
            ],
        };
        let widened = |pattern: &[(u32, u32)]| {
            let entries = pattern.iter();
            entries.map(|&(r, c)| (r as usize, c as usize)).collect()
        };
        SparsityPatterns {
            jacobian: widened(j),
            parameter_jacobian: widened(jp),
            observation_by_state: widened(dy_dx),
            observation_by_parameter: widened(dy_dp),
            observation_by_marker_len: dy_dmarker.len(),
        }
    }

    /// The invariants: values that depend only on the parameters `p`.
    pub fn prepared(&self, p: &[f64]) -> Vec<f64> {
        match self {
            Self::Generated(code) => {
                let mut prepared = vec![0.0; code.prepared.len()];
                (code.prepare)(p, &mut prepared);
                prepared
            }
            Self::Tape(tape) => tape.prepare(p),
        }
    }

    /// Computes the state derivative f = dx/dt, in state units per second.
    pub fn f(&self, at: EvaluationPoint<'_>, workspace: &mut Workspace, dx: &mut [f64]) {
        match self {
            Self::Generated(code) => (code.f)(at.t, at.x, at.p, at.prepared, dx),
            Self::Tape(tape) => tape.f.eval(at, &[], workspace, &mut [dx]),
        }
    }

    /// Computes the state derivative f and the entries of its Jacobians ∂f/∂x and ∂f/∂p.
    pub fn f_jac_par(
        &self,
        at: EvaluationPoint<'_>,
        workspace: &mut Workspace,
        dx: &mut [f64],
        j: &mut [f64],
        jp: &mut [f64],
    ) {
        match self {
            Self::Generated(code) => (code.f_jac_par)(at.t, at.x, at.p, at.prepared, dx, j, jp),
            Self::Tape(tape) => tape.f_jac_par.eval(at, &[], workspace, &mut [dx, j, jp]),
        }
    }

    /// Computes the position `y` of a marker in the inertial frame, m, from the marker's body-fixed coordinates, m.
    pub fn observe(
        &self,
        at: EvaluationPoint<'_>,
        marker: &[f64; 3],
        workspace: &mut Workspace,
        y: &mut [f64; 3],
    ) {
        match self {
            Self::Generated(code) => (code.observe)(at.t, at.x, at.p, at.prepared, marker, y),
            Self::Tape(tape) => tape.observe.eval(at, marker, workspace, &mut [y]),
        }
    }

    /// Position `y` of a marker, m, and its Jacobians by the state, the parameters and the marker coordinates.
    pub fn observe_jac(
        &self,
        at: EvaluationPoint<'_>,
        marker: &[f64; 3],
        workspace: &mut Workspace,
        y: &mut [f64; 3],
        [dx, dp, dmarker]: [&mut [f64]; 3],
    ) {
        let EvaluationPoint { t, x, p, prepared } = at;
        match self {
            Self::Generated(code) => {
                (code.observe_jac)(t, x, p, prepared, marker, y, dx, dp, dmarker);
            }
            Self::Tape(tape) => {
                let results = &mut [&mut y[..], dx, dp, dmarker];
                tape.observe_jac.eval(at, marker, workspace, results);
            }
        }
    }

    /// Computes the auxiliary variables of the model, in the order of its [`Layout`](codegen::Layout).
    pub fn quantities(&self, at: EvaluationPoint<'_>, workspace: &mut Workspace, q: &mut [f64]) {
        match self {
            Self::Generated(code) => (code.quantities)(at.t, at.x, at.p, at.prepared, q),
            Self::Tape(tape) => tape.quantities.eval(at, &[], workspace, &mut [q]),
        }
    }

    /// Computes the quantity of each limit of validity; the model is valid where each is above its bound.
    pub fn limits(&self, at: EvaluationPoint<'_>, workspace: &mut Workspace, l: &mut [f64]) {
        match self {
            Self::Generated(code) => (code.limits)(at.t, at.x, at.p, at.prepared, l),
            Self::Tape(tape) => tape.limits.eval(at, &[], workspace, &mut [l]),
        }
    }
}
