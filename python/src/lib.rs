//! The module `hyzer._hyzer` of the Python package: models, flights, datasets and fits, and the program.

mod analyses;
mod array;
mod batch;
mod checks;
mod dataset;
mod diagnosis;
mod errors;
mod evaluation;
mod fit;
mod flight;
mod made;
mod model;
mod model_methods;
mod report;
mod work;

use std::ffi::OsString;

use pyo3::prelude::*;
#[cfg(feature = "as-tested")]
use shared_features as _;

#[cfg(panic = "abort")]
compile_error!(
    "a cancelled analysis would end the interpreter: build with --profile wheel, or without --release, so that panics unwind"
);

/// Runs the program `hyzer` with its arguments, the first of which is its name, and returns the exit status.
#[pyfunction]
fn main(py: Python<'_>, arguments: Vec<OsString>) -> u8 {
    py.detach(|| hyzer::program::run(arguments))
}

/// The compiled part of hyzer.
#[pymodule]
mod _hyzer {
    /// Version of the package.
    #[pymodule_export]
    #[expect(non_upper_case_globals, reason = "the name of Python")]
    const __version__: &str = env!("CARGO_PKG_VERSION");
    #[pymodule_export]
    use super::main;
    #[pymodule_export]
    use crate::analyses::{bootstrap, design, stability, sweep, sweep_plan};
    #[pymodule_export]
    use crate::checks::{diff, verify};
    #[pymodule_export]
    use crate::dataset::Dataset;
    #[pymodule_export]
    use crate::diagnosis::{Diagnosis, diagnose};
    #[pymodule_export]
    use crate::fit::{Fit, fit};
    #[pymodule_export]
    use crate::flight::{Flight, fly, release_text};
    #[pymodule_export]
    use crate::made::{import_takes, synthesize, table_text};
    #[pymodule_export]
    use crate::model::Model;
    #[pymodule_export]
    use crate::report::{Report, write_files};
}
