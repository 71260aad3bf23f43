//! Evaluation of the functions of a model for one state or for rows of states.

use std::cell::RefCell;

use flight::{EvaluationPoint, ModelFunctions, Workspace};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::array::{Rows, array, points, rows, times};
use crate::batch::Batch;
use crate::errors::input;
use crate::model::Model;
use crate::work::cancelled;

/// Least number of states for which SIMD lanes are faster.
const MIN_BATCH: usize = 16;
/// Number of rows between two looks for signals: less than a tenth of a second, and far longer than a look.
const WATCHED: usize = 1024;
/// The same for rows on lanes and several threads, which take a time to start.
const WATCHED_BATCH: usize = 16_384;

thread_local! {
    static WORKSPACE: RefCell<Workspace> = RefCell::default();
}

/// Checked arguments of the functions of a model.
pub struct Evaluation<'m, 'py> {
    model: &'m Model,
    functions: &'m ModelFunctions,
    /// One time, or one for each row.
    t: Vec<f64>,
    x: Rows<'py>,
    /// Parameters and their invariants; `None` for the defaults.
    own: Option<(Vec<f64>, Vec<f64>)>,
}

impl<'m, 'py> Evaluation<'m, 'py> {
    /// Checks time, states and parameters.
    pub fn new(
        model: &'m Model,
        t: &Bound<'_, PyAny>,
        x: &Bound<'py, PyAny>,
        p: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Evaluation<'m, 'py>> {
        let x = rows(x, "x", &model.layout.states)?;
        let functions = model.functions();
        let own = p.map(|p| model.vector_of(p)).transpose()?.map(|p| {
            let prepared = functions.prepared(&p);
            (p, prepared)
        });
        Ok(Evaluation {
            t: times(t, x.rows)?,
            model,
            functions,
            x,
            own,
        })
    }

    fn at(&self, row: usize) -> EvaluationPoint<'_> {
        let (p, prepared) = match &self.own {
            Some((p, prepared)) => (p, prepared),
            None => (&self.model.layout.defaults, &self.model.compiled().prepared),
        };
        let n = self.model.layout.states.len();
        EvaluationPoint {
            t: if self.t.len() == 1 {
                self.t[0]
            } else {
                self.t[row]
            },
            x: &self.x.values()[row * n..][..n],
            p,
            prepared,
        }
    }

    /// Evaluates a function for each row of states, into arrays of the given lengths for each row.
    fn each<const N: usize>(
        &self,
        py: Python<'_>,
        lens: [usize; N],
        evaluate: impl Fn(EvaluationPoint<'_>, &mut Workspace, [&mut [f64]; N]),
    ) -> PyResult<[Vec<f64>; N]> {
        let count = self.x.rows.unwrap_or(1);
        let mut results = lens.map(|len| vec![0.0; len * count]);
        // Taken, as what handles a signal may evaluate a model too.
        let mut workspace = WORKSPACE.take();
        for row in 0..count {
            let mut lens = lens.iter();
            let parts = results.each_mut().map(|result| {
                let len = lens.next().copied().unwrap_or(0);
                &mut result[row * len..][..len]
            });
            evaluate(self.at(row), &mut workspace, parts);
            if row % WATCHED == WATCHED - 1 {
                watched(py)?;
            }
        }
        WORKSPACE.set(workspace);
        Ok(results)
    }

    /// f.
    pub fn rhs(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let n = self.model.layout.states.len();
        if self.x.rows.is_some_and(|rows| rows >= MIN_BATCH) {
            let dx = self.batch(py)?;
            return array(py, dx, &self.x.shape(&[n]));
        }
        let [dx] = self.each(py, [n], |at, workspace, [dx]| {
            self.functions.f(at, workspace, dx);
        })?;
        array(py, dx, &self.x.shape(&[n]))
    }

    /// f of many states.
    fn batch(&self, py: Python<'_>) -> PyResult<Vec<f64>> {
        let (tape, x) = (self.model.tape(), self.x.values());
        let mut dx = vec![0.0; x.len()];
        let p = match &self.own {
            Some((p, _)) => p,
            None => &self.model.layout.defaults,
        };
        let (n, prepared) = (tape.f.tape.outputs(), tape.prepare(p));
        for (index, dx) in dx.chunks_mut(WATCHED_BATCH * n).enumerate() {
            let first = index * WATCHED_BATCH;
            Batch {
                tape: &tape.f.tape,
                t: self.t.get(first..first + dx.len() / n).unwrap_or(&self.t),
                x: &x[first * n..][..dx.len()],
                p,
                prepared: &prepared,
                dx,
            }
            .run();
            watched(py)?;
        }
        Ok(dx)
    }

    /// J and Jp.
    pub fn jac(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
        let layout = &self.model.layout;
        let (n, width) = (layout.states.len(), layout.parameters.len());
        let patterns = self.functions.patterns();
        let by_state = RefCell::new(vec![0.0; patterns.jacobian.len()]);
        let by_parameter = RefCell::new(vec![0.0; patterns.parameter_jacobian.len()]);
        let lens = [n, n * n, n * width];
        let [_, j, jp] = self.each(py, lens, |at, workspace, [dx, j, jp]| {
            let (mut a, mut b) = (by_state.borrow_mut(), by_parameter.borrow_mut());
            self.functions.f_jac_par(at, workspace, dx, &mut a, &mut b);
            dense(&patterns.jacobian, &a, n, j);
            dense(&patterns.parameter_jacobian, &b, width, jp);
        })?;
        let j = array(py, j, &self.x.shape(&[n, n]))?;
        Ok((j, array(py, jp, &self.x.shape(&[n, width]))?))
    }

    /// Positions of markers.
    pub fn observe(&self, marker: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        if self.model.layout.marker.is_empty() {
            let name = &self.model.checked.name;
            return Err(input(format!(
                "the model {name} does not say what is observed of it"
            )));
        }
        let (markers, several) = points(marker, "marker")?;
        let [y] = self.each(marker.py(), [3 * markers.len()], |at, workspace, [y]| {
            for (marker, y) in markers.iter().zip(y.chunks_exact_mut(3)) {
                let mut seen = [0.0; 3];
                self.functions.observe(at, marker, workspace, &mut seen);
                y.copy_from_slice(&seen);
            }
        })?;
        let tail = if several {
            vec![markers.len(), 3]
        } else {
            vec![3]
        };
        array(marker.py(), y, &self.x.shape(&tail))
    }

    /// Auxiliary variables by name.
    pub fn quantities(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let names = &self.model.layout.quantities;
        let width = names.len();
        let [q] = self.each(py, [width], |at, workspace, [q]| {
            self.functions.quantities(at, workspace, q);
        })?;
        let found = PyDict::new(py);
        for (index, name) in names.iter().enumerate() {
            watched(py)?;
            let column: Vec<f64> = q.iter().skip(index).step_by(width).copied().collect();
            match self.x.rows {
                None => found.set_item(name, column[0])?,
                Some(rows) => found.set_item(name, array(py, column, &[rows])?)?,
            }
        }
        Ok(found)
    }
}

/// Looks for signals, of which an error is raised, and lets other threads run.
fn watched(py: Python<'_>) -> PyResult<()> {
    py.detach(|| ());
    py.check_signals().map_err(|error| cancelled(py, error))
}

/// A dense matrix from the entries of a sparse one.
fn dense(pattern: &[(usize, usize)], entries: &[f64], width: usize, out: &mut [f64]) {
    for (&(row, column), entry) in pattern.iter().zip(entries) {
        out[row * width + column] = *entry;
    }
}
