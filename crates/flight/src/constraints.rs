//! Constraints of a model, compiled: how far a state is from them, and the shortest way back.

use std::fmt;
use std::sync::Arc;

use codegen::Layout;
use codegen::compile::{Selection, compile_for};
use codegen::tape_model::TapeModel;
use model_spec::model::{AuxVariable, Expr, ExprKind, Model, Shape};
use nalgebra::{DMatrix, DMatrixViewMut, DVector};
use ode::Project;

use crate::functions::{EvaluationPoint, ModelFunctions, Workspace};
use crate::moore_penrose;

/// Maximum number of steps of Newton's method.
const MAX_STEPS: usize = 20;
/// Size of a step, relative to the states, below which the constraints hold but for rounding.
const SMALL: f64 = 4.0 * f64::EPSILON;
/// Singular values relative to the greatest, below which constraints count as saying the same.
const RANK_TOLERANCE: f64 = 1e-10;

/// Deviations from the constraints of a model, and from the derivatives of these that have no unknowns, with their
/// derivatives by the states.
pub struct Constraints {
    functions: ModelFunctions,
    layout: Layout,
    count: usize,
    states: usize,
    /// State indices of each unit quaternion.
    quaternions: Vec<[usize; 4]>,
}

impl fmt::Debug for Constraints {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Constraints")
            .field("count", &self.count)
            .finish_non_exhaustive()
    }
}

impl Constraints {
    /// Compiles the constraints of a model; `None` if it has none.
    pub fn of(model: &Model) -> Option<Constraints> {
        let systems = model.systems.iter();
        let deviations: Vec<Expr> = systems.flat_map(|own| own.constraints.clone()).collect();
        if deviations.is_empty() {
            return None;
        }
        let mut own = model.clone();
        for system in &mut own.systems {
            system.constraints.clear();
        }
        own.observation = None;
        own.limits.clear();
        let states = model.states.len();
        for (k, deviation) in deviations.iter().enumerate() {
            let name = format!("constraint__{k}");
            let by_state = (0..states).map(|state| Expr {
                kind: ExprKind::Partial(Box::new(deviation.clone()), state),
                shape: Shape::Scalar,
                ..deviation.clone()
            });
            let all = std::iter::once(deviation.clone()).chain(by_state);
            let all = all.map(|value| AuxVariable::new(name.clone(), value));
            own.aux_variables.extend(all);
        }
        let compiled = compile_for(&own, &Selection::Only(Vec::new()));
        Some(Constraints {
            functions: ModelFunctions::Tape(Box::new(TapeModel::new(&compiled))),
            layout: Layout::new(&own),
            count: deviations.len(),
            states,
            quaternions: model.quaternions().collect(),
        })
    }

    /// Number of constraints, and of their derivatives that have no unknowns.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Whether the constraints at the default states change with a parameter, by its index in the model's
    /// [`Layout`](codegen::Layout).
    pub fn depend_on(self: &Arc<Self>, parameters: &[f64], index: usize) -> bool {
        let states = self.layout.default_states();
        let at = |parameters: &[f64]| self.bind(parameters.to_vec()).deviations(0.0, &states);
        let mut moved = parameters.to_vec();
        moved[index] += 0.01 * (1.0 + moved[index].abs());
        let ((a, da), (b, db)) = (at(parameters), at(&moved));
        let mut all = a.iter().chain(&da).zip(b.iter().chain(&db));
        all.any(|(a, b)| (a - b).abs() > 0.0)
    }

    /// Binds the constraints to values of the model's parameters.
    pub fn bind(self: &Arc<Self>, parameters: Vec<f64>) -> BoundConstraints {
        BoundConstraints {
            constraints: Arc::clone(self),
            prepared: self.functions.prepared(&parameters),
            parameters,
        }
    }
}

/// Constraints of a model with values of its parameters.
#[derive(Debug)]
pub struct BoundConstraints {
    constraints: Arc<Constraints>,
    parameters: Vec<f64>,
    /// Values computed from the parameters alone.
    prepared: Vec<f64>,
}

impl BoundConstraints {
    /// Deviations from the constraints at a state, SI, and their derivatives by the states, a row for each.
    pub fn deviations(&self, t: f64, state: &[f64]) -> (DVector<f64>, DMatrix<f64>) {
        let (count, states) = (self.constraints.count, self.constraints.states);
        let mut quantities = vec![0.0; self.constraints.layout.quantities.len()];
        let at = EvaluationPoint {
            t,
            x: state,
            p: &self.parameters,
            prepared: &self.prepared,
        };
        let functions = &self.constraints.functions;
        functions.quantities(at, &mut Workspace::default(), &mut quantities);
        let own = &quantities[quantities.len() - count * (states + 1)..];
        let deviations = DVector::from_fn(count, |row, _| own[row * (states + 1)]);
        let by_state = DMatrix::from_fn(count, states, |row, state| {
            own[row * (states + 1) + 1 + state]
        });
        (deviations, by_state)
    }

    /// Moves a state to where the constraints hold, by the shortest steps of Newton's method along the columns of
    /// `directions`; without these, along all states. Returns whether it has moved; where the steps do not end, the state
    /// stays.
    pub fn project(&self, t: f64, state: &mut [f64], directions: Option<&DMatrix<f64>>) -> bool {
        let mut moved = state.to_vec();
        let mut has_moved = false;
        for _ in 0..MAX_STEPS {
            let (deviations, mut by_state) = self.deviations(t, &moved);
            take_lengths(&mut by_state, &moved, &self.constraints.quaternions);
            let along = match directions {
                Some(directions) => by_state * directions,
                None => by_state,
            };
            if along.ncols() == 0 || !along.iter().chain(&deviations).all(|v| v.is_finite()) {
                return false;
            }
            let step = moore_penrose(&along, RANK_TOLERANCE) * deviations;
            let step = match directions {
                Some(directions) => directions * step,
                None => step,
            };
            let size = moved.iter().map(|v| v * v).sum::<f64>().sqrt();
            if step.norm() <= SMALL * size {
                if has_moved {
                    state.copy_from_slice(&moved);
                }
                return has_moved;
            }
            for (state, change) in moved.iter_mut().zip(&step) {
                *state -= change;
            }
            has_moved = true;
        }
        false
    }
}

impl Project for BoundConstraints {
    fn project(&self, t: f64, x: &mut [f64]) -> bool {
        BoundConstraints::project(self, t, x, None)
    }

    fn project_directions(&self, t: f64, x: &[f64], directions: &mut [f64]) {
        let states = self.constraints.states;
        let (_, by_state) = self.deviations(t, x);
        let mut directions =
            DMatrixViewMut::from_slice(directions, states, directions.len() / states);
        let leaving = &by_state * &directions;
        let mut along = by_state;
        take_lengths(&mut along, x, &self.constraints.quaternions);
        if !along.iter().chain(&leaving).all(|v| v.is_finite()) {
            return;
        }
        directions -= moore_penrose(&along, RANK_TOLERANCE) * leaving;
    }

    fn depends_on(&self, parameter: usize) -> bool {
        parameter < self.parameters.len() && self.constraints.depend_on(&self.parameters, parameter)
    }
}

/// Takes from derivatives by the states, a row for each function of them, the part along each of `quaternions`, whose
/// length is not to change.
pub fn take_lengths(by_state: &mut DMatrix<f64>, state: &[f64], quaternions: &[[usize; 4]]) {
    for quaternion in quaternions {
        let own = quaternion.map(|k| state[k]);
        let square: f64 = own.iter().map(|q| q * q).sum();
        for mut row in by_state.row_iter_mut() {
            let along: f64 = quaternion.iter().zip(own).map(|(&k, q)| row[k] * q).sum();
            for (&k, q) in quaternion.iter().zip(&own) {
                row[k] -= along / square * q;
            }
        }
    }
}
