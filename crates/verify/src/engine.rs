//! Equations of motion of a compiled model, evaluated at one point at a time by the bytecode interpreter (tape).

use crate::subject::{Derivatives, Differentiable, Equations};
use codegen::compile::Compiled;
use codegen::program::Function;
use codegen::tape::{Inputs, Tape};
use nalgebra::Vector3;
use oracle::Point;
use std::sync::{Mutex, PoisonError};

/// Compiled equations of motion, with one program of the bytecode interpreter (tape) for each function.
pub struct Engine {
    prepare: Tape,
    /// Cache: parameters of the last evaluation, and the results of the function `prepare`, which computes values that
    /// depend on parameters only. These results are reused as long as the parameters do not change.
    last: Mutex<(Vec<f64>, Vec<f64>)>,
    f: Tape,
    f_jac: Tape,
    f_jac_par: Tape,
    observe: Tape,
    observe_jac: Tape,
    f_jac_layout: Entries,
    f_layout: Entries,
    observe_layout: Entries,
}

/// Maps the sparse Jacobians computed by a compiled function to one dense Jacobian. For each computed entry, it
/// contains the row and column in the dense Jacobian.
#[derive(Clone, Debug, Default)]
pub struct Entries {
    rows: usize,
    columns: usize,
    places: Vec<(usize, usize)>,
}

impl Entries {
    /// Determines the row and column, in the dense Jacobian, of each Jacobian entry that a compiled function computes.
    /// The outputs of the function are its values, in the group of outputs named `value`, then its sparse Jacobians, in
    /// the groups `sections` (name, number of columns of the dense matrix).
    pub fn of(function: &Function, value: &str, sections: &[(&str, usize)]) -> Self {
        let rows = function.range(value).len();
        let mut places = Vec::new();
        let mut start = 0;
        for &(name, width) in sections {
            let shifted = function
                .pattern(name)
                .iter()
                .map(|&(r, c)| (r as usize, start + c as usize));
            places.extend(shifted);
            start += width;
        }
        Self {
            rows,
            columns: start,
            places,
        }
    }

    /// Splits the outputs `out` of the compiled function into its values and its sparse Jacobian entries, and returns
    /// the values with a dense Jacobian.
    pub fn read(&self, out: &[f64]) -> Derivatives {
        let mut entries = vec![vec![0.0; self.columns]; self.rows];
        for (&(row, column), value) in self.places.iter().zip(&out[self.rows..]) {
            entries[row][column] = *value;
        }
        Derivatives {
            values: out[..self.rows].to_vec(),
            entries,
        }
    }
}

/// Inputs of a tape at a point. `p` is the point's parameter vector, `prepared` the results of the function `prepare`,
/// which computes values that depend on parameters only.
pub fn inputs<'a>(point: &'a Point<f64>, p: &'a [f64], prepared: &'a [f64]) -> Inputs<'a, f64> {
    Inputs {
        t: point.time,
        x: &point.states,
        p,
        prepared,
        marker: point.marker.as_slice(),
    }
}

impl Engine {
    /// Creates a tape for each function of a compiled model.
    pub fn new(compiled: &Compiled) -> Self {
        let (states, parameters) = (
            compiled.layout.states.len(),
            compiled.layout.parameters.len(),
        );
        Self {
            prepare: Tape::new(&compiled.prepare.program),
            last: Mutex::default(),
            f: Tape::new(&compiled.f.program),
            f_jac: Tape::new(&compiled.f_jac.program),
            f_jac_par: Tape::new(&compiled.f_jac_par.program),
            observe: Tape::new(&compiled.observe.program),
            observe_jac: Tape::new(&compiled.observe_jac.program),
            f_jac_layout: Entries::of(&compiled.f_jac, "dx", &[("j", states)]),
            f_layout: Entries::of(
                &compiled.f_jac_par,
                "dx",
                &[("j", states), ("jp", parameters)],
            ),
            observe_layout: Entries::of(
                &compiled.observe_jac,
                "y",
                &[("dy_dx", states), ("dy_dp", parameters)],
            ),
        }
    }

    fn eval(&self, tape: &Tape, point: &Point<f64>) -> Vec<f64> {
        let p = point.parameters();
        let mut scratch = Vec::new();
        let prepared = self.prepared(inputs(point, &p, &[]), &mut scratch);
        let mut out = vec![0.0; tape.outputs()];
        tape.eval(inputs(point, &p, &prepared), &mut scratch, &mut out);
        out
    }

    /// Results of the function `prepare`, which computes values that depend on parameters only. They are computed again
    /// only if the parameters differ from those of the last call.
    fn prepared(&self, inputs: Inputs<'_, f64>, scratch: &mut Vec<f64>) -> Vec<f64> {
        let mut last = self.last.lock().unwrap_or_else(PoisonError::into_inner);
        let same = |a: &f64, b: &f64| a.to_bits() == b.to_bits();
        let is_last =
            last.0.len() == inputs.p.len() && last.0.iter().zip(inputs.p).all(|(a, b)| same(a, b));
        // Without parameters, what was never computed would look like the last.
        if !is_last || last.1.len() != self.prepare.outputs() {
            let mut prepared = vec![0.0; self.prepare.outputs()];
            self.prepare.eval(inputs, scratch, &mut prepared);
            *last = (inputs.p.to_vec(), prepared);
        }
        last.1.clone()
    }
}

impl Equations for Engine {
    fn rates(&self, point: &Point<f64>) -> Vec<f64> {
        self.eval(&self.f, point)
    }

    fn observation(&self, point: &Point<f64>) -> Option<Vector3<f64>> {
        match self.eval(&self.observe, point).as_slice() {
            &[x, y, z] => Some(Vector3::new(x, y, z)),
            _ => None,
        }
    }
}

impl Differentiable for Engine {
    fn derivatives(&self, point: &Point<f64>) -> Derivatives {
        let mut all = self.f_layout.read(&self.eval(&self.f_jac_par, point));
        if self.observe.outputs() == 3 {
            let seen = self
                .observe_layout
                .read(&self.eval(&self.observe_jac, point));
            all.values.extend(seen.values);
            all.entries.extend(seen.entries);
        }
        all
    }

    fn by_state(&self, point: &Point<f64>) -> Derivatives {
        self.f_jac_layout.read(&self.eval(&self.f_jac, point))
    }
}
