//! Laboratory mistakes in one flight and in all flights.

use model_spec::model::Model;

use super::{Spoil, ball, calm_disc, disc, disc_releases, each_point, found, kinds, plan, spoiled};
use crate::FaultKind;
use crate::screening::distances::confused;
use crate::synthesize::{Plan, flights};
use crate::{Dataset, Flight, Marker};

/// Recording mistakes that can occur in flights of any body: name, expected kind of data fault, and the function that
/// introduces the mistake into a flight.
const SPOILS: [(&str, FaultKind, Spoil); 7] = [
    ("feet", FaultKind::Units, |f| {
        each_point(f, |p| p.map(|x| x / 0.3048));
    }),
    ("centimetres", FaultKind::Units, |f| {
        each_point(f, |p| p.map(|x| x * 100.0));
    }),
    ("z down", FaultKind::Axes, |f| {
        each_point(f, |[x, y, z]| [x, -y, -z]);
    }),
    ("y up", FaultKind::Axes, |f| {
        each_point(f, |[x, y, z]| [x, z, -y]);
    }),
    ("milliseconds", FaultKind::TimeUnit, |f| {
        f.times.iter_mut().for_each(|t| *t *= 1000.0);
    }),
    ("twice the time", FaultKind::TimeUnit, |f| {
        f.times.iter_mut().for_each(|t| *t *= 2.0);
    }),
    ("half the time", FaultKind::TimeUnit, |f| {
        f.times.iter_mut().for_each(|t| *t *= 0.5);
    }),
];

const DISC_SPOILS: [(&str, FaultKind, Spoil); 6] = [
    // One point has no distances.
    ("millimetres read as centimetres", FaultKind::Units, |f| {
        each_point(f, |p| p.map(|x| x * 10.0));
    }),
    ("labels", FaultKind::LabelsExchanged, |f| {
        f.positions.iter_mut().for_each(|row| row.swap(0, 1));
    }),
    ("labels 2 3", FaultKind::LabelsExchanged, |f| {
        f.positions.iter_mut().for_each(|row| row.swap(1, 2));
    }),
    ("labels in a cycle", FaultKind::LabelsExchanged, |f| {
        f.positions.iter_mut().for_each(|row| row.rotate_left(1));
    }),
    ("labels in a part", FaultKind::LabelsExchanged, |f| {
        f.positions[50..100]
            .iter_mut()
            .for_each(|row| row.swap(0, 2));
    }),
    ("frozen", FaultKind::Frozen, |f| {
        let held = f.positions[60][1];
        f.positions[60..80]
            .iter_mut()
            .for_each(|row| row[1] = held.or(Some([1.0, 1.0, 1.0])));
    }),
];

#[test]
fn mistakes_in_flights_of_a_disc_are_named() {
    let (model, dataset) = disc(3);
    assert_named(&model, &dataset, &[&SPOILS[..], &DISC_SPOILS].concat());
}

const BALL_SPOILS: [(&str, FaultKind, Spoil); 1] = [("frozen", FaultKind::Frozen, |f| {
    let held = f.positions[20][0];
    f.positions[20..35]
        .iter_mut()
        .for_each(|row| row[0] = held.or(Some([1.0, 1.0, 1.0])));
})];

#[test]
fn mistakes_in_flights_of_a_ball_are_named() {
    let (model, dataset) = ball(4);
    assert_named(&model, &dataset, &[&SPOILS[..], &BALL_SPOILS].concat());
}

#[test]
fn a_ball_whose_millimetres_were_read_as_centimetres_is_named() {
    let (model, dataset) = ball(4);
    let all: Vec<usize> = (0..dataset.flights.len()).collect();
    let tenfold: Spoil = |f| each_point(f, |p| p.map(|x| x * 10.0));
    let faults = found(&model, &spoiled(&dataset, &all, tenfold));
    assert_eq!(faults.len(), all.len());
    for fault in faults {
        assert_eq!(fault.fault, FaultKind::Units, "{fault:?}");
        assert!(
            fault
                .detail
                .contains("millimetres had been read as centimetres"),
            "{fault:?}"
        );
    }
}

/// Introduces each mistake of `spoils`, first into one flight and then into all flights. Asserts that the expected kind
/// of fault is reported for exactly the flights with the mistake.
fn assert_named(model: &Model, dataset: &Dataset, spoils: &[(&str, FaultKind, Spoil)]) {
    let all: Vec<usize> = (0..dataset.flights.len()).collect();
    let mut wrong = Vec::new();
    for (name, kind, spoil) in spoils {
        for which in [&[4][..], &all] {
            let dataset = spoiled(dataset, which, *spoil);
            let faults = found(model, &dataset);
            let expected = which
                .iter()
                .map(|&flight| (dataset.flights[flight].file.clone(), *kind));
            let got: Vec<_> = faults
                .iter()
                .map(|fault| (fault.file.clone(), fault.fault))
                .collect();
            if got != expected.collect::<Vec<_>>() {
                wrong.push((name, which.len(), faults.into_iter().next(), got.len()));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn a_mirrored_flight_is_named() {
    let mirror: Spoil = |f| each_point(f, |[x, y, z]| [x, -y, z]);
    let (model, dataset) = calm_disc(7);
    let one = found(&model, &spoiled(&dataset, &[5], mirror));
    assert_eq!(
        kinds(&one),
        [("flight06.csv", FaultKind::Mirrored)],
        "{one:#?}"
    );
    let usual = disc_releases(&model).swap_remove(0);
    let marker = |name: &str, position| Marker {
        name: name.into(),
        position,
    };
    let markers = vec![
        marker("a", [0.1, 0.0, 0.02]),
        marker("b", [-0.05, 0.09, 0.0]),
        marker("c", [-0.04, -0.08, 0.01]),
        marker("d", [0.02, 0.03, -0.04]),
    ];
    let made = flights(
        &model,
        &[usual],
        &Plan {
            markers,
            ..plan(6, 8)
        },
    )
    .expect("flights");
    assert_eq!(found(&model, &made.dataset), []);
    let all = found(&model, &spoiled(&made.dataset, &[0, 1, 2, 3, 4, 5], mirror));
    assert_eq!(all.len(), 6);
    assert!(all.iter().all(|fault| fault.fault == FaultKind::Mirrored));
}

#[test]
fn copies_and_tables_that_are_no_flights_are_named() {
    let (model, mut dataset) = disc(9);
    dataset.flights[6].positions = dataset.flights[1].positions.clone();
    let random = &mut dataset.flights[8];
    let mut state = 1_u64;
    each_random(random, &mut state);
    let faults = found(&model, &dataset);
    let files: Vec<&str> = faults.iter().map(|fault| fault.file.as_str()).collect();
    assert_eq!(files, ["flight07.csv", "flight09.csv"], "{faults:#?}");
    let (model, mut dataset) = ball(9);
    each_random(&mut dataset.flights[8], &mut state);
    let later = dataset.flights[4].positions.len() / 2;
    for row in &mut dataset.flights[4].positions[later..] {
        for point in row.iter_mut().flatten() {
            point[1] += 0.5;
        }
    }
    let faults = found(&model, &dataset);
    assert_eq!(
        kinds(&faults),
        [
            ("flight05.csv", FaultKind::Other),
            ("flight09.csv", FaultKind::Other)
        ],
        "{faults:#?}"
    );
}

fn each_random(flight: &mut Flight, state: &mut u64) {
    for point in flight.positions.iter_mut().flatten().flatten() {
        *point = point.map(|_| {
            *state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (*state >> 40) as f64 / (1_u64 << 24) as f64
        });
    }
}

#[test]
fn two_confused_units_are_named() {
    assert_eq!(confused(10.0), Some(("millimetres", "centimetres")));
    assert_eq!(confused(1.0 / 12.0), Some(("feet", "inches")));
    assert_eq!(confused(1.5), None);
}

#[test]
fn missing_frames_that_the_times_do_not_show_are_named() {
    let (model, mut dataset) = calm_disc(5);
    let flight = &mut dataset.flights[3];
    flight.positions.drain(50..53);
    flight.times.truncate(flight.positions.len());
    let faults = found(&model, &dataset);
    assert_eq!(kinds(&faults), [("flight04.csv", FaultKind::Other)]);
    assert!(
        faults[0].detail.contains("as where frames are missing"),
        "{}",
        faults[0].detail
    );
}

/// A constant load may be the reason of a constant acceleration between the axes; and among few flights none is unlike
/// the others.
#[test]
fn no_axis_is_named_of_a_fall_between_the_axes_and_no_flight_of_few() {
    let (model, dataset) = ball(4);
    let all: Vec<usize> = (0..dataset.flights.len()).collect();
    let (sin, cos) = 0.7_f64.sin_cos();
    let mut tilted = dataset.clone();
    for flight in &mut tilted.flights {
        each_point(flight, |[x, y, z]| {
            [x, cos * y - sin * z, sin * y + cos * z]
        });
    }
    let faults = found(&model, &tilted);
    assert!(
        faults.iter().all(|own| own.fault != FaultKind::Axes),
        "{faults:#?}"
    );
    let mut few = spoiled(&dataset, &all[..1], SPOILS[6].2);
    few.flights.truncate(3);
    let faults = found(&model, &few);
    assert!(
        faults
            .iter()
            .all(|own| !own.detail.contains("unlike in the other")),
        "{faults:#?}"
    );
}
