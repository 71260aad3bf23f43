//! Readings whose unit or axes the fit alone tells: those of an accelerometer at the mass centre, and of a gyroscope whose
//! rates about two axes are small.

use std::cell::RefCell;

use crate::support::release;
use dataset::synthesize::{Corruption, Plan, flights};
use dataset::{Dataset, Sensor, SensorKind};
use identify::{DataFault, FitError, FitOptions, FlightId, fit};
use model_spec::compose::Instrument;
use model_spec::model::Model;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;

/// The dataset with an instrument at the mass centre that reads `reading` of a sample of a flight.
pub fn with_readings(
    dataset: &Dataset,
    instrument: Instrument,
    sigma: Option<f64>,
    reading: impl Fn(usize, usize) -> [f64; 3],
) -> Dataset {
    let mut made = dataset.clone();
    let kind = SensorKind::Instrument(instrument);
    let mut sensor = Sensor::new("device", kind, [0.0; 3]);
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

/// What an instrument at the mass centre reads, by flight and sample: what a fit predicts of readings without weight.
pub fn readings(model: &Model, dataset: &Dataset, instrument: Instrument) -> Vec<Vec<[f64; 3]>> {
    let silent = with_readings(dataset, instrument, Some(1e6), |_, _| [0.0; 3]);
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
    let release = release("backhand", &model);
    let plan = Plan {
        flights: 3,
        duration: Some(0.6),
        ..Plan::default()
    };
    let dataset = flights(&model, &[release], &plan).expect("made").dataset;
    let forces = readings(&model, &dataset, Instrument::Accelerometer);
    let read_in = |unit: f64| {
        let random = RefCell::new(ChaCha12Rng::seed_from_u64(1));
        let noise = || 0.2 * (random.borrow_mut().random::<f64>() - 0.5);
        with_readings(
            &dataset,
            Instrument::Accelerometer,
            None,
            |flight, sample| forces[flight][sample].map(|force| (force + noise()) / unit),
        )
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
        let told = format!("device seems to be in {name}: ");
        assert!(detail.starts_with(&told), "{detail}");
        let stated = format!("acceleration = \"{name}\"");
        assert!(correction.contains(&stated), "{correction}");
    }
}

#[test]
fn exchanged_axes_of_a_gyroscope_are_named_where_the_rates_about_them_are_small() {
    let model = model_spec::load::load("disc", &[]).expect("built in");
    let release = release("backhand", &model);
    for rate in [30.0, 120.0] {
        let plan = Plan {
            flights: 4,
            duration: Some(1.2),
            rate,
            ..Plan::default()
        };
        let made = flights(&model, std::slice::from_ref(&release), &plan);
        let dataset = made.expect("made").dataset;
        let rates = readings(&model, &dataset, Instrument::Gyroscope);
        let told = |order: [usize; 3]| {
            let random = RefCell::new(ChaCha12Rng::seed_from_u64(1));
            let noise = || 0.1 * (random.borrow_mut().random::<f64>() - 0.5);
            let turned = with_readings(&dataset, Instrument::Gyroscope, None, |flight, sample| {
                let own = rates[flight][sample].map(|rate| rate + noise());
                order.map(|axis| own[axis])
            });
            // At 30 Hz the attitudes alone suggest other axes, which are wrong.
            let options = FitOptions {
                trust_data: true,
                ..FitOptions::default()
            };
            let report = fit(&model, &turned, &options).expect("a fit").report;
            (report.misread, report.cautions, report.data_faults)
        };
        let (_, cautions, faults) = told([0, 1, 2]);
        assert_eq!((cautions, faults), (Vec::new(), Vec::new()), "{rate} Hz");
        let (exchanged, cautions, _) = told([1, 0, 2]);
        assert_ne!(cautions, Vec::<String>::new(), "{rate} Hz");
        // Many precise readings turn the fitted body as they ask, and leave residuals of the markers.
        if rate > 100.0 {
            continue;
        }
        let is_own = |own: &String| own.contains("gyroscope_axes = [\"+y\", \"+x\", \"+z\"]");
        assert!(exchanged.iter().any(is_own), "{rate} Hz: {exchanged:?}");
    }
}

#[test]
fn a_late_gyroscope_is_told_and_not_its_axes() {
    let model = model_spec::load::load("disc", &[]).expect("built in");
    let release = release("backhand", &model);
    let plan = Plan {
        flights: 4,
        duration: Some(1.2),
        noise: Corruption {
            sigma: 3e-4,
            ..Corruption::default()
        },
        ..Plan::default()
    };
    let dataset = flights(&model, &[release], &plan).expect("made").dataset;
    let rates = readings(&model, &dataset, Instrument::Gyroscope);
    let told = |late: usize| {
        let random = RefCell::new(ChaCha12Rng::seed_from_u64(1));
        let noise = || 1.0 * (random.borrow_mut().random::<f64>() - 0.5);
        let read = with_readings(&dataset, Instrument::Gyroscope, None, |flight, sample| {
            rates[flight][sample.saturating_sub(late)].map(|rate| rate + noise())
        });
        let found = fit(&model, &read, &FitOptions::default()).expect("a fit");
        found.report.misread
    };
    assert_eq!(told(0), Vec::<String>::new());
    let late = told(4);
    // The fit turns the body towards the readings.
    let is_told = |own: &String| own.contains("about 0.025 s late") || own.contains("0.033 s late");
    assert!(late.len() == 1 && late.iter().all(is_told), "{late:?}");
}
