//! Positions of the protocol, line and UTF-16 unit from 0, and byte offsets.

use std::ops::Range;

use serde_json::{Value, json};

/// Where the lines of a text begin.
#[derive(Default)]
pub struct Lines {
    starts: Vec<usize>,
    /// UTF-16 units before the last character that begins at or before each multiple of [`STEP`], and its offset.
    marks: Vec<(usize, usize)>,
}

/// Distance of the marks, bytes: a line may be as long as a text.
const STEP: usize = 256;

fn marks(text: &str) -> Vec<(usize, usize)> {
    let (mut marks, mut at, mut units) = (vec![(0, 0)], 0, 0);
    while marks.len() * STEP <= text.len() {
        let next = text.floor_char_boundary(marks.len() * STEP);
        units += text[at..next].encode_utf16().count();
        at = next;
        marks.push((units, at));
    }
    marks
}

impl Lines {
    /// Finds the lines of a text, which end with LF, CRLF or CR.
    pub fn of(text: &str) -> Lines {
        let bytes = text.as_bytes();
        let is_end =
            |i: usize| bytes[i] == b'\n' || bytes[i] == b'\r' && bytes.get(i + 1) != Some(&b'\n');
        let ends = (0..bytes.len()).filter(|&i| is_end(i));
        Lines {
            starts: std::iter::once(0).chain(ends.map(|end| end + 1)).collect(),
            marks: marks(text),
        }
    }

    /// Byte offset of a position; one outside the text is the nearest inside.
    pub fn offset(&self, text: &str, position: &Value) -> usize {
        let number = |name: &str| {
            let number = position[name].as_u64().unwrap_or(0);
            usize::try_from(number).unwrap_or(usize::MAX)
        };
        let (line, units) = (number("line"), number("character"));
        let Some(&start) = self.starts.get(line) else {
            return text.len();
        };
        let end = self
            .starts
            .get(line.saturating_add(1))
            .copied()
            .unwrap_or(text.len());
        let line = text[start..end].trim_end_matches(['\n', '\r']);
        let mut left = units;
        for (at, c) in line.char_indices() {
            if left < c.len_utf16() {
                return start + at;
            }
            left -= c.len_utf16();
        }
        start + line.len()
    }

    /// Line, and UTF-16 units before the offset on it.
    pub fn place(&self, text: &str, offset: usize) -> (usize, usize) {
        let offset = text.floor_char_boundary(offset);
        let line = self.starts.partition_point(|&start| start <= offset) - 1;
        let start = self.starts[line];
        (line, self.units(text, offset) - self.units(text, start))
    }

    /// UTF-16 units before an offset, which is at a character boundary.
    fn units(&self, text: &str, offset: usize) -> usize {
        let (units, at) = self.marks[offset / STEP];
        units + text[at..offset].encode_utf16().count()
    }

    /// A range of the protocol.
    pub fn range(&self, text: &str, range: Range<usize>) -> Value {
        let position = |offset: usize| {
            let (line, character) = self.place(text, offset);
            json!({ "line": line, "character": character })
        };
        json!({ "start": position(range.start), "end": position(range.end.max(range.start)) })
    }

    /// Byte offsets of a range of the protocol, in order.
    pub fn offsets(&self, text: &str, range: &Value) -> Range<usize> {
        let [a, b] = ["start", "end"].map(|name| self.offset(text, &range[name]));
        a.min(b)..b.max(a)
    }
}
