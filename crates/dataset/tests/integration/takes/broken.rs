//! Malformed recordings, each refused with its file, its place, what was found and what was expected.

use std::fmt::Write;

use super::support::{self, read};
use dataset::takes::{Format, LengthUnit, ReadOptions};

/// Parses each malformed recording, which must fail. Returns a text with the name of each case and its error message.
fn messages(cases: &[(&str, Vec<u8>)], options: &ReadOptions) -> String {
    let mut text = String::new();
    let mut names = std::collections::BTreeSet::new();
    for (name, bytes) in cases {
        assert!(names.insert(*name), "two cases {name}");
        let error = match read(bytes, options) {
            Err(error) => error,
            Ok(take) => panic!("{name}: read with {:?}", take.notes),
        };
        let _ = writeln!(text, "{name}\n    {error}");
    }
    text
}

/// Returns a text in which the first occurrence of `from` is replaced by `to`.
#[track_caller]
fn changed(text: &str, from: &str, to: &str) -> Vec<u8> {
    assert!(text.contains(from), "{from}");
    text.replacen(from, to, 1).into_bytes()
}

/// Returns a text in which the line `number` (from 1) is replaced by `with`.
fn line(text: &str, number: usize, with: &str) -> Vec<u8> {
    let lines = text.lines().zip(1..);
    let lines = lines.map(|(line, n)| if n == number { with } else { line });
    (lines.collect::<Vec<_>>().join("\n") + "\n").into_bytes()
}

fn none() -> ReadOptions {
    ReadOptions::default()
}

#[test]
fn unknown_files() {
    let cases = [
        ("empty", Vec::new()),
        ("blank lines", b"\n\n,,,\n".to_vec()),
        ("comments alone", b"# a\n# b\n".to_vec()),
        ("a letter", b"Dear sir,\nplease find enclosed\n".to_vec()),
        ("numbers alone", b"1,2,3\n4,5,6\n".to_vec()),
        ("a workbook", b"PK\x03\x04 and so on".to_vec()),
        ("a MATLAB file", b"MATLAB 5.0 MAT-file, Platform".to_vec()),
        ("UTF-16", b"\xff\xfet\0,\0".to_vec()),
        (
            "a byte that is no UTF-8",
            b"Trajectories\n120\n\xff\n".to_vec(),
        ),
        ("a NUL byte", b"Trajectories\n12\x000\n".to_vec()),
        ("a TRC file", b"PathFileType\t4\t(X/Y/Z)\n".to_vec()),
        (
            "releases",
            b"id,time,timeSeconds,speedMph,speedKmh\n1,2,3,4,5\n".to_vec(),
        ),
    ];
    insta::assert_snapshot!(messages(&cases, &none()));
}

#[test]
fn vicon() {
    let good = support::vicon();
    read(good.as_bytes(), &none()).expect("a good one");
    let cases = [
        ("the name of the section alone", b"Trajectories\n".to_vec()),
        ("no rate", line(&good, 2, "")),
        ("a rate of 0", line(&good, 2, "0")),
        ("a rate that is no number", line(&good, 2, "fast")),
        ("a negative rate", line(&good, 2, "-120")),
        ("no labels", line(&good, 3, ",,,,")),
        (
            "a label out of place",
            changed(&good, "disc:m2,,", ",disc:m2,"),
        ),
        ("no names of columns", line(&good, 4, "1,0,2,3")),
        (
            "a column missing",
            changed(&good, "X,Y,Z,X,Y,Z,X,Y,Z", "X,Y,Z,X,Y,Z,X,Y"),
        ),
        (
            "no units",
            changed(&good, ",,mm,mm,mm,mm,mm,mm,mm,mm,mm\n", ""),
        ),
        (
            "an unknown unit",
            changed(&good, "mm,mm,mm\n", "mm,mm,parsec\n"),
        ),
        ("two units", changed(&good, "mm,mm,mm\n", "mm,mm,cm\n")),
        (
            "no rows",
            good.lines()
                .take(5)
                .map(|l| format!("{l}\n"))
                .collect::<String>()
                .into_bytes(),
        ),
        (
            "a word among the numbers",
            changed(&good, "\n3,0,250,", "\n3,0,fast,"),
        ),
        ("a row too short", line(&good, 8, "3,0,250,-500")),
        (
            "a row too long",
            changed(&good, "\n3,0,250,", "\n3,0,1,250,"),
        ),
        ("a frame twice", changed(&good, "\n3,0,", "\n2,0,")),
        (
            "a frame that is no number",
            changed(&good, "\n3,0,", "\nx,0,"),
        ),
        (
            "a frame that is no whole number",
            changed(&good, "\n3,0,", "\n3.5,0,"),
        ),
        (
            "a coordinate beyond the earth",
            changed(&good, "\n3,0,250,", "\n3,0,2e9,"),
        ),
        ("infinity", changed(&good, "\n3,0,250,", "\n3,0,inf,")),
        (
            "a quote left open",
            changed(&good, "\n3,0,250,", "\n3,0,\"250,"),
        ),
        ("forces alone", changed(&good, "Trajectories", "Devices")),
    ];
    insta::assert_snapshot!(messages(&cases, &none()));
}

#[test]
fn qualisys() {
    let good = support::qualisys(true, true);
    read(good.as_bytes(), &none()).expect("a good one");
    let bare = support::qualisys(false, false);
    let poses = support::qualisys_poses();
    let at = |text: &str, start: &str| {
        1 + text
            .lines()
            .position(|l| l.starts_with(start))
            .expect("a line")
    };
    let cases = [
        (
            "no labels",
            changed(&good, "MARKER_NAMES\tm1\tm2\trim left\n", ""),
        ),
        (
            "a label missing",
            changed(&good, "\tm2\trim left\n", "\tm2\n"),
        ),
        (
            "an empty label",
            changed(&good, "NAMES\tm1\tm2", "NAMES\tm1\t"),
        ),
        (
            "no rate and no times",
            changed(&bare, "FREQUENCY\t120\n", ""),
        ),
        (
            "a rate that is no number",
            changed(&good, "FREQUENCY\t120", "FREQUENCY\tfast"),
        ),
        (
            "a count that is no number",
            changed(&good, "NO_OF_FRAMES\t12", "NO_OF_FRAMES\tmany"),
        ),
        (
            "a count of markers that is none",
            changed(&good, "NO_OF_MARKERS\t3", "NO_OF_MARKERS\t-3"),
        ),
        (
            "the header alone",
            b"NO_OF_FRAMES\t1\nNO_OF_MARKERS\t1\nFREQUENCY\t9\nMARKER_NAMES\tm1\n".to_vec(),
        ),
        (
            "a row too short",
            line(&good, at(&good, "3\t"), "3\t0.5\t1"),
        ),
        (
            "a row too long",
            line(&bare, at(&bare, "250\t"), "1\t2\t3\t4\t5\t6\t7\t8\t9\t10"),
        ),
        (
            "a time twice",
            changed(&good, "\n3\t0.01666", "\n3\t0.00000"),
        ),
        ("a word", changed(&good, "\t250\t", "\tfar\t")),
        (
            "one fixed column",
            line(&bare, at(&bare, "0\t"), "1\t2\t3\t4\t5\t6\t7\t8\t9\t10"),
        ),
        (
            "bodies without names",
            changed(&poses, "BODY_NAMES\tdisc\n", ""),
        ),
        (
            "a matrix that is none",
            changed(&poses, "\t1.000000000", "\t0.1"),
        ),
        (
            "a body cut short",
            line(&poses, at(&poses, "3\t"), "3\t0.5\t1\t2\t3"),
        ),
    ];
    insta::assert_snapshot!(messages(&cases, &none()));
}

#[test]
fn optitrack() {
    let good = support::optitrack();
    read(good.as_bytes(), &none()).expect("a good one");
    let remove = |start: &str| {
        let lines = good.lines().filter(|line| !line.starts_with(start));
        (lines.collect::<Vec<_>>().join("\n") + "\n").into_bytes()
    };
    let cases = [
        ("no unit", changed(&good, "Length Units,Meters,", "")),
        ("an unknown unit", changed(&good, "Meters", "Cubits")),
        (
            "local coordinates",
            changed(&good, "Space,Global", "Space,Local"),
        ),
        (
            "a count that is no number",
            changed(&good, "Exported Frames,12", "Exported Frames,all"),
        ),
        ("angles", {
            let angles = "Format Version,1.23,Rotation Type,XYZ,Length Units,Meters\n\n,Type,Rigid Body,Rigid Body,\
                Rigid Body,Rigid Body,Rigid Body,Rigid Body\n,Name,a,a,a,a,a,a\n,,Rotation,Rotation,Rotation,Position,\
                Position,Position\nFrame,Time (Seconds),X,Y,Z,X,Y,Z\n0,0,1,2,3,4,5,6\n";
            angles.as_bytes().to_vec()
        }),
        ("no line Type", remove(",Type")),
        ("no line Name", remove(",Name")),
        ("no line of kinds", remove(",,Rotation")),
        ("no axes", remove("Frame,Time")),
        ("no times", changed(&good, "Time (Seconds)", "Clock")),
        ("an axis of no name", changed(&good, "X,Y,Z\n", "X,Y,Q\n")),
        ("an axis twice", changed(&good, "X,Y,Z\n", "X,Y,Y\n")),
        (
            "no rows",
            good.split_inclusive('\n')
                .take(7)
                .collect::<String>()
                .into_bytes(),
        ),
        (
            "the properties alone",
            good.split_inclusive('\n')
                .take(1)
                .collect::<String>()
                .into_bytes(),
        ),
        (
            "a quaternion that is none",
            changed(&good, "\n0,0,0,0,0,1,", "\n0,0,0,0,0,2,"),
        ),
        (
            "a word",
            changed(&good, "\n0,0,0,0,0,1,", "\n0,0,0,0,0,one,"),
        ),
    ];
    insta::assert_snapshot!(messages(&cases, &none()));
}

#[test]
fn tables() {
    let poses = support::poses();
    let plain = support::plain();
    let text = |text: &str| text.as_bytes().to_vec();
    let cases = [
        ("a header alone", text("t_s,m1_x_m,m1_y_m,m1_z_m\n")),
        ("a coordinate missing", text("t_s,m1_x_m,m1_y_m\n0,1,2\n")),
        (
            "a column twice",
            text("t_s,m1_x_m,m1_x_m,m1_y_m,m1_z_m\n0,1,1,2,3\n"),
        ),
        (
            "two times",
            text("t_s,time_s,m1_x_m,m1_y_m,m1_z_m\n0,0,1,2,3\n"),
        ),
        (
            "two units of length",
            text("t_s,m1_x_m,m1_y_mm,m1_z_m\n0,1,2,3\n"),
        ),
        ("no unit of time", text("t,m1_x_m,m1_y_m,m1_z_m\n0,1,2,3\n")),
        ("no unit of length", text("t_s,m1_x,m1_y,m1_z\n0,1,2,3\n")),
        ("no times", text("m1_x_m,m1_y_m,m1_z_m\n1,2,3\n")),
        ("a time that runs back", changed(&plain, "\n25,", "\n5,")),
        ("a time that is missing", changed(&plain, "\n25,", "\n,")),
        ("a row too short", line(&plain, 4, "16,1,2")),
        ("a hexadecimal number", changed(&plain, "\n25,", "\n0x19,")),
        (
            "nothing seen",
            text("t_s,m1_x_m,m1_y_m,m1_z_m\n0,,,\n1,NaN,NaN,NaN\n"),
        ),
        (
            "a part of a quaternion missing",
            changed(&poses, ",qz\n", ",roll\n"),
        ),
        (
            "a quaternion of nothing",
            changed(&poses, ",1,0,0,0\n", ",0,0,0,0\n"),
        ),
        (
            "kilometres",
            text("t_s,m1_x_m,m1_y_m,m1_z_m\n0,123456,2,3\n"),
        ),
    ];
    let mut all = messages(&cases, &none());
    let mut options = none();
    (options.rate, options.length) = (Some(0.0), Some(LengthUnit::Metre));
    all += &messages(
        &[("a rate of 0 by the option", support::dltdv().into_bytes())],
        &options,
    );
    options.rate = Some(120.0);
    options.format = Some(Format::Dltdv);
    all += &messages(
        &[(
            "another table under the format dltdv",
            text("a_x,a_y,a_z\n1,2,3\n"),
        )],
        &options,
    );
    options.format = Some(Format::Poses);
    all += &messages(
        &[("points under the format poses", plain.clone().into_bytes())],
        &options,
    );
    options.format = Some(Format::C3d);
    all += &messages(
        &[("a table under the format c3d", plain.into_bytes())],
        &options,
    );
    insta::assert_snapshot!(all);
}

#[test]
fn c3d() {
    let good = support::c3d();
    read(&good.bytes(), &none()).expect("a good one");
    let with = |change: &dyn Fn(&mut support::c3d::File)| {
        let mut file = good.clone();
        change(&mut file);
        file.bytes()
    };
    let spoiled = |at: usize, bytes: &[u8]| {
        let mut whole = good.bytes();
        whole[at..at + bytes.len()].copy_from_slice(bytes);
        whole
    };
    let cases = [
        ("cut in the header", good.bytes()[..300].to_vec()),
        (
            "cut before the first frame",
            good.bytes()[..1024 + 20].to_vec(),
        ),
        ("the parameters beyond the end", spoiled(0, &[8])),
        ("an unknown machine", spoiled(512 + 3, &[99])),
        ("the data before the parameters", spoiled(16, &[1, 0])),
        ("frames that run back", spoiled(6, &[99, 0])),
        ("many more frames in the header", spoiled(8, &[200, 0])),
        ("two numbers of points", spoiled(2, &[9, 0])),
        ("no unit", with(&|file| file.units = None)),
        (
            "an unknown unit",
            with(&|file| file.units = Some("yard".into())),
        ),
        (
            "a unit cut too short",
            with(&|file| file.units = Some("mi".into())),
        ),
        ("no rate", with(&|file| file.rate = 0.0)),
        ("two rates", spoiled(20, &50.0_f32.to_le_bytes())),
        ("two scales of integers", {
            let mut bytes = with(&|file| file.scale = 0.1);
            bytes[12..16].copy_from_slice(&0.5_f32.to_le_bytes());
            bytes
        }),
        (
            "a scale that is no number",
            with(&|file| file.scale = f32::NAN),
        ),
        (
            "a point at infinity",
            with(&|file| file.frames[2][0] = Some([f32::INFINITY, 0.0, 0.0])),
        ),
        (
            "nothing seen",
            with(&|file| {
                for row in &mut file.frames {
                    row.fill(None);
                }
            }),
        ),
        ("a parameter longer than the file", {
            with(&|file| file.more = vec![("LONG", 4, vec![255; 7], Vec::new())])
        }),
    ];
    insta::assert_snapshot!(messages(&cases, &none()));
}

#[test]
fn digitised_points() {
    let good = support::dltdv();
    let mut options = none();
    (options.rate, options.length) = (Some(120.0), Some(LengthUnit::Metre));
    read(good.as_bytes(), &options).expect("a good one");
    let head = good.lines().next().expect("a header");
    let cases = [
        ("the header alone", format!("{head}\n").into_bytes()),
        ("a coordinate missing", changed(&good, "pt2_Z", "pt2_Y2")),
        ("a point twice", changed(&good, "pt2_X", "pt1_X")),
        ("a row too short", line(&good, 3, "1,2,3,4")),
        ("a row too long", line(&good, 3, "1,2,3,4,5,6,7,8,9,10")),
        ("a word", line(&good, 3, "1,2,3,4,far,6,7,8,9")),
        ("infinity", line(&good, 3, "1,2,3,4,inf,6,7,8,9")),
        ("kilometres", line(&good, 3, "1,2,3,4,1e7,6,7,8,9")),
        (
            "a decimal comma between commas",
            line(&good, 3, "\"1,5\",2,3,4,5,6,7,8,9"),
        ),
        ("a quote left open", line(&good, 3, "1,2,3,\"4,5,6,7,8,9")),
    ];
    insta::assert_snapshot!(messages(&cases, &options));
}
