//! The methods of models in Python.

use std::collections::BTreeMap;

use model_spec::layout::Layout;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyMapping, PyTuple};

use crate::array::array;
use crate::errors::{of_class, raise};
use crate::evaluation::Evaluation;
use crate::model::Model;

#[pymethods]
impl Model {
    #[new]
    #[pyo3(signature = (source, effects = Vec::new(), parameters = None))]
    fn new(
        source: String,
        effects: Vec<String>,
        parameters: Option<&Bound<'_, PyMapping>>,
    ) -> PyResult<Model> {
        Model::load(source, &effects, parameters)
    }

    /// Name of the model.
    #[getter]
    fn name(&self) -> &str {
        &self.checked.name
    }

    /// The compiled model as JSON.
    fn ir_json(&self) -> PyResult<String> {
        codegen::ir::json(&self.checked).map_err(raise)
    }

    /// Documentation of the model.
    #[getter]
    fn doc(&self) -> &str {
        &self.checked.doc
    }

    /// The model in the model language, with the effects merged into its equations.
    #[getter]
    fn text(&self) -> String {
        self.model_text()
    }

    /// Whether its body turns, so that a throw has a spin.
    #[getter]
    fn has_rotating_body(&self) -> bool {
        self.checked.has_rotating_body()
    }

    /// Names of the effects added.
    #[getter]
    fn effects<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, self.checked.effects.iter().map(|effect| &effect.name))
    }

    /// Names of the states, in the order of `x`.
    #[getter]
    fn states<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, &self.layout.states)
    }

    /// Names of the parameters, in the order of `p`: constants, coefficients, components of inputs.
    #[getter]
    fn parameters<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, &self.layout.parameters)
    }

    /// Names of the coefficients, which a fit estimates.
    #[getter]
    fn coefficients<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        let first = self.layout.params;
        let last = first + self.layout.coefficients;
        PyTuple::new(py, &self.layout.parameters[first..last])
    }

    /// Unit of each state and parameter by name.
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

    /// Default value of each parameter and state by name, SI.
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

    /// Whether the functions are machine code; otherwise they are interpreted.
    #[getter]
    fn is_compiled(&self) -> bool {
        self.compiled().model.is_generated()
    }

    /// Return what the model declares, and run its check cases, as `hyzer check` does.
    ///
    /// Raises
    /// ------
    /// ModelError
    ///     If a check case fails, or the inertia tensor is not that of a body.
    ///
    /// Examples
    /// --------
    /// >>> import hyzer
    /// >>> print(hyzer.Model("ball").check().splitlines()[0])
    /// model ball
    fn check(&self) -> PyResult<String> {
        match hyzer::program::check::report(&self.checked) {
            (text, true) => Ok(text),
            (text, false) => Err(of_class("ModelError", &text)),
        }
    }

    /// Return the parameter vector `p`: the defaults, changed by name.
    ///
    /// Parameters
    /// ----------
    /// p : mapping of str to float, optional
    ///     Values that replace the defaults, SI.
    ///
    /// Returns
    /// -------
    /// ndarray, shape (k,)
    ///     In the order of `parameters`.
    ///
    /// Examples
    /// --------
    /// >>> import hyzer
    /// >>> disc = hyzer.Model("disc")
    /// >>> float(disc.parameter_vector({"m": 0.18})[disc.parameters.index("m")])
    /// 0.18
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

    /// Return the time derivatives of states, f(t, x, p).
    ///
    /// Parameters
    /// ----------
    /// t : float or array_like, shape (m,)
    ///     Time since release, s; one for all states, or one for each.
    /// x : array_like, shape (n,) or (m, n)
    ///     State, or one in each row, SI, in the order of `states`; those of a Series or DataFrame go by
    ///     their labels.
    /// p : array_like, shape (k,), or mapping or Series of str to float, optional
    ///     Parameters, SI, in the order of `parameters`, or those by name that differ from the
    ///     defaults.
    ///
    /// Returns
    /// -------
    /// ndarray, shape (n,) or (m, n)
    ///     dx/dt, in units of the states per second. A batch has the bits of single states.
    ///
    /// Raises
    /// ------
    /// InputError
    ///     If an array has another shape or dtype, or a number is not finite.
    ///
    /// Examples
    /// --------
    /// >>> import hyzer
    /// >>> ball = hyzer.Model("ball")
    /// >>> x = [0, 0, 1, 10, 0, 2]
    /// >>> ball.rhs(0.0, x)[:3].tolist()
    /// [10.0, 0.0, 2.0]
    /// >>> ball.rhs(0.0, [x, x], {"C_D": 0.0}).shape
    /// (2, 6)
    #[pyo3(signature = (t, x, p = None))]
    fn rhs<'py>(
        &self,
        t: &Bound<'py, PyAny>,
        x: &Bound<'py, PyAny>,
        p: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        Evaluation::new(self, t, x, p)?.rhs(t.py())
    }

    /// Return the exact Jacobians of f: J = df/dx and Jp = df/dp.
    ///
    /// Parameters
    /// ----------
    /// t : float or array_like, shape (m,)
    ///     Time since release, s; one for all states, or one for each.
    /// x : array_like, shape (n,) or (m, n)
    ///     State, or one in each row, SI, in the order of `states`; those of a Series or DataFrame go by
    ///     their labels.
    /// p : array_like, shape (k,), or mapping or Series of str to float, optional
    ///     Parameters, SI, in the order of `parameters`, or those by name that differ from the
    ///     defaults.
    ///
    /// Returns
    /// -------
    /// J : ndarray, shape (n, n) or (m, n, n)
    ///     Derivatives by the states.
    /// Jp : ndarray, shape (n, k) or (m, n, k)
    ///     Derivatives by the parameters, in the order of `parameters`.
    ///
    /// Raises
    /// ------
    /// InputError
    ///     As `rhs`.
    ///
    /// Examples
    /// --------
    /// >>> import hyzer
    /// >>> ball = hyzer.Model("ball")
    /// >>> J, Jp = ball.jac(0.0, [0, 0, 1, 10, 0, 2])
    /// >>> float(J[0, 3])
    /// 1.0
    /// >>> float(Jp[3, ball.parameters.index("C_D")]) < 0.0
    /// True
    #[pyo3(signature = (t, x, p = None))]
    fn jac<'py>(
        &self,
        t: &Bound<'py, PyAny>,
        x: &Bound<'py, PyAny>,
        p: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
        Evaluation::new(self, t, x, p)?.jac(t.py())
    }

    /// Return the positions of markers in the inertial frame.
    ///
    /// Parameters
    /// ----------
    /// t : float or array_like, shape (m,)
    ///     Time since release, s; one for all states, or one for each.
    /// x : array_like, shape (n,) or (m, n)
    ///     State, or one in each row, SI, in the order of `states`; those of a Series or DataFrame go by
    ///     their labels.
    /// marker : array_like, shape (3,) or (l, 3)
    ///     Positions in the body frame, m.
    /// p : array_like or mapping, optional
    ///     Parameters, as in `rhs`.
    ///
    /// Returns
    /// -------
    /// ndarray, shape (3,), (l, 3), (m, 3) or (m, l, 3)
    ///     Positions, m, z up.
    ///
    /// Raises
    /// ------
    /// InputError
    ///     As `rhs`, or if the model does not say what is observed.
    ///
    /// Examples
    /// --------
    /// >>> import hyzer
    /// >>> disc = hyzer.Model("disc")
    /// >>> disc.observe(0.0, [0.0] * 12, [0.1, 0.0, 0.0]).tolist()
    /// [0.1, 0.0, 0.0]
    #[pyo3(signature = (t, x, marker, p = None))]
    fn observe<'py>(
        &self,
        t: &Bound<'py, PyAny>,
        x: &Bound<'py, PyAny>,
        marker: &Bound<'py, PyAny>,
        p: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        Evaluation::new(self, t, x, p)?.observe(marker)
    }

    /// Return the quantities that the model names, such as angle of attack and lift.
    ///
    /// Parameters
    /// ----------
    /// t : float or array_like, shape (m,)
    ///     Time since release, s; one for all states, or one for each.
    /// x : array_like, shape (n,) or (m, n)
    ///     State, or one in each row, SI, in the order of `states`; those of a Series or DataFrame go by
    ///     their labels.
    /// p : array_like, shape (k,), or mapping or Series of str to float, optional
    ///     Parameters, SI, in the order of `parameters`, or those by name that differ from the
    ///     defaults.
    ///
    /// Returns
    /// -------
    /// dict of str to float or ndarray of shape (m,)
    ///     By name; components of vectors have names such as `v_x`.
    ///
    /// Examples
    /// --------
    /// >>> import hyzer
    /// >>> round(hyzer.Model("ball").quantities(0.0, [0, 0, 1, 3, 0, 4])["V"], 9)
    /// 5.0
    #[pyo3(signature = (t, x, p = None))]
    fn quantities<'py>(
        &self,
        t: &Bound<'py, PyAny>,
        x: &Bound<'py, PyAny>,
        p: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyDict>> {
        Evaluation::new(self, t, x, p)?.quantities(t.py())
    }

    /// What makes the same model: names where all is built in, else its text.
    fn made(&self) -> (String, Vec<String>, BTreeMap<String, f64>) {
        if self.is_text() || self.is_of_files {
            return (self.model_text(), Vec::new(), BTreeMap::new());
        }
        let replaced = self.replaced.iter().cloned().collect();
        (self.source.clone(), self.added.clone(), replaced)
    }

    fn __repr__(&self) -> String {
        let effects: Vec<&str> = self.checked.effects.iter().map(|e| &*e.name).collect();
        let with = match effects.is_empty() {
            true => String::new(),
            false => format!(", effects={effects:?}"),
        };
        let values = self.replaced.iter();
        let values: Vec<String> = values.map(|(name, v)| format!("{name:?}: {v}")).collect();
        let of = match values.is_empty() {
            true => String::new(),
            false => format!(", parameters={{{}}}", values.join(", ")),
        };
        format!("Model({:?}{with}{of})", self.checked.name)
    }
}
