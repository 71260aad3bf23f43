//! The backends.

use super::interface::Backend;
use crate::rust;

/// All backends, the default first.
pub static BACKENDS: &[&dyn Backend] = &[&rust::PlainRust, &rust::LanesRust];

/// The backend with a given name.
pub fn backend(name: &str) -> Option<&'static dyn Backend> {
    BACKENDS
        .iter()
        .copied()
        .find(|backend| backend.name() == name)
}
