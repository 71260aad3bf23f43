//! Texts of the built-in models, effects and term libraries, embedded by the build script.

include!(concat!(env!("OUT_DIR"), "/library.rs"));

/// Text stored under `name` in a table of built-in files; `None` if the table has no such entry.
pub(crate) fn find(table: &[(&'static str, &'static str)], name: &str) -> Option<&'static str> {
    let entry = table.iter().find(|(own, _)| *own == name);
    entry.map(|(_, text)| *text)
}
