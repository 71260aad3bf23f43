//! The gradient of the sum of squares against differences of it, for every choice of states and every loss.

use dataset::synthesize::{Corruption, corrupt};
use dataset::{Dataset, KnownValue};
use identify::Observations;
use identify::{
    AxesNoise, FitOptions, FitProblem, FlightAt, Loss, NoiseModel, Unknowns, initial_guesses,
};
use nalgebra::DVector;
use studies::oracle_flights::{Plan, TWELVE, disc, flights};

fn dataset() -> Dataset {
    let plan = Plan {
        flights: 1,
        duration: (0.2, 0.2),
        ..TWELVE
    };
    let mut dataset = flights(&disc(), &plan, 2);
    let noise = Corruption {
        dropouts: 0.1,
        ..Corruption::default()
    };
    corrupt(&mut dataset.flights[0].positions, &noise, 1);
    dataset
}

fn check(model: &str, dataset: &Dataset, free: &[String], loss: Loss<'_>) {
    let model = model_spec::load::load(model, &[]).expect("a model");
    let options = FitOptions {
        free,
        ..FitOptions::default()
    };
    let problem = FitProblem::new(&model, dataset, &options).expect("a setting");
    let observations = Observations::new(&problem, &dataset.flights[0]).expect("a track");
    let global = problem
        .globals
        .iter()
        .map(|global| 1.1 * global.model_value + 1e-3 * global.x_scale);
    let global = DVector::from_iterator(problem.globals.len(), global);
    let local = initial_guesses(&problem, &observations)
        .expect("a start")
        .remove(0)
        .state;
    let at = |global: &DVector<f64>, local: &DVector<f64>| {
        let at = FlightAt::new(&problem, &observations, (global, local));
        at.linearise(Unknowns::All, loss).expect("a flight")
    };
    let block = at(&global, &local);
    let half = |global: &DVector<f64>, local: &DVector<f64>| at(global, local).squares / 2.0;
    let close = |name: &str, found: f64, size: f64, differences: f64, step: f64| {
        // What the gradient is made of, residual by residual, and what differences lose by the integration.
        let scale = (size * block.squares).sqrt() + 1e-3 * block.squares / step.max(1e-6);
        assert!(
            (found - differences).abs() < 3e-4 * scale,
            "{name}: {found} against {differences} of {scale}"
        );
    };
    for direction in 0..observations.manifold.dimension() {
        let h = 1e-3 / (1.0 + block.local[(direction, direction)].sqrt() * 1e-3);
        let mut step = DVector::zeros(observations.manifold.dimension());
        step[direction] = h;
        let ahead = half(&global, &observations.manifold.plus(&local, &step));
        let behind = half(&global, &observations.manifold.plus(&local, &-step));
        let differences = (ahead - behind) / (2.0 * h);
        close(
            &format!("direction {direction}"),
            block.local_gradient[direction],
            block.local[(direction, direction)],
            differences,
            h,
        );
    }
    for (index, unknown) in problem.globals.iter().enumerate() {
        let h = 1e-3 * unknown.x_scale;
        let mut step = DVector::zeros(problem.globals.len());
        step[index] = h;
        let differences =
            (half(&(&global + &step), &local) - half(&(&global - &step), &local)) / (2.0 * h);
        close(
            &unknown.name,
            block.global_gradient[index],
            block.global[(index, index)],
            differences,
            h / unknown.x_scale,
        );
    }
    // Each flight has unknowns that no other has: none of them may be without effect.
    assert!(block.local.diagonal().iter().all(|value| *value > 0.0));
}

#[test]
fn gradients_are_those_of_the_squares() {
    let correlated = NoiseModel::from(AxesNoise {
        sigma: [0.001, 0.002, 0.003],
        ar1: [0.5, 0.0, -0.3],
        interval: 1.0 / 120.0,
    });
    let data = dataset();
    check("disc", &data, &[], Loss::Whitened(&correlated));
    check(
        "disc",
        &data,
        &["wind_x".to_owned(), "I_a".to_owned()],
        Loss::Whitened(&correlated),
    );
    check("disc", &data, &[], Loss::Huber(0.004));
    check("disc_quaternion", &data, &[], Loss::Whitened(&correlated));
}

#[test]
fn gradients_hold_where_states_are_known() {
    let mut data = dataset();
    data.flights[0]
        .known
        .insert("x".into(), KnownValue::Scalar(0.01));
    data.flights[0]
        .known
        .insert("thetadot".into(), KnownValue::Scalar(0.2));
    check(
        "disc",
        &data,
        &[],
        Loss::Whitened(&NoiseModel::white(0.0015, 1.0 / 120.0)),
    );
}
