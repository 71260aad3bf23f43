//! Time to compile a model, fit a dataset and diagnose one: `cargo bench --bench workflow`.

use std::hint::black_box;
use std::path::Path;
use std::time::Duration;

use criterion::{Criterion, criterion_group, criterion_main};
use hyzer::{Diagnosis, Fit, Model, read_dataset};

fn compile(c: &mut Criterion) {
    let disc = model_spec::load::load("disc", &[]).expect("a built-in model");
    let mut group = c.benchmark_group("compile");
    group.bench_function("load disc", |b| b.iter(|| Model::load(black_box("disc"))));
    group.bench_function("disc to tape", |b| {
        b.iter(|| flight::CompiledModel::interpreted(black_box(&disc)));
    });
    group.finish();
}

fn identify(c: &mut Criterion) {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let mut group = c.benchmark_group("identify");
    group
        .sample_size(10)
        .measurement_time(Duration::from_secs(10));
    for name in ["disc", "ball"] {
        let dataset = read_dataset(examples.join(name)).expect("an example dataset");
        let model = Model::load(&dataset.model).expect("its model");
        group.bench_function(format!("fit {name}"), |b| {
            b.iter(|| Fit::of(&model).run(&dataset).is_ok());
        });
    }
    let dataset = read_dataset(examples.join("mystery")).expect("an example dataset");
    let model = Model::load(&dataset.model).expect("its model");
    group.bench_function("diagnose mystery", |b| {
        b.iter(|| Diagnosis::of(&model).run(&dataset).is_ok());
    });
    group.finish();
}

criterion_group!(benches, compile, identify);
criterion_main!(benches);
