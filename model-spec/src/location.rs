//! Lines and columns of a text, both counted from 1; lines end with LF, columns count characters.

/// Line and column of a byte offset in a text, both counted from 1; columns count characters. An offset inside a
/// character counts as the character's first byte, an offset past the end as the end.
pub fn line_and_column(text: &str, byte: usize) -> (usize, usize) {
    let before = &text[..text.floor_char_boundary(byte)];
    let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
    (
        line_of(text, byte),
        before[line_start..].chars().count() + 1,
    )
}

/// Line, counted from 1, of a byte offset in a text; the last line for an offset past the end.
pub fn line_of(text: &str, byte: usize) -> usize {
    let before = &text.as_bytes()[..byte.min(text.len())];
    before.iter().filter(|&&b| b == b'\n').count() + 1
}

/// Line, counted from 1, of a byte offset in a text, and the text of this line without leading and trailing whitespace.
/// An offset past the end counts as the end.
pub fn trimmed_line(text: &str, byte: usize) -> (usize, &str) {
    let line = line_of(text, byte);
    (line, text.lines().nth(line - 1).unwrap_or_default().trim())
}

#[cfg(test)]
mod tests {
    use super::line_and_column;

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
}
