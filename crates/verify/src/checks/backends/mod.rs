//! Compares every backend with every other: the tape and the generated code, for `f64` and for the lanes of every
//! instruction set of this machine. Backends with fused multiply-add must agree bit for bit, and so must backends
//! without it; the two groups differ by rounding.

mod evaluate;

use crate::evaluation::{Inputs, results};
use crate::options::ALLOWED;
use crate::row::{Measure, Row, Verdict, Worst};
use codegen::compile::Compiled;
use codegen::program::Function;
use codegen::rust::source_hash;
pub(super) use evaluate::{Functions, Tapes};
use evaluate::{OnLanes, generated_results, on_lanes};
use lanes::Isa;
use model_spec::model::Model;
use oracle::Point;
use oracle::scalar::ErrorBound;
use std::ffi::OsStr;
use std::path::Path;

/// Name in reports of the check of bitwise agreement between backends.
pub const BACKENDS: &str = "backends";

/// Name in reports of the comparison of backends with and without fused multiply-add.
pub const FMA: &str = "FMA and non-FMA";

/// Name of the check that the running executable contains code generated from the model's current text.
pub const GENERATED: &str = "generated code";

/// Maximum difference by fused multiply-add, relative to the largest result of the function: 1e4 rounding errors.
const FMA_TOLERANCE: f64 = 1e-12;

/// Magnitude above which a fused and a separate operation may differ in whether they overflow.
const OVERFLOW: f64 = 1e300;

/// Results of one backend at a list of points.
#[derive(Clone, Debug)]
pub struct Run {
    /// Name of the backend that computed the results.
    pub backend: String,
    /// Whether the backend computes with fused multiply-add operations.
    pub fuses: bool,
    /// Concatenated results of all compiled functions, by point.
    pub results: Vec<Vec<f64>>,
}

/// Results of the function `name` among the concatenated ones; empty if there is none.
pub fn results_of<'a>(compiled: &Compiled, results: &'a [f64], name: &str) -> &'a [f64] {
    let functions = compiled.functions().into_iter();
    let before = functions.take_while(|function| function.name != name);
    let start: usize = before.map(|function| function.program.outputs.len()).sum();
    let count = compiled
        .function(name)
        .map_or(0, |function| function.program.outputs.len());
    results.get(start..start + count).unwrap_or_default()
}

/// Evaluates all functions on all backends; generated code only if it is of the current text of the model.
pub fn runs(model: &Model, compiled: &Compiled, points: &[Point<f64>]) -> Vec<Run> {
    let inputs = || points.iter().map(Inputs::of);
    let on = |name: &str, each: Vec<(Isa, Vec<Vec<f64>>)>| {
        let run = |(isa, results): (Isa, _)| Run {
            backend: format!("{name} on {}", isa.name()),
            fuses: isa.fuses(),
            results,
        };
        each.into_iter().map(run).collect::<Vec<_>>()
    };
    let tapes = Tapes::new(compiled.functions().map(|f| &f.program));
    let mut runs = vec![Run {
        backend: "tape".into(),
        fuses: false,
        results: inputs().map(|at| tapes.results(at)).collect(),
    }];
    runs.extend(on("tape", on_lanes(&tapes, points)));
    let same_text = |code: &&generated::Model| code.source_hash == source_hash(model);
    if let Some(code) = generated::model(&model.name).filter(same_text) {
        runs.push(Run {
            backend: "generated".into(),
            fuses: Isa::best().fuses(),
            results: inputs().map(|at| generated_results(code, &at)).collect(),
        });
        let each = generated::visit(code.name, OnLanes(points));
        runs.extend(on("generated", each.unwrap_or_default()));
    }
    runs
}

/// Whether the program has code generated from the current text of the model. Another text is said in a remark where the
/// file has the name of the model, as those have from which code is generated; a fitted or extended model has another.
pub fn generated_code(model: &Model) -> Row {
    let file = model.sources.first().map(|source| Path::new(&source.name));
    let is_source = || file.and_then(Path::file_stem) == Some(OsStr::new(&*model.name));
    match generated::model(&model.name) {
        _ if !model.effects.is_empty() => {
            Row::skipped(GENERATED, "the program has code without effects only")
        }
        None => Row::skipped(GENERATED, "the program has no code of this model"),
        Some(code) if code.source_hash == source_hash(model) => {
            Row::counted(GENERATED, 1, &[], "of this text")
        }
        Some(_) if !is_source() => {
            Row::skipped(GENERATED, "the program has no code of this text of the model")
        }
        Some(_) => Row::skipped(GENERATED, "STALE: it is of another text").with_remark(format!(
            "STALE: the code of `{}` in the program is of another text of the model, and was not compared with anything; \
             run `hyzer generate` and build again, or give the model another name",
            model.name
        )),
    }
}

fn first(runs: &[Run], fuses: bool) -> Option<&Run> {
    runs.iter().find(|run| run.fuses == fuses)
}

/// Compares all backends that fuse bit for bit, and all that do not.
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

/// Compares the first backends that fuse and that do not, relative to the largest result of the function; at the given
/// points of the runs, a difference may also be that of the roundings of the terms of a value, which may cancel.
pub fn check_fma(compiled: &Compiled, points: &[Point<f64>], runs: &[Run]) -> Row {
    let (Some(plain), Some(fused)) = (first(runs, false), first(runs, true)) else {
        return Row::skipped(FMA, "no backend fuses on this machine");
    };
    let mut worst = Worst::default();
    for (k, (plain, fused)) in plain.results.iter().zip(&fused.results).enumerate() {
        let bounds = points.get(k).map_or_else(Vec::new, |point| {
            results::<ErrorBound>(compiled, compiled.functions(), &point.lift())
        });
        for (f, Function { name, .. }) in compiled.functions().into_iter().enumerate() {
            let [plain, fused] = [plain, fused].map(|all| results_of(compiled, all, name));
            let sizes = plain.iter().map(|v| v.abs()).filter(|v| v.is_finite());
            let size = sizes.fold(ErrorBound::NEGLIGIBLE, f64::max);
            for (i, (&a, &b)) in plain.iter().zip(fused).enumerate() {
                let bound = bounds.get(f).and_then(|(_, values)| values.get(i));
                let size = size.max(bound.map_or(0.0, |bound| rounding(*bound)));
                worst.update(difference(a, b) / size, || (*name).to_owned());
            }
        }
    }
    Row::judged(FMA, plain.results.len(), &worst, FMA_TOLERANCE)
}

/// Magnitude of which [`FMA_TOLERANCE`] is the sum of the allowed roundings of two values with these terms.
fn rounding(bound: ErrorBound) -> f64 {
    let size = bound.magnitude * (2.0 * ALLOWED * f64::EPSILON / FMA_TOLERANCE);
    if size.is_finite() { size } else { 0.0 }
}

/// Absolute difference of two values; 0 if both overflow or nearly do.
fn difference(a: f64, b: f64) -> f64 {
    let overflows = |v: f64| v.is_nan() || v.abs() > OVERFLOW;
    if overflows(a) && overflows(b) {
        0.0
    } else {
        (a - b).abs()
    }
}

/// Name of the function of a result among the concatenated ones.
pub fn function_at(compiled: &Compiled, index: usize) -> &'static str {
    let mut end = 0;
    let found = compiled.functions().into_iter().find(|function| {
        end += function.program.outputs.len();
        index < end
    });
    found.map_or("nothing", |function| function.name)
}

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
