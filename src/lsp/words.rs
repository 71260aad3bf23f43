//! Words of the language: how they are used and what they mean.

/// A word of the language, how it is used, and what that means.
pub type Word = (&'static str, &'static str, &'static str);

/// Words that begin a statement.
pub fn statements() -> Vec<Word> {
    table(include_str!("words/statements.tsv"))
}

/// Words inside statements, and `in_` before the name of a frame.
pub fn inner() -> Vec<Word> {
    table(include_str!("words/inner.tsv"))
}

/// Functions and quantities of the language.
pub fn built_in() -> Vec<Word> {
    table(include_str!("words/built_in.tsv"))
}

fn table(text: &'static str) -> Vec<Word> {
    let row = |line: &'static str| {
        let (word, rest) = line.split_once('\t')?;
        let (form, meaning) = rest.split_once('\t')?;
        Some((word, form, meaning))
    };
    text.lines().filter_map(row).collect()
}

/// The keyword, or the function or quantity, of this name.
pub fn find(word: &str, is_keyword: bool) -> Option<Word> {
    let all = match is_keyword {
        true => [statements(), inner()].concat(),
        false => built_in(),
    };
    all.into_iter().find(|own| own.0 == word)
}
