//! Generated modules compile alone, without warnings, and give the values of the tape.

use codegen::build::Config;
use codegen::tape_model::{At, Scratch};
use codegen::{TapeModel, compile};
use model_spec::load;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Maximum allowed difference between a result of the generated code and of the bytecode, relative to the largest
/// result of the function. It allows for different rounding of the elementary functions of the standard library and of
/// the crate `lanes`.
const TOLERANCE: f64 = 1e-12;

/// Number of test points (sets of states and parameters) at which the functions of each model are evaluated.
const POINTS: usize = 5;

/// Text of a test model whose names are keywords of Rust, or names that generated code also uses.
const CLASHING: &str = "\
model yield;
param match = 1.5;
param sqrt_or_zero = 2;
param Self = 0.5;
param break = 2 s;
coefficient type = 0.7;
coefficient STATES = 0.3;
state fn = 0.3;
state dx = -0.4;
state PI = 0.7;
state T = 0.2;
state f64 = 0.1;
frame N;
let recip_or_zero = sqrt(match + fn^2);
let struct = ratio(type, recip_or_zero, 1);
let std = (fn, dx, PI) in N;
let J_PATTERN = norm(std);
der(fn) = (-match*dx + pi*struct)/break;
der(dx) = (sin(sqrt_or_zero)*fn*exp(Self) - J_PATTERN)/break;
der(PI) = (STATES*PI + sin(T)*cos(T) + min(f64, T))/break;
der(T) = (log(match + T^2) + asin(f64/2)*asin(T) + step(f64)*T)/break;
der(f64) = (sin(atan2(T, PI)) + sign(T)*max(T, f64))/break;
";

struct Case {
    /// Name of a built-in model or path of a model file, as passed to the code generator.
    source: String,
    /// Name of the generated file, without extension, and of its module in the test program.
    stem: &'static str,
}

fn cases(folder: &Path) -> Vec<Case> {
    let zoo = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/integration/zoo/zoo.hyz");
    let clashing = folder.join("yield.hyz");
    std::fs::write(&clashing, CLASHING).unwrap();
    let path = |path: &Path| path.to_str().unwrap().to_string();
    let built_in = ["ball", "disc", "disc_quaternion", "discus"].map(|name| Case {
        source: name.to_string(),
        stem: name,
    });
    let files = [(path(&zoo), "zoo"), (path(&clashing), "yield")];
    let files = files.map(|(source, stem)| Case { source, stem });
    built_in.into_iter().chain(files).collect()
}

/// States and parameters of the test point number `k`. They differ by up to 10 % from the model's defaults; in place of
/// a default of 0, they are between 0.1 and 0.7.
fn point(layout: &codegen::Layout, k: usize) -> (Vec<f64>, Vec<f64>) {
    let vary = |value: f64, n: usize| {
        let wave = ((7 * n + 3 * k) as f64).sin();
        if value == 0.0 {
            0.3 * wave + 0.4
        } else {
            value * (1.0 + 0.1 * wave)
        }
    };
    let each = |values: &[f64]| {
        values
            .iter()
            .enumerate()
            .map(|(n, &v)| vary(v, n))
            .collect()
    };
    (each(&layout.initial), each(&layout.defaults))
}

const MARKER: [f64; 3] = [0.1, -0.02, 0.01];

/// Results of all functions of a model for the states `x` and parameters `p`, computed by its bytecode: one list per
/// function.
fn by_tape(tape: &TapeModel, x: &[f64], p: &[f64]) -> Vec<Vec<f64>> {
    let prepared = tape.prepare(p);
    let at = At {
        t: 0.2,
        x,
        p,
        prepared: &prepared,
    };
    let mut scratch = Scratch::default();
    let buffers =
        |lens: Vec<usize>| -> Vec<Vec<f64>> { lens.iter().map(|&n| vec![0.0; n]).collect() };
    let mut all = vec![prepared.clone()];
    let mut jac = buffers(tape.f_jac_par.lens());
    let [dx, j, jp] = jac.as_mut_slice() else {
        panic!("three sections")
    };
    tape.f_jac_par.eval(at, &[], &mut scratch, &mut [dx, j, jp]);
    all.push(jac.concat());
    let mut observed = buffers(tape.observe_jac.lens());
    let [y, dy_dx, dy_dp, dy_dmarker] = observed.as_mut_slice() else {
        panic!("four sections")
    };
    tape.observe_jac.eval(
        at,
        &MARKER,
        &mut scratch,
        &mut [y, dy_dx, dy_dp, dy_dmarker],
    );
    all.push(observed.concat());
    let mut values = buffers(tape.quantities.lens()).concat();
    tape.quantities
        .eval(at, &[], &mut scratch, &mut [&mut values]);
    all.push(values);
    let mut margins = buffers(tape.limits.lens()).concat();
    tape.limits.eval(at, &[], &mut scratch, &mut [&mut margins]);
    all.push(margins);
    all
}

/// Source text of a function of the test program. The function prints all results of a generated module for the states
/// `x` and parameters `p`, one line per function of the module. `observed` is the number of components of the
/// observation, and `k` the number of the test point.
fn printer(module: &str, observed: usize, k: usize, x: &[f64], p: &[f64]) -> String {
    let marker = &MARKER[..if observed == 0 { 0 } else { 3 }];
    format!(
        "fn {module}_{k}() {{
    use r#{module} as m;
    let (t, x, p, marker) = (0.2, &{x:?}, &{p:?}, &{marker:?} as &[f64; {}]);
    let mut k = [0.0; m::PREPARED.len()];
    m::prepare(p, &mut k);
    print(&[&k]);
    let (mut dx, mut j) = ([0.0; m::STATES.len()], [0.0; m::J_PATTERN.len()]);
    let mut jp = [0.0; m::JP_PATTERN.len()];
    m::f_jac_par(t, x, p, &k, &mut dx, &mut j, &mut jp);
    print(&[&dx, &j, &jp]);
    let mut y = [0.0; {observed}];
    let (mut yx, mut yp) = ([0.0; m::DY_DX_PATTERN.len()], [0.0; m::DY_DP_PATTERN.len()]);
    let mut ym = [0.0; m::DY_DMARKER_PATTERN.len()];
    m::observe_jac(t, x, p, &k, marker, &mut y, &mut yx, &mut yp, &mut ym);
    print(&[&y, &yx, &yp, &ym]);
    let mut q = [0.0; m::QUANTITIES.len()];
    m::quantities(t, x, p, &k, &mut q);
    print(&[&q]);
    let mut l = [0.0; m::LIMITS.len()];
    m::limits(t, x, p, &k, &mut l);
    print(&[&l]);
}}\n",
        marker.len()
    )
}

const PRINT: &str = "fn print(parts: &[&[f64]]) {
    let bits: Vec<String> = parts.iter().flat_map(|part| part.iter().map(|v| v.to_bits().to_string())).collect();
    println!(\"{}\", bits.join(\" \"));
}\n";

fn rustc(arguments: &[&str], folder: &Path) {
    let done = Command::new(std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into()))
        .args(["--edition", "2024"])
        .args(arguments)
        .current_dir(folder)
        .output()
        .expect("rustc runs");
    assert!(
        done.status.success(),
        "{}",
        String::from_utf8_lossy(&done.stderr)
    );
}

#[test]
fn plain_modules_agree_with_the_tape() {
    let folder = tempfile::tempdir().unwrap();
    let cases = cases(folder.path());
    let mut config = Config::new();
    let mut program = String::from("#![deny(warnings)]\n");
    let (mut printers, mut calls) = (String::from(PRINT), String::new());
    let mut expected: Vec<(&str, Vec<f64>)> = Vec::new();
    for (index, Case { source, stem }) in cases.iter().enumerate() {
        config.model(source);
        // Both ways of use: as a file of a module and by `include!`.
        match index % 2 {
            0 => writeln!(program, "mod r#{stem};").unwrap(),
            _ => writeln!(program, "mod r#{stem} {{ include!(\"{stem}.rs\"); }}").unwrap(),
        }
        let compiled = compile(&load::load(source, &[]).unwrap_or_else(|e| panic!("{e}")));
        let tape = TapeModel::new(&compiled);
        for k in 0..POINTS {
            let (x, p) = point(&compiled.layout, k);
            expected.extend(
                by_tape(&tape, &x, &p)
                    .into_iter()
                    .map(|results| (*stem, results)),
            );
            let observed = compiled.observe.range("y").len();
            printers += &printer(stem, observed, k, &x, &p);
            writeln!(calls, "    {stem}_{k}();").unwrap();
        }
    }
    let paths = config.out_dir(folder.path()).compile().unwrap();
    assert_eq!(paths.len(), cases.len());
    program += &format!("{printers}fn main() {{\n{calls}}}\n");
    std::fs::write(folder.path().join("main.rs"), program).unwrap();
    rustc(
        &["-C", "opt-level=1", "main.rs", "-o", "main"],
        folder.path(),
    );
    let done = Command::new(folder.path().join("main"))
        .output()
        .expect("runs");
    assert!(done.status.success());
    let printed = String::from_utf8(done.stdout).unwrap();
    let found: Vec<Vec<f64>> = printed
        .lines()
        .map(|line| {
            line.split_whitespace()
                .map(|bits| f64::from_bits(bits.parse().unwrap()))
                .collect()
        })
        .collect();
    assert_eq!(found.len(), expected.len());
    for ((stem, expected), found) in expected.iter().zip(&found) {
        assert_eq!(expected.len(), found.len(), "{stem}");
        let largest = expected
            .iter()
            .fold(f64::MIN_POSITIVE, |m, v| m.max(v.abs()));
        for (a, b) in expected.iter().zip(found) {
            assert!(
                a.is_finite() && (a - b).abs() <= TOLERANCE * largest,
                "{stem}: {a} {b}"
            );
        }
    }
}

#[test]
fn modules_over_lanes_compile() {
    let folder = tempfile::tempdir().unwrap();
    let lanes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../crates/lanes/src/lib.rs");
    let mut config = Config::new();
    let mut library = String::from("#![deny(warnings)]\n");
    for Case { source, stem } in cases(folder.path()) {
        config.model(source);
        writeln!(library, "pub mod r#{stem};").unwrap();
    }
    let written: Vec<PathBuf> = config.lanes(true).out_dir(folder.path()).compile().unwrap();
    assert!(written.iter().all(|path| path.is_file()));
    std::fs::write(folder.path().join("lib.rs"), library).unwrap();
    let lanes = lanes.to_str().unwrap();
    rustc(
        &["--crate-type", "rlib", "--crate-name", "lanes", lanes],
        folder.path(),
    );
    let arguments = [
        "--crate-type",
        "rlib",
        "--emit",
        "metadata",
        "--extern",
        "lanes=liblanes.rlib",
    ];
    rustc(
        &[&arguments[..], &["lib.rs", "-o", "lib.rmeta"]].concat(),
        folder.path(),
    );
}
