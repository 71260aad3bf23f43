//! Malformed datasets are refused with file, place, what was found and what was expected.

use std::fmt::Write;
use std::path::Path;

use identify::dataset::{self, Role};

const MANIFEST: &str = r#"model = "ball"
[parameters]
m = 0.0027
[[markers]]
name = "centre"
position = [0.0, 0.0, 0.0]
[[flights]]
file = "a.csv"
role = "held-out"
known = { omega = [1.0, 2.0, 3.0] }
"#;

const TABLE: &str = "t,centre_x,centre_y,centre_z\n0.0,1,2,3\n0.1,1.1,2,3\n";

fn load(manifest: &[u8], table: &[u8]) -> Result<dataset::Dataset, String> {
    let folder = tempfile::tempdir().expect("a temporary folder");
    std::fs::write(folder.path().join("dataset.toml"), manifest).expect("written");
    std::fs::write(folder.path().join("a.csv"), table).expect("written");
    let strip = |file: &Path| {
        file.file_name()
            .map(|name| name.to_string_lossy().into_owned())
            .unwrap_or_default()
    };
    dataset::load(folder.path()).map_err(|mut error| {
        error.file = strip(&error.file).into();
        error.to_string()
    })
}

#[test]
fn a_good_dataset_is_read_whole() {
    let table = "\u{feff}# made\n\nt; centre_x;centre_z;centre_y\r\n0;1;3;2\r\n\r\n0.1;;NaN;\r\n0.25;4;6;5\r\n";
    let dataset = load(MANIFEST.as_bytes(), table.as_bytes()).expect("it is well formed");
    assert_eq!(dataset.parameters["m"], 0.0027);
    let flight = &dataset.flights[0];
    assert_eq!(flight.role, Role::HeldOut);
    assert_eq!(flight.known["omega"], [1.0, 2.0, 3.0]);
    assert_eq!(flight.times, [0.0, 0.1, 0.25]);
    assert_eq!(
        flight.positions,
        [
            vec![Some([1.0, 2.0, 3.0])],
            vec![None],
            vec![Some([4.0, 5.0, 6.0])]
        ]
    );
    assert_eq!(flight.measurements(), 6);
}

#[test]
fn broken_datasets_are_refused_with_their_place() {
    let manifests: &[(&str, &str)] = &[
        ("role = \"held-out\"", "role = \"spare\""),
        ("m = 0.0027", "m = -0.0027"),
        ("m = 0.0027", "m = nan"),
        ("m = 0.0027", "m = \"light\""),
        ("model = \"ball\"", "modle = \"ball\""),
        ("model = \"ball\"", ""),
        ("model = \"ball\"", "model = "),
        ("position = [0.0, 0.0, 0.0]", "position = [0.0, 0.0]"),
        ("position = [0.0, 0.0, 0.0]", "position = [0.0, inf, 0.0]"),
        ("name = \"centre\"", "name = \"the centre\""),
        (
            "[[flights]]",
            "[[markers]]\nname = \"centre\"\nposition = [0.0, 0.0, 0.0]\n[[flights]]",
        ),
        ("[[flights]]", "[noise]\nsigma = 0.0\n[[flights]]"),
        ("file = \"a.csv\"", "file = \"../a.csv\""),
        ("file = \"a.csv\"", "file = \"/etc/passwd\""),
        ("file = \"a.csv\"", "file = \"missing.csv\""),
        ("omega = [1.0, 2.0, 3.0]", "omega = 3.0"),
    ];
    let tables: &[&[u8]] = &[
        b"",
        b"# nothing\n",
        b"t,centre_x,centre_y,centre_z\n",
        b"time,centre_x,centre_y,centre_z\n0,1,2,3\n",
        b"centre_x,centre_y,centre_z\n1,2,3\n",
        b"t,centre_x,centre_y\n0,1,2\n",
        b"t,centre_x,centre_y,centre_z,rim_x\n0,1,2,3,4\n",
        b"t,centre_x,centre_y,centre_z,centre_z\n0,1,2,3,4\n",
        b"t,centre_x,centre_y,centre_z\n0,1,2\n",
        b"t,centre_x,centre_y,centre_z\n0,1,2,three\n",
        b"t,centre_x,centre_y,centre_z\n0,1,2,1e999\n",
        b"t,centre_x,centre_y,centre_z\n,1,2,3\n",
        b"t,centre_x,centre_y,centre_z\n0.1,1,2,3\n0.1,1,2,3\n",
        b"t,centre_x,centre_y,centre_z\n0.1,1,2,3\n0.0,1,2,3\n",
        b"t,centre_x,centre_y,centre_z\n0,1,2,\xff\n",
    ];
    let mut told = String::new();
    for (from, to) in manifests {
        assert!(MANIFEST.contains(from), "{from}");
        let error = load(MANIFEST.replace(from, to).as_bytes(), TABLE.as_bytes()).expect_err(to);
        let _ = writeln!(told, "{error}");
    }
    for table in tables {
        let error = load(MANIFEST.as_bytes(), table).expect_err(&String::from_utf8_lossy(table));
        let _ = writeln!(told, "{error}");
    }
    insta::assert_snapshot!(told);
}

proptest::proptest! {
    #[test]
    fn no_table_makes_it_panic(bytes in proptest::collection::vec(proptest::prelude::any::<u8>(), 0..400)) {
        let _ = load(MANIFEST.as_bytes(), &bytes);
        let _ = load(&bytes, TABLE.as_bytes());
    }

    #[test]
    fn no_soup_of_cells_makes_it_panic(text in "(t|centre_[xyz]|[,;\t\n]|-?[0-9]{1,3}|nan|#|\"){0,60}") {
        let _ = load(MANIFEST.as_bytes(), text.as_bytes());
    }
}
