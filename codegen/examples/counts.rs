//! Prints the operation counts of every function of a model, and the compile time: `cargo run --release -p
//! hyzer-codegen --example counts -- disc ball`.

use std::time::Instant;

fn main() {
    for name in std::env::args().skip(1) {
        let model = match model_spec::load::load(&name, &[]) {
            Ok(model) => model,
            Err(faults) => {
                eprintln!("{name}: {faults:?}");
                continue;
            }
        };
        let start = Instant::now();
        let compiled = codegen::compile(&model);
        let took = start.elapsed();
        println!(
            "{name}: compiled in {took:.1?}, {} constants prepared",
            compiled.prepared.len()
        );
        for function in compiled.functions() {
            println!(
                "  {:12} {}",
                function.name,
                codegen::count::count(&function.program)
            );
        }
    }
}
