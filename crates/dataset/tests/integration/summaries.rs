//! Tables with a row per flight: what is read, written and refused.

use std::collections::BTreeMap;
use std::path::Path;

use dataset::{Dataset, InputError, Role, ShotOptions, from_texts, import_shots, load, write};

const SHOTS: &str =
    "Ball,Carry,Height,Dir.\n[mph],[yds],[ft],[deg]\n100,150,60,-2\n# half a shot\n90,,50,1\n";

const MANIFEST: &str = "model = \"golf_ball\"\n[[summaries]]\nfile = \"shots.csv\"\nheld_out = [5]\n[summaries.columns]\n\
    Ball = { is = \"speed\", unit = \"mph\", sigma = 0.5 }\n\
    Carry = { is = \"carry\", unit = \"yd\" }\n\
    Height = { is = \"apex_height\", unit = \"ft\" }\n\
    \"Dir.\" = { is = \"heading\", unit = \"deg\", positive = \"right\" }\n";

fn read(manifest: &str, shots: &str) -> Result<Dataset, InputError> {
    let tables = BTreeMap::from([("shots.csv".to_owned(), shots.to_owned())]);
    from_texts(manifest, &tables)
}

#[test]
fn each_row_is_a_flight_named_by_its_line() {
    let dataset = read(MANIFEST, SHOTS).expect("a dataset");
    let files: Vec<&str> = dataset
        .flights
        .iter()
        .map(|own| own.file.as_str())
        .collect();
    assert_eq!(files, ["shots.csv:3", "shots.csv:5"]);
    assert_eq!(dataset.flights[1].role, Role::HeldOut);
    let carry = dataset
        .sensors
        .iter()
        .position(|own| own.name == "Carry")
        .expect("a column");
    let of = |flight: usize| dataset.flights[flight].readings[0][carry].map(|own| own[0]);
    assert_eq!((of(0), of(1)), (Some(150.0), None));
}

#[test]
fn written_summaries_are_read_again() {
    let dataset = read(MANIFEST, SHOTS).expect("a dataset");
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("written");
    write(&path, &dataset).expect("written");
    assert_eq!(load(&path).expect("read"), dataset);
}

#[test]
fn mistakes_are_told_with_their_places() {
    let of_manifest = [
        ("is = \"carry\"", "is = \"cary\"", "did you mean carry?"),
        ("unit = \"yd\"", "unit = \"mph\"", "for carry one of m, yd"),
        (
            "unit = \"yd\"",
            "unit = \"furlong\"",
            "for carry one of m, yd",
        ),
        (
            "is = \"carry\"",
            "is = \"apex_height\"",
            "each quantity once",
        ),
        ("is = \"carry\", ", "", "is, one of speed"),
        ("sigma = 0.5", "sigma = -1", "a standard deviation above 0"),
        ("sigma = 0.5", "sgima = 1", "sgima"),
        ("[5]", "[4]", "no flight at line 4"),
        ("[5]", "[5, 5]", "each line once"),
        ("[5]", "5", "the lines of the rows"),
        ("[5]", "[4.5]", "the lines of the rows"),
        ("[5]", "[1]", "the lines of the rows"),
        (
            "positive = \"right\"",
            "positive = \"up\"",
            "\"left\" or \"right\"",
        ),
        (
            "\"mph\", sigma",
            "\"mph\", positive = \"right\", sigma",
            "heading, side and spin_axis alone",
        ),
        ("Carry =", "Carried =", "no column \"Carried\""),
        (
            "unit = \"ft\"",
            "unit = \"m\"",
            "[m] as dataset.toml states",
        ),
        (
            "file = \"shots.csv\"",
            "file = \"../shots.csv\"",
            "inside the dataset's folder",
        ),
        (
            "[summaries.columns]",
            "[summaries.colums]",
            "did you mean columns?",
        ),
    ];
    for (from, to, expected) in of_manifest {
        assert!(MANIFEST.contains(from), "{from}");
        let error = read(&MANIFEST.replacen(from, to, 1), SHOTS).expect_err(to);
        assert!(error.to_string().contains(expected), "{error}");
    }
    let release = MANIFEST.replace("Carry =", "#").replace("Height =", "#");
    let error = read(&release, SHOTS).expect_err("no outcome");
    assert!(
        error.to_string().contains("columns of the release alone"),
        "{error}"
    );
    let of_table = [
        ("100,150", "100,far", "3:5"),
        ("100,150", "100,1e9", "carry from 0 to 10000 m"),
        ("100,150,60,-2", "100,150,60", "4 as in the header"),
        ("100,150,60,-2", ",,,", "a row without a value"),
        ("[yds]", "[m]", "[yd] as dataset.toml states"),
        ("Ball,Carry", "Carry,Carry", "no column \"Ball\""),
        ("Height", "Carry", "a second column \"Carry\""),
        ("100,150", "1e999,150", "3:1"),
    ];
    for (from, to, expected) in of_table {
        assert!(SHOTS.contains(from), "{from}");
        let error = read(MANIFEST, &SHOTS.replacen(from, to, 1)).expect_err(to);
        assert!(error.to_string().contains(expected), "{error}");
    }
    assert!(read(MANIFEST, "").is_err() && read(MANIFEST, "Ball,Carry,Height,Dir.\n").is_err());
}

#[test]
fn exports_of_launch_monitors_are_recognised() {
    let trackman = "Club,Ball Speed,Launch Angle,Launch Direction,Spin Rate,Spin Rate Type,Spin Axis,Carry Flat - Length,Carry Flat - Side,Last data Point - Length,Last data Point - Time\n\
        ,[mph],[deg],[deg],[rpm],[],[deg],[yds],[yds],[yds],[s]\n\
        7 Iron,120,15,-1,5500,Measured,4,170,8,3.2,0.06\n\
        Driver,150,11,2,2300,Estimated,-3,250,-5,3.4,0.05\n\
        Average,,,,,,,,,,\n";
    let import = |text: &str, columns: &[(&str, &str, Option<&str>)]| {
        let columns = columns.iter().map(|(header, is, unit)| {
            (
                (*header).to_owned(),
                (*is).to_owned(),
                unit.map(str::to_owned),
            )
        });
        let options = ShotOptions {
            model: None,
            columns: columns.collect(),
        };
        import_shots(Path::new("shots.csv"), text.as_bytes(), &options)
    };
    let made = import(trackman, &[]).expect("a dataset");
    assert_eq!(made.dataset.flights.len(), 2);
    assert_eq!(made.dataset.model, "golf_ball");
    let notes = made.dataset.notes.join(" ");
    assert!(
        notes.contains("3.3 yd and 0.06 s after launch: the fit describes the device's model"),
        "{notes}"
    );
    assert!(
        notes.contains("the spin of 1 of 2 shots is estimated"),
        "{notes}"
    );
    let disc = "speedMph,spinRpm,hyzerAngle,noseAngle,launchAngle,distance\n60,1100,10,1,9,300\n";
    let error = import(disc, &[])
        .expect_err("the distance has no unit")
        .to_string();
    assert!(error.contains("no column of what was seen"), "{error}");
    let made = import(disc, &[("distance", "carry", Some("ft"))]).expect("a dataset");
    assert_eq!(
        (made.dataset.model.as_str(), made.dataset.sensors.len()),
        ("disc", 6)
    );
    let plain = "v,c\n40,90\n";
    let columns = [("v", "speed", Some("m/s")), ("c", "carry", Some("m"))];
    assert_eq!(
        import(plain, &columns)
            .expect("a dataset")
            .dataset
            .flights
            .len(),
        1
    );
    for (wrong, expected) in [
        (("w", "speed", Some("m/s")), "no column"),
        (("v", "sped", Some("m/s")), "one of speed"),
        (("c", "carry", Some("s")), "with m, yd"),
    ] {
        let error = import(plain, &[wrong]).expect_err(wrong.1).to_string();
        assert!(error.contains(expected), "{error}");
    }
}
