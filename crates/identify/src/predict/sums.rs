//! Rows of residuals, weighed by the noise, on their way to the sums.

use flight::body::Derivatives;

use super::Loss;
use super::columns::Columns;
use crate::noise::HUBER;
use crate::rows::Rows;

/// Rows being summed, with the last row of each marker.
pub(super) struct Sums<'a> {
    /// What was summed.
    pub rows: Rows,
    loss: Loss<'a>,
    /// The rows of x, y and z of one marker.
    now: [Vec<f64>; 3],
    /// Time and rows of the last time that each marker was seen.
    before: Vec<Option<(f64, [Vec<f64>; 3])>>,
}

impl<'a> Sums<'a> {
    pub fn new(rows: Rows, markers: usize, loss: Loss<'a>) -> Self {
        let width = rows.width();
        Self {
            rows,
            loss,
            now: [0; 3].map(|_| vec![0.0; width]),
            before: vec![None; markers],
        }
    }

    /// Puts the derivatives of a marker's position by the unknowns into the rows of its axes.
    pub fn derive<'s>(
        &mut self,
        derivatives: &Derivatives<'_>,
        row_of: impl Fn(usize) -> &'s [f64],
        constants: &[usize],
        columns: &Columns,
    ) {
        let flown = columns.moving + columns.shared;
        for row in &mut self.now {
            row.fill(0.0);
        }
        let entries = derivatives.by_state_at.iter().zip(derivatives.by_state);
        for (&(axis, state), &value) in entries {
            let row = &mut self.now[axis];
            for (sum, part) in row[..flown].iter_mut().zip(row_of(state)) {
                *sum += value * part;
            }
            if let Some((direction, _)) = columns.still.iter().find(|(_, s)| *s == state) {
                row[columns.own[*direction]] += value;
            }
        }
        let entries = derivatives
            .by_parameter_at
            .iter()
            .zip(derivatives.by_parameter);
        for (&(axis, place), &value) in entries {
            if let Some(column) = constants.iter().position(|constant| *constant == place) {
                self.now[axis][columns.moving + column] += value;
            }
        }
    }

    pub fn add(&mut self, marker: usize, time: f64, residual: [f64; 3]) {
        let at = self.rows.residual();
        for (row, residual) in self.now.iter_mut().zip(residual) {
            row[at] = residual;
        }
        match self.loss {
            Loss::Huber(scale) => {
                // An outlier is one of a point, not of an axis.
                let size = residual.iter().map(|r| r * r).sum::<f64>().sqrt() / scale;
                let limit = HUBER * 3.0_f64.sqrt();
                let weight = if size > limit { limit / size } else { 1.0 };
                // What the loss has beyond the weighted square.
                let extra = (weight * size * size - limit * limit).max(0.0);
                for (axis, row) in self.now.iter().enumerate() {
                    let extra = if axis == 0 { extra } else { 0.0 };
                    self.rows.add(row, None, weight.sqrt() / scale, extra);
                }
            }
            Loss::Whitened(noise) => {
                for (axis, row) in self.now.iter().enumerate() {
                    match &self.before[marker] {
                        Some((earlier, before)) => {
                            let (kept, fresh) = noise.innovation(axis, time - earlier);
                            let before = Some((kept, before[axis].as_slice()));
                            self.rows.add(row, before, 1.0 / fresh, 0.0);
                        }
                        None => self.rows.add(row, None, 1.0 / noise.sigma[axis], 0.0),
                    }
                }
                match &mut self.before[marker] {
                    Some((earlier, before)) => {
                        *earlier = time;
                        for (before, now) in before.iter_mut().zip(&self.now) {
                            before.copy_from_slice(now);
                        }
                    }
                    none => *none = Some((time, self.now.clone())),
                }
            }
        }
    }
}
