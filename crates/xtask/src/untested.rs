//! Check that no test lies in a target whose manifest switches its tests off.

use std::path::Path;

use anyhow::{Context, Result, bail};
use cargo_metadata::{MetadataCommand, Package, Target};

use crate::source;

/// Returns an error if a package contains tests that would not run: a `#[test]` in `src` although its manifest sets
/// `test = false`, or an example in a doc comment although it sets `doctest = false`.
pub fn check(root: &Path) -> Result<()> {
    let metadata = MetadataCommand::new()
        .manifest_path(root.join("Cargo.toml"))
        .no_deps()
        .exec()?;
    let mut lost = Vec::new();
    for package in metadata.workspace_packages() {
        let has_unit_tests = targets(package).any(|target| target.test);
        let has_doc_tests = targets(package).any(|target| target.doctest);
        let folder = package
            .manifest_path
            .parent()
            .context("a manifest without folder")?;
        for file in source::rust_files(folder.join("src").as_std_path())? {
            let text = source::read(&file)?;
            let name = source::relative(root, &file);
            if !has_unit_tests && text.contains("#[test]") {
                lost.push(format!(
                    "{name}: a unit test, but Cargo.toml says `test = false`"
                ));
            }
            if !has_doc_tests && has_example(&text) {
                lost.push(format!(
                    "{name}: an example, but Cargo.toml says `doctest = false`"
                ));
            }
        }
    }
    if !lost.is_empty() {
        bail!("tests that would not run:\n{}", lost.join("\n"));
    }
    Ok(())
}

/// Library and program targets of a package; their unit tests and documentation examples are in its folder `src`.
fn targets(package: &Package) -> impl Iterator<Item = &Target> {
    let targets = package.targets.iter();
    targets.filter(|target| target.is_lib() || target.is_bin())
}

/// Whether a doc comment has a code block that rustdoc would compile.
fn has_example(text: &str) -> bool {
    let lines = text.lines().map(str::trim_start);
    let mut blocks = lines.filter_map(|line| {
        let doc = line
            .strip_prefix("///")
            .or_else(|| line.strip_prefix("//!"))?;
        doc.trim_start().strip_prefix("```")
    });
    // Every other mark closes a block.
    let mut opening = std::iter::from_fn(|| {
        let language = blocks.next()?;
        blocks.next();
        Some(language)
    });
    opening.any(|language| !["text", "toml", "json", "ignore"].contains(&language.trim()))
}

#[cfg(test)]
mod tests {
    use super::has_example;

    #[test]
    fn blocks_of_other_languages_are_no_examples() {
        assert!(!has_example("/// ```text\n/// a\n/// ```\nfn f() {}"));
        assert!(has_example(
            "/// ```text\n/// a\n/// ```\n/// ```\n/// f();\n/// ```"
        ));
        assert!(has_example("    //! ```no_run\n    //! f();\n    //! ```"));
        assert!(!has_example("let text = \"```\";"));
    }
}
