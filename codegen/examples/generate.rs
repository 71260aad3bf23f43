//! Writes `crates/generated/src` of this repository: `cargo run -p hyzer-codegen --example generate`. The corresponding
//! command of the program is `hyzer generate`.

use std::path::Path;

fn main() {
    let models: Vec<_> = model_spec::load::MODELS
        .iter()
        .map(|(name, _)| {
            model_spec::load::load(name, &[]).unwrap_or_else(|error| panic!("{error}"))
        })
        .collect();
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("../crates/generated/src");
    for path in codegen::generate::write(&source, &models).expect("a writable folder") {
        println!("{path}");
    }
}
