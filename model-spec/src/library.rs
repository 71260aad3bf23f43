//! Models, effects and term libraries that are built in; a file added to their folder is found by the build script.

include!(concat!(env!("OUT_DIR"), "/library.rs"));

/// Text of an entry of a table by its name.
pub(crate) fn find(table: &[(&'static str, &'static str)], name: &str) -> Option<&'static str> {
    let entry = table.iter().find(|(own, _)| *own == name);
    entry.map(|(_, text)| *text)
}
