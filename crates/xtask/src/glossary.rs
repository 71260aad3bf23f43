//! Check of `docs/reference/glossary.md`: every name in its column of Rust names must occur in the source.

use std::collections::BTreeSet;
use std::path::Path;

use anyhow::{Result, bail};

use crate::source;

/// Heading of the column of the tables in `docs/reference/glossary.md` that lists Rust names, each of which must
/// occur in the source.
const COLUMN: &str = "Rust name";

/// Returns an error if a name in the column [`COLUMN`] of `docs/reference/glossary.md` occurs in no source file.
pub fn check(root: &Path) -> Result<()> {
    let mut words = BTreeSet::new();
    for folder in source::crates(root)? {
        for file in source::rust_files(&folder.join("src"))? {
            let text = source::read(&file)?;
            let code = text
                .lines()
                .filter(|line| !line.trim_start().starts_with("//"));
            for line in code {
                let split = line.split(|c: char| !c.is_alphanumeric() && c != '_');
                words.extend(split.map(str::to_owned));
            }
        }
    }
    let names = names(&source::read(&root.join("docs/reference/glossary.md"))?);
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
    let mut column = None;
    let mut names = Vec::new();
    for line in page.lines() {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        if cells.len() < 3 {
            column = None;
        } else if let Some(found) = cells.iter().position(|cell| *cell == COLUMN) {
            column = Some(found);
        } else if let Some(cell) = column.and_then(|column| cells.get(column)) {
            let quoted = cell.split('`').skip(1).step_by(2);
            names.extend(
                quoted
                    .filter_map(|name| name.split("::").last())
                    .map(str::to_owned),
            );
        }
    }
    names
}

#[cfg(test)]
mod tests {
    use super::names;

    #[test]
    fn names_are_the_last_segments_in_the_column() {
        let page = "| concept | Rust name |\n|---|---|\n| `a` x | `m::T`, `U` |\n\n| `V` | `W` |";
        assert_eq!(names(page), ["T", "U"]);
    }
}
