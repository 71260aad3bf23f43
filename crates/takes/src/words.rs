//! Formatting for error messages: external texts escaped and cut, long lists shortened.

/// Longest external text in a message, characters; longer texts are cut.
const LONGEST: usize = 40;
/// Greatest number of names that a message lists.
const MOST: usize = 12;

/// An external text in quotes, escaped and cut to a bounded length.
pub fn shown(text: &str) -> String {
    if text.chars().count() <= LONGEST {
        return format!("{text:?}");
    }
    let start: String = text.chars().take(LONGEST).collect();
    format!("{start:?}…")
}

/// A list of names for a message; long lists are shortened.
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
