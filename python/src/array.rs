//! Arrays from Python: checked, and copied where they are not contiguous.

use numpy::{PyArray1, PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::types::{PyList, PyMapping, PyTuple};

use crate::errors::input;

/// Contiguous numbers of an array: its own, or a copy.
pub struct Numbers<'py>(PyReadonlyArrayDyn<'py, f64>);

impl Numbers<'_> {
    /// The numbers, row by row.
    pub fn values(&self) -> &[f64] {
        // Contiguous and aligned, as `numbers` checked.
        self.0.as_slice().unwrap_or_default()
    }
}

/// One vector or several, one per row.
pub struct Rows<'py> {
    numbers: Numbers<'py>,
    /// Number of rows; `None` for one vector, an array of one dimension.
    pub rows: Option<usize>,
}

impl Rows<'_> {
    /// The numbers, row by row.
    pub fn values(&self) -> &[f64] {
        self.numbers.values()
    }

    /// Shape of a result that has `tail` numbers for each row.
    pub fn shape(&self, tail: &[usize]) -> Vec<usize> {
        self.rows.into_iter().chain(tail.iter().copied()).collect()
    }
}

/// The numbers of an array and its shape. `what` names the array in messages.
pub fn numbers<'py>(array: &Bound<'py, PyAny>, what: &str) -> PyResult<(Numbers<'py>, Vec<usize>)> {
    if array.is_exact_instance_of::<PyArrayDyn<f64>>()
        && let Ok(array) = array.cast::<PyArrayDyn<f64>>()
        && array.is_c_contiguous()
        && let Ok(array) = array.try_readonly()
        && array.as_slice().is_ok()
    {
        let shape = array.shape().to_vec();
        return Ok((Numbers(array), shape));
    }
    let numpy = array.py().import("numpy")?;
    // What is masked has no value.
    let array = &match array.getattr("mask").is_ok() && array.getattr("filled").is_ok() {
        true => array
            .call_method1("astype", ("float64",))?
            .call_method1("filled", (f64::NAN,))?,
        false => array.clone(),
    };
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
    found.as_slice().map_err(|error| input(error.to_string()))?;
    Ok((Numbers(found), shape))
}

/// Labels along the last axis of an array of pandas, polars or xarray: `None` where one is no name. Nothing of other
/// arrays, or where the labels are numbers.
pub fn labels(array: &Bound<'_, PyAny>) -> PyResult<Option<Vec<Option<String>>>> {
    if array.is_exact_instance_of::<PyArrayDyn<f64>>() {
        return Ok(None);
    }
    let labels = if array.hasattr("columns")? {
        array.getattr("columns")?
    } else if array.hasattr("iloc")? {
        array.getattr("index")?
    } else if let Some(labels) = coordinates(array)? {
        labels
    } else {
        return Ok(None);
    };
    let labels: Vec<Bound<'_, PyAny>> = labels.try_iter()?.collect::<PyResult<_>>()?;
    if labels.iter().all(|label| label.extract::<i64>().is_ok()) {
        return Ok(None);
    }
    let names = labels.iter().map(|label| label.extract::<String>().ok());
    Ok(Some(names.collect()))
}

/// Coordinates along the last axis of an array of xarray, if it has some.
fn coordinates<'py>(array: &Bound<'py, PyAny>) -> PyResult<Option<Bound<'py, PyAny>>> {
    if !array.hasattr("dims")? || !array.hasattr("coords")? {
        return Ok(None);
    }
    let coordinates = array.getattr("coords")?;
    match array.getattr("dims")?.try_iter()?.last().transpose()? {
        Some(last) if coordinates.contains(&last)? => {
            let values = coordinates.get_item(last)?.getattr("values")?;
            values.call_method0("tolist").map(Some)
        }
        _ => Ok(None),
    }
}

/// An array whose elements, or columns, are in the order of `names`: by their labels, if it has some.
pub fn in_order<'py>(
    array: &Bound<'py, PyAny>,
    what: &str,
    names: &[String],
) -> PyResult<Bound<'py, PyAny>> {
    if let Ok(list) = array.cast::<PyList>()
        && !list.is_empty()
        && labels(&list.get_item(0)?)?.is_some()
    {
        let rows = list.iter().map(|row| in_order(&row, what, names));
        return Ok(PyList::new(array.py(), rows.collect::<PyResult<Vec<_>>>()?)?.into_any());
    }
    let Some(labels) = labels(array)? else {
        return match array.is_exact_instance_of::<PyArrayDyn<f64>>() {
            true => Ok(array.clone()),
            false => of_mapping(array, what, names),
        };
    };
    let is_name = |label: &Option<String>| label.as_ref().is_some_and(|own| names.contains(own));
    let at = |name: &String| labels.iter().position(|label| label.as_ref() == Some(name));
    let order: Option<Vec<usize>> = names.iter().map(at).collect();
    let Some(order) = order.filter(|_| labels.len() == names.len() && labels.iter().all(is_name))
    else {
        let found: Vec<&str> = labels
            .iter()
            .map(|own| own.as_deref().unwrap_or("?"))
            .collect();
        return Err(input(format!(
            "{what} has the labels {}, expected {}; or no labels, as of to_numpy(), in this order",
            found.join(", "),
            names.join(", ")
        )));
    };
    let numpy = array.py().import("numpy")?;
    numpy.call_method1(
        "take",
        (numpy.call_method1("asarray", (array,))?, order, -1),
    )
}

/// The values of a mapping in the order of `names`, along the last axis; anything else as it is.
fn of_mapping<'py>(
    values: &Bound<'py, PyAny>,
    what: &str,
    names: &[String],
) -> PyResult<Bound<'py, PyAny>> {
    let Ok(mapping) = values.cast::<PyMapping>() else {
        return Ok(values.clone());
    };
    let has = |name: &String| mapping.contains(name).unwrap_or(false);
    if mapping.len()? != names.len() || !names.iter().all(has) {
        let found: Vec<String> = { mapping.keys()?.iter() }
            .map(|key| key.to_string())
            .collect();
        return Err(input(format!(
            "{what} has the names {}, expected {}",
            found.join(", "),
            names.join(", ")
        )));
    }
    let columns: Vec<_> = { names.iter() }
        .map(|name| mapping.get_item(name))
        .collect::<PyResult<_>>()?;
    let numpy = values.py().import("numpy")?;
    let columns = numpy.call_method1("broadcast_arrays", PyTuple::new(values.py(), columns)?)?;
    numpy.call_method1("stack", (columns, -1))
}

/// A vector with a number for each of `names`, or several as the rows of an array; all numbers are finite.
pub fn rows<'py>(array: &Bound<'py, PyAny>, what: &str, names: &[String]) -> PyResult<Rows<'py>> {
    let (numbers, shape) = numbers(&in_order(array, what, names)?, what)?;
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
    finite(numbers.values(), what, |index| names[index % n].clone(), n)?;
    Ok(Rows { numbers, rows })
}

/// One vector with a number for each of `names`, all finite.
pub fn vector(array: &Bound<'_, PyAny>, what: &str, names: &[String]) -> PyResult<Vec<f64>> {
    let n = names.len();
    let (values, shape) = numbers(&in_order(array, what, names)?, what)?;
    if shape[..] != [n] {
        let found = shape_text(&shape);
        return Err(input(format!(
            "{what} has the shape {found}, expected ({n},)"
        )));
    }
    finite(values.values(), what, |index| names[index].clone(), n)?;
    Ok(values.values().to_vec())
}

/// Points, (3,) or (k, 3), all finite.
pub fn points(array: &Bound<'_, PyAny>, what: &str) -> PyResult<(Vec<[f64; 3]>, bool)> {
    let names = ["x", "y", "z"].map(str::to_owned);
    let found = rows(array, what, &names)?;
    let points = found.values().chunks_exact(3).map(|c| [c[0], c[1], c[2]]);
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
    let values = values.values();
    finite(values, "t", |_| "s".into(), values.len())?;
    Ok(values.to_vec())
}

fn finite(values: &[f64], what: &str, name: impl Fn(usize) -> String, n: usize) -> PyResult<()> {
    // Without an early end, so that several are compared at once.
    let all = values
        .iter()
        .fold(true, |all, value| all & value.is_finite());
    if all {
        return Ok(());
    }
    let at = values.iter().position(|value| !value.is_finite());
    let at = at.unwrap_or_default();
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
