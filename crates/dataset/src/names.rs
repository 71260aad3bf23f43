//! Rules for the names of markers and flight files.

use std::path::{Component, Path};

/// Maximum length of a marker name, bytes; file paths may be eight times as long.
const MAX_BYTES: usize = 255;

pub(super) fn wrong_with_marker(name: &str) -> Option<&'static str> {
    let separates =
        |c: char| c.is_whitespace() || c.is_control() || [',', ';', '"', '#'].contains(&c);
    if name.is_empty() || name.len() > MAX_BYTES || name.chars().any(separates) {
        Some("a name without spaces, separators, quotes and #")
    } else if ["_x", "_y", "_z"].iter().any(|axis| name.ends_with(axis)) {
        Some("a marker, not one of its columns: the columns of m1 are m1_x, m1_y and m1_z")
    } else {
        None
    }
}

pub(super) fn wrong_with_file(file: &str) -> Option<&'static str> {
    let parts = || Path::new(file).components();
    let inside = parts().all(|part| matches!(part, Component::Normal(_)));
    // Each file must have only one spelling, so that a duplicate entry is noticed: no `a//b`, no `a/./b`.
    let names: Option<Vec<&str>> = parts().map(|part| part.as_os_str().to_str()).collect();
    let plain = names.is_some_and(|names| names.join("/") == file);
    // A backslash separates folders on some systems and is an ordinary character on others.
    let odd = |c: char| c.is_control() || c == '\\';
    if file.is_empty() || !inside {
        Some("a file inside the dataset's folder")
    } else if !plain || file.chars().any(odd) || file.len() > 8 * MAX_BYTES {
        Some("a file name, with / between folders")
    } else {
        None
    }
}

/// Whether a flight's file is read as C3D (motion-capture format), judged by the extension of its name.
pub(super) fn is_c3d(file: &Path) -> bool {
    file.extension()
        .is_some_and(|extension| extension.eq_ignore_ascii_case("c3d"))
}
