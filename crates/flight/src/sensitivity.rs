//! How a flight changes with its start and its constants: the variational equations, flown along with it.

mod product;

use self::product::Product;
use crate::aligned::Aligned;
use crate::dynamics::Dynamics;
use std::borrow::Cow;
use std::ops::Range;

/// Equations of motion with their derivatives, as generated code and the tape give them.
pub trait Linearised {
    /// How many states.
    fn states(&self) -> usize;
    /// Row and column of each entry of ∂f/∂x that is not always 0, row by row.
    fn state_pattern(&self) -> &[(usize, usize)];
    /// Row and column of each entry of ∂f/∂p that is not always 0; columns are constants of the model.
    fn constant_pattern(&self) -> &[(usize, usize)];
    /// Writes the rate of change of `x` at time `t` (s), and the entries of both derivatives in the order of
    /// their patterns.
    fn linearise(
        &mut self,
        t: f64,
        x: &[f64],
        dx: &mut [f64],
        by_state: &mut [f64],
        by_constant: &mut [f64],
    );
    /// Name of a state, for messages.
    fn state_name(&self, state: usize) -> Cow<'_, str> {
        format!("state {state}").into()
    }
}

/// Rows are padded to this, so that they are whole lanes of every kind.
const PADDING: usize = 8;

/// A model that is flown together with S = ∂x/∂(some of the start's states, some constants).
///
/// Its state is `x`, then S row by row, all padded with zeros; [`start`](Self::start) makes it,
/// [`state`](Self::state) and [`row`](Self::row) read it. Steps are controlled by the error of `x` alone, unless
/// [`controlled_by_all`](Self::controlled_by_all).
pub struct Sensitivities<M> {
    model: M,
    states: usize,
    /// Where S begins.
    first: usize,
    columns: usize,
    stride: usize,
    initial: Vec<usize>,
    product: Product,
    /// Entry of ∂f/∂p, and where it is added in S.
    constant_entries: Vec<(usize, usize)>,
    by_state: Vec<f64>,
    by_constant: Vec<f64>,
    by_all: bool,
}

impl<M: Linearised> Sensitivities<M> {
    /// With respect to the start's states `initial`, and then the model's constants `constants`, in that order.
    ///
    /// # Panics
    /// Where there is no such state, or the entries of ∂f/∂x do not stand row by row.
    pub fn new(model: M, initial: &[usize], constants: &[usize]) -> Self {
        let states = model.states();
        assert!(initial.iter().all(|i| *i < states), "states of the model");
        let columns = initial.len() + constants.len();
        let stride = columns.next_multiple_of(PADDING);
        let entries = model.constant_pattern().iter().enumerate();
        let constant_entries = entries.flat_map(|(entry, (row, constant))| {
            let chosen = constants
                .iter()
                .enumerate()
                .filter(move |(_, c)| *c == constant);
            chosen.map(move |(column, _)| (entry, row * stride + initial.len() + column))
        });
        let constant_entries = constant_entries.collect();
        let by_state = vec![0.0; model.state_pattern().len()];
        let by_constant = vec![0.0; model.constant_pattern().len()];
        let initial = initial.to_vec();
        let pattern = model.state_pattern();
        assert!(pattern.is_sorted_by_key(|(row, _)| row), "row by row");
        let product = Product::new(pattern, states, stride);
        Sensitivities {
            model,
            states,
            first: states.next_multiple_of(PADDING),
            columns,
            stride,
            initial,
            product,
            constant_entries,
            by_state,
            by_constant,
            by_all: false,
        }
    }

    /// The error of S counts in the control of the step as that of the state does.
    pub fn controlled_by_all(self) -> Self {
        Sensitivities {
            by_all: true,
            ..self
        }
    }

    /// How many columns S has.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// The start of a flight: the state, and S there.
    ///
    /// # Panics
    /// Where `x` has not a number for each state.
    pub fn start(&self, x: &[f64]) -> Aligned {
        assert_eq!(x.len(), self.states, "a number for each state");
        let mut all = Aligned::zeros(self.len());
        let start = all.as_mut();
        start[..self.states].copy_from_slice(x);
        for (column, state) in self.initial.iter().enumerate() {
            start[self.first + state * self.stride + column] = 1.0;
        }
        all
    }

    /// The start of a flight whose S has these entries (state, column, value) and 0 elsewhere.
    ///
    /// # Panics
    /// Where `x` has not a number for each state, or there is no such state or column.
    pub fn start_along(&self, x: &[f64], entries: &[(usize, usize, f64)]) -> Aligned {
        assert_eq!(x.len(), self.states, "a number for each state");
        let mut all = Aligned::zeros(self.len());
        let start = all.as_mut();
        start[..self.states].copy_from_slice(x);
        for &(state, column, value) in entries {
            assert!(column < self.columns, "a column of S");
            start[self.first + state * self.stride + column] = value;
        }
        all
    }

    /// Where the state and S stand among the numbers that are flown.
    pub fn places(&self) -> Places {
        Places {
            states: self.states,
            first: self.first,
            stride: self.stride,
        }
    }

    /// How many numbers the state and S together are.
    #[allow(clippy::len_without_is_empty)] // of a vector that is never empty
    pub fn len(&self) -> usize {
        self.first + self.states * self.stride
    }

    /// The state alone.
    pub fn state<'x>(&self, both: &'x [f64]) -> &'x [f64] {
        self.places().state(both)
    }

    /// How one state changes with each of the columns.
    pub fn row<'x>(&self, both: &'x [f64], state: usize) -> &'x [f64] {
        &self.places().padded_row(both, state)[..self.columns]
    }

    /// The model.
    pub fn model(&mut self) -> &mut M {
        &mut self.model
    }
}

/// Where the state and S stand among the numbers that are flown.
#[derive(Clone, Copy, Debug)]
pub struct Places {
    states: usize,
    first: usize,
    stride: usize,
}

impl Places {
    /// The state's.
    pub fn of_state(&self) -> Range<usize> {
        0..self.states
    }

    /// Those of how one state changes with each of the columns, padded with zeros to whole lanes.
    pub fn of_row(&self, state: usize) -> Range<usize> {
        let first = self.first + state * self.stride;
        first..first + self.stride
    }

    /// The state alone.
    pub fn state<'x>(&self, both: &'x [f64]) -> &'x [f64] {
        &both[self.of_state()]
    }

    /// How one state changes with each of the columns, with the zeros behind them.
    pub fn padded_row<'x>(&self, both: &'x [f64], state: usize) -> &'x [f64] {
        &both[self.of_row(state)]
    }
}

impl<M: Linearised> Dynamics for Sensitivities<M> {
    type State = Aligned;

    fn derivative(&mut self, t: f64, both: &Aligned, rates: &mut Aligned) {
        let (x, s) = both.as_ref().split_at(self.first);
        let (dx, ds) = rates.as_mut().split_at_mut(self.first);
        let (x, dx) = (&x[..self.states], &mut dx[..self.states]);
        self.model
            .linearise(t, x, dx, &mut self.by_state, &mut self.by_constant);
        self.product.write(&self.by_state, s, ds);
        let by_constant = &self.by_constant[..];
        for &(entry, place) in &self.constant_entries[..] {
            ds[place] += by_constant[entry];
        }
    }

    fn controlled(&self) -> usize {
        if self.by_all { usize::MAX } else { self.states }
    }

    fn state_name(&self, component: usize) -> Cow<'_, str> {
        match component.checked_sub(self.first) {
            None => self.model.state_name(component),
            Some(i) => format!(
                "∂{}/∂column {}",
                self.model.state_name(i / self.stride),
                i % self.stride
            )
            .into(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A model of four states whose entries of ∂f/∂x are the numbers from 1 on.
    struct Numbered(Vec<(usize, usize)>);

    impl Linearised for Numbered {
        fn states(&self) -> usize {
            4
        }
        fn state_pattern(&self) -> &[(usize, usize)] {
            &self.0
        }
        fn constant_pattern(&self) -> &[(usize, usize)] {
            &[(2, 0)]
        }
        fn linearise(&mut self, _: f64, _: &[f64], dx: &mut [f64], j: &mut [f64], jp: &mut [f64]) {
            dx.fill(0.0);
            jp.fill(100.0);
            for (i, value) in j.iter_mut().enumerate() {
                *value = (i + 1) as f64;
            }
        }
    }

    #[test]
    fn rates_are_those_of_plain_loops_for_any_number_of_columns() {
        let each_its_own = [(0, 1), (0, 3), (2, 0), (2, 1), (2, 2), (2, 3), (3, 1)];
        let two_alike = [(0, 1), (0, 3), (1, 2), (3, 1), (3, 3)];
        let all_alike = [0, 1, 2, 3].map(|row| [(row, 0), (row, 2), (row, 3)]);
        for columns in 1..100 {
            rates_are_those_of_plain_loops(&each_its_own, columns);
            rates_are_those_of_plain_loops(&two_alike, columns);
            rates_are_those_of_plain_loops(&all_alike.concat(), columns);
        }
    }

    fn rates_are_those_of_plain_loops(pattern: &[(usize, usize)], columns: usize) {
        let constants = vec![0; columns];
        let mut both = Sensitivities::new(Numbered(pattern.to_vec()), &[], &constants);
        let value = |state: usize, column: usize| (state * 7 + column * 3) as f64;
        let entries = (0..4).flat_map(|s| (0..columns).map(move |c| (s, c, value(s, c))));
        let at = both.start_along(&[0.0; 4], &entries.collect::<Vec<_>>());
        let mut rates = at.clone();
        both.derivative(0.0, &at, &mut rates);
        for state in 0..4 {
            for column in 0..columns {
                let entries = pattern
                    .iter()
                    .enumerate()
                    .filter(|(_, (row, _))| *row == state);
                let terms = entries.map(|(i, (_, other))| (i + 1) as f64 * value(*other, column));
                let expected = terms.sum::<f64>() + if state == 2 { 100.0 } else { 0.0 };
                let found = both.row(rates.as_ref(), state)[column];
                assert_eq!(found, expected, "{state}, {column} of {columns}");
            }
        }
    }
}
