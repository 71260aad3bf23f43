//! Formats counts and lists in reports and messages.

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
