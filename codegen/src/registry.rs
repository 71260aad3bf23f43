//! Registry of all backends.

use crate::backend::Backend;
use crate::rust;

/// All code generation backends; the first is the default.
pub static BACKENDS: &[&dyn Backend] = &[&rust::PlainRust, &rust::LanesRust];

/// Returns the backend with a given name; `None` if there is none.
pub fn backend(name: &str) -> Option<&'static dyn Backend> {
    BACKENDS
        .iter()
        .copied()
        .find(|backend| backend.name() == name)
}
