//! Header lines that programs write as a comment, as in `# timestamp tx ty tz qx qy qz qw`.

use std::borrow::Cow;

use crate::takes::columns::{Column, Quantity};
use crate::takes::neighbours::columns_of;
use crate::takes::separator;

/// The text with its header line bare, where that stands behind a `#` above a first row of numbers: the last comment
/// there that names coordinates. Lines and places are those of `text`.
pub(super) fn with_bare_header(text: Cow<'_, str>) -> Cow<'_, str> {
    let mut start = 0;
    let (mut header, mut has_rows) = (None, false);
    for line in text.split_inclusive('\n') {
        let bare = line.trim();
        if let Some(comment) = bare.strip_prefix('#') {
            if has_coordinates(comment) {
                header = line.find('#').map(|at| start + at);
            }
        } else if !bare.is_empty() {
            let first = bare.split([',', ';', '\t', ' ']).next().unwrap_or_default();
            has_rows = first.parse::<f64>().is_ok();
            break;
        }
        start += line.len();
    }
    match header.filter(|_| has_rows) {
        None => text,
        Some(at) => {
            let mut bare = text.into_owned();
            bare.replace_range(at..=at, " ");
            bare.into()
        }
    }
}

/// Whether a line names columns of coordinates.
fn has_coordinates(line: &str) -> bool {
    let names: Vec<&str> = line.split(separator(line)).map(str::trim).collect();
    let columns = columns_of(names.into_iter().filter(|name| !name.is_empty()));
    let axes = |column: &&Column| matches!(column.quantity, Quantity::Coordinate(..));
    columns.iter().filter(axes).count() >= 3
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_comment_that_names_columns_is_the_header() {
        let bare = |text: &'static str| with_bare_header(text.into()).into_owned();
        assert_eq!(
            bare("# ground truth\n# t x y z\n1 2 3 4\n"),
            "# ground truth\n  t x y z\n1 2 3 4\n"
        );
        for same in [
            "# x y z\nt x y z\n1 2 3 4\n",
            "# a note\n1 2 3 4\n",
            "",
            "# x y z",
        ] {
            assert_eq!(bare(same), same);
        }
    }
}
