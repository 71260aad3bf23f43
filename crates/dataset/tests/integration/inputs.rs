//! Inputs over time that cannot be read, each refused with its file and place.

use crate::support::{MANIFEST, TABLE, folder, read};

/// The flight's table with a column more, whose cells are `throttle`.
fn with_column(name: &str, throttle: [&str; 2]) -> String {
    let lines = TABLE.lines().zip([name, throttle[0], throttle[1]]);
    lines
        .map(|(line, cell)| format!("{line},{cell}\n"))
        .collect()
}

/// Reads a dataset of one flight with a table of inputs.
fn with_inputs(flight: &str, inputs: &str) -> Result<dataset::Dataset, String> {
    let manifest = MANIFEST.replace("role", "inputs = \"u.csv\"\nrole");
    let files = [
        ("dataset.toml", manifest.as_bytes()),
        ("a.csv", flight.as_bytes()),
        ("u.csv", inputs.as_bytes()),
    ];
    read(folder(&files).path())
}

#[test]
fn inputs_that_cannot_be_read_are_refused_with_their_place() {
    let cases = [
        ("", "u.csv:1:1", "no header"),
        ("# only a comment\n", "u.csv:1:1", "no header"),
        ("t,throttle\n", "u.csv:2:2", "no value in the column"),
        ("throttle\n1\n", "u.csv:1:1", "no column t"),
        ("0,1\n1,2\n", "u.csv:1:1", "no column t"),
        ("t\n0\n1\n", "u.csv:1:1", "the column t alone"),
        (
            "t,throttle,throttle\n0,1,2\n",
            "u.csv:1:3",
            "a second column",
        ),
        (
            "t,throttle\n0,1\n0,2\n",
            "u.csv:3:1",
            "expected a time after 0 s",
        ),
        (
            "t,throttle\n0,1\n0.2,1\n0.1,2\n",
            "u.csv:4:1",
            "expected a time after 0.2 s",
        ),
        ("t,throttle\n,1\n", "u.csv:2:1", "no time"),
        ("t,throttle\n0,1\nnan,2\n", "u.csv:3:1", "no time"),
        ("t,throttle\n0,1\n0.1,full\n", "u.csv:3:2", "\"full\""),
        ("t,throttle\n0,1 V\n", "u.csv:2:2", "\"1 V\""),
        ("t,throttle\n0,inf\n", "u.csv:2:2", "\"inf\""),
        ("t,throttle\n0,1e400\n", "u.csv:2:2", "\"1e400\""),
        ("t;throttle\n0;1,5,0\n", "u.csv:2:2", "\"1,5,0\""),
        ("t,throttle\n0\n", "u.csv:2:2", "1 cells"),
        ("t,throttle\n0,1,2\n", "u.csv:2:3", "3 cells"),
        (
            "t,throttle\n0,NaN\n0.1,\n",
            "u.csv:4:2",
            "no value in the column",
        ),
        ("t,throttle\n0,1\n100000,1\n", "u.csv:3:1", "milliseconds?"),
        (
            "t,throttle\n0,1\n0.1,\"1\n",
            "u.csv:3:2",
            "a quote that is not closed",
        ),
    ];
    for (inputs, place, told) in cases {
        let error = with_inputs(TABLE, inputs).expect_err(inputs);
        assert!(
            error.contains(place) && error.contains(told),
            "{inputs:?}: {error}"
        );
    }
    let twice = with_inputs(
        &with_column("throttle", ["1", "2"]),
        "t,throttle\n0,1\n1,1\n",
    );
    let error = twice.expect_err("in both tables");
    assert!(
        error.contains("the input throttle, which the flight's own table has too"),
        "{error}"
    );
}

#[test]
fn columns_of_a_flight_that_are_no_inputs_are_refused_with_their_place() {
    let read = |table: &str| {
        let files = [
            ("dataset.toml", MANIFEST.as_bytes()),
            ("a.csv", table.as_bytes()),
        ];
        read(folder(&files).path())
    };
    for (name, cells, place, told) in [
        ("throttle", ["1", "full"], "a.csv:3:13", "full"),
        ("throttle", ["inf", "1"], "a.csv:2:11", "inf"),
        ("throttle", ["", "NaN"], "a.csv", "no value in the column"),
        ("center_x", ["1", "2"], "a.csv:1:30", "center_x"),
        ("full throttle", ["1", "2"], "a.csv:1:30", "full throttle"),
        ("centre_y", ["1", "2"], "a.csv:1:30", "centre_y"),
    ] {
        let error = read(&with_column(name, cells)).expect_err(name);
        assert!(
            error.contains(place) && error.contains(told),
            "{name}: {error}"
        );
    }
    let found = read(&with_column("throttle", ["", "2"])).expect("a gap is bridged");
    let (name, series) = &found.flights[0].inputs[0];
    assert_eq!((name.as_str(), series.span()), ("throttle", (0.1, 0.1)));
}
