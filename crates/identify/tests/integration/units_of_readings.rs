//! Readings whose unit the mechanics of the body do not tell: those of an accelerometer at the mass centre.

use std::cell::RefCell;

use dataset::synthesize::{Plan, flights};
use dataset::{Dataset, Sensor, SensorKind};
use flight::release::{Vocabulary, built_in, read};
use identify::{DataFault, FitError, FitOptions, FlightId, fit};
use model_spec::compose::Instrument;
use model_spec::model::Model;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;

/// The dataset with an accelerometer at the mass centre that reads `reading` of a sample of a flight.
fn with_readings(
    dataset: &Dataset,
    sigma: Option<f64>,
    reading: impl Fn(usize, usize) -> [f64; 3],
) -> Dataset {
    let mut made = dataset.clone();
    let kind = SensorKind::Instrument(Instrument::Accelerometer);
    let mut sensor = Sensor::new("force", kind, [0.0; 3]);
    sensor.sigma = sigma;
    made.sensors.push(sensor);
    for (index, flight) in made.flights.iter_mut().enumerate() {
        let rows = (0..flight.times.len()).map(|sample| {
            let [x, y, z] = reading(index, sample);
            vec![Some([x, y, z, 0.0])]
        });
        flight.readings = rows.collect();
    }
    made
}

/// Specific forces at the mass centre, m/s², by flight and sample: what a fit predicts of readings without weight.
fn forces(model: &Model, dataset: &Dataset) -> Vec<Vec<[f64; 3]>> {
    let silent = with_readings(dataset, Some(1e6), |_, _| [0.0; 3]);
    let found = fit(model, &silent, &FitOptions::default()).expect("a fit");
    let each = (0..dataset.flights.len()).map(|index| {
        let evidence = found.evidence(FlightId::new(index)).expect("flown");
        let residuals = evidence.sensors[0].residuals.iter();
        let predicted = residuals.map(|residual| residual.expect("a reading").map(|own| -own));
        predicted.collect()
    });
    each.collect()
}

#[test]
fn an_accelerometer_in_g_is_named_where_only_the_fit_tells() {
    let model = model_spec::load::load("disc", &[]).expect("built in");
    let text = built_in("backhand").expect("built in");
    let release = read("backhand", text, |_| Ok(Vocabulary::of(&model))).expect("a release");
    let plan = Plan {
        flights: 3,
        duration: Some(0.6),
        ..Plan::default()
    };
    let dataset = flights(&model, &[release], &plan).expect("made").dataset;
    let forces = forces(&model, &dataset);
    let read_in = |unit: f64| {
        let random = RefCell::new(ChaCha12Rng::seed_from_u64(1));
        let noise = || 0.2 * (random.borrow_mut().random::<f64>() - 0.5);
        with_readings(&dataset, None, |flight, sample| {
            forces[flight][sample].map(|force| (force + noise()) / unit)
        })
    };
    let right = fit(&model, &read_in(1.0), &FitOptions::default());
    assert!(right.is_ok());
    for (unit, name) in [(9.80665, "g"), (9.80665e-3, "mg")] {
        let error = fit(&model, &read_in(unit), &FitOptions::default()).err();
        let Some(FitError::FaultyData(faults)) = error else {
            panic!("{name}: {error:?}");
        };
        assert_eq!(faults.len(), 3);
        let DataFault {
            detail, correction, ..
        } = &faults[0];
        let told = format!("force seems to be in {name}: ");
        assert!(detail.starts_with(&told), "{detail}");
        let stated = format!("acceleration = \"{name}\"");
        assert!(correction.contains(&stated), "{correction}");
    }
}
