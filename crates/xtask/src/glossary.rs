//! Checks of `docs/reference/glossary.md`: every name in its column of Rust names must occur in the source, and no doc
//! comment may explain one of its terms in parentheses.

use std::collections::BTreeSet;
use std::path::Path;

use anyhow::{Result, bail};

use crate::source;

/// Heading of the column of the tables in `docs/reference/glossary.md` that lists Rust names, each of which must
/// occur in the source.
const COLUMN: &str = "Rust name";

/// Heading of the column of terms.
const TERMS: &str = "term";

/// First words of a parenthesis that explains the term before it.
const EXPLAINS: [&str; 9] = [
    "a", "an", "the", "one", "those", "whose", "which", "that", "i.e.",
];

/// Returns an error if a name in the column [`COLUMN`] of `docs/reference/glossary.md` occurs in no source file, or a
/// doc comment explains a term of the glossary in parentheses.
pub fn check(root: &Path) -> Result<()> {
    let mut words = BTreeSet::new();
    let mut glosses = Vec::new();
    let page = source::read(&root.join("docs/reference/glossary.md"))?;
    let terms = terms(&page);
    for folder in source::crates(root)? {
        for file in source::rust_files(&folder.join("src"))? {
            let text = source::read(&file)?;
            let place = source::relative(root, &file).to_string();
            let found = glossed(&text, &terms).into_iter();
            glosses.extend(found.map(|gloss| format!("{place}: {gloss}")));
            let code = text
                .lines()
                .filter(|line| !line.trim_start().starts_with("//"));
            for line in code {
                let split = line.split(|c: char| !c.is_alphanumeric() && c != '_');
                words.extend(split.map(str::to_owned));
            }
        }
    }
    if !glosses.is_empty() {
        bail!(
            "doc comments explain terms that the glossary explains; link the type or leave the parenthesis out:\n{}",
            glosses.join("\n")
        );
    }
    let names = names(&page);
    if names.is_empty() {
        bail!("docs/reference/glossary.md has no column `{COLUMN}` with names");
    }
    let unknown: Vec<&str> = names
        .iter()
        .map(String::as_str)
        .filter(|name| !words.contains(*name))
        .collect();
    if !unknown.is_empty() {
        bail!(
            "docs/reference/glossary.md has names that no source file has: {}",
            unknown.join(", ")
        );
    }
    println!("{} names of the glossary are in the source", names.len());
    Ok(())
}

/// Names in backticks in the column [`COLUMN`] of the tables of the Markdown text `page`, each reduced to its last path
/// segment.
fn names(page: &str) -> Vec<String> {
    let cells = column(page, COLUMN).into_iter();
    let quoted = cells.flat_map(|cell| cell.split('`').skip(1).step_by(2));
    let names = quoted.filter_map(|name| name.split("::").last());
    names.map(str::to_owned).collect()
}

/// The terms of the glossary, in lower case.
fn terms(page: &str) -> BTreeSet<String> {
    let cells = column(page, TERMS).into_iter();
    let terms = cells.flat_map(|cell| cell.split([',', ':', ';']));
    let terms = terms.map(|term| term.trim().to_lowercase());
    terms.filter(|term| !term.is_empty()).collect()
}

/// Cells of the column with this heading in all tables of a Markdown text.
fn column<'p>(page: &'p str, heading: &str) -> Vec<&'p str> {
    let mut column = None;
    let mut found = Vec::new();
    for line in page.lines() {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        if cells.len() < 3 {
            column = None;
        } else if let Some(place) = cells.iter().position(|cell| *cell == heading) {
            column = Some(place);
        } else if let Some(cell) = column.and_then(|column| cells.get(column)) {
            found.push(*cell);
        }
    }
    found
}

/// Terms in the doc comments of a source text that a parenthesis explains, each with the parenthesis.
fn glossed(text: &str, terms: &BTreeSet<String>) -> Vec<String> {
    let comments = text.lines().map(|line| {
        let line = line.trim_start();
        let comment = line.strip_prefix("///").or(line.strip_prefix("//!"));
        comment.map_or("", str::trim)
    });
    let joined = comments.collect::<Vec<_>>().join(" ");
    let mut found = Vec::new();
    for (place, _) in joined.match_indices(" (") {
        let (before, inside) = (&joined[..place], &joined[place + 2..]);
        let explains = |word: &&str| inside.starts_with(&format!("{word} "));
        let Some(end) = inside.find(')').filter(|_| EXPLAINS.iter().any(explains)) else {
            continue;
        };
        let before = before.to_lowercase();
        let ends = |term: &&String| {
            let rest = before.strip_suffix(term.as_str());
            let rest = rest.or_else(|| before.strip_suffix('s')?.strip_suffix(term.as_str()));
            rest.is_some_and(|rest| !rest.ends_with(char::is_alphanumeric))
        };
        if let Some(term) = terms.iter().find(ends) {
            found.push(format!("{term} ({})", &inside[..end]));
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::{glossed, names, terms};

    #[test]
    fn a_parenthesis_that_explains_a_term_is_found() {
        let terms =
            terms("| concept | term |\n|---|---|\n| x | effect |\n| y | noise floor, error |");
        let text = "/// Two effects (changes of a model), an effect (a named\n/// change), noise floors (the least noise)\n/// \
                    and a side effect (such as this), prefect (a word).";
        let found = glossed(text, &terms);
        assert_eq!(
            found,
            ["effect (a named change)", "noise floor (the least noise)"]
        );
    }

    #[test]
    fn names_are_the_last_segments_in_the_column() {
        let page = "| concept | Rust name |\n|---|---|\n| `a` x | `m::T`, `U` |\n\n| `V` | `W` |";
        assert_eq!(names(page), ["T", "U"]);
    }
}
