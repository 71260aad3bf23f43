//! Assignment of unknowns to the columns of a residual's Jacobian.

use flight::ObservationJacobians;
use lanes::{Kernel, Lanes};
use model_spec::layout::ParamId;
use nalgebra::DMatrix;
use ode::{DifferentiableRhs, SensitivityLayout};

use crate::ids::LocalId;
use crate::least_squares::GramAccumulator;
use crate::observations::Observations;

/// Order of a Jacobian row's columns: directions of the initial state with integrated sensitivities, parameters,
/// directions with constant sensitivity 1, on whose state no derivative of the model depends.
pub(crate) struct JacobianColumns<'p> {
    pub integrated: usize,
    /// Column index of each free direction of the initial state (see `StateManifold`).
    local: Vec<usize>,
    constant: Vec<Option<usize>>,
    pub parameters: &'p [ParamId],
}

impl<'p> JacobianColumns<'p> {
    /// Assigns columns to the directions of the initial state and to `parameters`, for the equations of motion `motion`.
    pub fn new(
        observations: &Observations,
        motion: &dyn DifferentiableRhs,
        parameters: &'p [ParamId],
    ) -> Self {
        let pattern = motion.jacobian_pattern();
        let manifold = &observations.manifold;
        let dimension = manifold.dimension();
        let constant: Vec<(usize, usize)> = (0..dimension)
            .filter_map(|direction| {
                let state = manifold.direct_state(LocalId::new(direction))?;
                Some((direction, state.index()))
            })
            .filter(|(_, state)| pattern.iter().all(|(_, column)| column != state))
            .collect();
        let integrated = dimension - constant.len();
        let (mut next, mut next_constant) = (0, integrated + parameters.len());
        let local = (0..dimension).map(|direction| {
            let is_constant = constant.iter().any(|(d, _)| *d == direction);
            let column = if is_constant {
                &mut next_constant
            } else {
                &mut next
            };
            *column += 1;
            *column - 1
        });
        let local: Vec<usize> = local.collect();
        let mut column_of = vec![None; manifold.states()];
        for (direction, state) in constant {
            column_of[state] = Some(local[direction]);
        }
        Self {
            integrated,
            local,
            constant: column_of,
            parameters,
        }
    }

    fn parameter_columns(&self) -> std::ops::Range<usize> {
        self.integrated..self.integrated + self.parameters.len()
    }

    /// Creates an empty accumulator of normal equations for Jacobian rows with these columns.
    pub fn accumulator(&self) -> GramAccumulator {
        GramAccumulator::new(self.local.clone(), self.parameter_columns().collect())
    }

    pub fn local_then_parameters(&self) -> Vec<usize> {
        let local = self.local.iter().copied();
        local.chain(self.parameter_columns()).collect()
    }

    /// Derivatives of the states by the local parameters (states × local parameters).
    pub fn states_by_local(&self, layout: SensitivityLayout, augmented: &[f64]) -> DMatrix<f64> {
        DMatrix::from_fn(self.constant.len(), self.local.len(), |state, k| {
            let column = self.local[k];
            match column < self.integrated {
                true => layout.padded_row(augmented, state)[column],
                false => f64::from(u8::from(self.constant[state] == Some(column))),
            }
        })
    }

    /// Converts entries of the manifold's tangent (state, direction, value) to (state, column, value), where
    /// integrated.
    pub fn tangent(&self, entries: &[(usize, usize, f64)]) -> Vec<(usize, usize, f64)> {
        let columns = entries.iter();
        let columns =
            columns.map(|&(state, direction, value)| (state, self.local[direction], value));
        columns
            .filter(|(_, column, _)| *column < self.integrated)
            .collect()
    }

    /// Rows of zeros, one per axis, as long as the rows of the accumulator.
    pub fn empty_rows(&self) -> [Vec<f64>; 3] {
        let columns = self.local.len() + self.parameters.len();
        [0; 3].map(|_| vec![0.0; GramAccumulator::width(columns)])
    }

    /// Writes the derivatives of an observation into `rows`, one row per axis, by the chain rule. `augmented` is the
    /// state with its sensitivities.
    pub fn derive(
        &self,
        derivatives: &ObservationJacobians<'_>,
        (layout, augmented): (SensitivityLayout, &[f64]),
        rows: &mut [Vec<f64>; 3],
    ) {
        lanes::dispatch(Chain {
            derivatives,
            layout,
            augmented,
            rows,
        });
        let entries = derivatives
            .by_state_pattern
            .iter()
            .zip(derivatives.by_state);
        for (&(axis, state), &value) in entries {
            if let Some(column) = self.constant[state] {
                rows[axis][column] += value;
            }
        }
        let entries = derivatives
            .by_parameter_pattern
            .iter()
            .zip(derivatives.by_parameter);
        for (&(axis, parameter), &value) in entries {
            let mut parameters = self.parameters.iter();
            if let Some(k) = parameters.position(|id| id.index() == parameter) {
                rows[axis][self.integrated + k] += value;
            }
        }
    }
}

/// SIMD kernel of the chain rule.
struct Chain<'a> {
    derivatives: &'a ObservationJacobians<'a>,
    layout: SensitivityLayout,
    /// State with its sensitivities to the unknowns, padded with zeros to whole SIMD vectors.
    augmented: &'a [f64],
    rows: &'a mut [Vec<f64>; 3],
}

impl Kernel for Chain<'_> {
    type Output = ();

    #[inline(always)]
    fn run<T: Lanes>(self) {
        let ObservationJacobians {
            by_state_pattern,
            by_state,
            ..
        } = *self.derivatives;
        for row in &mut *self.rows {
            row.fill(0.0);
        }
        for (&(axis, state), &value) in by_state_pattern.iter().zip(by_state) {
            let (factor, from) = (
                T::splat(value),
                self.layout.padded_row(self.augmented, state),
            );
            let to = self.rows[axis].chunks_exact_mut(T::WIDTH);
            for (to, from) in to.zip(from.chunks_exact(T::WIDTH)) {
                factor.mul_add(T::load(from), T::load(to)).store(to);
            }
        }
    }
}
