//! Every function of the language is in the model that all backends are tested with, and in the language's page.

use model_spec::model::Function;

#[test]
fn the_zoo_and_the_page_of_the_language_have_every_function() {
    let folder = env!("CARGO_MANIFEST_DIR");
    let read = |path: &str| {
        std::fs::read_to_string(format!("{folder}/{path}")).expect("a file of the repository")
    };
    let (zoo, page) = (
        read("tests/integration/zoo/zoo.hyz"),
        read("../docs/reference/language.md"),
    );
    let rows: Vec<&str> = page
        .lines()
        .filter(|line| line.starts_with("| `"))
        .collect();
    for (name, _) in Function::NAMES {
        assert!(
            zoo.contains(&format!("{name}(")),
            "codegen/tests/integration/zoo/zoo.hyz lacks {name}"
        );
        let is_name = |word: &str| word == name;
        let is_listed = |row: &&str| row.split(|c: char| !c.is_alphanumeric()).any(is_name);
        assert!(
            rows.iter().any(is_listed),
            "docs/reference/language.md lacks {name}"
        );
    }
}
