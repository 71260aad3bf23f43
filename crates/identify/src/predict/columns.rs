//! Where each unknown stands in a row.

use flight::body::Derivatives;

use crate::rows::Rows;
use crate::track::Track;

/// Where the derivatives by each unknown stand in a row. A state that no rate depends on keeps its derivative of 1, and
/// need not be flown: its column stands behind those that are.
pub(super) struct Columns {
    /// Directions of the chart that are flown, which come first; the shared unknowns follow.
    pub moving: usize,
    /// Place of each direction.
    pub own: Vec<usize>,
    /// Direction and state of those that are not flown.
    pub still: Vec<(usize, usize)>,
    /// How many shared unknowns.
    pub shared: usize,
}

impl Columns {
    pub fn new(track: &Track, pattern: &[(usize, usize)], shared: usize) -> Self {
        let dimension = track.chart.dimension();
        let still: Vec<(usize, usize)> = (0..dimension)
            .filter_map(|direction| Some((direction, track.chart.plain(direction)?)))
            .filter(|(_, state)| pattern.iter().all(|(_, column)| column != state))
            .collect();
        let moving = dimension - still.len();
        let (mut next, mut behind) = (0, moving + shared);
        let own = (0..dimension).map(|direction| {
            let place = if still.iter().any(|(d, _)| *d == direction) {
                &mut behind
            } else {
                &mut next
            };
            *place += 1;
            *place - 1
        });
        Self {
            moving,
            own: own.collect(),
            still,
            shared,
        }
    }

    pub fn rows(&self) -> Rows {
        let shared = self.moving..self.moving + self.shared;
        Rows::new(self.own.clone(), shared.collect())
    }

    /// The entries of the chart's tangent in the columns that are flown.
    pub fn tangent(&self, entries: &[(usize, usize, f64)]) -> Vec<(usize, usize, f64)> {
        let placed = entries
            .iter()
            .map(|&(state, direction, value)| (state, self.own[direction], value));
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
        derivatives: &Derivatives<'_>,
        row_of: impl Fn(usize) -> &'s [f64],
        constants: &[usize],
        rows: &mut [Vec<f64>; 3],
    ) {
        let flown = self.moving + self.shared;
        for row in rows.iter_mut() {
            row.fill(0.0);
        }
        let entries = derivatives.by_state_at.iter().zip(derivatives.by_state);
        for (&(axis, state), &value) in entries {
            let row = &mut rows[axis];
            for (sum, part) in row[..flown].iter_mut().zip(row_of(state)) {
                *sum += value * part;
            }
            if let Some((direction, _)) = self.still.iter().find(|(_, s)| *s == state) {
                row[self.own[*direction]] += value;
            }
        }
        let entries = derivatives
            .by_parameter_at
            .iter()
            .zip(derivatives.by_parameter);
        for (&(axis, place), &value) in entries {
            if let Some(column) = constants.iter().position(|constant| *constant == place) {
                rows[axis][self.moving + column] += value;
            }
        }
    }
}
