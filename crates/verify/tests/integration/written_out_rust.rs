//! Random models as Rust text, with functions, arrays and sums and written out by hand: what `rustc` makes of both computes
//! the same, and what the tape computes. The models are those of `written_out`.

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::written_out::{FUNCTIONS, MAX_ULP, POINTS, Texts, farthest, loaded};
use codegen::Compiled;
use oracle::Point;
use verify::checks::backends::{results_of, runs};
use verify::random::Random;
use verify::sample;

/// Models that one run of `rustc` compiles, each in both forms.
const BATCH: usize = 50;

/// Greatest distance from the tape, in units in the last place: its functions are not those of the standard library, and what
/// cancels multiplies their last places.
const MAX_ULP_OF_TAPE: f64 = 1e-12 / f64::EPSILON;

/// A form of a model: its results by the tape, at each point those of [`FUNCTIONS`].
struct Form {
    text: String,
    tape: Vec<Vec<f64>>,
}

const PRINT: &str = "fn print(parts: &[&[f64]]) {
    let bits: Vec<String> = parts.iter().flat_map(|part| part.iter().map(|v| v.to_bits().to_string())).collect();
    println!(\"{}\", bits.join(\" \"));
}\n";

/// Text of a function that prints the results of a generated module at some points, a line for each of [`FUNCTIONS`].
fn printer(module: &str, points: &[Point<f64>]) -> String {
    let inputs = points.iter().map(|at| {
        let (x, p) = (&at.states, at.parameters());
        format!("({:?}, {x:?}, {p:?}),", at.time)
    });
    let inputs: String = inputs.collect();
    format!(
        "fn {module}() {{
    use {module} as m;
    for (t, x, p) in [{inputs}] {{
        let (mut k, mut dx) = ([0.0; m::PREPARED.len()], [0.0; m::STATES.len()]);
        let (mut j, mut jp) = ([0.0; m::J_PATTERN.len()], [0.0; m::JP_PATTERN.len()]);
        m::prepare(&p, &mut k);
        m::f(t, &x, &p, &k, &mut dx);
        print(&[&dx]);
        m::f_jac(t, &x, &p, &k, &mut dx, &mut j);
        print(&[&dx, &j]);
        m::f_jac_par(t, &x, &p, &k, &mut dx, &mut j, &mut jp);
        print(&[&dx, &j, &jp]);
    }}
}}\n"
    )
}

fn by_tape(compiled: &Compiled, all: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let of_point = |results| FUNCTIONS.map(|name| results_of(compiled, results, name).to_vec());
    all.iter().flat_map(|results| of_point(results)).collect()
}

/// What `rustc` and the program that it makes print.
fn output(command: &mut Command) -> String {
    let done = command.output().expect("it runs");
    let said = String::from_utf8_lossy(&done.stderr);
    assert!(done.status.success(), "{said}");
    String::from_utf8(done.stdout).expect("text")
}

/// Writes a crate of some random models; returns their forms.
fn written(folder: &Path, random: &mut Random, count: usize) -> Vec<[Form; 2]> {
    let (mut program, mut calls) = (PRINT.to_owned(), String::new());
    let rust = codegen::backend("rust").expect("a backend");
    let mut models: Vec<[Form; 2]> = Vec::new();
    while models.len() < count {
        let Some(Texts { short, by_hand }) = Texts::drawn(random).compared() else {
            continue;
        };
        let (model, _) = loaded(&short);
        let points: Vec<_> = (0..POINTS).map(|_| sample::point(&model, random)).collect();
        let number = models.len();
        models.push([("short", short), ("hand", by_hand)].map(|(form, text)| {
            let (model, compiled) = loaded(&text);
            let module = format!("model_{number}_{form}");
            let files = rust.emit(&model, &compiled);
            let [file] = &files[..] else {
                panic!("one file")
            };
            std::fs::write(folder.join(format!("{module}.rs")), &file.text).expect("written");
            let _ = writeln!(program, "mod {module};\n{}", printer(&module, &points));
            let _ = writeln!(calls, "    {module}();");
            let runs = runs(&model, &compiled, &points);
            let tape = runs.iter().find(|run| !run.fuses).expect("the tape");
            Form {
                text,
                tape: by_tape(&compiled, &tape.results),
            }
        }));
    }
    let _ = writeln!(program, "fn main() {{\n{calls}}}");
    std::fs::write(folder.join("main.rs"), program).expect("written");
    models
}

/// Compares a number of random models; returns the greatest distances from the form by hand, and from the tape.
fn compared(folder: &str, random: &mut Random, count: usize) -> [f64; 2] {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(folder);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("a folder");
    let models = written(&folder, random, count);
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let options = [
        "--edition",
        "2024",
        "-C",
        "opt-level=0",
        "main.rs",
        "-o",
        "main",
    ];
    output(Command::new(rustc).args(options).current_dir(&folder));
    let printed = output(&mut Command::new(folder.join("main")));
    let number = |bits: &str| f64::from_bits(bits.parse().expect("bits"));
    let mut lines = printed.lines();
    let mut most = [0.0_f64; 2];
    for forms in &models {
        let both = forms.each_ref().map(|form| -> Vec<Vec<f64>> {
            let lines = lines.by_ref().take(form.tape.len());
            lines
                .map(|line| line.split(' ').map(number).collect())
                .collect()
        });
        let [short, hand] = &both;
        let texts = || format!("{}\n{}", forms[0].text, forms[1].text);
        let by_tape = forms.iter().zip(&both);
        let by_tape =
            by_tape.flat_map(|(form, rust)| form.tape.iter().zip(rust).map(|pair| (1, pair)));
        let by_hand = short.iter().zip(hand).map(|pair| (0, pair));
        for (kind, (a, b)) in by_hand.chain(by_tape) {
            assert_eq!(a.len(), b.len(), "{}", texts());
            let (apart, at) = farthest(a, b);
            assert!(
                apart <= [MAX_ULP, MAX_ULP_OF_TAPE][kind],
                "{kind}, {at}: {a:?}\n{b:?}, {apart} ulp\n{}",
                texts()
            );
            most[kind] = most[kind].max(apart);
        }
    }
    assert_eq!(lines.next(), None);
    most
}

#[test]
fn random_models_as_rust_are_what_is_written_out_by_hand() {
    compared("few_models", &mut Random::new(46, "few"), 10);
}

#[test]
#[ignore = "a thousand models, compiled by rustc: minutes"]
fn a_thousand_random_models_as_rust_are_what_is_written_out_by_hand() {
    let mut random = Random::new(46, "many");
    for batch in 0..1000 / BATCH {
        let [hand, tape] = compared("many_models", &mut random, BATCH);
        println!(
            "models {} to {}: {hand} ulp from those by hand, {tape} ulp from the tape",
            batch * BATCH + 1,
            (batch + 1) * BATCH
        );
    }
}
