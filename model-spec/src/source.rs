//! Source texts of a model, and byte ranges in them.

use std::ops::Range;

/// A source text of a model: the text of the model file, or of an effect that is applied.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Source {
    /// File name, or name of a built-in model or effect, for messages.
    pub name: String,
    /// Full content of the source text.
    pub text: String,
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
}

/// Byte offsets of the line starts of a text, for a binary search of line numbers.
pub(crate) struct LineStarts(Vec<usize>);

impl LineStarts {
    pub(crate) fn new(text: &str) -> LineStarts {
        let starts = text.match_indices('\n').map(|(newline, _)| newline + 1);
        LineStarts(std::iter::once(0).chain(starts).collect())
    }

    /// Line number of a byte offset, counted from 1.
    pub(crate) fn line(&self, byte: u32) -> usize {
        self.0.partition_point(|&start| start <= byte as usize)
    }
}
