//! Flies a model with its sensitivities: `cargo run -p hyzer-flight --example sensitivities -- disc 3 < point`.
//!
//! Standard input has the initial states and the parameters, standard output a row for each state after these seconds:
//! its value, then its derivatives with respect to the initial states and to the parameters.

use flight::CompiledModel;
use ode::{IntegrationOptions, Sensitivities, integrate_to_end};

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let model = model_spec::load::load(&arguments[1], &[]).expect("a model");
    let seconds = arguments[2].parse().expect("seconds");
    let compiled = CompiledModel::new(&model);
    let states = compiled.layout().states.len();
    let text = std::io::read_to_string(std::io::stdin()).expect("text");
    let words = text.split_whitespace();
    let point: Vec<f64> = words.map(|word| word.parse().expect("a number")).collect();
    let (x, p) = point.split_at(states);

    let bound = compiled.bind(p.to_vec());
    let (columns, parameters) = (states + p.len(), (0..p.len()).collect::<Vec<usize>>());
    let mut rhs = bound.rhs();
    let mut both = Sensitivities::new(&mut rhs, states, &parameters);
    let unit: Vec<_> = (0..states).map(|state| (state, state, 1.0)).collect();
    let (start, options) = (
        both.initial_state(x, &unit),
        IntegrationOptions::with_tolerance(1e-13),
    );
    let end = integrate_to_end(&mut both, (0.0, &start), seconds, &options, &mut []);
    let end = end.expect("a flight").state;
    for (k, value) in both.layout().state(end.as_ref()).iter().enumerate() {
        let row = both.layout().padded_row(end.as_ref(), k)[..columns].iter();
        let row: Vec<String> = row.map(|entry| format!("{entry:?}")).collect();
        println!("{value:?} {}", row.join(" "));
    }
}
