//! Where each unknown stands in a row.

use flight::ObservationJacobians;
use lanes::{Kernel, Lanes};

use crate::least_squares::GramAccumulator;
use crate::observations::Observations;

/// Where the derivatives by each unknown stand in a row. A state that no rate depends on keeps its derivative of 1, and
/// need not be flown: its column stands behind those that are.
pub(super) struct JacobianColumns {
    /// Directions of the chart that are flown, which come first; the shared unknowns follow.
    pub moving: usize,
    /// Place of each direction.
    pub local: Vec<usize>,
    /// Of each state the place of the direction that is it and is not flown.
    still: Vec<Option<usize>>,
    /// How many shared unknowns.
    pub global: usize,
}

impl JacobianColumns {
    pub fn new(observations: &Observations, pattern: &[(usize, usize)], global: usize) -> Self {
        let dimension = observations.manifold.dimension();
        let still: Vec<(usize, usize)> = (0..dimension)
            .filter_map(|direction| Some((direction, observations.manifold.plain(direction)?)))
            .filter(|(_, state)| pattern.iter().all(|(_, column)| column != state))
            .collect();
        let moving = dimension - still.len();
        let (mut next, mut behind) = (0, moving + global);
        let local = (0..dimension).map(|direction| {
            let place = if still.iter().any(|(d, _)| *d == direction) {
                &mut behind
            } else {
                &mut next
            };
            *place += 1;
            *place - 1
        });
        let local: Vec<usize> = local.collect();
        let mut place_of = vec![None; observations.manifold.states()];
        for (direction, state) in still {
            place_of[state] = Some(local[direction]);
        }
        Self {
            moving,
            local,
            still: place_of,
            global,
        }
    }

    pub fn rows(&self) -> GramAccumulator {
        let global = self.moving..self.moving + self.global;
        GramAccumulator::new(self.local.clone(), global.collect())
    }

    /// The entries of the chart's tangent in the columns that are flown.
    pub fn tangent(&self, entries: &[(usize, usize, f64)]) -> Vec<(usize, usize, f64)> {
        let placed = entries
            .iter()
            .map(|&(state, direction, value)| (state, self.local[direction], value));
        placed
            .filter(|(_, place, _)| *place < self.moving)
            .collect()
    }

    /// Rows of x, y and z of one marker, of zeros.
    pub fn empty_rows(&self) -> [Vec<f64>; 3] {
        let width = self.rows().width();
        [0; 3].map(|_| vec![0.0; width])
    }

    /// Puts the derivatives of a marker's position by the unknowns into the rows of its axes.
    pub fn derive<'s>(
        &self,
        derivatives: &ObservationJacobians<'_>,
        row_of: impl Fn(usize) -> &'s [f64],
        constants: &[usize],
        rows: &mut [Vec<f64>; 3],
    ) {
        lanes::dispatch(Chain {
            derivatives,
            row_of,
            rows,
        });
        let entries = derivatives
            .by_state_pattern
            .iter()
            .zip(derivatives.by_state);
        for (&(axis, state), &value) in entries {
            if let Some(place) = self.still[state] {
                rows[axis][place] += value;
            }
        }
        let entries = derivatives
            .by_parameter_pattern
            .iter()
            .zip(derivatives.by_parameter);
        for (&(axis, place), &value) in entries {
            if let Some(column) = constants.iter().position(|constant| *constant == place) {
                rows[axis][self.moving + column] += value;
            }
        }
    }
}

/// Rows of a marker by what is flown: its derivatives by the states, times how those change.
struct Chain<'a, R> {
    derivatives: &'a ObservationJacobians<'a>,
    /// How a state changes, padded with zeros to whole lanes.
    row_of: R,
    rows: &'a mut [Vec<f64>; 3],
}

impl<'s, R: Fn(usize) -> &'s [f64]> Kernel for Chain<'_, R> {
    type Output = ();

    #[inline(always)]
    fn run<T: Lanes>(self) {
        let ObservationJacobians {
            by_state_pattern,
            by_state,
            ..
        } = self.derivatives;
        for (axis, row) in self.rows.iter_mut().enumerate() {
            row.fill(0.0);
            let all = by_state_pattern.iter().zip(*by_state);
            let mut entries = all.filter(|((at, _), _)| *at == axis);
            // Two at a time, so that the row is read and written half as often.
            while let Some((&(_, state), &value)) = entries.next() {
                let (value, from) = (T::splat(value), (self.row_of)(state));
                let to = row.chunks_exact_mut(T::WIDTH);
                match entries.next() {
                    Some((&(_, state), &second)) => {
                        let (second, others) = (T::splat(second), (self.row_of)(state));
                        let from = from
                            .chunks_exact(T::WIDTH)
                            .zip(others.chunks_exact(T::WIDTH));
                        for (to, (from, other)) in to.zip(from) {
                            let sum = value.mul_add(T::load(from), T::load(to));
                            second.mul_add(T::load(other), sum).store(to);
                        }
                    }
                    None => {
                        for (to, from) in to.zip(from.chunks_exact(T::WIDTH)) {
                            value.mul_add(T::load(from), T::load(to)).store(to);
                        }
                    }
                }
            }
        }
    }
}
