//! A dataset that is written is read back as it was, and nothing is overwritten.

use std::collections::BTreeMap;
use std::io::ErrorKind;
use std::path::Path;

use dataset::{Dataset, Flight, KnownValue, Marker, Role, load, write, write_with};
use flight::{InputInterpolation, InputSeries};
use proptest::prelude::*;

fn small() -> Dataset {
    let flight = |file: &str| Flight {
        file: file.into(),
        role: Role::Fit,
        known: BTreeMap::from([("rho".into(), KnownValue::Scalar(1.19))]),
        times: vec![0.0, 0.1],
        positions: vec![vec![Some([1.0, 2.0, 3.0])], vec![None]],
        ..Flight::default()
    };
    Dataset {
        model: "ball".into(),
        parameters: BTreeMap::from([("m".into(), 0.0027)]),
        markers: vec![Marker {
            name: "centre".into(),
            position: [0.0; 3],
        }],
        sigma: Some(0.001),
        flights: vec![flight("a.csv"), flight("sub/b.csv")],
        ..Dataset::default()
    }
}

fn files(folder: &Path) -> usize {
    std::fs::read_dir(folder).expect("a folder").count()
}

#[test]
fn it_is_written_to_a_new_an_empty_or_its_own_folder() {
    let around = tempfile::tempdir().expect("a folder");
    let folder = around.path().join("deep/inside");
    write(&folder, &small()).expect("a new folder");
    assert_eq!(load(&folder).expect("read"), small());
    write(&folder, &small()).expect("the same again");
    let empty = around.path().join("empty");
    std::fs::create_dir(&empty).expect("made");
    let beside = [("truth.toml".into(), "a = 1\n".into())];
    write_with(&empty, &small(), &beside).expect("an empty folder");
    assert_eq!(load(&empty).expect("read"), small());
    assert_eq!(files(&empty), 4);
    assert_eq!(files(around.path()), 2, "nothing is left beside");
}

#[test]
fn what_is_there_already_is_not_overwritten() {
    let around = tempfile::tempdir().expect("a folder");
    let folder = around.path().join("d");
    write(&folder, &small()).expect("a new folder");
    let mut other = small();
    other.parameters.insert("m".into(), 1.0);
    let error = write(&folder, &other).expect_err("another dataset is there");
    assert_eq!(error.kind(), ErrorKind::AlreadyExists);
    assert_eq!(load(&folder).expect("as it was"), small());
    std::fs::write(folder.join("notes"), "mine").expect("written");
    write(&folder, &small()).expect_err("something else is there");
    let file = around.path().join("file");
    std::fs::write(&file, "mine").expect("written");
    write(&file, &small()).expect_err("a file is there");
    assert_eq!(std::fs::read(&file).expect("as it was"), b"mine");
    assert_eq!(files(around.path()), 2, "nothing is left beside");
}

#[test]
fn a_disk_that_refuses_leaves_nothing_behind() {
    let around = tempfile::tempdir().expect("a folder");
    let mut dataset = small();
    // A file and a folder of one name.
    dataset.flights[1].file = "a.csv/b.csv".into();
    write(&around.path().join("d"), &dataset).expect_err("no disk can hold it");
    assert_eq!(files(around.path()), 0);
}

#[test]
fn what_would_not_be_read_back_is_not_written() {
    let around = tempfile::tempdir().expect("a folder");
    let refused = |name: &str, change: &dyn Fn(&mut Dataset)| {
        let mut dataset = small();
        change(&mut dataset);
        let error = write(&around.path().join("d"), &dataset).expect_err(name);
        assert_eq!(error.kind(), ErrorKind::InvalidInput, "{name}: {error}");
        assert_eq!(files(around.path()), 0, "{name}");
    };
    refused("a file outside", &|d| d.flights[0].file = "../a.csv".into());
    refused("C3D", &|d| d.flights[0].file = "a.c3d".into());
    refused("a file twice", &|d| d.flights[0].file = "sub/b.csv".into());
    refused("the manifest's own name", &|d| {
        d.flights[0].file = "dataset.toml".into();
    });
    refused("a marker without a name", &|d| d.markers[0].name.clear());
    refused("a negative mass", &|d| {
        d.parameters.insert("m".into(), -1.0);
    });
    refused("no flights", &|d| d.flights.clear());
    refused("time that runs back", &|d| d.flights[0].times.reverse());
    refused("a time without a position", &|d| {
        d.flights[0].times.push(0.2);
    });
    refused("a position that is no number", &|d| {
        d.flights[0].positions[0][0] = Some([f64::NAN; 3]);
    });
    refused("a known number that is none", &|d| {
        let known = &mut d.flights[0].known;
        known.insert("rho".into(), KnownValue::Scalar(f64::INFINITY));
    });
}

/// Strategy for numbers of magnitude up to `size`, including 0, −0 and 10⁻³⁰⁰.
fn number(size: f64) -> impl Strategy<Value = f64> {
    prop_oneof![
        -size..size,
        Just(0.0),
        Just(-0.0),
        Just(1e-300),
        Just(size / 3.0)
    ]
}

fn flight(markers: usize) -> impl Strategy<Value = Flight> {
    let axis = || number(0.25);
    let point = prop::option::weighted(0.8, [axis(), axis(), axis()]);
    let row = prop::collection::vec(point, markers);
    let known = prop_oneof![
        (0.1..10.0).prop_map(KnownValue::Scalar),
        [number(1e9), number(1e9), number(1e9)].prop_map(KnownValue::Vector)
    ];
    (
        prop::collection::vec((1e-6..1.0, row), 1..20),
        prop::collection::btree_map("[a-zA-Z_é\" .]{1,8}", known, 0..3),
        any::<bool>(),
        number(1e6),
        prop::collection::btree_map(
            "[a-zA-Z_é]{1,7}a",
            prop::collection::vec((1e-6..1.0, number(1e6)), 1..8),
            0..3,
        ),
        prop::collection::btree_set("[a-zA-Z_é\" .]{1,8}", 0..3),
    )
        .prop_map(move |(mut rows, known, held_out, start, inputs, unknown)| {
            // At least one marker is seen.
            rows[0].1[0] = Some([0.1, 0.2, 0.1]);
            let mut time = start;
            let times = rows.iter().map(|(step, _)| {
                time += step;
                time
            });
            Flight {
                file: String::new(),
                role: if held_out { Role::HeldOut } else { Role::Fit },
                known,
                times: times.collect(),
                positions: rows.iter().map(|(_, row)| row.clone()).collect(),
                unknown: unknown.into_iter().collect(),
                inputs: inputs
                    .into_iter()
                    .map(|(name, steps)| (name, series(start, &steps)))
                    .collect(),
                ..Flight::default()
            }
        })
}

/// An input over time whose samples follow one another by `steps`, pairs of a time and a value.
fn series(start: f64, steps: &[(f64, f64)]) -> InputSeries {
    let mut time = start;
    let samples = steps.iter().map(|(step, value)| {
        time += step;
        (time, *value)
    });
    InputSeries::new(&samples.collect::<Vec<_>>(), InputInterpolation::Hold)
}

fn dataset() -> impl Strategy<Value = Dataset> {
    let parameters = prop::collection::btree_map("[a-zA-Z_µ]{1,8}", 1e-9..1e9, 0..4);
    (
        1..4_usize,
        "[a-zé/ \"\\\\]{1,12}",
        parameters,
        prop::option::of(1e-9..1.0),
    )
        .prop_flat_map(|(markers, model, parameters, sigma)| {
            prop::collection::vec(flight(markers), 1..4).prop_map(move |mut flights| {
                for (i, flight) in flights.iter_mut().enumerate() {
                    flight.file = format!("flight {i}.csv");
                }
                let marker = |i| Marker {
                    name: format!("m{i}"),
                    position: [0.1 * i as f64, 1.0 / 3.0, -1e-7],
                };
                Dataset {
                    model: format!("m{model}"),
                    parameters: parameters.clone(),
                    markers: (0..markers).map(marker).collect(),
                    sigma,
                    unknown: vec!["wind".to_owned()],
                    input_interpolation: InputInterpolation::Hold,
                    flights,
                    ..Dataset::default()
                }
            })
        })
}

proptest! {
    #[test]
    fn what_is_written_is_read(dataset in dataset()) {
        let around = tempfile::tempdir().expect("a folder");
        let folder = around.path().join("d");
        write(&folder, &dataset).expect("written");
        prop_assert_eq!(load(&folder).expect("read"), dataset);
    }
}
