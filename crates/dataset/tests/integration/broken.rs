//! Broken datasets, each refused with its file, its place, what was found and what was expected.

use std::fmt::Write;
use std::path::Path;

use crate::support::c3d::File;
use crate::support::{MANIFEST, TABLE, folder, read, read_both};

/// Text with the name and the error message of each case; panics if a case has no error.
fn told(cases: Vec<(&str, Result<dataset::Dataset, String>)>) -> String {
    let mut text = String::new();
    let mut names = std::collections::BTreeSet::new();
    for (name, result) in cases {
        assert!(names.insert(name.to_owned()), "two cases {name}");
        let error = result.expect_err(name);
        let _ = writeln!(text, "{name}\n    {error}");
    }
    text
}

/// Valid text of `dataset.toml` in which `from` is replaced by `to`.
fn changed(from: &str, to: &str) -> String {
    assert!(MANIFEST.contains(from), "{from}");
    MANIFEST.replace(from, to)
}

#[test]
fn the_dataset_that_is_broken_below_is_good() {
    read_both(MANIFEST.as_bytes(), TABLE.as_bytes()).expect("a good one");
}

#[test]
fn manifests() {
    const CENTRE: &str = "position = [0.0, 0.0, 0.0]";
    let second = |name: &str, position: &str| {
        format!("{CENTRE}\n[[markers]]\nname = {name}\nposition = {position}")
    };
    let noise = |sigma: &str| format!("[noise]\nsigma = {sigma}\n[[flights]]");
    let deep = format!("model = {}1{}", "[".repeat(5000), "]".repeat(5000));
    let cases = [
        ("empty", String::new()),
        ("no TOML", changed("model = \"ball\"", "model = ")),
        ("a value without quotes", changed("\"ball\"", "ball")),
        ("a key twice", changed("m = 0.0027", "m = 1.0\nm = 2.0")),
        ("lists nested without end", deep),
        ("a NUL byte", changed("ball", "ba\0ll")),
        ("no model", changed("model = \"ball\"", "")),
        (
            "an unknown key, nearly known",
            changed("model =", "modle ="),
        ),
        ("an unknown key", changed("[parameters]", "[weather]")),
        ("a model that is a number", changed("\"ball\"", "3")),
        ("a model without a name", changed("\"ball\"", "\" \"")),
        ("a negative mass", changed("0.0027", "-0.0027")),
        ("no mass", changed("0.0027", "0")),
        ("a negative radius", changed("m = 0.0027", "radius = -0.02")),
        ("a negative density", changed("m = 0.0027", "rho = -1.2")),
        ("a mass that is no number", changed("0.0027", "nan")),
        ("an infinite mass", changed("0.0027", "inf")),
        ("a mass beyond all numbers", changed("0.0027", "1e999")),
        ("a mass in words", changed("0.0027", "\"light\"")),
        ("a mass with a unit", changed("0.0027", "2.7 g")),
        (
            "parameters that are no table",
            changed("[parameters]\nm = 0.0027", "parameters = 1"),
        ),
        (
            "no markers",
            MANIFEST.replace(
                "[[markers]]\nname = \"centre\"\nposition = [0.0, 0.0, 0.0]\n",
                "",
            ),
        ),
        (
            "a marker that is no list",
            changed("[[markers]]", "[markers]"),
        ),
        (
            "a marker without a name",
            changed("name = \"centre\"\n", ""),
        ),
        ("a marker without a position", changed(CENTRE, "")),
        ("a marker with an empty name", changed("\"centre\"", "\"\"")),
        (
            "a marker with a space",
            changed("\"centre\"", "\"the centre\""),
        ),
        (
            "a marker with a separator",
            changed("\"centre\"", "\"a;b\""),
        ),
        ("a marker with a quote", changed("\"centre\"", "'a\"b'")),
        (
            "a marker named as a column",
            changed("\"centre\"", "\"m1_x\""),
        ),
        (
            "a marker with a colour",
            changed(CENTRE, "position = [0,0,0]\ncolour = 1"),
        ),
        (
            "a marker in a plane",
            changed(CENTRE, "position = [0.0, 0.0]"),
        ),
        ("a marker in words", changed(CENTRE, "position = \"rim\"")),
        (
            "a marker with a word",
            changed(CENTRE, "position = [0.0, \"rim\", 0.0]"),
        ),
        (
            "a marker at infinity",
            changed(CENTRE, "position = [0.0, inf, 0.0]"),
        ),
        (
            "a marker in millimetres",
            changed(CENTRE, "position = [100.0, 0.0, 10.0]"),
        ),
        (
            "a marker twice",
            changed(CENTRE, &second("\"centre\"", "[1, 0, 0]")),
        ),
        (
            "two markers at one place",
            changed(CENTRE, &second("\"b\"", "[0, 0, 1e-9]")),
        ),
        ("too many markers", {
            let each = |i| format!("[[markers]]\nname = \"n{i}\"\nposition = [{i}e-3, 0, 0]\n");
            let all: String = (1..=1000).map(each).collect();
            changed("[[flights]]", &format!("{all}[[flights]]"))
        }),
        ("noise of 0", changed("[[flights]]", &noise("0"))),
        ("negative noise", changed("[[flights]]", &noise("-0.001"))),
        (
            "noise in millimetres",
            changed("[[flights]]", &noise("1.5")),
        ),
        (
            "noise that is no number",
            changed("[[flights]]", &noise("nan")),
        ),
        (
            "noise of an unknown kind",
            changed("[[flights]]", "[noise]\ncolour = \"pink\"\n[[flights]]"),
        ),
        (
            "no flights",
            MANIFEST[..MANIFEST.find("[[flights]]").expect("flights")].to_owned(),
        ),
        ("a flight without a file", changed("file = \"a.csv\"\n", "")),
        ("a flight with an unknown key", changed("role =", "rolle =")),
        ("an unknown role", changed("held-out", "spare")),
        ("a role nearly known", changed("held-out", "heldout")),
        ("a role that is a number", changed("\"held-out\"", "1")),
        ("a file above the folder", changed("a.csv", "../a.csv")),
        (
            "a file above the folder, from within",
            changed("a.csv", "sub/../../a.csv"),
        ),
        ("a file from the root", changed("a.csv", "/etc/passwd")),
        ("a file without a name", changed("a.csv", "")),
        ("a file by a longer way", changed("a.csv", "./a.csv")),
        (
            "a file by a longer way, from within",
            changed("a.csv", "sub//./a.csv"),
        ),
        (
            "a file with a backslash",
            changed("\"a.csv\"", "'sub\\a.csv'"),
        ),
        ("a file with a line break", changed("a.csv", "a\\nb.csv")),
        ("a file that is not there", changed("a.csv", "missing.csv")),
        (
            "a file twice",
            format!("{MANIFEST}[[flights]]\nfile = \"a.csv\"\n"),
        ),
        (
            "known quantities that are no table",
            changed("{ omega = [1.0, 2.0, 3.0] }", "3"),
        ),
        (
            "a known vector of two",
            changed("[1.0, 2.0, 3.0]", "[1.0, 2.0]"),
        ),
        (
            "a known vector without a number",
            changed("[1.0, 2.0, 3.0]", "[1.0, nan, 3.0]"),
        ),
        ("a known text", changed("[1.0, 2.0, 3.0]", "\"fast\"")),
        (
            "a known negative density",
            changed("omega = [1.0, 2.0, 3.0]", "rho = -1"),
        ),
    ];
    let cases = cases
        .iter()
        .map(|(name, manifest)| (*name, read_both(manifest.as_bytes(), TABLE.as_bytes())));
    insta::assert_snapshot!(told(cases.collect()));
}

#[test]
fn tables() {
    const HEAD: &str = "t,centre_x,centre_y,centre_z\n";
    let rows = |rows: &str| format!("{HEAD}{rows}").into_bytes();
    let text = |text: &str| text.as_bytes().to_vec();
    let line =
        |i: i32, scale: f64| format!("{},{},0,1\n", f64::from(i) / 100.0, f64::from(i) * scale);
    let cases = [
        ("empty", text("")),
        ("comments alone", text("# nothing\n\n# here\n")),
        ("a header alone", text(HEAD)),
        ("a header without line end", text(HEAD.trim_end())),
        (
            "time under another name",
            text("time,centre_x,centre_y,centre_z\n0,1,2,3\n"),
        ),
        ("no time", text("centre_x,centre_y,centre_z\n1,2,3\n")),
        ("a column missing", text("t,centre_x,centre_y\n0,1,2\n")),
        (
            "a marker that is not declared",
            text("t,centre_x,centre_y,centre_z,rim_x\n0,1,2,3,4\n"),
        ),
        (
            "a marker nearly declared",
            text("# made\n\nt,center_x,center_y,center_z\n0,1,2,3\n"),
        ),
        (
            "a marker in capitals",
            text("t,Centre_X,centre_y,centre_z\n0,1,2,3\n"),
        ),
        (
            "a column without a name",
            text("t,centre_x,centre_y,centre_z,\n0,1,2,3,\n"),
        ),
        (
            "a column twice",
            text("t,centre_x,centre_y,centre_z,centre_z\n0,1,2,3,4\n"),
        ),
        (
            "two times",
            text("t,centre_x,centre_y,centre_z,t\n0,1,2,3,4\n"),
        ),
        ("a table without a header", text("0,1,2,3\n0.1,1,2,3\n")),
        (
            "a header in two separators",
            text("t;centre_x,centre_y,centre_z\n0,1,2,3\n"),
        ),
        (
            "a header between bars",
            text("t|centre_x|centre_y|centre_z\n0|1|2|3\n"),
        ),
        ("too few cells", rows("0,1,2\n")),
        ("too many cells", rows("0,1,2,3\n0.1,1,2,3,4\n")),
        ("a word", rows("0,1,2,three\n")),
        (
            "a word after comments, in quotes",
            rows("# \"a\n\n\"0\",\"1\",  zwei,\"3\"\n"),
        ),
        ("a number beyond all numbers", rows("0,1,2,1e999\n")),
        ("infinity", rows("0,1,inf,3\n")),
        ("a hexadecimal number", rows("0,1,0x1F,3\n")),
        ("a typographic minus", rows("0,1,\u{2212}2,3\n")),
        (
            "decimal commas and decimal points",
            text("t;centre_x;centre_y;centre_z\n0;1.5;2;3\n0.1;1,500;2;3\n"),
        ),
        (
            "thousands with commas",
            text("t;centre_x;centre_y;centre_z\n0;1,234.5;2;3\n"),
        ),
        (
            "a missing cell between spaces",
            text("t centre_x centre_y centre_z\n 0   1.5  2\n"),
        ),
        (
            "a word between spaces",
            text("t   centre_x centre_y centre_z\n 0   1.5  zwei 3\n"),
        ),
        (
            "a control character of another encoding",
            b"t,centre_x,centre_y,centre_z\n0,1,\x96 2,3\n".to_vec(),
        ),
        ("decimal commas between commas", rows("0,0,1,5,2,0,3,0\n")),
        (
            "a cell longer than a message",
            rows(&format!("0,{},2,3\n", "9a".repeat(100))),
        ),
        ("a row without time", rows(",1,2,3\n")),
        ("a time that is no number", rows("nan,1,2,3\n")),
        ("one time twice", rows("0.1,1,2,3\n0.1,1,2,3\n")),
        (
            "time that runs back",
            rows("0.1,1,2,3\n\n# here\n0.0,1,2,3\n"),
        ),
        ("time in milliseconds", rows("0,1,2,3\n1500,1,2,3\n")),
        ("positions in millimetres", rows("0,1234567,2,3\n")),
        (
            "speeds in millimetres",
            rows(&(0..9).map(|i| line(i, 140.0)).collect::<String>()),
        ),
        ("dropouts alone", rows("0,,,\n0.1,NaN,NaN,NaN\n")),
        (
            "points with a coordinate missing alone",
            rows("0,1,2,\n0.1,1,2,\n"),
        ),
        (
            "a quote left open",
            rows("0,\"1,2,3\n0.1,1,2,3\n0.2,1,2,3\n"),
        ),
        ("a quote left open in the last row", rows("0,1,2,\"3")),
        ("a line break in a cell", rows("0,\"1\n\",2,3\n")),
        (
            "a byte that is no UTF-8",
            b"t,centre_x,centre_y,centre_z\n0,1,2,\xff\n".to_vec(),
        ),
        ("a NUL byte", rows("0,1,\0,3\n")),
        ("UTF-16", b"\xff\xfet\0,\0".to_vec()),
        ("a C3D file under another name", vec![2, 0x50, 0, 0, 0, 0]),
    ];
    let cases = cases
        .iter()
        .map(|(name, table)| (*name, read_both(MANIFEST.as_bytes(), table)));
    insta::assert_snapshot!(told(cases.collect()));
}

#[test]
fn markers_declared_in_metres_and_tracked_in_millimetres() {
    let manifest = MANIFEST.replace(
        "[[flights]]",
        "[[markers]]\nname = \"rim\"\nposition = [0.1, 0, 0]\n[[flights]]",
    );
    let table =
        "t,centre_x,centre_y,centre_z,rim_x,rim_y,rim_z\n0,0,0,0,100,0,0\n0.1,0,0,0,99,1,0\n";
    let error = read_both(manifest.as_bytes(), table.as_bytes()).expect_err("millimetres");
    insta::assert_snapshot!(error, @"a.csv: found centre and rim 99.503 m apart, declared 0.100 m apart, expected positions in metres (millimetres given for metres? then length = \"mm\" of [recording])");
    for (x, note) in [
        (
            "10",
            "(centimetres given for metres? then length = \"cm\" of [recording])",
        ),
        (
            "3.937",
            "(inches given for metres? then length = \"in\" of [recording])",
        ),
        ("20", "(another unit given for metres?)"),
    ] {
        let table = format!("t,centre_x,centre_y,centre_z,rim_x,rim_y,rim_z\n0,0,0,0,{x},0,0\n");
        let error = read_both(manifest.as_bytes(), table.as_bytes()).expect_err(x);
        assert!(error.contains(note), "{error}");
    }
    // A distance alone may be 3.28 times too large by chance, several are not.
    let table = "t,centre_x,centre_y,centre_z,rim_x,rim_y,rim_z\n0,0,0,0,0.328,0,0\n";
    read_both(manifest.as_bytes(), table.as_bytes()).expect("too few markers");
    let third = "[[markers]]\nname = \"left\"\nposition = [0, 0.1, 0]\n[[flights]]";
    let manifest = manifest.replace("[[flights]]", third);
    let table = "t,centre_x,centre_y,centre_z,rim_x,rim_y,rim_z,left_x,left_y,left_z\n\
        0,0,0,0,0.328,0,0,0,0.328,0\n";
    let error = read_both(manifest.as_bytes(), table.as_bytes()).expect_err("feet");
    assert!(
        error.contains("(feet given for metres? then length = \"ft\""),
        "{error}"
    );
}

#[test]
fn files_and_folders() {
    let empty = folder(&[]);
    let is_folder = folder(&[("dataset.toml/a", b""), ("b", b"")]);
    let table_is_folder = folder(&[("dataset.toml", MANIFEST.as_bytes()), ("a.csv/b", b"")]);
    let large = folder(&[("dataset.toml", MANIFEST.as_bytes()), ("a.csv", b"")]);
    // Sparse: no disk is filled.
    let table = std::fs::File::create(large.path().join("a.csv")).expect("a file");
    table.set_len((1 << 30) + 1).expect("a long file");
    let long = folder(&[("dataset.toml", &[b'#'; (4 << 20) + 1])]);
    let from = |folder: &Path, name: &str| {
        let around = format!("{}/", folder.display());
        read(&folder.join(name)).map_err(|error| error.replace(&around, ""))
    };
    let cases = vec![
        ("no folder", from(empty.path(), "nowhere")),
        ("an empty folder", read(empty.path())),
        ("a file for a folder", from(is_folder.path(), "b")),
        ("a manifest that is a folder", read(is_folder.path())),
        ("a table that is a folder", read(table_is_folder.path())),
        ("a table beyond a gibibyte", read(large.path())),
        ("a manifest beyond four mebibytes", read(long.path())),
    ];
    insta::assert_snapshot!(told(cases));
}

#[cfg(unix)]
#[test]
fn links_are_followed_and_devices_are_not_read() {
    let folder = folder(&[
        ("dataset.toml", MANIFEST.as_bytes()),
        ("b", TABLE.as_bytes()),
    ]);
    let link = folder.path().join("a.csv");
    std::os::unix::fs::symlink(folder.path().join("b"), &link).expect("a link");
    read(folder.path()).expect("a linked table");
    std::fs::remove_file(&link).expect("removed");
    std::os::unix::fs::symlink("/dev/zero", &link).expect("a link");
    let error = read(folder.path()).expect_err("it never ends");
    assert_eq!(error, "a.csv: found no ordinary file, expected a table");
}

#[test]
fn c3d_files() {
    let good = File::new(&["centre"], vec![vec![Some([1.0, 2.0, 3.0])]; 4]);
    let changed = |change: &dyn Fn(&mut File)| {
        let mut file = good.clone();
        change(&mut file);
        file.bytes()
    };
    let spoiled = |at: usize, with: &[u8]| {
        let mut bytes = good.bytes();
        bytes[at..at + with.len()].copy_from_slice(with);
        bytes
    };
    let cut = |length: usize| good.bytes()[..length].to_vec();
    let cases = [
        ("empty", Vec::new()),
        (
            "a table under the name of a C3D file",
            [TABLE; 40].concat().into_bytes(),
        ),
        ("the parameters nowhere", spoiled(0, &[0])),
        ("the parameters beyond the end", spoiled(0, &[200])),
        ("an unknown machine", spoiled(512 + 3, &[99])),
        ("a group that ends in itself", spoiled(512 + 11, &[1, 0])),
        ("the data before the parameters", spoiled(16, &[1, 0])),
        ("the data beyond the end", spoiled(16, &[0xff, 0xff])),
        ("frames that run back", spoiled(6, &[9, 0])),
        ("more frames than the file holds", spoiled(8, &[0xfe, 0xff])),
        (
            "more points than the parameters say",
            spoiled(2, &[0xff, 0xff]),
        ),
        ("cut in the header", cut(300)),
        ("cut in the parameters", cut(600)),
        ("cut in the data", cut(good.bytes().len() - 1)),
        ("no unit", changed(&|file| file.units = None)),
        (
            "an unknown unit",
            changed(&|file| file.units = Some("inch".into())),
        ),
        ("no rate", changed(&|file| file.rate = 0.0)),
        ("a negative rate", changed(&|file| file.rate = -120.0)),
        ("two rates", spoiled(20, &50.0_f32.to_le_bytes())),
        ("two scales", spoiled(12, &0.5_f32.to_le_bytes())),
        (
            "a scale that is no number",
            changed(&|file| file.scale = f32::NAN),
        ),
        (
            "a declared marker missing",
            changed(&|file| file.labels = vec!["rim".into()]),
        ),
        ("a declared marker twice", {
            let labels = ["centre", "centre"];
            File::new(&labels, vec![vec![Some([1.0; 3]); 2]; 2]).bytes()
        }),
        ("a point at infinity", {
            File::new(&["centre"], vec![vec![Some([f32::INFINITY, 0.0, 0.0])]]).bytes()
        }),
        (
            "dropouts alone",
            File::new(&["centre"], vec![vec![None]; 3]).bytes(),
        ),
        ("a parameter longer than the file", {
            changed(&|file| file.more = vec![("LONG", 4, vec![255; 7], Vec::new())])
        }),
        ("a parameter of no kind", {
            changed(&|file| file.more = vec![("ODD", 3, Vec::new(), vec![0; 3])])
        }),
    ];
    let manifest = MANIFEST.replace("a.csv", "a.c3d");
    let cases = cases.iter().map(|(name, bytes)| {
        let folder = folder(&[("dataset.toml", manifest.as_bytes()), ("a.c3d", bytes)]);
        (*name, read(folder.path()))
    });
    insta::assert_snapshot!(told(cases.collect()));
}
