//! The screening on synthetic flights: none of what flies is a fault, and mistakes are named.

use ::flight::release::{Release, Stop, Vocabulary, built_in, read};
use model_spec::model::Model;

use super::track::{self, Track};
use super::{DataFault, FaultKind, screen};
use crate::dataset::{Dataset, Flight, Marker};
use crate::impact_detection;
use crate::options::FitOptions;
use crate::problem::FitProblem;
use crate::synthesize::{Corruption, Plan, Spread, flights};

const AR: Corruption = Corruption {
    sigma: 0.0015,
    ar1: 0.6,
    outliers: 0.01,
    outlier_size: 0.05,
    dropouts: 0.12,
};

fn model(name: &str) -> Model {
    model_spec::load::load(name, &[]).expect("a model")
}

fn release(model: &Model, name: &str) -> Release {
    let text = built_in(name).expect("a release");
    read(name, text, |_| Ok(Vocabulary::of(model))).expect("readable")
}

fn plan(flights: usize, seed: u64) -> Plan {
    Plan {
        flights,
        seed,
        noise: AR,
        duration: Some(1.0),
        ..Plan::default()
    }
}

fn found(model: &Model, dataset: &Dataset) -> Vec<DataFault> {
    let problem = FitProblem::new(model, dataset, &FitOptions::default()).expect("a problem");
    screen(&problem, dataset, 2)
}

/// Throws of a disc: usual, at steep angles of attack, fast, slow, upside down.
fn disc_releases(model: &Model) -> Vec<Release> {
    let usual = release(model, "backhand");
    let with = |changes: &[(&str, f64)]| {
        let mut release = usual.clone();
        release.stop = Stop::Duration(1.0);
        for (name, value) in &mut release.initial {
            if let Some((_, changed)) = changes.iter().find(|(changed, _)| changed == name) {
                *value = *changed;
            }
        }
        release
    };
    vec![
        with(&[]),
        with(&[("u", 25.0), ("w", -7.0), ("gammadot", -90.0)]),
        with(&[("u", 30.0), ("w", -4.0), ("theta", 0.1)]),
        with(&[("u", 6.0), ("w", -1.0), ("gammadot", -20.0)]),
        with(&[("u", 12.0), ("w", -9.0)]),
        with(&[("phi", 0.9), ("theta", -0.5)]),
    ]
}

fn discs(flights_each: usize, seed: u64) -> (Model, Vec<Dataset>) {
    let model = model("disc");
    let each = disc_releases(&model).into_iter().enumerate();
    let made = each.filter_map(|(k, release)| {
        let plan = plan(flights_each, seed + 100 * k as u64);
        flights(&model, &[release], &plan)
            .ok()
            .map(|made| made.dataset)
    });
    let made = made.collect();
    (model, made)
}

fn disc(seed: u64) -> (Model, Dataset) {
    let model = model("disc");
    let mut usual = release(&model, "backhand");
    usual.stop = Stop::Duration(1.0);
    let made = flights(&model, &[usual], &plan(10, seed)).expect("flights");
    (model, made.dataset)
}

/// Flights of a disc with white noise alone.
fn calm_disc(seed: u64) -> (Model, Dataset) {
    let model = model("disc");
    let mut usual = release(&model, "backhand");
    usual.stop = Stop::Duration(1.0);
    let plan = Plan {
        noise: Corruption::default(),
        ..plan(10, seed)
    };
    let made = flights(&model, &[usual], &plan).expect("flights");
    (model, made.dataset)
}

fn ball(seed: u64) -> (Model, Dataset) {
    let model = model("ball");
    let mut serve = release(&model, "serve");
    serve.stop = Stop::Duration(0.6);
    let plan = Plan {
        duration: Some(0.6),
        spread: Spread {
            fraction: 0.3,
            ..Spread::default()
        },
        ..plan(10, seed)
    };
    let made = flights(&model, &[serve], &plan).expect("flights");
    (model, made.dataset)
}

#[test]
fn clean_flights_have_no_fault() {
    let (model, datasets) = discs(6, 1);
    assert!(datasets.len() > 4);
    for (k, dataset) in datasets.iter().enumerate() {
        assert_eq!(found(&model, dataset), [], "dataset {k}");
    }
    let (model, dataset) = ball(2);
    assert_eq!(found(&model, &dataset), []);
}

fn each_point(flight: &mut Flight, change: impl Fn([f64; 3]) -> [f64; 3]) {
    for point in flight.positions.iter_mut().flatten().flatten() {
        *point = change(*point);
    }
}

type Spoil = fn(&mut Flight);

const DISC_SPOILS: [(&str, FaultKind, Spoil); 12] = [
    ("labels", FaultKind::LabelsExchanged, |f| {
        f.positions.iter_mut().for_each(|row| row.swap(0, 1))
    }),
    ("labels 2 3", FaultKind::LabelsExchanged, |f| {
        f.positions.iter_mut().for_each(|row| row.swap(1, 2))
    }),
    ("labels in a cycle", FaultKind::LabelsExchanged, |f| {
        f.positions.iter_mut().for_each(|row| row.rotate_left(1))
    }),
    ("labels in a part", FaultKind::LabelsExchanged, |f| {
        f.positions[50..100]
            .iter_mut()
            .for_each(|row| row.swap(0, 2))
    }),
    ("feet", FaultKind::Units, |f| {
        each_point(f, |p| p.map(|x| x / 0.3048))
    }),
    ("centimetres", FaultKind::Units, |f| {
        each_point(f, |p| p.map(|x| x * 100.0))
    }),
    ("z down", FaultKind::Axes, |f| {
        each_point(f, |[x, y, z]| [x, -y, -z])
    }),
    ("y up", FaultKind::Axes, |f| {
        each_point(f, |[x, y, z]| [x, z, -y])
    }),
    ("milliseconds", FaultKind::TimeUnit, |f| {
        f.times.iter_mut().for_each(|t| *t *= 1000.0)
    }),
    ("twice the time", FaultKind::TimeUnit, |f| {
        f.times.iter_mut().for_each(|t| *t *= 2.0)
    }),
    ("half the time", FaultKind::TimeUnit, |f| {
        f.times.iter_mut().for_each(|t| *t *= 0.5)
    }),
    ("frozen", FaultKind::Frozen, |f| {
        let held = f.positions[60][1];
        f.positions[60..80]
            .iter_mut()
            .for_each(|row| row[1] = held.or(Some([1.0, 1.0, 1.0])));
    }),
];

fn spoiled(dataset: &Dataset, which: &[usize], spoil: Spoil) -> Dataset {
    let mut dataset = dataset.clone();
    for &flight in which {
        spoil(&mut dataset.flights[flight]);
    }
    dataset
}

#[test]
fn mistakes_in_flights_of_a_disc_are_named() {
    let (model, dataset) = disc(3);
    let all: Vec<usize> = (0..dataset.flights.len()).collect();
    let mut wrong = Vec::new();
    for (name, kind, spoil) in DISC_SPOILS {
        for which in [&[4][..], &all] {
            let dataset = spoiled(&dataset, which, spoil);
            let faults = found(&model, &dataset);
            let expected = which
                .iter()
                .map(|&flight| (dataset.flights[flight].file.clone(), kind));
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

const BALL_SPOILS: [(&str, FaultKind, Spoil); 8] = [
    ("feet", FaultKind::Units, |f| {
        each_point(f, |p| p.map(|x| x / 0.3048))
    }),
    ("centimetres", FaultKind::Units, |f| {
        each_point(f, |p| p.map(|x| x * 100.0))
    }),
    ("z down", FaultKind::Axes, |f| {
        each_point(f, |[x, y, z]| [x, -y, -z])
    }),
    ("y up", FaultKind::Axes, |f| {
        each_point(f, |[x, y, z]| [x, z, -y])
    }),
    ("milliseconds", FaultKind::TimeUnit, |f| {
        f.times.iter_mut().for_each(|t| *t *= 1000.0)
    }),
    ("twice the time", FaultKind::TimeUnit, |f| {
        f.times.iter_mut().for_each(|t| *t *= 2.0)
    }),
    ("half the time", FaultKind::TimeUnit, |f| {
        f.times.iter_mut().for_each(|t| *t *= 0.5)
    }),
    ("frozen", FaultKind::Frozen, |f| {
        let held = f.positions[20][0];
        f.positions[20..35]
            .iter_mut()
            .for_each(|row| row[0] = held.or(Some([1.0, 1.0, 1.0])));
    }),
];

#[test]
fn mistakes_in_flights_of_a_ball_are_named() {
    let (model, dataset) = ball(4);
    let all: Vec<usize> = (0..dataset.flights.len()).collect();
    let mut wrong = Vec::new();
    for (name, kind, spoil) in BALL_SPOILS {
        for which in [&[4][..], &all] {
            let dataset = spoiled(&dataset, which, spoil);
            let faults = found(&model, &dataset);
            let expected = which
                .iter()
                .map(|&flight| (dataset.flights[flight].file.clone(), kind));
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

/// Many clean flights of many kinds; run with --ignored in release.
#[test]
#[ignore = "takes long"]
fn two_thousand_clean_flights_have_no_fault() {
    let (mut count, mut alarms) = (0, 0);
    for seed in 0..30 {
        let (model, datasets) = discs(12, 1000 * seed);
        for dataset in datasets {
            let faults = found(&model, &dataset);
            count += dataset.flights.len();
            alarms += faults.len();
            for fault in faults {
                eprintln!("disc {seed} {fault}");
            }
        }
        let (model, dataset) = ball(seed);
        let faults = found(&model, &dataset);
        count += dataset.flights.len();
        alarms += faults.len();
        for fault in faults {
            eprintln!("ball {seed} {fault}");
        }
    }
    eprintln!("{alarms} alarms in {count} flights");
    assert_eq!(alarms, 0);
}

#[test]
fn measured_flights_and_examples_have_no_fault() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let folders = [
        "../shared/data/spindoe",
        "examples/ball",
        "examples/disc",
        "examples/mystery",
    ];
    for folder in folders {
        let path = root.join(folder);
        if !path.exists() {
            eprintln!("skipped: {folder} is absent");
            continue;
        }
        let dataset = crate::dataset::load(&path).expect("a dataset");
        assert_eq!(found(&model(&dataset.model), &dataset), [], "{folder}");
    }
}

/// Lets the body of a flight bounce at a time: its velocity jumps by `change`, m/s.
fn bounced(flight: &Flight, time: f64, change: [f64; 3]) -> Flight {
    let mut flight = flight.clone();
    for (t, row) in flight.times.iter().zip(&mut flight.positions) {
        let since = (t - time).max(0.0);
        for point in row.iter_mut().flatten() {
            for (axis, change) in point.iter_mut().zip(change) {
                *axis += change * since;
            }
        }
    }
    flight
}

/// Index of the first sample after the impact that is detected.
fn cut_at(problem: &FitProblem, flight: &Flight) -> Option<usize> {
    let track = Track::of(
        &problem.markers,
        problem.has_attitude,
        &flight.times,
        &flight.positions,
    );
    let path: Vec<_> = track
        .points
        .iter()
        .map(|p| (p.sample, p.time, p.position))
        .collect();
    impact_detection::impact(&path).map(|impact| path[impact.index].0)
}

fn cuts(seeds: std::ops::Range<u64>) -> [usize; 4] {
    let (mut flown, mut wrong, mut bounces, mut missed) = (0, 0, 0, 0);
    for seed in seeds {
        let (disc, mut datasets) = discs(12, 1000 * seed);
        let (ball, of_ball) = ball(seed);
        let discs = datasets.len();
        datasets.push(of_ball);
        for (k, dataset) in datasets.iter().enumerate() {
            let model = if k < discs { &disc } else { &ball };
            let problem =
                FitProblem::new(model, dataset, &FitOptions::default()).expect("a problem");
            for (index, flight) in dataset.flights.iter().enumerate() {
                flown += 1;
                if let Some(at) = cut_at(&problem, flight) {
                    wrong += 1;
                    eprintln!(
                        "seed {seed} dataset {k} flight {index} cut at {at} of {}",
                        flight.times.len()
                    );
                }
                let track = Track::of(
                    &problem.markers,
                    problem.has_attitude,
                    &flight.times,
                    &flight.positions,
                );
                let middle = track.points.len() / 2 + index;
                let Some(motion) =
                    track::parabola(&track.points[middle - 10..middle + 10], track.noise)
                else {
                    continue;
                };
                let velocity = motion.velocity;
                if velocity.z > -1.0 {
                    continue;
                }
                bounces += 1;
                let restitution = 0.2 + 0.05 * index as f64;
                let change = [
                    -0.2 * velocity.x,
                    -0.2 * velocity.y,
                    -(1.0 + restitution) * velocity.z,
                ];
                let time = track.points[middle].time - 0.003;
                let at = cut_at(&problem, &bounced(flight, time, change));
                // Dropouts may hide the samples at the impact.
                let index_of = |sample| track.points.partition_point(|point| point.sample < sample);
                if at.is_none_or(|at| index_of(at).abs_diff(middle) > 2) {
                    missed += 1;
                    eprintln!(
                        "seed {seed} dataset {k} flight {index}: bounce at {middle} of change {change:?}, cut at {:?}",
                        at.map(index_of)
                    );
                }
            }
        }
    }
    eprintln!("{wrong} of {flown} cut wrongly; {missed} of {bounces} bounces missed");
    [flown, wrong, bounces, missed]
}

#[test]
fn flights_are_cut_at_bounces_only() {
    let [flown, wrong, bounces, missed] = cuts(0..1);
    assert!(flown > 50 && bounces > 20);
    assert_eq!([wrong, missed], [0, 0]);
}

/// Cuts of many flights; run with --ignored in release.
#[test]
#[ignore = "takes long"]
fn two_thousand_flights_are_cut_at_bounces_only() {
    let [_, wrong, bounces, missed] = cuts(0..30);
    assert_eq!(wrong, 0);
    assert!(100 * missed <= bounces);
}

/// A flight with samples before its release: the body is held, then pushed along its first velocity.
fn with_hand(flight: &Flight, held: usize, pushed: usize) -> Flight {
    let mut flight = flight.clone();
    let dt = flight.times[1] - flight.times[0];
    let complete = |row: &Vec<Option<[f64; 3]>>| row.iter().all(Option::is_some);
    let first = flight
        .positions
        .iter()
        .position(complete)
        .expect("a complete row");
    flight.positions.drain(..first);
    let next = (1..)
        .find(|&i| complete(&flight.positions[i]))
        .expect("another");
    let row = |i: usize| {
        flight.positions[i]
            .iter()
            .flatten()
            .copied()
            .collect::<Vec<[f64; 3]>>()
    };
    let (start, later) = (row(0), row(next));
    let count = start.len() as f64;
    let velocity = [0, 1, 2].map(|axis| {
        let moved = later.iter().zip(&start).map(|(b, a)| b[axis] - a[axis]);
        moved.sum::<f64>() / count / (next as f64 * dt)
    });
    let push = pushed as f64 * dt;
    let before = (1..=held + pushed).rev().map(|back| {
        let since = push - back as f64 * dt;
        let moved = since.max(0.0).powi(2) / (2.0 * push) - push / 2.0;
        let shift = |(k, p): (usize, &[f64; 3])| {
            let noise = 0.0015 * ((back * 31 + k * 7) as f64).sin();
            Some([0, 1, 2].map(|axis| p[axis] + velocity[axis] * moved + noise))
        };
        start.iter().enumerate().map(shift).collect()
    });
    let mut positions: Vec<Vec<Option<[f64; 3]>>> = before.collect();
    positions.append(&mut flight.positions);
    flight.times = (0..positions.len()).map(|i| i as f64 * dt).collect();
    flight.positions = positions;
    flight
}

/// A flight whose body is caught: braked within some samples, then held.
fn with_catch(flight: &Flight, braked: usize, held: usize) -> Flight {
    let mut backwards = flight.clone();
    backwards.positions.reverse();
    let mut caught = with_hand(&backwards, held, braked);
    caught.positions.reverse();
    caught
}

fn kinds(faults: &[DataFault]) -> Vec<(&str, FaultKind)> {
    faults
        .iter()
        .map(|fault| (fault.file.as_str(), fault.fault))
        .collect()
}

#[test]
fn samples_in_the_hand_and_after_the_catch_are_named() {
    type Change = fn(&Flight) -> Flight;
    let changes: [(&str, Change); 6] = [
        ("held for half a second", |f| with_hand(f, 60, 20)),
        ("pushed only", |f| with_hand(f, 0, 14)),
        ("pushed briefly", |f| with_hand(f, 0, 7)),
        ("caught and held", |f| with_catch(f, 8, 30)),
        ("caught", |f| with_catch(f, 9, 0)),
        ("at rest", |f| Flight {
            positions: f
                .positions
                .iter()
                .map(|_| {
                    f.positions[0]
                        .iter()
                        .map(|p| p.or(Some([1.0; 3])))
                        .collect()
                })
                .collect(),
            ..f.clone()
        }),
    ];
    let mut wrong = Vec::new();
    for ((model, clean), which_body) in [(disc(5), "disc"), (ball(6), "ball")] {
        for (name, change) in &changes {
            for which in [&[3][..], &[0, 1, 2, 3, 4, 5, 6, 7, 8, 9]] {
                let mut dataset = clean.clone();
                for &flight in which {
                    dataset.flights[flight] = change(&clean.flights[flight]);
                }
                let faults = found(&model, &dataset);
                let files = faults.iter().map(|fault| fault.file.as_str());
                let expected = which
                    .iter()
                    .map(|&flight| dataset.flights[flight].file.as_str());
                if !files.eq(expected) {
                    wrong.push(format!(
                        "{which_body}, {name}, {}: {:?} {:?}",
                        which.len(),
                        kinds(&faults),
                        faults.first().map(|f| &f.detail)
                    ));
                }
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
    let all = found(
        &model,
        &spoiled(&dataset, &[0, 1, 2, 3, 4, 5, 6, 7, 8, 9], mirror),
    );
    assert_eq!(all.len(), 10, "{all:#?}");
    assert!(all.iter().all(|fault| fault.fault == FaultKind::Mirrored));
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
fn throws_that_are_upside_down_are_no_mirror_images() {
    let model = model("disc");
    let mut usual = release(&model, "backhand");
    usual.stop = Stop::Duration(0.8);
    for (name, value) in &mut usual.initial {
        match name.as_str() {
            "phi" => *value += std::f64::consts::PI,
            "v" | "w" => *value = -*value,
            _ => {}
        }
    }
    let plan = Plan {
        duration: Some(0.8),
        ..plan(8, 11)
    };
    let made = flights(&model, &[usual], &plan).expect("flights");
    assert_eq!(found(&model, &made.dataset), []);
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

/// Clean flights of models of a user's own.
#[test]
fn flights_of_other_models_have_no_fault() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../studies/models");
    // Names, and initial states other than the defaults.
    let cases: [(&str, &[(&str, f64)]); 6] = [
        ("shuttlecock", &[("vx", 40.0), ("vz", 10.0), ("z", 2.0)]),
        (
            "spinning_ball",
            &[("vx", 20.0), ("vz", 6.0), ("z", 2.0), ("p", 40.0)],
        ),
        (
            "quaternion_dart",
            &[("vx", 15.0), ("vz", 2.0), ("z", 2.0), ("p", 5.0)],
        ),
        ("glider", &[]),
        ("pendulum", &[("x", 1.5), ("z", -2.0)]),
        ("kite", &[]),
    ];
    for (name, initial) in cases {
        let path = root.join(format!("{name}.hyz"));
        let model = model(path.to_str().expect("a path"));
        let states = model.states.iter().map(|state| {
            let value = initial.iter().find(|(name, _)| *name == state.name);
            (
                state.name.clone(),
                value.map_or(state.value, |(_, value)| *value),
            )
        });
        let release = Release {
            model: model.name.clone(),
            stop: Stop::Duration(1.0),
            parameters: Vec::new(),
            coefficients: Vec::new(),
            initial: states.collect(),
            wind: [0.0; 3],
            known: Vec::new(),
        };
        for seed in 0..5 {
            let plan = Plan {
                spread: Spread {
                    fraction: 0.05,
                    ..Spread::default()
                },
                ..plan(8, seed)
            };
            match flights(&model, std::slice::from_ref(&release), &plan) {
                Ok(made) => assert_eq!(found(&model, &made.dataset), [], "{name}"),
                Err(error) => eprintln!("skipped: {name}: {error}"),
            }
        }
    }
}

#[test]
#[ignore = "measures time"]
fn time_of_the_screening() {
    let (model, _) = disc(1);
    let made = flights(
        &model,
        &[disc_releases(&model).swap_remove(0)],
        &plan(20, 1),
    )
    .expect("flights");
    let problem =
        FitProblem::new(&model, &made.dataset, &FitOptions::default()).expect("a problem");
    let time = |name: &str, work: &dyn Fn()| {
        let clock = std::time::Instant::now();
        for _ in 0..20 {
            work();
        }
        eprintln!(
            "{name}: {:.3} ms",
            1e3 * clock.elapsed().as_secs_f64() / 20.0
        );
    };
    let dataset = &made.dataset;
    let track =
        |flight: &Flight| super::track_until_impact(&problem, &flight.times, &flight.positions);
    let tracks: Vec<Option<Track>> = dataset
        .flights
        .iter()
        .map(|flight| Some(track(flight)))
        .collect();
    let gravity = super::gravity::gravity(&problem).expect("gravity");
    let each = |work: &dyn Fn(usize)| (0..dataset.flights.len()).for_each(work);
    time("records", &|| {
        each(&|i| assert!(super::records::check(dataset, i).is_none()))
    });
    time("distances", &|| {
        each(&|i| assert!(super::distances::check(dataset, i).is_none()))
    });
    time("tracks", &|| {
        each(&|i| assert!(!track(&dataset.flights[i]).points.is_empty()))
    });
    time("poses", &|| {
        each(&|i| {
            let flight = &dataset.flights[i];
            let track = Track::of(&problem.markers, true, &flight.times, &flight.positions);
            assert!(!track.points.is_empty());
        });
    });
    time("jumps", &|| {
        each(&|i| {
            assert!(
                super::jumps::check(tracks[i].as_ref().expect("a track"), &dataset.flights[i])
                    .is_none()
            )
        });
    });
    time("gravity", &|| {
        assert!(super::gravity::gravity(&problem).is_some())
    });
    time("free fall", &|| {
        assert!(
            super::FreeFall::new(&problem, dataset, gravity, &tracks)
                .check()
                .is_empty()
        )
    });
    time("handling", &|| {
        each(&|i| {
            assert!(
                super::handling::check(
                    tracks[i].as_ref().expect("a track"),
                    gravity,
                    &dataset.flights[i]
                )
                .is_none()
            )
        });
    });
    time("screening", &|| {
        assert_eq!(screen(&problem, dataset, 1), [])
    });
    let clock = std::time::Instant::now();
    let options = FitOptions {
        threads: Some(1),
        ..FitOptions::default()
    };
    crate::fit(&model, dataset, &options).expect("a fit");
    eprintln!("fit: {:.3} ms", 1e3 * clock.elapsed().as_secs_f64());
}
