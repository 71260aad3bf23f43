//! The module `hyzer._hyzer` of the Python package: models, flights, datasets and fits, and the program.

mod array;
mod dataset;
mod errors;
mod fit;
mod model;
mod work;

use std::ffi::OsString;

use pyo3::prelude::*;

/// Runs the program `hyzer` with its arguments, the first of which is its name, and returns the exit status.
#[pyfunction]
fn main(py: Python<'_>, arguments: Vec<OsString>) -> u8 {
    py.detach(|| hyzer::program::run(arguments))
}

/// The compiled part of hyzer.
#[pymodule]
mod _hyzer {
    #[pymodule_export]
    use super::main;
    #[pymodule_export]
    use crate::dataset::Dataset;
    #[pymodule_export]
    use crate::fit::{Fit, fit};
    #[pymodule_export]
    use crate::model::Model;
}
