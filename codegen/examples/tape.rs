//! Evaluates a model by the tape: `cargo run -p hyzer-codegen --example tape -- disc wind < points`.
//!
//! Each line of standard input is a point: time, states, parameters and, if the model has a marker, its coordinates.
//! Each line of standard output has the outputs of `f_jac_par`, `observe_jac`, `quantities` and `limits` at that point.

use codegen::tape_model::{At, Scratch, TapeFunction, TapeModel};

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let with: Vec<&str> = arguments[1..].iter().map(String::as_str).collect();
    let model = model_spec::load::load(&arguments[0], &with).expect("a model");
    let tape = TapeModel::new(&codegen::compile(&model));
    for line in std::io::stdin().lines() {
        let line = line.expect("text");
        let words = line.split_whitespace();
        let point: Vec<f64> = words.map(|word| word.parse().expect("a number")).collect();
        let values = evaluated(&tape, &point);
        let values: Vec<String> = values.iter().map(|value| format!("{value:?}")).collect();
        println!("{}", values.join(" "));
    }
}

fn evaluated(tape: &TapeModel, point: &[f64]) -> Vec<f64> {
    let (x, rest) = point[1..].split_at(tape.states);
    let (p, marker) = rest.split_at(tape.parameters);
    let (t, prepared) = (point[0], &tape.prepare(p)[..]);
    let at = At { t, x, p, prepared };
    let scratch = &mut Scratch::default();
    let [mut dx, mut j, mut jp] = arrays(&tape.f_jac_par);
    tape.f_jac_par
        .eval(at, &[], scratch, &mut [&mut dx, &mut j, &mut jp]);
    let mut observed: [Vec<f64>; 4] = arrays(&tape.observe_jac);
    let mut slices = observed.each_mut().map(Vec::as_mut_slice);
    tape.observe_jac.eval(at, marker, scratch, &mut slices);
    let ([mut q], [mut l]) = (arrays(&tape.quantities), arrays(&tape.limits));
    tape.quantities.eval(at, &[], scratch, &mut [&mut q]);
    tape.limits.eval(at, &[], scratch, &mut [&mut l]);
    [dx, j, jp, observed.concat(), q, l].concat()
}

fn arrays<const N: usize>(function: &TapeFunction) -> [Vec<f64>; N] {
    let lens = function.lens();
    std::array::from_fn(|k| vec![0.0; lens[k]])
}
