//! Models: names, units, default values, and the functions f, J and Jp on arrays.

use std::cell::RefCell;
use std::sync::{Arc, OnceLock};

use flight::{CompiledModel, EvaluationPoint, ModelFunctions, Workspace};
use model_spec::ModelTree;
use model_spec::compose::ValueError;
use model_spec::layout::Layout;
use model_spec::model::Model as Checked;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyMapping, PyTuple};

use crate::array::{Rows, array, points, rows, times, vector};
use crate::errors::{input, of_class, raise};

thread_local! {
    static WORKSPACE: RefCell<Workspace> = RefCell::default();
}

/// A checked model of a flying body.
#[pyclass(subclass, frozen, module = "hyzer._hyzer")]
pub struct Model {
    /// The syntax tree, with effects and values.
    pub tree: ModelTree,
    /// The checked model.
    pub checked: Arc<Checked>,
    /// The layout of states and parameters.
    pub layout: Layout,
    /// Name, path or text by which the model was loaded.
    pub source: String,
    /// Whether effects or values were added to what `source` names.
    pub is_changed: bool,
    compiled: OnceLock<Compiled>,
}

struct Compiled {
    model: Arc<CompiledModel>,
    prepared: Vec<f64>,
}

/// Values of the parameters and the invariants computed from them.
struct Parameters<'m> {
    own: Option<(Vec<f64>, Vec<f64>)>,
    model: &'m Model,
}

impl Parameters<'_> {
    fn at<'a>(&'a self, t: f64, x: &'a [f64]) -> EvaluationPoint<'a> {
        let (p, prepared) = match &self.own {
            Some((p, prepared)) => (p, prepared),
            None => (&self.model.layout.defaults, &self.model.compiled().prepared),
        };
        EvaluationPoint { t, x, p, prepared }
    }
}

impl Model {
    /// A model from its syntax tree; `source` is how it was named.
    pub fn of(tree: ModelTree, source: String) -> PyResult<Model> {
        let checked = tree.check().map_err(raise)?;
        Ok(Model {
            layout: Layout::new(&checked),
            checked: Arc::new(checked),
            tree,
            source,
            is_changed: false,
            compiled: OnceLock::new(),
        })
    }

    /// Whether the model was loaded from a text.
    pub fn is_text(&self) -> bool {
        self.source.contains('\n')
    }

    fn compiled(&self) -> &Compiled {
        self.compiled.get_or_init(|| {
            let model = Arc::new(CompiledModel::new(&self.checked));
            let mut prepared = vec![0.0; model.functions().prepared_len()];
            model
                .functions()
                .prepare(&self.layout.defaults, &mut prepared);
            Compiled { model, prepared }
        })
    }

    /// The compiled model.
    pub fn compiled_model(&self) -> Arc<CompiledModel> {
        Arc::clone(&self.compiled().model)
    }

    fn functions(&self) -> &dyn ModelFunctions {
        self.compiled().model.functions()
    }

    fn parameters_of(&self, p: Option<&Bound<'_, PyAny>>) -> PyResult<Parameters<'_>> {
        let own = p.map(|p| self.vector_of(p)).transpose()?.map(|p| {
            let functions = self.functions();
            let mut prepared = vec![0.0; functions.prepared_len()];
            functions.prepare(&p, &mut prepared);
            (p, prepared)
        });
        Ok(Parameters { own, model: self })
    }

    /// The parameter vector: an array, or the defaults with the values of a mapping by name.
    fn vector_of(&self, p: &Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
        let names = &self.layout.parameters;
        let Ok(mapping) = p.cast::<PyMapping>() else {
            return vector(p, "p", names.len(), |index| names[index].clone());
        };
        let mut values = self.layout.defaults.clone();
        for (name, value) in pairs(mapping, "p")? {
            let index = self.layout.parameter(&name).ok_or_else(|| {
                let known = names.iter().map(String::as_str);
                let hint = flight::release::suggestion(&name, known);
                input(format!(
                    "the model {} has no parameter {name:?}{hint}",
                    self.checked.name
                ))
            })?;
            values[index.index()] = value;
        }
        Ok(values)
    }

    /// Evaluates one of the functions for each row of states, into arrays of the given lengths for each row.
    fn each<const N: usize>(
        &self,
        (t, x): (&[f64], &Rows),
        parameters: &Parameters<'_>,
        lens: [usize; N],
        evaluate: impl Fn(EvaluationPoint<'_>, &mut Workspace, [&mut [f64]; N]),
    ) -> [Vec<f64>; N] {
        let n = self.layout.states.len();
        let count = x.rows.unwrap_or(1);
        let mut results = lens.map(|len| vec![0.0; len * count]);
        let time = |row: usize| if t.len() == 1 { t[0] } else { t[row] };
        WORKSPACE.with_borrow_mut(|workspace| {
            for row in 0..count {
                let at = parameters.at(time(row), &x.values[row * n..][..n]);
                let mut index = 0;
                let parts = results.each_mut().map(|result| {
                    let len = lens[index];
                    index += 1;
                    &mut result[row * len..][..len]
                });
                evaluate(at, workspace, parts);
            }
        });
        results
    }
}

/// Names and finite numbers of a mapping.
pub fn pairs(mapping: &Bound<'_, PyMapping>, what: &str) -> PyResult<Vec<(String, f64)>> {
    let mut pairs = Vec::new();
    for item in mapping.items()?.iter() {
        let (name, value): (Bound<'_, PyAny>, Bound<'_, PyAny>) = item.extract()?;
        let name: String = name
            .extract()
            .map_err(|_| input(format!("{what}: found the key {name}, expected a name")))?;
        let number: f64 = value
            .extract()
            .map_err(|_| input(format!("{what}: {name} is {value}, expected a number")))?;
        if !number.is_finite() {
            return Err(input(format!(
                "{what}: {name} is {number}, expected a finite number"
            )));
        }
        pairs.push((name, number));
    }
    Ok(pairs)
}

/// A dense matrix from the entries of a sparse one.
fn dense(pattern: &[(u32, u32)], entries: &[f64], width: usize, out: &mut [f64]) {
    for (&(row, column), entry) in pattern.iter().zip(entries) {
        out[row as usize * width + column as usize] = *entry;
    }
}

#[pymethods]
impl Model {
    #[new]
    #[pyo3(signature = (source, effects = Vec::new(), parameters = None))]
    fn new(
        source: String,
        effects: Vec<String>,
        parameters: Option<&Bound<'_, PyMapping>>,
    ) -> PyResult<Model> {
        let tree = match source.contains('\n') {
            true => ModelTree::parse("<text>", &source),
            false => ModelTree::load(&source),
        };
        let mut tree = tree
            .and_then(|tree| tree.with_named(&effects))
            .map_err(raise)?;
        if let Some(parameters) = parameters {
            let values = pairs(parameters, "parameters")?;
            let values = values.iter().map(|(name, value)| (name.as_str(), *value));
            tree = tree.with_values(values).map_err(|error| match error {
                ValueError::Load(error) => raise(error),
                other => input(other.to_string()),
            })?;
        }
        let is_changed = parameters.is_some() || !effects.is_empty();
        Ok(Model {
            is_changed,
            ..Model::of(tree, source)?
        })
    }

    #[getter]
    fn name(&self) -> &str {
        &self.checked.name
    }

    #[getter]
    fn doc(&self) -> &str {
        &self.checked.doc
    }

    #[getter]
    fn text(&self) -> String {
        self.tree.to_text("")
    }

    #[getter]
    fn effects<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, self.checked.effects.iter().map(|effect| &effect.name))
    }

    #[getter]
    fn states<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, &self.layout.states)
    }

    #[getter]
    fn parameters<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, &self.layout.parameters)
    }

    #[getter]
    fn coefficients<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        let first = self.layout.params;
        let last = first + self.layout.coefficients;
        PyTuple::new(py, &self.layout.parameters[first..last])
    }

    #[getter]
    fn units<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let units = PyDict::new(py);
        for state in &self.checked.states {
            units.set_item(&state.name, &state.unit_text)?;
        }
        for constant in self.checked.params.iter().chain(&self.checked.coefficients) {
            units.set_item(&constant.name, &constant.unit_text)?;
        }
        for input in &self.checked.inputs {
            for axis in dataset::AXES {
                units.set_item(format!("{}_{axis}", input.name), &input.unit_text)?;
            }
        }
        Ok(units)
    }

    #[getter]
    fn defaults<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let defaults = PyDict::new(py);
        let Layout {
            states,
            initial,
            parameters,
            defaults: values,
            ..
        } = &self.layout;
        for (name, value) in states
            .iter()
            .zip(initial)
            .chain(parameters.iter().zip(values))
        {
            defaults.set_item(name, value)?;
        }
        Ok(defaults)
    }

    #[getter]
    fn is_compiled(&self) -> bool {
        self.compiled().model.is_generated()
    }

    fn check(&self) -> PyResult<String> {
        match hyzer::program::check::report(&self.checked) {
            (text, true) => Ok(text),
            (text, false) => Err(of_class("ModelError", &text)),
        }
    }

    #[pyo3(signature = (p = None))]
    fn parameter_vector<'py>(
        &self,
        py: Python<'py>,
        p: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let values = match p {
            Some(p) => self.vector_of(p)?,
            None => self.layout.defaults.clone(),
        };
        let len = values.len();
        array(py, values, &[len])
    }

    #[pyo3(signature = (t, x, p = None))]
    fn rhs<'py>(
        &self,
        t: &Bound<'py, PyAny>,
        x: &Bound<'py, PyAny>,
        p: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let n = self.layout.states.len();
        let x = rows(x, "x", &self.layout.states)?;
        let times = times(t, x.rows)?;
        let parameters = self.parameters_of(p)?;
        let functions = self.functions();
        let [dx] = self.each((&times, &x), &parameters, [n], |at, workspace, [dx]| {
            functions.f(at, workspace, dx);
        });
        array(t.py(), dx, &x.shape(&[n]))
    }

    #[pyo3(signature = (t, x, p = None))]
    fn jac<'py>(
        &self,
        t: &Bound<'py, PyAny>,
        x: &Bound<'py, PyAny>,
        p: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
        let (n, width) = (self.layout.states.len(), self.layout.parameters.len());
        let x = rows(x, "x", &self.layout.states)?;
        let times = times(t, x.rows)?;
        let parameters = self.parameters_of(p)?;
        let (functions, patterns) = (self.functions(), self.functions().patterns());
        let by_state = RefCell::new(vec![0.0; patterns.jacobian.len()]);
        let by_parameter = RefCell::new(vec![0.0; patterns.parameter_jacobian.len()]);
        let lens = [n, n * n, n * width];
        let [_, j, jp] = self.each(
            (&times, &x),
            &parameters,
            lens,
            |at, workspace, [dx, j, jp]| {
                let (mut a, mut b) = (by_state.borrow_mut(), by_parameter.borrow_mut());
                functions.f_jac_par(at, workspace, dx, &mut a, &mut b);
                dense(patterns.jacobian, &a, n, j);
                dense(patterns.parameter_jacobian, &b, width, jp);
            },
        );
        let j = array(t.py(), j, &x.shape(&[n, n]))?;
        Ok((j, array(t.py(), jp, &x.shape(&[n, width]))?))
    }

    #[pyo3(signature = (t, x, marker, p = None))]
    fn observe<'py>(
        &self,
        t: &Bound<'py, PyAny>,
        x: &Bound<'py, PyAny>,
        marker: &Bound<'py, PyAny>,
        p: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        if self.layout.marker.is_empty() {
            let name = &self.checked.name;
            return Err(input(format!(
                "the model {name} does not say what is observed of it"
            )));
        }
        let x = rows(x, "x", &self.layout.states)?;
        let times = times(t, x.rows)?;
        let (markers, several) = points(marker, "marker")?;
        let parameters = self.parameters_of(p)?;
        let functions = self.functions();
        let lens = [3 * markers.len()];
        let [y] = self.each((&times, &x), &parameters, lens, |at, workspace, [y]| {
            for (marker, y) in markers.iter().zip(y.chunks_exact_mut(3)) {
                let mut seen = [0.0; 3];
                functions.observe(at, marker, workspace, &mut seen);
                y.copy_from_slice(&seen);
            }
        });
        let tail = if several {
            vec![markers.len(), 3]
        } else {
            vec![3]
        };
        array(t.py(), y, &x.shape(&tail))
    }

    #[pyo3(signature = (t, x, p = None))]
    fn quantities<'py>(
        &self,
        t: &Bound<'py, PyAny>,
        x: &Bound<'py, PyAny>,
        p: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let x = rows(x, "x", &self.layout.states)?;
        let times = times(t, x.rows)?;
        let parameters = self.parameters_of(p)?;
        let (functions, names) = (self.functions(), &self.layout.quantities);
        let width = names.len();
        let [q] = self.each((&times, &x), &parameters, [width], |at, workspace, [q]| {
            functions.quantities(at, workspace, q);
        });
        let found = PyDict::new(t.py());
        for (index, name) in names.iter().enumerate() {
            let column: Vec<f64> = q.iter().skip(index).step_by(width).copied().collect();
            match x.rows {
                None => found.set_item(name, column[0])?,
                Some(rows) => found.set_item(name, array(t.py(), column, &[rows])?)?,
            }
        }
        Ok(found)
    }

    fn __repr__(&self) -> String {
        let effects: Vec<&str> = self.checked.effects.iter().map(|e| &*e.name).collect();
        let with = match effects.is_empty() {
            true => String::new(),
            false => format!(", effects={effects:?}"),
        };
        format!("Model({:?}{with})", self.checked.name)
    }
}
