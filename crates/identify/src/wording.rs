//! Formats counts, lists and sentences in reports and messages.

/// Maximum number of names that a sentence lists; of the remaining names it states only the number.
const MAX_NAMES: usize = 24;
/// Maximum number of characters of a note in a report; longer notes are truncated.
const MAX_LETTERS: usize = 300;

/// Formats a count with its noun in the singular or plural: `1 flight`, `2 flights`. `one` is the singular.
pub fn count(number: usize, one: &str) -> String {
    format!("{number} {one}{}", if number == 1 { "" } else { "s" })
}

/// Formats a list in words: `a`, `a and b`, `a, b and c`; an empty string for no names.
pub fn listed<S: AsRef<str>>(names: &[S]) -> String {
    let names: Vec<&str> = names.iter().map(AsRef::as_ref).collect();
    match names.as_slice() {
        [] => String::new(),
        [name] => (*name).to_owned(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

/// Truncates a text to 300 characters.
pub fn short(text: &str) -> String {
    truncated(text, MAX_LETTERS)
}

/// Truncates a text to `most` characters, with `…` at the end if it is shortened.
pub fn truncated(text: &str, most: usize) -> String {
    match text.char_indices().nth(most) {
        Some((end, _)) => text[..end].to_owned() + "…",
        None => text.to_owned(),
    }
}

/// Joins names as `a, b and c`; of more than 24 names, only the number of further names is stated.
pub fn names(names: &[impl AsRef<str>]) -> String {
    let shown = names.iter().take(MAX_NAMES).map(AsRef::as_ref);
    let mut shown: Vec<&str> = shown.collect();
    let more = format!("{} more", names.len() - shown.len());
    if shown.len() < names.len() {
        shown.push(&more);
    }
    listed(&shown)
}

/// Text on a number of things in the past tense: `1 flight was`, `2 flights were`.
pub fn counted(number: usize, one: &str) -> String {
    let verb = if number == 1 { "was" } else { "were" };
    format!("{} {verb}", count(number, one))
}

/// Truncates a text to a note, without a colon at its end, and appends a full stop unless it ends a sentence.
pub fn sentence(text: &str) -> String {
    let text = short(text.trim_end().trim_end_matches(':'));
    if text.ends_with(['.', '…', '!', '?']) {
        text
    } else {
        text + "."
    }
}

/// Formats a text as a sentence that begins with a capital letter and ends with a full stop.
pub fn capitalized(text: &str) -> String {
    let sentence = sentence(text);
    let mut letters = sentence.chars();
    let first = letters.next().into_iter().flat_map(char::to_uppercase);
    first.collect::<String>() + letters.as_str()
}

/// Computing times as text; those that are not finite are left out.
pub fn durations<'a>(seconds: impl IntoIterator<Item = (&'a String, &'a f64)>) -> String {
    let seconds = seconds.into_iter().filter(|(_, s)| s.is_finite());
    let seconds = seconds.map(|(what, s)| format!("{what} {} s", crate::numbers::plain(*s, 2)));
    seconds.collect::<Vec<_>>().join(", ")
}
