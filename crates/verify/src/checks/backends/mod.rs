//! Compares every backend with every other: the tape and the generated code, for `f64` and for the lanes of every
//! instruction set of this machine. Backends with fused multiply-add must agree bit for bit, and so must backends
//! without it; the two groups differ by rounding. Generated code runs on lanes as recorded programs, see `record`.

mod evaluate;
mod record;

use crate::row::{Measure, Row, Verdict, Worst};
use codegen::compile::Compiled;
use codegen::rust::source_hash;
use evaluate::{Numbers, Tapes, generated_results};
use lanes::Isa;
use model_spec::model::Model;
use oracle::Point;

/// Name in reports of the check of bitwise agreement between backends.
pub const BACKENDS: &str = "backends";

/// Name in reports of the comparison between backends with and without fused multiply-add; a backend is the generated
/// code or the bytecode interpreter.
pub const FMA: &str = "FMA and non-FMA";

/// Name of the check that the running executable contains code generated from the model's current text.
pub const GENERATED: &str = "generated code";

/// Maximum allowed difference caused by fused multiply-add, relative to the largest absolute result of the compiled
/// function. The value allows for an amplification of rounding errors by 1e4 through cancellation.
const FMA_TOLERANCE: f64 = 1e-12;

/// Results of one backend at a list of points.
#[derive(Clone, Debug)]
pub struct Run {
    /// Name of the backend that computed the results.
    pub backend: String,
    /// Whether the backend computes with fused multiply-add operations.
    pub fuses: bool,
    /// For each point, the concatenated results of all compiled functions of the model, in the order of
    /// `codegen::Compiled::functions`.
    pub results: Vec<Vec<f64>>,
}

/// Name and number of results of each compiled function, in the order in which a [`Run`] concatenates the results.
pub fn functions(compiled: &Compiled) -> Vec<(&'static str, usize)> {
    compiled
        .functions()
        .map(|f| (f.name, f.program.outputs.len()))
        .into()
}

/// Evaluates all compiled functions on all backends at the points. The generated code in the running executable is
/// included only if the hash stored with it equals that of the current text of the model.
pub fn runs(model: &Model, compiled: &Compiled, points: &[Point<f64>]) -> Vec<Run> {
    let tapes = Tapes::new(compiled.functions().map(|f| &f.program));
    let mut runs = vec![Run {
        backend: "tape".into(),
        fuses: false,
        results: points
            .iter()
            .map(|p| tapes.results(&Numbers::of(p)))
            .collect(),
    }];
    runs.extend(on_lanes("tape", &tapes, points));
    let same_text = |code: &&generated::Model| code.source_hash == source_hash(model);
    if let Some(code) = generated::model(&model.name).filter(same_text) {
        let results = points
            .iter()
            .map(|p| generated_results(code, &Numbers::of(p)));
        runs.push(Run {
            backend: "generated".into(),
            fuses: Isa::best().fuses(),
            results: results.collect(),
        });
        if let Some(programs) = record::programs(code.name) {
            runs.extend(on_lanes("generated", &Tapes::new(&programs), points));
        }
    }
    runs
}

/// Checks whether the running executable contains code generated from the model's current text. The check is skipped if
/// the executable contains no code of this model or the model has effects. It is skipped with a remark if the code was
/// generated from another text of the model.
pub fn generated_code(model: &Model) -> Row {
    match generated::model(&model.name) {
        _ if !model.effects.is_empty() => {
            Row::skipped(GENERATED, "the program has code without effects only")
        }
        None => Row::skipped(GENERATED, "the program has no code of this model"),
        Some(code) if code.source_hash == source_hash(model) => {
            Row::counted(GENERATED, 1, &[], "of this text")
        }
        Some(_) => Row::skipped(GENERATED, "STALE: it is of another text").with_remark(format!(
            "STALE: the code of `{}` in the program is of another text of the model, and was not compared with anything; \
             run `hyzer generate` and build again, or give the model another name",
            model.name
        )),
    }
}

fn on_lanes(name: &str, tapes: &Tapes, points: &[Point<f64>]) -> Vec<Run> {
    let run = |isa: Isa| {
        Some(Run {
            backend: format!("{name} on {}", isa.name()),
            fuses: isa.fuses(),
            results: tapes.on_lanes(isa, points)?,
        })
    };
    Isa::ALL.into_iter().filter_map(run).collect()
}

/// Results of the first backend that fuses multiply and add (`fuses` true) or does not (`fuses` false); `None` if
/// `runs` contains no such backend.
fn first(runs: &[Run], fuses: bool) -> Option<&Run> {
    runs.iter().find(|run| run.fuses == fuses)
}

/// Checks for bitwise agreement of the backends: the results of all backends that fuse multiply and add must be equal,
/// and those of all backends that do not fuse must be equal.
pub fn check(compiled: &Compiled, runs: &[Run]) -> Row {
    let mut worst = Worst::default();
    for run in runs {
        let Some(first) = first(runs, run.fuses) else {
            continue;
        };
        for (expected, got) in first.results.iter().zip(&run.results) {
            for (index, (a, b)) in expected.iter().zip(got).enumerate() {
                worst.update(ulps(*a, *b), || {
                    format!("{} in {}", function_at(compiled, index), run.backend)
                });
            }
            if expected.len() != got.len() {
                worst.update(f64::INFINITY, || {
                    format!("another number of results in {}", run.backend)
                });
            }
        }
    }
    let names: Vec<&str> = runs.iter().map(|run| run.backend.as_str()).collect();
    let cases = runs.iter().map(|run| run.results.len()).sum();
    let row = Row {
        measure: Measure::Ulp,
        ..Row::judged(BACKENDS, cases, &worst, 0.0)
    };
    if row.verdict == Verdict::Holds {
        row.with_detail(names.join(", "))
    } else {
        row
    }
}

/// Compares the results of the first backend that fuses multiply and add with those of the first backend that does not.
/// Errors are relative to the largest absolute result of the same compiled function at the same point.
pub fn check_fma(compiled: &Compiled, runs: &[Run]) -> Row {
    let (Some(plain), Some(fused)) = (first(runs, false), first(runs, true)) else {
        return Row::skipped(FMA, "no backend fuses on this machine");
    };
    let mut worst = Worst::default();
    for (plain, fused) in plain.results.iter().zip(&fused.results) {
        let mut start = 0;
        for (function, len) in functions(compiled) {
            let range = start..start + len;
            start += len;
            let size = plain[range.clone()]
                .iter()
                .fold(f64::MIN_POSITIVE, |most, v| most.max(v.abs()));
            for (a, b) in plain[range.clone()].iter().zip(&fused[range]) {
                worst.update((a - b).abs() / size, || function.to_string());
            }
        }
    }
    Row::judged(FMA, plain.results.len(), &worst, FMA_TOLERANCE)
}

/// Name of the compiled function to which the result with the given index belongs; the index counts the concatenated
/// results of all functions.
pub fn function_at(compiled: &Compiled, index: usize) -> &'static str {
    let mut end = 0;
    let found = functions(compiled).into_iter().find(|(_, len)| {
        end += len;
        index < end
    });
    found.map_or("nothing", |(name, _)| name)
}

/// Distance of two values in units in the last place; 0 if both are NaN, infinite if only one is NaN.
fn ulps(a: f64, b: f64) -> f64 {
    if a == b || (a.is_nan() && b.is_nan()) {
        return 0.0;
    }
    // Maps floating-point values to integers in the same order, negative values included.
    let place = |v: f64| {
        let bits = v.to_bits() as i64;
        if bits < 0 {
            i64::MIN.wrapping_sub(bits)
        } else {
            bits
        }
    };
    if a.is_nan() || b.is_nan() {
        f64::INFINITY
    } else {
        place(a).abs_diff(place(b)) as f64
    }
}
