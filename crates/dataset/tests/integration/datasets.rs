//! What a good dataset may look like, and that no other makes the reader panic or wait.

use std::time::{Duration, Instant};

use crate::support::{MANIFEST, TABLE, folder, read, read_both};
use dataset::{KnownValue, Role};
use proptest::prelude::*;

#[test]
fn a_good_dataset_is_read_whole() {
    let table = "\u{feff}# made\n\nt; centre_x;centre_z;\"centre_y\"\r\n0;1;3;2\r\n\r\n  \n0.1;;NaN;\r\n \t# said \"so\"\n\"0.25\";4;6;5";
    let dataset = read_both(MANIFEST.as_bytes(), table.as_bytes()).expect("it is well formed");
    assert_eq!(dataset.parameters["m"], 0.0027);
    let flight = &dataset.flights[0];
    assert_eq!(flight.role, Role::HeldOut);
    assert_eq!(flight.known["omega"], KnownValue::Vector([1.0, 2.0, 3.0]));
    assert_eq!(flight.times, [0.0, 0.1, 0.25]);
    let seen = |x, y, z| vec![Some([x, y, z])];
    assert_eq!(
        flight.positions,
        [seen(1.0, 2.0, 3.0), vec![None], seen(4.0, 5.0, 6.0)]
    );
    assert_eq!(dataset::measurements(flight), 2);
}

#[test]
fn tabs_capitals_of_nan_old_line_ends_and_columns_in_any_order_are_ordinary() {
    let table = "centre_z\tcentre_y\tt\tcentre_x\r3\t2\t-5\t1\r6\tnan\t-4.5\t4\r";
    let dataset = read_both(MANIFEST.as_bytes(), table.as_bytes()).expect("it is well formed");
    assert_eq!(dataset.flights[0].times, [-5.0, -4.5]);
    let positions = &dataset.flights[0].positions;
    assert_eq!(positions[0], [Some([1.0, 2.0, 3.0])]);
    assert_eq!(positions[1], [None]);
}

/// Tables as R, MATLAB, spreadsheets with a decimal comma and terminals of instruments write them.
#[test]
fn tables_of_other_programs_are_ordinary() {
    let rows = |table: &[u8]| {
        let dataset = read_both(MANIFEST.as_bytes(), table).expect("it is well formed");
        let flight = &dataset.flights[0];
        assert_eq!(flight.times, [0.0, 0.5, 1.0], "{table:?}");
        flight.positions.concat()
    };
    let expected = [Some([1.5, 2.0, -3.25]), None, Some([4.0, 5e-3, 6.0])];
    let spaces = "\"t\" \"centre_x\"  centre_y centre_z\n  0.0  1.5 2   -3.25  \n0.5 NA NA NA\n\n1 4 5e-3 6\n";
    assert_eq!(rows(spaces.as_bytes()), expected);
    let commas = "t centre_x centre_y centre_z\n0 1,5 2 -3,25\n0,5 n/a NaN null\n1 4 5e-3 6\n";
    assert_eq!(rows(commas.as_bytes()), expected);
    let semicolons =
        "t;centre_x;centre_y;centre_z\r\n0,0;1,5;2;-3,25\r\n0,5;;#N/A;\r\n1;4;5E-3;6\r\n";
    assert_eq!(rows(semicolons.as_bytes()), expected);
    let latin1 = [b"# \xfcber Gras, 20 \xb0C\n", semicolons.as_bytes()].concat();
    assert_eq!(rows(&latin1), expected);
    let wide = semicolons.encode_utf16().flat_map(u16::to_le_bytes);
    let wide: Vec<u8> = [0xff, 0xfe].into_iter().chain(wide).collect();
    assert_eq!(rows(&wide), expected);
}

#[test]
fn rounded_times_of_frames_are_evenly_spaced_and_noted() {
    let mut table = "t,centre_x,centre_y,centre_z\n".to_owned();
    for frame in 0..60 {
        table += &format!("{:.2},{frame},2,3\n", f64::from(frame) / 60.0);
    }
    let dataset = read_both(MANIFEST.as_bytes(), table.as_bytes()).expect("it is well formed");
    for (frame, time) in dataset.flights[0].times.iter().enumerate() {
        assert!((time - frame as f64 / 60.0).abs() < 2.5e-3, "{time}");
    }
    let noted = |note: &String| note.contains("a.csv") && note.contains("0.01 s");
    assert!(dataset.notes.iter().any(noted), "{:?}", dataset.notes);
}

#[test]
fn one_sample_integers_the_farthest_marker_and_all_flights_held_out_are_ordinary() {
    let manifest = MANIFEST.replace("[0.0, 0.0, 0.0]", "[0, 0, 10]").replace(
        "omega = [1.0, 2.0, 3.0]",
        "omega = [1, 2, 3], rho = 1.19, vz = -3",
    );
    let table = "t,centre_x,centre_y,centre_z\n1700000000.5,1,2,3\n";
    let dataset = read_both(manifest.as_bytes(), table.as_bytes()).expect("it is well formed");
    assert_eq!(dataset.markers[0].position, [0.0, 0.0, 10.0]);
    let known = &dataset.flights[0].known;
    assert_eq!(known["omega"], KnownValue::Vector([1.0, 2.0, 3.0]));
    assert_eq!(known["rho"], KnownValue::Scalar(1.19));
    assert_eq!(known["vz"], KnownValue::Scalar(-3.0));
}

#[test]
fn markers_may_be_named_like_the_columns_of_others() {
    let manifest = MANIFEST.replace(
        "[[flights]]",
        "[[markers]]\nname = \"centre_x_2\"\nposition = [1, 1, 1]\n[[flights]]",
    );
    let table =
        "t,centre_x,centre_y,centre_z,centre_x_2_x,centre_x_2_y,centre_x_2_z\n0,1,2,3,4,5,6\n";
    let dataset = read_both(manifest.as_bytes(), table.as_bytes()).expect("it is well formed");
    let row = &dataset.flights[0].positions[0];
    assert_eq!(*row, [Some([1.0, 2.0, 3.0]), Some([4.0, 5.0, 6.0])]);
}

#[test]
fn tables_may_lie_in_folders_and_files_beside_are_ignored() {
    let manifest = MANIFEST.replace("a.csv", "day one/a.csv");
    let files: [(&str, &[u8]); 4] = [
        ("dataset.toml", manifest.as_bytes()),
        ("day one/a.csv", TABLE.as_bytes()),
        ("truth.toml", b"[coefficients]"),
        ("notes", b"\xff"),
    ];
    read(folder(&files).path()).expect("it is well formed");
}

#[test]
fn large_and_crooked_files_are_refused_or_read_in_bounded_time() {
    let begun = Instant::now();
    let mib = 1 << 20;
    let dotted = format!("{}x = 1\n", "a.".repeat(mib));
    let tables: String = (0..100_000).map(|i| format!("[a{i}.b.c.d]\n")).collect();
    let marker = "[[markers]]\nname = \"b\"\nposition = [0, 0, 0]\n".repeat(50_000);
    let flights: String = (0..60_000)
        .map(|i| format!("[[flights]]\nfile = \"{i}.csv\"\n"))
        .collect();
    for crooked in [
        dotted,
        tables,
        "[".repeat(2 * mib),
        "a = {".repeat(mib / 2),
        format!("a = \"{}", "\\".repeat(2 * mib)),
        format!("{MANIFEST}{marker}"),
        MANIFEST.replace("[[flights]]\nfile = \"a.csv\"", &flights),
    ] {
        read_both(crooked.as_bytes(), TABLE.as_bytes()).expect_err("it is crooked");
    }
    let wide = format!("t,centre_x,centre_y,centre_z{}\n", ",".repeat(8 * mib));
    let quotes = format!("{TABLE}{}", "\"\n".repeat(2 * mib));
    let long = "9".repeat(8 * mib);
    for crooked in [wide, quotes, format!("{TABLE}0.2,{long},2,3\n")] {
        read_both(MANIFEST.as_bytes(), crooked.as_bytes()).expect_err("it is crooked");
    }
    let comments = format!("{}{TABLE}", "#\n\n".repeat(2 * mib));
    read_both(MANIFEST.as_bytes(), comments.as_bytes()).expect("a table after comments");
    assert!(
        begun.elapsed() < Duration::from_secs(60),
        "{:?}",
        begun.elapsed()
    );
}

/// Strategy for a text in which some bytes are replaced, inserted or removed at random.
fn spoiled(text: &'static str) -> impl Strategy<Value = Vec<u8>> {
    let edit = (
        0..text.len(),
        0..4_u8,
        any::<u8>(),
        "[-0-9.,;\"#\\[\\]={}a-z\n]",
    );
    proptest::collection::vec(edit, 1..6).prop_map(move |edits| {
        let mut bytes = text.as_bytes().to_vec();
        for (at, kind, byte, letter) in edits {
            let at = at.min(bytes.len().saturating_sub(1));
            match kind {
                0 => drop(bytes.splice(at..=at, [byte])),
                1 => drop(bytes.splice(at..=at, letter.bytes())),
                2 => drop(bytes.splice(at..at, letter.bytes())),
                _ => drop(bytes.remove(at)),
            }
        }
        bytes
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn no_bytes_make_it_panic(bytes in proptest::collection::vec(any::<u8>(), 0..400)) {
        let _ = read_both(MANIFEST.as_bytes(), &bytes);
        let _ = read_both(&bytes, TABLE.as_bytes());
    }

    #[test]
    fn no_soup_of_cells_makes_it_panic(text in "(t|centre_[xyz]|[,;\t\n]|-?[0-9]{1,3}|nan|#|\"|é){0,60}") {
        let _ = read_both(MANIFEST.as_bytes(), text.as_bytes());
    }

    #[test]
    fn no_spoiled_table_makes_it_panic(table in spoiled(TABLE)) {
        match read_both(MANIFEST.as_bytes(), &table) {
            Ok(dataset) => prop_assert!(dataset.flights[0].times.is_sorted()),
            Err(error) => prop_assert!(error.starts_with("a.csv:"), "{}", error),
        }
    }

    #[test]
    fn no_spoiled_manifest_makes_it_panic(manifest in spoiled(MANIFEST)) {
        if let Err(error) = read_both(&manifest, TABLE.as_bytes()) {
            prop_assert!(error.contains(": found ") && error.contains(", expected "), "{}", error);
        }
    }

    #[test]
    fn the_place_is_that_of_the_cell(
        before in proptest::collection::vec("#[ -~]{0,9}|", 0..4),
        rows in 0..4_usize,
        index in 0..4_usize,
        pad in " {0,3}",
    ) {
        let mut table: String = before.iter().map(|line| format!("{line}\n")).collect();
        table.push_str("t,centre_x,centre_y,centre_z\n");
        for row in 0..rows {
            table.push_str(&format!("{row},1,2,3\n"));
        }
        let mut cells = ["9".to_owned(), "1".into(), "2".into(), "3".into()];
        cells[index] = format!("{pad}oops");
        let line = before.len() + rows + 2;
        let column = cells[..index].iter().map(|cell| cell.len() + 1).sum::<usize>() + pad.len() + 1;
        table.push_str(&cells.join(","));
        let error = read_both(MANIFEST.as_bytes(), table.as_bytes()).expect_err("oops");
        prop_assert!(error.starts_with(&format!("a.csv:{line}:{column}: found \"oops\"")), "{}", error);
    }
}
