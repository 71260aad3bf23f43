//! Assignment of unknowns to the columns of a residual's Jacobian.

use flight::ObservationJacobians;
use lanes::{Kernel, Lanes};
use model_spec::layout::ParamId;
use ode::SensitivityLayout;

use crate::ids::LocalId;
use crate::least_squares::GramAccumulator;
use crate::observations::Observations;

/// Order of the columns of a Jacobian row: free directions of the initial state with integrated sensitivities, then
/// parameters, then free directions with constant sensitivity. The sensitivity to a direction is constant if no
/// derivative of the model depends on the state that varies along it: the derivative of that state with respect to its
/// initial value is then 1.
pub(super) struct JacobianColumns<'p> {
    /// Number of free directions of the initial state whose sensitivities are integrated; other sensitivities are
    /// constant.
    pub integrated: usize,
    /// Column index of each free direction of the initial state (see `StateManifold`).
    local: Vec<usize>,
    /// For each state with constant sensitivity, the index of the Jacobian column with the derivatives with respect to
    /// its initial value; `None` for states whose sensitivities are integrated or that are known.
    constant: Vec<Option<usize>>,
    /// Parameters with respect to which residuals are differentiated.
    pub parameters: &'p [ParamId],
}

impl<'p> JacobianColumns<'p> {
    /// Assigns a Jacobian column to each free direction of the flight's initial state and to each of `parameters`.
    /// `pattern` contains the (row, column) indices of the nonzero entries of ∂f/∂x, where f is the derivative of the
    /// state x with respect to time.
    pub fn new(
        observations: &Observations,
        pattern: &[(usize, usize)],
        parameters: &'p [ParamId],
    ) -> Self {
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

    /// Column indices of the estimated components of the flight's own initial state, followed by those of the
    /// parameters common to all flights.
    pub fn local_then_parameters(&self) -> Vec<usize> {
        let local = self.local.iter().copied();
        local.chain(self.parameter_columns()).collect()
    }

    /// Converts entries of the tangent of the state manifold from (state, direction, value) to (state, column, value).
    /// Returns only entries in columns whose sensitivities are integrated.
    pub fn tangent(&self, entries: &[(usize, usize, f64)]) -> Vec<(usize, usize, f64)> {
        let columns = entries.iter();
        let columns =
            columns.map(|&(state, direction, value)| (state, self.local[direction], value));
        columns
            .filter(|(_, column, _)| *column < self.integrated)
            .collect()
    }

    /// Rows of zeros for the derivatives along the three axes of an observation, as long as the rows of the accumulator
    /// of the normal equations.
    pub fn empty_rows(&self) -> [Vec<f64>; 3] {
        let columns = self.local.len() + self.parameters.len();
        [0; 3].map(|_| vec![0.0; GramAccumulator::width(columns)])
    }

    /// Writes the derivatives of an observation with respect to the unknowns into `rows`, one row per axis. They follow
    /// from its Jacobians `derivatives` by the chain rule. `augmented` is the state with its sensitivities to the
    /// unknowns, in the given layout.
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

/// SIMD kernel of the chain rule: derivatives of an observation with respect to the states, times the sensitivities of
/// the states.
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
        let stride = self.layout.row_range(0).len();
        // Number of elements of each row that are written.
        let mut written = [0; 3];
        let mut terms = [(0.0, &[] as &[f64]); GROUP];
        let (mut axis, mut count) = (0, 0);
        for (&(of, state), &value) in by_state_pattern.iter().zip(by_state) {
            if of != axis || count == GROUP {
                sum_terms::<T>(
                    &mut self.rows[axis][..stride],
                    &terms[..count],
                    &mut written[axis],
                );
                (axis, count) = (of, 0);
            }
            terms[count] = (value, self.layout.padded_row(self.augmented, state));
            count += 1;
        }
        sum_terms::<T>(
            &mut self.rows[axis][..stride],
            &terms[..count],
            &mut written[axis],
        );
        for (row, written) in self.rows.iter_mut().zip(written) {
            row[written..].fill(0.0);
        }
    }
}

/// Number of terms of the chain rule that are summed at once, so that the row is seldom written.
const GROUP: usize = 4;

/// Writes the sum of at most `GROUP` products of a factor and a vector to `row`, or adds it if the row is already
/// written. `written` is the number of elements written, 0 or all.
#[inline(always)]
fn sum_terms<T: Lanes>(row: &mut [f64], terms: &[(f64, &[f64])], written: &mut usize) {
    let adds = *written > 0;
    match *terms {
        [a, b, c, d] => sum_exactly::<T, 4>(row, [a, b, c, d], adds),
        [a, b, c] => sum_exactly::<T, 3>(row, [a, b, c], adds),
        [a, b] => sum_exactly::<T, 2>(row, [a, b], adds),
        [a] => sum_exactly::<T, 1>(row, [a], adds),
        _ => return,
    }
    *written = row.len();
}

#[inline(always)]
fn sum_exactly<T: Lanes, const N: usize>(
    row: &mut [f64],
    mut terms: [(f64, &[f64]); N],
    adds: bool,
) {
    let length = row.len();
    // Equal lengths, visible to the compiler, remove the bounds checks from the loop.
    for (_, from) in &mut terms {
        *from = &from[..length];
    }
    let mut i = 0;
    while i + T::WIDTH <= length {
        let mut sum = match adds {
            true => T::load(&row[i..]),
            false => T::splat(0.0),
        };
        for (factor, from) in terms {
            sum = T::splat(factor).mul_add(T::load(&from[i..]), sum);
        }
        sum.store(&mut row[i..]);
        i += T::WIDTH;
    }
}
