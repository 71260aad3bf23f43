//! Registry of all backends.

use super::interface::Backend;
use crate::rust;

/// All backends; the first is the default.
pub static BACKENDS: &[&dyn Backend] = &[&rust::PlainRust, &rust::LanesRust];

/// Backend with a given name; `None` if there is none.
pub fn backend(name: &str) -> Option<&'static dyn Backend> {
    BACKENDS
        .iter()
        .copied()
        .find(|backend| backend.name() == name)
}
