//! What is seen of a body: its markers, and the model's named quantities.

use super::{Conditions, Functions};
use codegen::tape_model::Scratch;

/// What is seen of a body in the conditions of one flight.
pub struct Observer<'a> {
    conditions: &'a Conditions<'a>,
    scratch: Scratch,
    dy_dx: Vec<f64>,
    dy_dp: Vec<f64>,
    dy_dmarker: Vec<f64>,
}

/// Derivatives of a marker's position: entries (row, column, value) of 3 rows that are not always 0.
pub struct Derivatives<'o> {
    /// Where each entry of the derivative by the states stands.
    pub by_state_at: &'o [(usize, usize)],
    /// The entries.
    pub by_state: &'o [f64],
    /// Where each entry of the derivative by the parameters of the layout stands.
    pub by_parameter_at: &'o [(usize, usize)],
    /// The entries.
    pub by_parameter: &'o [f64],
}

impl<'a> Observer<'a> {
    pub(super) fn new(conditions: &'a Conditions<'a>) -> Self {
        let patterns = &conditions.body.patterns;
        Observer {
            conditions,
            scratch: Scratch::default(),
            dy_dx: vec![0.0; patterns.dy_dx.len()],
            dy_dp: vec![0.0; patterns.dy_dp.len()],
            dy_dmarker: vec![0.0; patterns.dy_dmarker],
        }
    }

    /// Where a marker is seen in the inertial frame, m; `marker` is its position in the frame it is fixed in, m.
    pub fn position(&mut self, t: f64, x: &[f64], marker: &[f64; 3]) -> [f64; 3] {
        let conditions = self.conditions;
        let (p, k) = (&conditions.parameters, &conditions.prepared);
        let mut y = [0.0; 3];
        match &conditions.body.functions {
            Functions::Generated(code) => (code.observe)(t, x, p, k, marker, &mut y),
            Functions::Tape(tape) => {
                tape.observe(conditions.at(t, x), marker, &mut self.scratch, &mut y);
            }
        }
        y
    }

    /// As [`position`](Self::position), with its derivatives.
    pub fn linearise(
        &mut self,
        t: f64,
        x: &[f64],
        marker: &[f64; 3],
    ) -> ([f64; 3], Derivatives<'_>) {
        let conditions = self.conditions;
        let (p, k) = (&conditions.parameters, &conditions.prepared);
        let mut y = [0.0; 3];
        let (dx, dp, dm) = (&mut self.dy_dx, &mut self.dy_dp, &mut self.dy_dmarker);
        match &conditions.body.functions {
            Functions::Generated(code) => {
                (code.observe_jac)(t, x, p, k, marker, &mut y, dx, dp, dm);
            }
            Functions::Tape(tape) => {
                let results = [&mut y[..], dx, dp, dm];
                tape.observe_jac(conditions.at(t, x), marker, &mut self.scratch, results);
            }
        }
        let patterns = &conditions.body.patterns;
        let derivatives = Derivatives {
            by_state_at: &patterns.dy_dx,
            by_state: &self.dy_dx,
            by_parameter_at: &patterns.dy_dp,
            by_parameter: &self.dy_dp,
        };
        (y, derivatives)
    }

    /// The model's named quantities, in the order of [`Layout::quantities`](codegen::Layout).
    pub fn quantities(&mut self, t: f64, x: &[f64]) -> Vec<f64> {
        let conditions = self.conditions;
        let (p, k) = (&conditions.parameters, &conditions.prepared);
        let mut q = vec![0.0; conditions.body.layout.quantities.len()];
        match &conditions.body.functions {
            Functions::Generated(code) => (code.quantities)(t, x, p, k, &mut q),
            Functions::Tape(tape) => {
                tape.quantities(conditions.at(t, x), &mut self.scratch, &mut q)
            }
        }
        q
    }

    /// Whether a state is where the model holds: every limit above its bound.
    pub fn is_within_limits(&mut self, t: f64, x: &[f64]) -> bool {
        let conditions = self.conditions;
        let (p, k) = (&conditions.parameters, &conditions.prepared);
        let bounds = &conditions.body.limits;
        let mut values = vec![0.0; bounds.len()];
        match &conditions.body.functions {
            Functions::Generated(code) => (code.limits)(t, x, p, k, &mut values),
            Functions::Tape(tape) => {
                tape.limits(conditions.at(t, x), &mut self.scratch, &mut values)
            }
        }
        values
            .iter()
            .zip(bounds)
            .all(|(value, (bound, _))| value > bound)
    }
}
