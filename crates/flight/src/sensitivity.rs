//! How a flight changes with its start and its constants: the variational equations, flown along with it.

use crate::dynamics::Dynamics;
use lanes::{Kernel, Lanes};
use std::borrow::Cow;
use std::ops::Range;

/// Equations of motion with their derivatives, as generated code and the tape give them.
pub trait Linearised {
    /// How many states.
    fn states(&self) -> usize;
    /// Row and column of each entry of ∂f/∂x that is not always 0.
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
/// Its state is `x`, then S row by row, each row padded with zeros; [`start`](Self::start) makes it,
/// [`state`](Self::state) and [`row`](Self::row) read it. Steps are controlled by the error of `x` alone, unless
/// [`controlled_by_all`](Self::controlled_by_all).
pub struct Sensitivities<M> {
    model: M,
    states: usize,
    columns: usize,
    stride: usize,
    initial: Vec<usize>,
    /// Rows of ∂f/∂x, and where the entries of each are.
    rows: Vec<(usize, Range<usize>)>,
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
    /// Where there is no such state.
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
        let rows = rows(model.state_pattern());
        Sensitivities {
            model,
            states,
            columns,
            stride,
            initial,
            rows,
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
    pub fn start(&self, x: &[f64]) -> Box<[f64]> {
        assert_eq!(x.len(), self.states, "a number for each state");
        let mut start = vec![0.0; self.len()];
        start[..self.states].copy_from_slice(x);
        for (column, state) in self.initial.iter().enumerate() {
            start[self.states + state * self.stride + column] = 1.0;
        }
        start.into()
    }

    /// The start of a flight whose S has these entries (state, column, value) and 0 elsewhere.
    ///
    /// # Panics
    /// Where `x` has not a number for each state, or there is no such state or column.
    pub fn start_along(&self, x: &[f64], entries: &[(usize, usize, f64)]) -> Box<[f64]> {
        assert_eq!(x.len(), self.states, "a number for each state");
        let mut start = vec![0.0; self.len()];
        start[..self.states].copy_from_slice(x);
        for &(state, column, value) in entries {
            assert!(column < self.columns, "a column of S");
            start[self.states + state * self.stride + column] = value;
        }
        start.into()
    }

    /// How many numbers the state and S together are.
    #[allow(clippy::len_without_is_empty)] // of a vector that is never empty
    pub fn len(&self) -> usize {
        self.states * (1 + self.stride)
    }

    /// The state alone.
    pub fn state<'x>(&self, both: &'x [f64]) -> &'x [f64] {
        &both[..self.states]
    }

    /// How one state changes with each of the columns.
    pub fn row<'x>(&self, both: &'x [f64], state: usize) -> &'x [f64] {
        &both[self.states + state * self.stride..][..self.columns]
    }

    /// The same with the zeros that it is padded with to whole lanes.
    pub fn padded_row<'x>(&self, both: &'x [f64], state: usize) -> &'x [f64] {
        &both[self.states + state * self.stride..][..self.stride]
    }

    /// The model.
    pub fn model(&mut self) -> &mut M {
        &mut self.model
    }
}

impl<M: Linearised> Dynamics for Sensitivities<M> {
    type State = Box<[f64]>;

    fn derivative(&mut self, t: f64, both: &Box<[f64]>, rates: &mut Box<[f64]>) {
        let (x, s) = both.split_at(self.states);
        let (dx, ds) = rates.split_at_mut(self.states);
        self.model
            .linearise(t, x, dx, &mut self.by_state, &mut self.by_constant);
        ds.fill(0.0);
        for (entry, place) in &self.constant_entries {
            ds[*place] = self.by_constant[*entry];
        }
        lanes::dispatch(AddProduct {
            rows: &self.rows,
            columns: self.model.state_pattern(),
            values: &self.by_state,
            stride: self.stride,
            s,
            ds,
        });
    }

    fn controlled(&self) -> usize {
        if self.by_all { usize::MAX } else { self.states }
    }

    fn state_name(&self, component: usize) -> Cow<'_, str> {
        match component.checked_sub(self.states) {
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

/// The entries of each row, which stand together.
fn rows(pattern: &[(usize, usize)]) -> Vec<(usize, Range<usize>)> {
    let mut rows: Vec<(usize, Range<usize>)> = Vec::new();
    for (entry, (row, _)) in pattern.iter().enumerate() {
        match rows.last_mut() {
            Some((last, range)) if last == row => range.end = entry + 1,
            _ => rows.push((*row, entry..entry + 1)),
        }
    }
    rows
}

/// `ds += J s`, J given by its entries.
struct AddProduct<'a> {
    rows: &'a [(usize, Range<usize>)],
    columns: &'a [(usize, usize)],
    values: &'a [f64],
    stride: usize,
    s: &'a [f64],
    ds: &'a mut [f64],
}

impl Kernel for AddProduct<'_> {
    type Output = ();

    #[inline(always)]
    fn run<T: Lanes>(self) {
        const { assert!(PADDING.is_multiple_of(T::WIDTH)) };
        for (row, entries) in self.rows {
            let to = &mut self.ds[row * self.stride..][..self.stride];
            let entries = self.columns[entries.clone()]
                .iter()
                .zip(&self.values[entries.clone()]);
            // Two sums at a time, which stay where they are summed.
            let mut pairs = to.chunks_exact_mut(2 * T::WIDTH);
            let mut at = 0;
            for to in &mut pairs {
                let (mut left, mut right) = (T::load(to), T::load(&to[T::WIDTH..]));
                for (&(_, column), &value) in entries.clone() {
                    let from = &self.s[column * self.stride + at..][..2 * T::WIDTH];
                    let value = T::splat(value);
                    left = value.mul_add(T::load(from), left);
                    right = value.mul_add(T::load(&from[T::WIDTH..]), right);
                }
                left.store(to);
                right.store(&mut to[T::WIDTH..]);
                at += 2 * T::WIDTH;
            }
            let to = pairs.into_remainder();
            if !to.is_empty() {
                let mut sum = T::load(to);
                for (&(_, column), &value) in entries.clone() {
                    sum =
                        T::splat(value).mul_add(T::load(&self.s[column * self.stride + at..]), sum);
                }
                sum.store(to);
            }
        }
    }
}
