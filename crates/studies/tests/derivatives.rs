//! The gradient of the sum of squares against differences of it, for every choice of states and every loss.

use identify::dataset::{Dataset, Known};
use identify::noise::Noise;
use identify::options::Options;
use identify::predict::{By, Loss, linearise};
use identify::setting::Setting;
use identify::start;
use identify::synthesize::{Noise as Made, corrupt};
use identify::track::Track;
use nalgebra::DVector;
use studies::identification::coverage::TWELVE;
use studies::oracle_flights::dataset::{Plan, disc, flights};

fn dataset() -> Dataset {
    let plan = Plan {
        flights: 1,
        duration: (0.2, 0.2),
        ..TWELVE
    };
    let mut dataset = flights(&disc(), &plan, 2);
    let noise = Made {
        dropouts: 0.1,
        ..Made::default()
    };
    corrupt(&mut dataset.flights[0].positions, &noise, 1);
    dataset
}

fn check(model: &str, dataset: &Dataset, free: &[String], loss: Loss<'_>) {
    let model = model_spec::load::load(model, &[]).expect("a model");
    let options = Options {
        free,
        ..Options::default()
    };
    let setting = Setting::new(&model, dataset, &options).expect("a setting");
    let track = Track::new(&setting, &dataset.flights[0]).expect("a track");
    let shared = setting
        .shared
        .iter()
        .map(|shared| 1.1 * shared.model_value + 1e-3 * shared.usual);
    let shared = DVector::from_iterator(setting.shared.len(), shared);
    let own = start::starts(&setting, &track)
        .expect("a start")
        .remove(0)
        .state;
    let samples = track.times.len();
    let at = |shared: &DVector<f64>, own: &DVector<f64>| {
        linearise(&setting, &track, (shared, own), samples, By::All, loss).expect("a flight")
    };
    let block = at(&shared, &own);
    let half = |shared: &DVector<f64>, own: &DVector<f64>| at(shared, own).squares / 2.0;
    let close = |name: &str, found: f64, size: f64, differences: f64, step: f64| {
        // What the gradient is made of, residual by residual, and what differences lose by the integration.
        let scale = (size * block.squares).sqrt() + 1e-3 * block.squares / step.max(1e-6);
        assert!(
            (found - differences).abs() < 3e-4 * scale,
            "{name}: {found} against {differences} of {scale}"
        );
    };
    for direction in 0..track.chart.dimension() {
        let h = 1e-3 / (1.0 + block.own[(direction, direction)].sqrt() * 1e-3);
        let mut step = DVector::zeros(track.chart.dimension());
        step[direction] = h;
        let ahead = half(&shared, &track.chart.moved(&own, &step));
        let behind = half(&shared, &track.chart.moved(&own, &-step));
        let differences = (ahead - behind) / (2.0 * h);
        close(
            &format!("direction {direction}"),
            block.own_gradient[direction],
            block.own[(direction, direction)],
            differences,
            h,
        );
    }
    for (index, unknown) in setting.shared.iter().enumerate() {
        let h = 1e-3 * unknown.usual;
        let mut step = DVector::zeros(setting.shared.len());
        step[index] = h;
        let differences =
            (half(&(&shared + &step), &own) - half(&(&shared - &step), &own)) / (2.0 * h);
        close(
            &unknown.name,
            block.shared_gradient[index],
            block.shared[(index, index)],
            differences,
            h / unknown.usual,
        );
    }
    // Each flight has unknowns that no other has: none of them may be without effect.
    assert!(block.own.diagonal().iter().all(|value| *value > 0.0));
}

#[test]
fn gradients_are_those_of_the_squares() {
    let correlated = Noise {
        sigma: [0.001, 0.002, 0.003],
        ar1: [0.5, 0.0, -0.3],
        interval: 1.0 / 120.0,
    };
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
        .insert("x".into(), Known::Scalar(0.01));
    data.flights[0]
        .known
        .insert("thetadot".into(), Known::Scalar(0.2));
    check(
        "disc",
        &data,
        &[],
        Loss::Whitened(&Noise::white(0.0015, 1.0 / 120.0)),
    );
}
