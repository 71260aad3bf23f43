//! Arrays from Python: checked, and copied where they are not contiguous.

use numpy::{PyArray1, PyArrayDyn, PyArrayMethods, PyUntypedArrayMethods};
use pyo3::prelude::*;

use crate::errors::input;

/// One vector or several, one per row.
pub struct Rows {
    /// The numbers, row by row.
    pub values: Vec<f64>,
    /// Number of rows; `None` for one vector, an array of one dimension.
    pub rows: Option<usize>,
}

impl Rows {
    /// Shape of a result that has `tail` numbers for each row.
    pub fn shape(&self, tail: &[usize]) -> Vec<usize> {
        self.rows.into_iter().chain(tail.iter().copied()).collect()
    }
}

/// The numbers of an array and its shape. `what` names the array in messages.
pub fn numbers(array: &Bound<'_, PyAny>, what: &str) -> PyResult<(Vec<f64>, Vec<usize>)> {
    if let Ok(array) = array.cast::<PyArrayDyn<f64>>()
        && array.is_c_contiguous()
        && let Ok(array) = array.try_readonly()
        && let Ok(values) = array.as_slice()
    {
        return Ok((values.to_vec(), array.shape().to_vec()));
    }
    let numpy = array.py().import("numpy")?;
    let found = numpy
        .call_method1("asarray", (array,))
        .map_err(|error| input(format!("{what}: {error}, expected an array of float64")))?;
    let dtype = found.getattr("dtype")?;
    let kind: String = dtype.getattr("kind")?.extract()?;
    if !matches!(kind.as_str(), "f" | "i" | "u") {
        return Err(input(format!(
            "{what} has the dtype {dtype}, expected float64"
        )));
    }
    let shape: Vec<usize> = found.getattr("shape")?.extract()?;
    let found = numpy.call_method1("require", (found, "float64", ["C", "A"]))?;
    let found = found.cast_into::<PyArrayDyn<f64>>().map_err(PyErr::from)?;
    let found = found.readonly();
    let values = found.as_slice().map_err(|error| input(error.to_string()))?;
    Ok((values.to_vec(), shape))
}

/// A vector with a number for each of `names`, or several as the rows of an array; all numbers are finite.
pub fn rows(array: &Bound<'_, PyAny>, what: &str, names: &[String]) -> PyResult<Rows> {
    let (values, shape) = numbers(array, what)?;
    let n = names.len();
    let rows = match shape[..] {
        [len] if len == n => None,
        [rows, len] if len == n => Some(rows),
        _ => {
            let found = shape_text(&shape);
            return Err(input(format!(
                "{what} has the shape {found}, expected ({n},) or (m, {n}): {}",
                names.join(", ")
            )));
        }
    };
    finite(&values, what, |index| names[index % n].clone(), n)?;
    Ok(Rows { values, rows })
}

/// One vector of `n` numbers, all finite; `name` names each.
pub fn vector(
    array: &Bound<'_, PyAny>,
    what: &str,
    n: usize,
    name: impl Fn(usize) -> String,
) -> PyResult<Vec<f64>> {
    let (values, shape) = numbers(array, what)?;
    if shape[..] != [n] {
        let found = shape_text(&shape);
        return Err(input(format!(
            "{what} has the shape {found}, expected ({n},)"
        )));
    }
    finite(&values, what, name, n)?;
    Ok(values)
}

/// Points, (3,) or (k, 3), all finite.
pub fn points(array: &Bound<'_, PyAny>, what: &str) -> PyResult<(Vec<[f64; 3]>, bool)> {
    let names = ["x", "y", "z"].map(str::to_owned);
    let found = rows(array, what, &names)?;
    let points = found.values.chunks_exact(3).map(|c| [c[0], c[1], c[2]]);
    Ok((points.collect(), found.rows.is_some()))
}

/// Times of `rows` rows: a number for all of them, or one for each.
pub fn times(t: &Bound<'_, PyAny>, rows: Option<usize>) -> PyResult<Vec<f64>> {
    if let Ok(t) = t.extract::<f64>() {
        finite(&[t], "t", |_| "s".into(), 1)?;
        return Ok(vec![t]);
    }
    let (values, shape) = numbers(t, "t")?;
    let fits = match rows {
        Some(rows) => shape[..] == [rows],
        None => false,
    };
    if !fits {
        let found = shape_text(&shape);
        let expected = match rows {
            Some(rows) => format!("a number or ({rows},), one for each state"),
            None => "a number".to_owned(),
        };
        return Err(input(format!(
            "t has the shape {found}, expected {expected}"
        )));
    }
    finite(&values, "t", |_| "s".into(), values.len())?;
    Ok(values)
}

fn finite(values: &[f64], what: &str, name: impl Fn(usize) -> String, n: usize) -> PyResult<()> {
    let Some(at) = values.iter().position(|value| !value.is_finite()) else {
        return Ok(());
    };
    let place = match values.len() > n {
        true => format!("[{}, {}]", at / n, at % n),
        false => format!("[{at}]"),
    };
    let (value, name) = (values[at], name(at));
    Err(input(format!(
        "{what}{place} ({name}) is {value}, expected a finite number"
    )))
}

/// A shape as Python shows it.
pub fn shape_text(shape: &[usize]) -> String {
    match shape {
        [one] => format!("({one},)"),
        _ => {
            let each: Vec<String> = shape.iter().map(usize::to_string).collect();
            format!("({})", each.join(", "))
        }
    }
}

/// The numbers as an array of the given shape.
pub fn array<'py>(
    py: Python<'py>,
    values: Vec<f64>,
    shape: &[usize],
) -> PyResult<Bound<'py, PyAny>> {
    let flat = PyArray1::from_vec(py, values);
    match shape.len() {
        1 => Ok(flat.into_any()),
        _ => Ok(flat.reshape(shape.to_vec())?.into_any()),
    }
}
