//! Formatting of external text for error messages: escaped and truncated, long lists shortened.

/// Maximum length of a text from an input file in a message, characters; longer texts are truncated.
const MAX_CHARACTERS: usize = 40;
/// Maximum number of names that [`listed`] writes out; of the remaining names it states only the number.
const MAX_NAMES: usize = 12;

/// Formats a text from an input file for a message: quoted, escaped and truncated to a bounded length.
pub fn shown(text: &str) -> String {
    if text.chars().count() <= MAX_CHARACTERS {
        return format!("{text:?}");
    }
    let start: String = text.chars().take(MAX_CHARACTERS).collect();
    format!("{start:?}…")
}

/// Joins names by commas for a message; a long list is its first names and the number of the others.
pub fn listed<S: AsRef<str>>(names: impl IntoIterator<Item = S>) -> String {
    let mut names = names.into_iter();
    let first: Vec<S> = names.by_ref().take(MAX_NAMES).collect();
    let first: Vec<&str> = first.iter().map(AsRef::as_ref).collect();
    match names.count() {
        0 => first.join(", "),
        more => format!("{} and {more} more", first.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_are_escaped_and_cut() {
        assert_eq!(shown("a\u{1b}b"), "\"a\\u{1b}b\"");
        assert_eq!(shown(&"x".repeat(50)), format!("\"{}\"…", "x".repeat(40)));
    }

    #[test]
    fn long_lists_are_counted() {
        let names: Vec<String> = (0..20).map(|i| i.to_string()).collect();
        let text = listed(&names);
        assert!(text.ends_with("11 and 8 more"), "{text}");
    }
}
