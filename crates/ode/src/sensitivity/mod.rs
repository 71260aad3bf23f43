//! Forward sensitivities: the variational equations dS/dt = J S + [0 | Jp], integrated together with the state.

mod integrate;
mod jacobian_product;
mod projected;

use self::jacobian_product::JacobianProduct;
use self::projected::ProjectedSensitivities;
use crate::projection::Projection;
use crate::{AlignedVec, OdeRhs, RhsProperties};
use lanes::{Enclosure, Switch};
use std::borrow::Cow;
use std::ops::Range;
use std::sync::Arc;

/// Right-hand side f(t, x, p) with its sparse Jacobians J = ∂f/∂x and Jp = ∂f/∂p.
pub trait DifferentiableRhs: RhsProperties {
    /// Number of states.
    fn states(&self) -> usize;
    /// Sparsity pattern of the Jacobian J = ∂f/∂x: (row, column) of each entry, ordered by row.
    fn jacobian_pattern(&self) -> &[(usize, usize)];
    /// Sparsity pattern of the Jacobian Jp = ∂f/∂p: (row, parameter index) of each entry, in any order.
    fn parameter_jacobian_pattern(&self) -> &[(usize, usize)];
    /// Writes f(t, x, p) to `dx`, the entries of J = ∂f/∂x to `jacobian`, and the entries of Jp = ∂f/∂p to
    /// `parameter_jacobian`; entries are in the order of the sparsity patterns.
    fn derivative_with_jacobians(
        &mut self,
        t: f64,
        x: &[f64],
        dx: &mut [f64],
        jacobian: &mut [f64],
        parameter_jacobian: &mut [f64],
    );
}

/// Augmented right-hand side for the state x and its sensitivities S = ∂x/∂(initial states, parameters).
///
/// The augmented state vector contains x, then S row by row, both padded with zeros; see [`SensitivityLayout`].
/// [`initial_state`](Self::initial_state) builds the initial state vector. Only x is in the error norm of the step-size
/// control, so that the steps are those of x alone.
///
/// [`integrate_at`](Self::integrate_at), [`integrate_to_event`](Self::integrate_to_event) and
/// [`integrate_with_callback`](Self::integrate_with_callback) integrate it as the generic functions of the same names do,
/// without compiling the solver again in the calling crate.
pub struct Sensitivities<'m> {
    rhs: &'m mut dyn DifferentiableRhs,
    layout: SensitivityLayout,
    /// Indices in ∂f/∂p of the parameters of the last columns of the sensitivity matrix S.
    parameters: Vec<usize>,
    product: JacobianProduct,
    /// Terms that the parameter Jacobian Jp = ∂f/∂p adds to dS/dt, the time derivative of the sensitivity matrix S:
    /// (index of the entry in Jp, index of the element in S).
    parameter_terms: Vec<(usize, usize)>,
    jacobian: Vec<f64>,
    parameter_jacobian: Vec<f64>,
}

impl<'m> Sensitivities<'m> {
    /// Builds the augmented right-hand side. The first columns of the sensitivity matrix S are derivatives along
    /// `directions` in the space of initial states, which [`initial_state`](Self::initial_state) sets; the following
    /// columns are derivatives with respect to the parameters with the indices `parameters` in ∂f/∂p.
    ///
    /// # Panics
    /// If the entries of the Jacobian ∂f/∂x are not ordered by row.
    pub fn new(
        rhs: &'m mut dyn DifferentiableRhs,
        directions: usize,
        parameters: &[usize],
    ) -> Self {
        let states = rhs.states();
        let columns = directions + parameters.len();
        // Rows consist of whole SIMD vectors.
        let width = lanes::Isa::best().width();
        let stride = columns.next_multiple_of(width);
        let entries = rhs.parameter_jacobian_pattern().iter().enumerate();
        let parameter_terms = entries.flat_map(|(entry, (row, parameter))| {
            let columns = parameters.iter().enumerate();
            let columns = columns.filter(move |(_, p)| *p == parameter);
            columns.map(move |(column, _)| (entry, row * stride + directions + column))
        });
        let parameter_terms = parameter_terms.collect();
        let jacobian = vec![0.0; rhs.jacobian_pattern().len()];
        let parameter_jacobian = vec![0.0; rhs.parameter_jacobian_pattern().len()];
        let pattern = rhs.jacobian_pattern();
        assert!(pattern.is_sorted_by_key(|(row, _)| row), "ordered by row");
        let product = JacobianProduct::new(pattern, states, stride);
        Sensitivities {
            layout: SensitivityLayout {
                states,
                columns,
                first: states.next_multiple_of(width),
                stride,
            },
            rhs,
            parameters: parameters.to_vec(),
            product,
            parameter_terms,
            jacobian,
            parameter_jacobian,
        }
    }

    /// Augmented initial state: the state `x`, and the sensitivity matrix S with the given entries (state, column,
    /// value) and all other entries 0. A column that contains a direction in the space of initial states becomes the
    /// derivative of the state along it.
    ///
    /// # Panics
    /// If the length of `x` is not the number of states, or a state or column does not exist.
    pub fn initial_state(&self, x: &[f64], entries: &[(usize, usize, f64)]) -> AlignedVec {
        let layout = self.layout;
        assert_eq!(x.len(), layout.states, "one value per state");
        let mut augmented = AlignedVec::zeros(self.len());
        let values = augmented.as_mut();
        values[..layout.states].copy_from_slice(x);
        for &(state, column, value) in entries {
            assert!(column < layout.columns, "a column of S");
            values[layout.row_range(state)][column] = value;
        }
        augmented
    }

    /// Layout of the augmented state vector.
    pub fn layout(&self) -> SensitivityLayout {
        self.layout
    }

    /// Length of the augmented state vector, padding included.
    #[allow(clippy::len_without_is_empty)] // never empty
    pub fn len(&self) -> usize {
        self.layout.first + self.layout.states * self.layout.stride
    }
}

/// Layout of the augmented state: x, then S row by row; x and each row of S are padded with zeros.
#[derive(Clone, Copy, Debug)]
pub struct SensitivityLayout {
    states: usize,
    columns: usize,
    /// Index of the first element of the sensitivity matrix S in the augmented state vector.
    first: usize,
    /// Distance, in elements, between the first elements of successive rows of the sensitivity matrix S.
    stride: usize,
}

impl SensitivityLayout {
    /// Index range of the state x in the augmented state vector.
    pub fn state_range(&self) -> Range<usize> {
        0..self.states
    }

    /// Index range of the row of the sensitivity matrix S of one state, padding included.
    #[inline]
    pub fn row_range(&self, state: usize) -> Range<usize> {
        let first = self.first + state * self.stride;
        first..first + self.stride
    }

    /// State x within an augmented state vector.
    pub fn state<'x>(&self, augmented: &'x [f64]) -> &'x [f64] {
        &augmented[self.state_range()]
    }

    /// Row of the sensitivity matrix S of one state within an augmented state vector, padding included.
    #[inline]
    pub fn padded_row<'x>(&self, augmented: &'x [f64], state: usize) -> &'x [f64] {
        &augmented[self.row_range(state)]
    }
}

impl OdeRhs for Sensitivities<'_> {
    type State = AlignedVec;

    fn derivative(&mut self, t: f64, augmented: &AlignedVec, rates: &mut AlignedVec) {
        let SensitivityLayout { states, first, .. } = self.layout;
        let (x, s) = augmented.as_ref().split_at(first);
        let (dx, ds) = rates.as_mut().split_at_mut(first);
        let (x, dx) = (&x[..states], &mut dx[..states]);
        let (jacobian, parameter_jacobian) = (&mut self.jacobian, &mut self.parameter_jacobian);
        self.rhs
            .derivative_with_jacobians(t, x, dx, jacobian, parameter_jacobian);
        self.product.write(jacobian, s, ds);
        let parameter_jacobian = &parameter_jacobian[..];
        for &(entry, index) in &self.parameter_terms[..] {
            ds[index] += parameter_jacobian[entry];
        }
    }

    fn error_controlled_len(&self) -> usize {
        self.layout.states
    }
}

impl RhsProperties for Sensitivities<'_> {
    fn projection(&self) -> Option<Projection> {
        let of_states = self.rhs.projection()?;
        Some(Arc::new(ProjectedSensitivities::new(
            of_states,
            self.layout,
            &self.parameters,
        )))
    }

    fn time_breaks(&self) -> &[f64] {
        self.rhs.time_breaks()
    }

    fn switches(&self) -> Option<Arc<[Switch]>> {
        self.rhs.switches()
    }

    fn switch_arguments(&mut self, t: f64, augmented: &[f64], to: &mut [f64]) {
        self.rhs
            .switch_arguments(t, self.layout.state(augmented), to);
    }

    fn switch_bounds(&mut self, t: Enclosure, x: &[Enclosure], to: &mut [Enclosure]) -> bool {
        self.rhs.switch_bounds(t, &x[..self.layout.states], to)
    }

    fn state_name(&self, component: usize) -> Cow<'_, str> {
        let SensitivityLayout { first, stride, .. } = self.layout;
        match component.checked_sub(first) {
            None => self.rhs.state_name(component),
            Some(i) => {
                let state = self.rhs.state_name(i / stride);
                format!("∂{state}/∂column {}", i % stride).into()
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Test right-hand side of four states whose Jacobian has the entries 1, 2, … in the order of its pattern.
    struct Numbered(Vec<(usize, usize)>);

    impl DifferentiableRhs for Numbered {
        fn states(&self) -> usize {
            4
        }
        fn jacobian_pattern(&self) -> &[(usize, usize)] {
            &self.0
        }
        fn parameter_jacobian_pattern(&self) -> &[(usize, usize)] {
            &[(2, 0)]
        }
        fn derivative_with_jacobians(
            &mut self,
            _: f64,
            _: &[f64],
            dx: &mut [f64],
            j: &mut [f64],
            jp: &mut [f64],
        ) {
            dx.fill(0.0);
            jp.fill(100.0);
            for (i, value) in j.iter_mut().enumerate() {
                *value = (i + 1) as f64;
            }
        }
    }

    impl RhsProperties for Numbered {}

    #[test]
    fn derivative_equals_plain_loops_for_any_number_of_columns() {
        let distinct_rows = [(0, 1), (0, 3), (2, 0), (2, 1), (2, 2), (2, 3), (3, 1)];
        let two_equal_rows = [(0, 1), (0, 3), (1, 2), (3, 1), (3, 3)];
        let all_equal_rows = [0, 1, 2, 3].map(|row| [(row, 0), (row, 2), (row, 3)]);
        for columns in 1..100 {
            check_against_plain_loops(&distinct_rows, columns);
            check_against_plain_loops(&two_equal_rows, columns);
            check_against_plain_loops(&all_equal_rows.concat(), columns);
        }
    }

    fn check_against_plain_loops(pattern: &[(usize, usize)], columns: usize) {
        let parameters = vec![0; columns];
        let mut rhs = Numbered(pattern.to_vec());
        let mut augmented = Sensitivities::new(&mut rhs, 0, &parameters);
        let value = |state: usize, column: usize| (state * 7 + column * 3) as f64;
        let entries = (0..4).flat_map(|s| (0..columns).map(move |c| (s, c, value(s, c))));
        let at = augmented.initial_state(&[0.0; 4], &entries.collect::<Vec<_>>());
        let mut rates = at.clone();
        augmented.derivative(0.0, &at, &mut rates);
        for state in 0..4 {
            for column in 0..columns {
                let entries = pattern
                    .iter()
                    .enumerate()
                    .filter(|(_, (row, _))| *row == state);
                let terms = entries.map(|(i, (_, other))| (i + 1) as f64 * value(*other, column));
                let expected = terms.sum::<f64>() + if state == 2 { 100.0 } else { 0.0 };
                let found = augmented.layout.padded_row(rates.as_ref(), state)[column];
                assert_eq!(found, expected, "{state}, {column} of {columns}");
            }
        }
    }
}
