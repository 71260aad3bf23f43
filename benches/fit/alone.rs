//! The least squares alone, kept running: for benches/fit, which has the peers solve the same problem in turn.
//!
//! `cargo run --release --example fit_alone -- DATASET [THREADS]` fits the dataset once and prints the model's coefficients and
//! the starts of each flight at each of its samples, by the markers alone. The first line that it reads says where to begin
//! and how large the noise is; for each further line it solves once from there. All lines are JSON.

use std::collections::BTreeMap;
use std::io::{BufRead, Write, stdin, stdout};
use std::path::Path;
use std::time::Instant;

use dataset::load;
use identify::{Fit, FitOptions, NoiseModel, Observations, fit, initial_guesses};
use nalgebra::DVector;
use serde_json::{Value, json};

type Failure = Box<dyn std::error::Error>;
type Values = BTreeMap<String, f64>;

fn main() -> Result<(), Failure> {
    let mut arguments = std::env::args().skip(1);
    let folder = arguments.next().ok_or("which dataset?")?;
    let threads = arguments.next().map(|text| text.parse()).transpose()?;
    let options = FitOptions {
        threads,
        ..FitOptions::default()
    };
    let dataset = load(Path::new(&folder))?;
    let model = model_spec::load::load(&dataset.model, &[])?;
    let fitted = fit(&model, &dataset, &options)?;
    let observation_sets: Vec<&Observations> = (0..dataset.flights.len())
        .filter_map(|flight| Some(fitted.flight(identify::FlightId::new(flight))?.0))
        .collect();
    let each = observation_sets
        .iter()
        .map(|observations| from_markers(&fitted, observations));
    let global = &fitted.problem().globals;
    let model_values: Values = global
        .iter()
        .map(|global| (global.name.clone(), global.model_value))
        .collect();
    say(&json!({"coefficients": model_values, "starts": each.collect::<Vec<_>>()}))?;

    let mut lines = stdin().lock().lines();
    let begin: Value = serde_json::from_str(&lines.next().ok_or("where to begin?")??)?;
    let states = &fitted.problem().body.layout().states;
    let names: Vec<&String> = global.iter().map(|global| &global.name).collect();
    let from = vector(&begin["coefficients"], &names)?;
    let states: Vec<&String> = states.iter().collect();
    let local = begin["initial"].as_array().ok_or("no initial states")?;
    let local: Vec<DVector<f64>> = local
        .iter()
        .map(|flight| vector(flight, &states))
        .collect::<Result<_, _>>()?;
    let sigma = begin["sigma"].as_f64().ok_or("no noise")?;
    let noise = NoiseModel::white(sigma, fitted.noise().interval);
    for line in lines {
        line?;
        let clock = Instant::now();
        let found = fitted.warm_start(&from, &local, &noise, &options)?;
        let seconds = clock.elapsed().as_secs_f64();
        let named = names.iter().zip(found.iterate.global.iter());
        let values: Values = named
            .map(|(name, &value)| ((*name).clone(), value))
            .collect();
        let (steps, converged) = (found.iterations, found.converged());
        say(
            &json!({"seconds": seconds, "steps": steps, "converged": converged, "coefficients": values}),
        )?;
    }
    Ok(())
}

/// The state at each sample by the markers from there on; null where too few follow.
fn from_markers(fitted: &Fit, observations: &Observations) -> Vec<Value> {
    let problem = fitted.problem();
    let states = &problem.body.layout().states;
    let of_tail = |first: usize| {
        let mut tail = observations.clone();
        tail.times.drain(..first);
        tail.measured.drain(..first * observations.markers);
        tail.outlier.drain(..first * observations.markers);
        let begun = tail.times[0];
        tail.times.iter_mut().for_each(|time| *time -= begun);
        let start = initial_guesses(problem, &tail).ok()?.swap_remove(0);
        Some(
            states
                .iter()
                .cloned()
                .zip(start.state.iter().copied())
                .collect::<Values>(),
        )
    };
    (0..observations.times.len())
        .map(|first| json!(of_tail(first)))
        .collect()
}

fn vector(values: &Value, names: &[&String]) -> Result<DVector<f64>, Failure> {
    let each = names.iter().map(|name| {
        let value = values[name.as_str()].as_f64();
        value.ok_or_else(|| format!("no {name}"))
    });
    Ok(DVector::from_vec(each.collect::<Result<_, _>>()?))
}

fn say(value: &Value) -> std::io::Result<()> {
    let mut out = stdout().lock();
    writeln!(out, "{value}")?;
    out.flush()
}
