//! Screening with the model of a fit: distances that an estimated parameter changes are not compared, and mirrored axes are
//! told where the model describes the mirror image better.

use crate::support::release;
use dataset::screening::{Body, marker_pairs, screen};
use dataset::synthesize::{Corruption, Plan, flights};
use dataset::{DataFault, Dataset, FaultKind, Flight};
use flight::release::Stop;
use identify::{FitOptions, FitProblem, fit};
use model_spec::load::load;
use model_spec::model::Model;

type Spoil = fn(&mut Flight);

/// Flights of a disc.
fn disc(seed: u64, noise: Corruption) -> (Model, Dataset) {
    let model = load("disc", &[]).expect("built in");
    let mut release = release("backhand", &model);
    release.stop = Stop::Duration(1.0);
    let plan = Plan {
        flights: 10,
        seed,
        noise,
        duration: Some(1.0),
        ..Plan::default()
    };
    let made = flights(&model, &[release], &plan).expect("flights");
    (model, made.dataset)
}

fn rough() -> Corruption {
    Corruption {
        sigma: 0.0015,
        ar1: 0.6,
        outliers: 0.01,
        outlier_size: 0.05,
        dropouts: 0.12,
    }
}

fn spoiled(dataset: &Dataset, which: &[usize], spoil: Spoil) -> Dataset {
    let mut dataset = dataset.clone();
    { which.iter() }.for_each(|&flight| spoil(&mut dataset.flights[flight]));
    dataset
}

fn found(model: &Model, dataset: &Dataset) -> Vec<DataFault> {
    let problem = FitProblem::new(model, dataset, &FitOptions::default()).expect("a problem");
    screen(&problem, dataset, 2).0
}

fn rigid(effects: &[&str], dataset: &Dataset) -> Vec<bool> {
    let model = load("disc", effects).expect("a model");
    let problem = FitProblem::new(&model, dataset, &FitOptions::default()).expect("a problem");
    problem.rigid_pairs()
}

#[test]
fn estimated_parameters_of_the_measurement_leave_distances_open() {
    let (_, dataset) = disc(3, rough());
    assert_eq!(marker_pairs(3), [(0, 1), (0, 2), (1, 2)]);
    for (effect, expected) in [
        (&[][..], [true, true, true]),
        (&["stall"], [true, true, true]),
        (&["tilted_vertical"], [true, true, true]),
        (&["marker_1_misplaced"], [false, false, true]),
        (&["marker_3_misplaced"], [true, false, false]),
        (&["marker_radius"], [false, false, false]),
        (&["marker_time_offset"], [false, false, false]),
        (&["scale"], [false, false, false]),
    ] {
        assert_eq!(rigid(effect, &dataset), expected, "{effect:?}");
    }
}

#[test]
fn a_misplaced_marker_is_a_fault_only_where_the_model_does_not_estimate_it() {
    let far: Spoil = |flight| {
        for row in &mut flight.positions {
            let [Some(a), Some(b), _] = row[..] else {
                continue;
            };
            let toward = [0, 1, 2].map(|k| a[k] + 0.4 * (b[k] - a[k]));
            row[0] = Some(toward);
        }
    };
    let (plain, dataset) = disc(3, rough());
    let all: Vec<usize> = (0..dataset.flights.len()).collect();
    let dataset = spoiled(&dataset, &all, far);
    assert_eq!(found(&plain, &dataset).len(), all.len());
    for effect in ["marker_1_misplaced", "marker_radius"] {
        let model = load("disc", &[effect]).expect("a model");
        assert_eq!(found(&model, &dataset), [], "{effect}");
    }
    // Estimating the offset of another marker does not allow for the misplaced one.
    let model = load("disc", &["marker_3_misplaced"]).expect("a model");
    assert_eq!(found(&model, &dataset).len(), all.len());
}

#[test]
fn known_faults_replace_the_screening() {
    let (model, dataset) = disc(3, rough());
    let dataset = spoiled(&dataset, &[1], |flight| {
        flight.positions.iter_mut().for_each(|row| row.swap(0, 1));
    });
    let excluded = |known: Option<&[DataFault]>| {
        let options = FitOptions {
            known_faults: known,
            ..FitOptions::default()
        };
        let report = fit(&model, &dataset, &options).expect("a fit").report;
        let files = report.data_faults.iter().map(|fault| fault.file.clone());
        files.collect::<Vec<String>>()
    };
    let file = |index: usize| dataset.flights[index].file.clone();
    assert_eq!(excluded(None), [file(1)]);
    assert!(excluded(Some(&[])).is_empty());
    let other = DataFault {
        file: file(4),
        fault: FaultKind::Other,
        detail: "a mistake".into(),
        correction: "none".into(),
    };
    assert_eq!(excluded(Some(&[other])), [file(4)]);
}

#[test]
fn flights_that_are_all_mirrored_are_named() {
    let mirror: Spoil = |flight| {
        let points = flight.positions.iter_mut().flatten().flatten();
        points.for_each(|point| point[1] = -point[1]);
    };
    let (model, dataset) = disc(7, Corruption::default());
    let every: Vec<usize> = (0..dataset.flights.len()).collect();
    assert_eq!(found(&model, &dataset), []);
    let all = found(&model, &spoiled(&dataset, &every, mirror));
    assert_eq!(all.len(), every.len(), "{all:#?}");
    assert!(all.iter().all(|fault| fault.fault == FaultKind::Mirrored));
}
