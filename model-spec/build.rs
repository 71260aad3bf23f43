//! Embeds the files of the model, effect and term-library folders as tables of name and text, sorted by name.

use std::env;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

/// Rust constants that this build script writes, each a table of the built-in files of one folder. The fields are the
/// name of the constant, its doc comment, the name of the folder, and the extension of the files.
const TABLES: [(&str, &str, &str, &str); 6] = [
    (
        "MODELS",
        "Built-in models that `hyzer verify` checks by default, as pairs of name and text.",
        "models",
        "hyz",
    ),
    (
        "BODIES",
        "Built-in models of measured bodies, as pairs of name and text.",
        "bodies",
        "hyz",
    ),
    (
        "EFFECTS",
        "Built-in effects (optional model extensions), as pairs of name and text.",
        "effects",
        "hyz",
    ),
    (
        "WINDS",
        "Winds that a release can specify, as effects for any model; a diagnosis does not test them: name and text.",
        "winds",
        "hyz",
    ),
    (
        "REFUTED",
        "Models that are wrong on purpose, for tests of the verification: name and text.",
        "refuted",
        "hyz",
    ),
    (
        "TERM_LIBRARIES",
        "Built-in term libraries: name and text, in TOML.",
        "term_libraries",
        "toml",
    ),
];

fn main() {
    let root = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").expect("set by cargo"));
    let mut code = String::new();
    for (table, doc, folder, extension) in TABLES {
        println!("cargo::rerun-if-changed={folder}");
        let _ = writeln!(code, "/// {doc}\npub const {table}: &[(&str, &str)] = &[");
        for path in files(&root.join(folder), extension) {
            let name = path.file_stem().expect("a file name").to_string_lossy();
            // The folder of the crate may be another one when this is compiled: a checkout that was moved.
            let text =
                format!("concat!(env!(\"CARGO_MANIFEST_DIR\"), \"/{folder}/{name}.{extension}\")");
            let _ = writeln!(code, "    ({name:?}, include_str!({text})),");
        }
        code.push_str("];\n");
    }
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("set by cargo"));
    fs::write(out.join("library.rs"), code).expect("the list of built-in files is written");
}

/// Files in a folder with the given extension, sorted by path.
fn files(folder: &Path, extension: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    let paths = entries.map(|entry| entry.expect("a folder entry").path());
    let mut files: Vec<PathBuf> = paths
        .filter(|path| path.extension().is_some_and(|e| e == extension))
        .collect();
    files.sort();
    files
}
