//! Formatting of external text for error messages: escaped and truncated, long lists shortened.

/// Maximum length of a text from an input file in a message, characters; longer texts are truncated.
const LONGEST: usize = 40;
/// Maximum number of names that [`listed`] writes out; of the remaining names it states only the number.
const MOST: usize = 12;

/// Quotes and escapes a text from an input file for a message, and truncates it to a bounded length.
pub fn shown(text: &str) -> String {
    if text.chars().count() <= LONGEST {
        return format!("{text:?}");
    }
    let start: String = text.chars().take(LONGEST).collect();
    format!("{start:?}…")
}

/// Joins names by commas for a message; a long list is shortened to its first names and the number of the remaining
/// ones.
pub fn listed<'a>(names: impl IntoIterator<Item = &'a str>) -> String {
    let mut names = names.into_iter();
    let first: Vec<&str> = names.by_ref().take(MOST).collect();
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
        let told = listed(names.iter().map(String::as_str));
        assert!(told.ends_with("11 and 8 more"), "{told}");
    }
}
