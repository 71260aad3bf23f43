//! Source texts of a model and ranges in them.

use std::ops::Range;

/// A text that a model was made from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Source {
    /// File name, or name of a built-in model or effect, for messages.
    pub name: String,
    /// The text.
    pub text: String,
}

/// A byte range of a source text: from `start` up to, not including, `end`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Span {
    /// First byte.
    pub start: u32,
    /// One past the last byte.
    pub end: u32,
    /// Index of the text: 0 is the model file; those of applied effects follow.
    pub source: u16,
}

impl Span {
    /// The byte range within its text.
    pub fn range(self) -> Range<usize> {
        self.start as usize..self.end as usize
    }

    /// The range from the start of this span to the end of another one in the same text.
    #[must_use]
    pub fn to(self, end: Span) -> Span {
        Span {
            end: end.end.max(self.start),
            ..self
        }
    }
}

/// Where the lines of a text begin, for line numbers of many spans.
pub(crate) struct LineStarts(Vec<usize>);

impl LineStarts {
    pub(crate) fn new(text: &str) -> LineStarts {
        let starts = text.match_indices('\n').map(|(newline, _)| newline + 1);
        LineStarts(std::iter::once(0).chain(starts).collect())
    }

    /// Line of a byte, from 1.
    pub(crate) fn line(&self, byte: u32) -> usize {
        self.0.partition_point(|&start| start <= byte as usize)
    }
}
