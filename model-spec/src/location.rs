//! Source texts, spans in them, and lines and columns, both counted from 1; lines end with LF, columns count characters.

use std::ops::Range;

/// Line and column of a byte offset, counted from 1 and in characters; an offset past the end is the end.
pub fn line_and_column(text: &str, byte: usize) -> (usize, usize) {
    let byte = text.floor_char_boundary(byte);
    let line_start = line_start(text, byte);
    (
        line_of(text, byte),
        text[line_start..byte].chars().count() + 1,
    )
}

/// Line, counted from 1, of a byte offset in a text; the last line for an offset past the end.
pub fn line_of(text: &str, byte: usize) -> usize {
    let before = &text.as_bytes()[..byte.min(text.len())];
    memchr::memchr_iter(b'\n', before).count() + 1
}

/// Line of a byte offset, counted from 1, and its trimmed text; an offset past the end is the end.
pub fn trimmed_line(text: &str, byte: usize) -> (usize, &str) {
    let byte = text.floor_char_boundary(byte);
    let line = &text[line_start(text, byte)..];
    let line = line.lines().next().unwrap_or_default();
    (line_of(text, byte), line.trim())
}

/// Offset of the first byte of the line that contains `byte`, which is at a character boundary of `text`.
fn line_start(text: &str, byte: usize) -> usize {
    text[..byte].rfind('\n').map_or(0, |newline| newline + 1)
}

/// A source text of a model: the text of the model file, or of an effect that is applied.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Source {
    /// File name, or name of a built-in model or effect, for messages.
    pub name: String,
    /// Full content of the source text.
    pub text: String,
}

impl Source {
    /// Creates a source text.
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Source {
        Source {
            name: name.into(),
            text: text.into(),
        }
    }
}

/// A byte range of a source text: from `start` up to, not including, `end`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Span {
    /// Byte offset of the start of the range.
    pub start: u32,
    /// Byte offset of the end of the range, exclusive.
    pub end: u32,
    /// Index of the source text: 0 is the model file; applied effects follow.
    pub source: u16,
}

impl Span {
    /// The span as a range of byte offsets in its source text.
    pub fn range(self) -> Range<usize> {
        self.start as usize..self.end as usize
    }

    /// Span from the start of `self` to the end of `end`; both must lie in the same source text.
    #[must_use]
    pub fn to(self, end: Span) -> Span {
        Span {
            end: end.end.max(self.start),
            ..self
        }
    }

    /// The empty span before this one.
    pub(crate) fn before(self) -> Span {
        self.first_bytes(0)
    }

    /// The empty span behind this one.
    pub(crate) fn behind(self) -> Span {
        let start = self.end;
        Span { start, ..self }
    }

    /// The beginning of the span, of as many bytes.
    pub(crate) fn first_bytes(self, count: u32) -> Span {
        let end = self.start + count;
        Span { end, ..self }
    }

    /// Whether another span lies within this one.
    pub(crate) fn contains(self, other: Span) -> bool {
        self.source == other.source && self.start <= other.start && other.end <= self.end
    }
}

#[cfg(test)]
mod tests {
    use super::{line_and_column, trimmed_line};

    #[test]
    fn columns_count_characters() {
        let text = "I_a\nalpha ° β\n";
        let places = [0, 4, 10, 11, 12, 13, 15, 16, 99].map(|byte| line_and_column(text, byte));
        let expected = [
            (1, 1),
            (2, 1),
            (2, 7),
            (2, 7),
            (2, 8),
            (2, 9),
            (2, 10),
            (3, 1),
            (3, 1),
        ];
        assert_eq!(places, expected);
    }

    #[test]
    fn a_line_is_found_from_each_of_its_bytes() {
        let text = "\n  I_a = β  \r\nm";
        let expected = [(1, ""), (2, "I_a = β"), (2, "I_a = β"), (3, "m"), (3, "m")];
        for (byte, line) in [0, 1, 14, 15, 99].into_iter().zip(expected) {
            assert_eq!(trimmed_line(text, byte), line, "byte {byte}");
        }
        assert_eq!(trimmed_line("m\n", 2), (2, ""));
    }
}
