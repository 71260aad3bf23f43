//! Prints the generated code of a model: `cargo run -p hyzer-codegen --example emit -- disc f`.

fn main() {
    let mut arguments = std::env::args().skip(1);
    let name = arguments.next().unwrap_or_else(|| "disc".into());
    let wanted = arguments.next().unwrap_or_else(|| "f".into());
    let model = model_spec::load::load(&name, &[]).expect("a model");
    let compiled = codegen::compile(&model);
    for codegen::backend::SourceFile { path, text } in codegen::rust::emit(&compiled, &model) {
        if path.ends_with(&format!("/{wanted}.rs")) {
            println!("{text}");
        }
    }
}
