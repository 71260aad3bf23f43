//! Quantities that are stated twice for a flight, each refused with both places.

use std::collections::BTreeMap;

use dataset::from_texts;

use crate::support::TABLE;

const MANIFEST: &str = "model = \"ball\"
[[markers]]
name = \"centre\"
position = [0, 0, 0]
[[flights]]
file = \"a.csv\"
";

fn read(manifest: &str) -> Result<dataset::Dataset, String> {
    let mut with_inputs = TABLE.replace("z\n", "z,throttle\n");
    with_inputs = with_inputs.replace(",3\n", ",3,0.5\n");
    let tables = [
        ("a.csv", TABLE),
        ("b.csv", &with_inputs),
        ("u.csv", "t,throttle\n0,1\n1,1\n"),
        ("shots.csv", "Ball,Spin,Carry\n60,2500,150\n"),
    ];
    let tables = tables.map(|(name, text)| (name.to_owned(), text.to_owned()));
    from_texts(manifest, &BTreeMap::from(tables)).map_err(|error| error.to_string())
}

#[track_caller]
fn refused(manifest: &str, told: &str) {
    let error = read(manifest).expect_err(manifest);
    assert!(error.contains(told), "{manifest}\n{error}");
}

#[test]
fn an_input_of_a_table_is_neither_known_nor_unknown() {
    let flight = |lines: &str| format!("{MANIFEST}{lines}\n");
    let of_own_table = |lines: &str| flight(lines).replace("a.csv", "b.csv");
    read(&flight("inputs = \"u.csv\"\nknown = { tilt = 0.1 }")).expect("another input");
    refused(
        &flight("inputs = \"u.csv\"\nknown = { tilt = 0.1, throttle = 0.5 }"),
        "dataset.toml:8:23: found throttle under known, and as a column of u.csv, expected each quantity",
    );
    refused(
        &of_own_table("known = { throttle = 0.5, throttle_sigma = 0.1 }"),
        "dataset.toml:7:11: found throttle under known, and as a column of b.csv",
    );
    refused(
        &of_own_table("unknown = [\"tilt\", \"throttle\"]"),
        "dataset.toml:7:20: found throttle under unknown, and as a column of b.csv",
    );
    // In every flight that does not state it.
    let all = format!("unknown = [\"throttle\"]\n{}", of_own_table(""));
    read(&all).expect("this flight states it");
}

#[test]
fn a_quantity_is_not_known_and_unknown() {
    let flight = |known: &str| format!("{MANIFEST}known = {{ {known} }}\nunknown = [\"omega\"]\n");
    read(&flight("omega = [1, 2, 3], omega_sigma = [1, 1, 1]")).expect("a prior");
    read(&flight("wind = [1, 2, 3]")).expect("another quantity");
    refused(
        &flight("omega = [1, 2, 3]"),
        "dataset.toml:7:11: found omega under known, and under unknown in line 8, expected one of the two; omega_sigma",
    );
}

#[test]
fn the_spin_of_a_ball_is_not_known_beside_its_column() {
    let shots = |own: &str, columns: &str| {
        format!(
            "model = \"golf_ball\"\n[[summaries]]\nfile = \"shots.csv\"\n{own}\n[summaries.columns]\n\
             Carry = {{ is = \"carry\", unit = \"yd\" }}\n{columns}\n"
        )
    };
    let spin = "Spin = { is = \"spin\", unit = \"rpm\" }";
    let known = "known = { omega = [0, -200, 0] }";
    read(&shots(known, "")).expect("known alone");
    read(&shots("known = { wind = [1, 0, 0] }", spin)).expect("another quantity");
    refused(
        &shots(known, spin),
        "dataset.toml:4:11: found omega under known, and as the spin by the columns Spin, expected each quantity",
    );
}
