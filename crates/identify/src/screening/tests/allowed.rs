//! Deviations that the model can describe are no faults: distances that an estimated parameter changes are not
//! compared.

use model_spec::load::load;

use super::{Spoil, disc, found, spoiled};
use crate::error::{DataFault, FaultKind};
use crate::fit;
use crate::options::FitOptions;
use crate::problem::FitProblem;
use crate::screening::distances::{marker_pairs, rigid_pairs};
use dataset::Dataset;

fn rigid(effects: &[&str], dataset: &Dataset) -> Vec<bool> {
    let model = load("disc", effects).expect("a model");
    let problem = FitProblem::new(&model, dataset, &FitOptions::default()).expect("a problem");
    rigid_pairs(&problem)
}

#[test]
fn estimated_parameters_of_the_measurement_leave_distances_open() {
    let (_, dataset) = disc(3);
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
    let (plain, dataset) = disc(3);
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
    let (model, dataset) = disc(3);
    let dataset = spoiled(&dataset, &[1], |flight| {
        flight.positions.iter_mut().for_each(|row| row.swap(0, 1));
    });
    let excluded = |known: Option<&[DataFault]>| {
        let options = FitOptions {
            known_faults: known,
            ..FitOptions::default()
        };
        let report = fit::fit(&model, &dataset, &options).expect("a fit").report;
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
