//! Tables that are written in other units and along other axes: the section `[recording]` of a dataset.

use crate::support::{MANIFEST, read_both};
use dataset::takes::{Axis, Take};

/// Times, s, and positions, m, along right-handed axes with z up, which a correctly read table yields.
const TRUTH: [(f64, [f64; 3]); 3] = [
    (0.0, [0.5, -1.25, 2.0]),
    (0.125, [1.5, -1.0, 2.25]),
    (0.25, [2.5, -0.75, 2.125]),
];

fn manifest(recording: &str) -> String {
    MANIFEST.replacen(
        "[parameters]",
        &format!("[recording]\n{recording}\n[parameters]"),
        1,
    )
}

/// Converts a position to axes of which `up` points upwards; left-handed axes are obtained by changing the sign of y
/// first.
fn along(up: &str, left_handed: bool, [x, y, z]: [f64; 3]) -> [f64; 3] {
    let y = if left_handed { -y } else { y };
    match up {
        "+z" => [x, y, z],
        "-z" => [x, -y, -z],
        "+y" => [x, z, -y],
        "-y" => [x, -z, y],
        "+x" => [z, y, -x],
        "-x" => [-z, y, x],
        other => panic!("{other}"),
    }
}

fn table(up: &str, left_handed: bool, metre: f64, second: f64) -> String {
    let rows = TRUTH.map(|(t, position)| {
        let [x, y, z] = along(up, left_handed, position).map(|x| x / metre);
        format!("{},{x},{y},{z}\n", t / second)
    });
    format!("t,centre_x,centre_y,centre_z\n{}", rows.concat())
}

#[test]
fn tables_in_other_units_and_along_other_axes_are_converted() {
    let lengths = [
        ("m", 1.0),
        ("cm", 0.01),
        ("mm", 1e-3),
        ("in", 0.0254),
        ("ft", 0.3048),
    ];
    for (length, metre) in lengths {
        for (time, second) in [("s", 1.0), ("ms", 1e-3)] {
            for up in ["+z", "-z", "+y", "-y", "+x", "-x"] {
                for left in [false, true] {
                    let recording = format!(
                        "length = \"{length}\"\ntime = \"{time}\"\nup = \"{up}\"\nleft_handed = {left}"
                    );
                    let text = table(up, left, metre, second);
                    let read = read_both(manifest(&recording).as_bytes(), text.as_bytes());
                    let read = read.expect(&recording);
                    let flight = &read.flights[0];
                    for (i, (t, position)) in TRUTH.into_iter().enumerate() {
                        assert!((flight.times[i] - t).abs() < 1e-12, "{recording}");
                        let found = flight.positions[i][0].expect("seen");
                        let far = found
                            .iter()
                            .zip(position)
                            .any(|(a, b)| (a - b).abs() > 1e-12);
                        assert!(!far, "{recording}: {found:?} {position:?}");
                    }
                }
            }
        }
    }
}

#[test]
fn the_default_is_metres_seconds_and_z_up_to_the_bit() {
    let text = table("+z", false, 1.0, 1.0);
    let bare = read_both(MANIFEST.as_bytes(), text.as_bytes()).expect("read");
    let empty = read_both(manifest("").as_bytes(), text.as_bytes()).expect("read");
    assert_eq!(bare, empty);
    for (row, (t, position)) in bare.flights[0].positions.iter().zip(TRUTH) {
        assert_eq!(row[0], Some(position), "{t}");
    }
}

#[test]
fn an_import_turns_a_take_the_same_way() {
    let take: Take = dataset::takes::parse(
        std::path::Path::new("take"),
        b"t_s,centre_x_m,centre_y_m,centre_z_m\n0,1,2,3\n",
        &dataset::takes::ReadOptions::default(),
    )
    .expect("read");
    for up in ["+z", "-z", "+y", "-y", "+x", "-x"] {
        for left in [false, true] {
            let turned = take.clone().with_z_up(Axis::parse(up).expect(up), left);
            let recording = format!("up = \"{up}\"\nleft_handed = {left}");
            let table = b"t,centre_x,centre_y,centre_z\n0,1,2,3\n";
            let read = read_both(manifest(&recording).as_bytes(), table).expect(up);
            assert_eq!(
                read.flights[0].positions[0][0],
                turned.points[0].positions[0]
            );
        }
    }
}

#[test]
fn a_pose_is_turned_with_its_place() {
    let manifest = |recording: &str| {
        format!(
            "model = \"disc\"\n{recording}[[sensors]]\nname = \"tag\"\nkind = \"pose\"\n[[flights]]\nfile = \"a.csv\"\n"
        )
    };
    let table = b"t,tag_x,tag_y,tag_z,tag_qw,tag_qx,tag_qy,tag_qz\n0,1000,2000,3000,0.6,0,0.8,0\n";
    let recording = "[recording]\nlength = \"mm\"\nup = \"+y\"\n";
    let read = read_both(manifest(recording).as_bytes(), table).expect("read");
    let readings = &read.flights[0].readings[0];
    assert_eq!(readings[0], Some([1.0, -3.0, 2.0, 0.0]));
    // A direction of the body is turned as a position is.
    let direction = [0.3, -0.5, 0.7];
    let before = dataset::takes::rotated([0.6, 0.0, 0.8, 0.0], direction);
    let after = dataset::takes::rotated(readings[1].expect("an attitude"), direction);
    let wanted = Axis::parse("+y").expect("an axis").upright(false, before);
    assert!(
        after.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-12),
        "{after:?} {wanted:?}"
    );
    let recording = "[recording]\nleft_handed = true\n";
    let error = read_both(manifest(recording).as_bytes(), table).expect_err("mirrored");
    assert!(
        error.contains("expected poses with respect to right-handed axes"),
        "{error}"
    );
}

#[test]
fn what_is_stated_wrongly_is_refused() {
    let cases = [
        (
            "length = \"yard\"",
            "found length = \"yard\", expected \"m\", \"cm\", \"mm\", \"in\", \"ft\"",
        ),
        ("length = 1", "found length = 1, expected \"m\""),
        ("time = \"h\"", "found time = \"h\", expected \"s\", \"ms\""),
        ("up = \"z\"", "found up = \"z\", expected \"+z\", \"-z\""),
        (
            "left_handed = \"yes\"",
            "found left_handed = the text \"yes\", expected true or false",
        ),
        (
            "units = \"mm\"",
            "found the key \"units\" in [recording], expected length, time, up, left_handed",
        ),
    ];
    let text = table("+z", false, 1.0, 1.0);
    for (recording, message) in cases {
        let error =
            read_both(manifest(recording).as_bytes(), text.as_bytes()).expect_err(recording);
        assert!(error.starts_with("dataset.toml:3:"), "{error}");
        assert!(error.contains(message), "{error}");
    }
}
