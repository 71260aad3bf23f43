//! The oracle is worth something only as long as it shares nothing with what it checks.

use std::fs;
use std::path::Path;

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

#[test]
fn the_manifest_names_nothing_of_the_compiler() {
    let manifest = fs::read_to_string(Path::new(ROOT).join("Cargo.toml")).unwrap();
    let dependencies: Vec<&str> = manifest
        .lines()
        .skip_while(|line| *line != "[dependencies]")
        .skip(1)
        .take_while(|line| !line.starts_with('['))
        .filter_map(|line| line.split(['.', ' ', '=']).next())
        .filter(|name| !name.is_empty() && !name.starts_with('#'))
        .collect();
    for name in &dependencies {
        let known = [
            "astro-float-num",
            "model-spec",
            "nalgebra",
            "num-dual",
            "num-traits",
            "thiserror",
        ];
        assert!(
            known.contains(name),
            "`{name}`: may the oracle depend on it?"
        );
    }
    assert!(
        dependencies.contains(&"nalgebra"),
        "the manifest was not read: {dependencies:?}"
    );
}

#[test]
fn what_it_depends_on_does_not_lead_to_the_compiler_either() {
    let manifest = fs::read_to_string(Path::new(ROOT).join("../../model-spec/Cargo.toml")).unwrap();
    for room in ["codegen", "generated", "lanes", "flight", "verify"] {
        assert!(
            !manifest.contains(&format!("{room}.workspace")),
            "model-spec leads to {room}"
        );
    }
}

#[test]
fn no_line_of_it_uses_the_compiler() {
    fn walk(folder: &Path, read: &mut usize) {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                walk(&path, read);
                continue;
            }
            *read += 1;
            for line in fs::read_to_string(&path).unwrap().lines() {
                for room in ["codegen", "generated", "lanes", "flight"] {
                    let used = line.contains(&format!("{room}::"))
                        || line.contains(&format!("use {room}"));
                    assert!(!used, "{}: {line}", path.display());
                }
            }
        }
    }
    let mut read = 0;
    walk(&Path::new(ROOT).join("src"), &mut read);
    assert!(read > 10);
}
