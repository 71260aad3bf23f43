//! Text of results for a terminal.

use std::sync::OnceLock;

pub(crate) const MAX_ROWS: usize = 20;
const WIDTH: usize = 100;

/// Least width that text is fitted to; a terminal may state less.
const MIN_WIDTH: usize = 30;

/// Width of the terminal, characters.
static TERMINAL: OnceLock<usize> = OnceLock::new();

/// States the width of the terminal, once for a process; without it sentences are broken at 100 characters.
pub fn set_width(characters: usize) {
    TERMINAL.get_or_init(|| characters.max(MIN_WIDTH));
}

/// Width of the terminal, if it was stated.
pub(crate) fn width() -> Option<usize> {
    TERMINAL.get().copied()
}

/// A sentence in lines that fit the terminal, or elsewhere on one line; it ends with a line break.
pub(crate) fn fitted(text: &str) -> String {
    match width() {
        Some(_) => wrapped(text),
        None => format!("{text}\n"),
    }
}

/// Breaks a paragraph into lines that fit the terminal; it ends with a line break.
pub fn wrapped(text: &str) -> String {
    let width = width().map_or(WIDTH, |width| width.min(WIDTH));
    lines(text, width).join("\n") + "\n"
}

/// Words of a paragraph as lines of less than `width` characters, unless a word is longer.
pub(crate) fn lines(text: &str, width: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    let mut length = 0;
    for word in text.split_ascii_whitespace() {
        let letters = word.chars().count();
        if length > 0 && length + letters >= width {
            lines.push(String::new());
            length = 0;
        }
        if let Some(line) = lines.last_mut() {
            if length > 0 {
                line.push(' ');
                length += 1;
            }
            *line += word;
            length += letters;
        }
    }
    lines
}
