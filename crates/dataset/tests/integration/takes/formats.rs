//! One motion in every format: each reader gives the same positions, poses and times.

use super::support::{self, LABELS, RATE, SAMPLES, attitude, read, truth};
use dataset::takes::{Axis, Format, LengthUnit, ReadOptions, Take, TimeUnit};

pub fn options() -> ReadOptions {
    ReadOptions::default()
}

#[track_caller]
pub fn has_times(take: &Take, start: f64) {
    assert_eq!(take.times.len(), SAMPLES);
    for (sample, time) in take.times.iter().enumerate() {
        assert!((time - start - sample as f64 / RATE).abs() < 1e-9, "{time}");
    }
}

#[track_caller]
fn is_near(found: Option<[f64; 3]>, wanted: Option<[f64; 3]>, what: &str) {
    match (found, wanted) {
        (None, None) => {}
        (Some(a), Some(b)) => {
            let far = a.iter().zip(b).any(|(a, b)| (a - b).abs() > 1e-6);
            assert!(!far, "{what}: {a:?} {b:?}");
        }
        other => panic!("{what}: {other:?}"),
    }
}

#[track_caller]
pub fn has_points(take: &Take, labels: &[&str]) {
    let found: Vec<&str> = take
        .points
        .iter()
        .map(|point| point.label.as_str())
        .collect();
    assert_eq!(found, labels);
    for (number, point) in take.points.iter().enumerate() {
        assert_eq!(point.positions.len(), SAMPLES);
        for (sample, position) in point.positions.iter().enumerate() {
            let what = format!("{} in sample {sample}", point.label);
            is_near(*position, truth(sample, number), &what);
        }
    }
}

#[track_caller]
fn has_poses(take: &Take, label: &str) {
    let [body] = &take.bodies[..] else {
        panic!("{} bodies", take.bodies.len());
    };
    assert_eq!((body.label.as_str(), body.poses.len()), (label, SAMPLES));
    for (sample, pose) in body.poses.iter().enumerate() {
        let wanted = (sample != 4).then(|| truth(sample, 0)).flatten();
        is_near(pose.map(|pose| pose.position), wanted, label);
        let Some(pose) = pose else { continue };
        let q = attitude(sample);
        let dot: f64 = q.iter().zip(pose.quaternion).map(|(a, b)| a * b).sum();
        assert!(dot.abs() > 1.0 - 1e-9, "{q:?} {:?}", pose.quaternion);
    }
}

#[test]
fn c3d() {
    let take = read(&support::c3d().bytes(), &options()).expect("read");
    assert_eq!(
        (take.format, take.length),
        (Format::C3d, LengthUnit::Millimetre)
    );
    has_times(&take, 1.0 / RATE);
    has_points(&take, &LABELS);
    assert!(take.notes.is_empty(), "{:?}", take.notes);
}

#[test]
fn vicon() {
    let take = read(support::vicon().as_bytes(), &options()).expect("read");
    assert_eq!(take.format, Format::Vicon);
    has_times(&take, 1.0 / RATE);
    has_points(&take, &LABELS);
    let around = format!(
        "Devices\n1000\n,,Plate\nFrame,Sub Frame,Fx\n,,N\n1,0,3\n\n{}\nModel Outputs\n120\n",
        support::vicon()
    );
    let take = read(around.as_bytes(), &options()).expect("read");
    has_points(&take, &LABELS);
    assert!(
        take.notes.iter().any(|note| note.contains("Devices")),
        "{:?}",
        take.notes
    );
}

#[test]
fn qualisys() {
    for (with_times, with_titles) in [(false, false), (true, false), (true, true), (false, true)] {
        let text = support::qualisys(with_times, with_titles);
        let take = read(text.as_bytes(), &options()).expect("read");
        assert_eq!(take.format, Format::Qualisys);
        has_times(&take, 0.0);
        has_points(&take, &LABELS);
        let gaps = take.points.iter().flat_map(|own| &own.positions);
        let gaps = gaps.filter(|own| own.is_none()).count();
        let note = format!("{gaps} positions of exactly 0, 0, 0 were read as not seen");
        assert!(gaps > 0 && take.notes.contains(&note), "{:?}", take.notes);
        let seen = text.replace("0.000", "0.001");
        let seen = read(seen.as_bytes(), &options()).expect("read");
        assert!(!seen.notes.iter().any(|own| own.contains("not seen")));
    }
    let take = read(support::qualisys_poses().as_bytes(), &options()).expect("read");
    assert_eq!(take.format, Format::QualisysPoses);
    has_times(&take, 0.0);
    has_poses(&take, "disc");
}

#[test]
fn optitrack() {
    let take = read(support::optitrack().as_bytes(), &options()).expect("read");
    assert_eq!(
        (take.format, take.length),
        (Format::OptiTrack, LengthUnit::Metre)
    );
    has_times(&take, 0.0);
    has_points(&take, &LABELS);
    has_poses(&take, "disc");
    assert_eq!(take.up, None);
}

#[test]
fn dltdv() {
    let error = read(support::dltdv().as_bytes(), &options()).expect_err("no times");
    assert!(error.contains("--rate"), "{error}");
    let mut chosen = options();
    chosen.rate = Some(RATE);
    let error = read(support::dltdv().as_bytes(), &chosen).expect_err("no unit");
    assert!(error.contains("--length"), "{error}");
    chosen.length = Some(LengthUnit::Metre);
    let take = read(support::dltdv().as_bytes(), &chosen).expect("read");
    assert_eq!(take.format, Format::Dltdv);
    has_times(&take, 0.0);
    has_points(&take, &["pt1", "pt2", "pt3"]);
}

#[test]
fn tables() {
    let take = read(support::poses().as_bytes(), &options()).expect("read");
    assert_eq!(take.format, Format::Poses);
    has_times(&take, 0.0);
    has_poses(&take, "body");
    let take = read(support::plain().as_bytes(), &options()).expect("read");
    assert_eq!(
        (take.format, take.length),
        (Format::Plain, LengthUnit::Millimetre)
    );
    has_times(&take, 0.0);
    has_points(&take, &LABELS);
    // Other separators, decimal commas, a byte-order mark, comments, CR LF.
    let text = support::plain().replace(',', ";").replace('.', ",");
    let text = format!("\u{feff}# made\n\n{text}").replace('\n', "\r\n");
    let take = read(text.as_bytes(), &options()).expect("read");
    has_times(&take, 0.0);
    has_points(&take, &LABELS);
    // Where spaces separate cells, a name with spaces is in quotes and a missing value is a word.
    let filled = |cell: &str| match cell {
        "" => "NA".to_owned(),
        name if name.contains(' ') => format!("\"{name}\""),
        number => number.to_owned(),
    };
    let row = |line: &str| line.split(',').map(filled).collect::<Vec<_>>().join("  ");
    let text: String = support::plain()
        .lines()
        .map(|line| row(line) + "\n")
        .collect();
    let take = read(text.as_bytes(), &options()).expect("read");
    has_points(&take, &LABELS);
    // One comma for the decimals, one for the thousands.
    let mixed = "t_s;m1_x_mm;m1_y_mm;m1_z_mm\n0;1.5;2;3\n1;1,500;2;3\n";
    let error = read(mixed.as_bytes(), &options()).expect_err("two decimal marks");
    assert!(error.contains("one decimal mark"), "{error}");
}

/// A table of poses of one motion with other names of its columns.
fn poses_named(header: &str) -> String {
    let poses = support::poses();
    let (_, rows) = poses.split_once('\n').expect("a header");
    format!("{header}\n{rows}")
}

#[test]
fn headers_of_other_programs() {
    let header = support::poses();
    let header = header.lines().next().expect("a header");
    assert_eq!(header, "t_s,x_m,y_m,z_m,qw,qx,qy,qz");
    let mut chosen = options();
    chosen.length = Some(LengthUnit::Metre);
    chosen.time = Some(TimeUnit::Second);
    for names in [
        "timestamp,tx,ty,tz,qw,qx,qy,qz",
        "# timestamp,tx,ty,tz,qw,qx,qy,qz",
        "# of a robot\n# timestamp,tx,ty,tz,qw,qx,qy,qz",
        "%time,p.position.x,p.position.y,p.position.z,p.orientation.w,p.orientation.x,p.orientation.y,p.orientation.z",
        "t,x,y,z,w,i,j,k",
    ] {
        let take = read(poses_named(names).as_bytes(), &chosen).expect(names);
        assert_eq!(take.format, Format::Poses, "{names}");
        has_times(&take, 0.0);
        has_poses(&take, if names.starts_with('%') { "p" } else { "body" });
    }
    let points = "t_s,X1,Y1,Z1,X2,Y2,Z2\n0,1,2,3,4,5,6\n1,1,2,3,4,5,6\n";
    let take = read(points.as_bytes(), &chosen).expect(points);
    let labels: Vec<&str> = take.points.iter().map(|own| own.label.as_str()).collect();
    assert_eq!(labels, ["1", "2"]);
    assert_eq!(take.points[1].positions[0], Some([4.0, 5.0, 6.0]));
    chosen.time = None;
    let bag = "%time,p.x,p.y,p.z\n1700000000000000000,1,2,3\n1700000000500000000,1,2,3\n";
    let take = read(bag.as_bytes(), &chosen).expect(bag);
    assert!((take.times[1] - take.times[0] - 0.5).abs() < 1e-6);
}

#[test]
fn one_number_for_all_coordinates_is_a_point_that_is_not_seen() {
    let header = "t_s,m1_x_mm,m1_y_mm,m1_z_mm,m2_x_mm,m2_y_mm,m2_z_mm\n";
    for word in ["0", "-9999", "9999.999"] {
        let gap = [word; 3].join(",");
        let rows = format!("0,1,2,3,{gap}\n1,{gap},4,5,6\n2,7,7,7,1,2,3\n");
        let take = read(format!("{header}{rows}").as_bytes(), &options()).expect(word);
        assert_eq!(take.points[0].positions[1], None, "{word}");
        assert_eq!(take.points[1].positions[0], None, "{word}");
        // Once, it may be a position.
        assert!(take.points[0].positions[2].is_some(), "{word}");
        let noted = |note: &String| note.contains("2 positions") && note.contains(word);
        assert!(take.notes.iter().any(noted), "{:?}", take.notes);
    }
}

#[test]
fn columns_of_other_programs_and_a_line_for_spreadsheets_are_read() {
    let rows = "0;1;2;3\n10;1;2;4\n";
    for header in [
        "sep=;\ntime_us;m1_x_mm;m1_y_mm;m1_z_mm",
        "Time (µs);m1-X [mm];m1-Y [mm];m1-Z [mm]",
        "TIME_US;m1 - X (MM);m1 - Y (MM);m1 - Z (MM)",
        "TIME_US;m1_X_MM;m1_Y_MM;m1_Z_MM",
    ] {
        let take = read(format!("{header}\n{rows}").as_bytes(), &options()).expect(header);
        assert_eq!(take.points[0].label, "m1", "{header}");
        assert!((take.times[1] - 1e-5).abs() < 1e-12, "{header}");
        assert_eq!(
            take.points[0].positions[1],
            Some([0.001, 0.002, 0.004]),
            "{header}"
        );
    }
    let error = read(
        format!("Zeit;m1_x_mm;m1_y_mm;m1_z_mm\n{rows}").as_bytes(),
        &options(),
    );
    let error = error.expect_err("no times");
    assert!(error.contains("Zeit") && error.contains("t_s"), "{error}");
}

#[test]
fn rounded_times_of_frames_are_evenly_spaced() {
    let mut text = "t_s,m1_x_m,m1_y_m,m1_z_m\n".to_owned();
    for frame in 0..100 {
        text += &format!("{:.3},1,2,{frame}\n", f64::from(frame) / 240.0);
    }
    let take = read(text.as_bytes(), &options()).expect("read");
    for (frame, time) in take.times.iter().enumerate() {
        assert!((time - frame as f64 / 240.0).abs() < 2e-4, "{time}");
    }
    let noted = |note: &String| note.contains("rounded to 0.001 s");
    assert!(take.notes.iter().any(noted), "{:?}", take.notes);
}

#[test]
fn euler_angles_are_refused() {
    let mut chosen = options();
    chosen.length = Some(LengthUnit::Metre);
    for header in [
        "t_s,x,y,z,roll,pitch,yaw",
        "t_s,disc_x,disc_y,disc_z,disc_roll_deg,disc_pitch_deg,disc_yaw_deg",
        "t_s,disc_x,disc_y,disc_z,Roll (deg),Pitch (deg),Yaw (deg)",
    ] {
        let text = format!("{header}\n0,1,2,3,4,5,6\n");
        let error = read(text.as_bytes(), &chosen).expect_err(header);
        assert!(error.contains("export quaternions"), "{error}");
    }
    let with_both = "t_s,x,y,z,qw,qx,qy,qz,roll\n0,1,2,3,1,0,0,0,5\n";
    let take = read(with_both.as_bytes(), &chosen).expect(with_both);
    let noted = take.notes.iter().any(|note| note.contains("roll"));
    assert!(noted, "{:?}", take.notes);
}

#[test]
fn units_come_from_the_file_or_an_option() {
    let bare = "t,m1_x,m1_y,m1_z\n0,1,2,3\n10,2,2,3\n";
    let mut chosen = options();
    let error = read(bare.as_bytes(), &chosen).expect_err("no unit of time");
    assert!(error.contains("--time"), "{error}");
    chosen.time = Some(TimeUnit::Millisecond);
    let error = read(bare.as_bytes(), &chosen).expect_err("no unit of length");
    assert!(error.contains("--length"), "{error}");
    chosen.length = Some(LengthUnit::Inch);
    let take = read(bare.as_bytes(), &chosen).expect("read");
    assert_eq!(take.times[1], 0.01);
    assert_eq!(
        take.points[0].positions[0],
        Some([0.0254, 2.0 * 0.0254, 3.0 * 0.0254])
    );
    // A statement of the file that is set aside is noted.
    chosen.length = Some(LengthUnit::Metre);
    let take = read(support::vicon().as_bytes(), &chosen).expect("read");
    assert_eq!(take.length, LengthUnit::Metre);
    assert!(
        take.notes.iter().any(|note| note.contains("--length")),
        "{:?}",
        take.notes
    );
}

#[test]
fn what_programs_write_wrongly_is_read_with_a_note() {
    let stated = support::qualisys(false, false).replace("NO_OF_FRAMES\t12", "NO_OF_FRAMES\t13");
    let cut = support::vicon()
        .trim_end()
        .rsplit_once(',')
        .expect("cells")
        .0
        .to_owned();
    let mut blanks = support::c3d();
    blanks.labels[1] = String::new();
    let mut twice = support::c3d();
    twice.labels[2] = "m1".into();
    let mut unit = support::c3d();
    unit.units = Some("mill".into());
    let mut more = support::c3d().bytes();
    // The last frame in the header, and the count of the parameters.
    more[8] = 13;
    let mut reaching = support::c3d();
    reaching.more = vec![("LONG", -1, vec![200, 4], Vec::new())];
    let cut_c3d = support::c3d().bytes();
    let cut_c3d = &cut_c3d[..cut_c3d.len() - 10];
    let cases: [(&str, Vec<u8>, &str, usize); 8] = [
        (
            "a count off by one",
            stated.into_bytes(),
            "states 13 frames and holds 12",
            12,
        ),
        ("a row that is cut", cut.into_bytes(), "is cut", 11),
        (
            "a point without a label",
            blanks.bytes(),
            "1 points without a label",
            12,
        ),
        (
            "a label twice",
            twice.bytes(),
            "a second \"m1\" is called \"m1#2\"",
            12,
        ),
        ("a unit cut short", unit.bytes(), "read as mm", 12),
        (
            "a frame more in the header",
            more,
            "the 12 whole frames",
            12,
        ),
        (
            "a parameter that reaches into the data",
            reaching.bytes(),
            "the parameters before it",
            12,
        ),
        (
            "a frame that is cut",
            cut_c3d.to_vec(),
            "the 11 whole frames",
            11,
        ),
    ];
    for (name, bytes, note, samples) in cases {
        let take = read(&bytes, &options()).expect(name);
        assert!(
            take.notes.iter().any(|it| it.contains(note)),
            "{name}: {:?}",
            take.notes
        );
        assert_eq!(take.times.len(), samples, "{name}");
    }
}

#[test]
fn a_sample_of_nothing_is_a_sample_where_rows_are_counted() {
    let rows = "pt1_X,pt1_Y,pt1_Z\n0,0,1\n,,\n0,0,3\n";
    let mut chosen = options();
    (chosen.rate, chosen.length) = (Some(10.0), Some(LengthUnit::Metre));
    let take = read(rows.as_bytes(), &chosen).expect("read");
    assert_eq!(take.times, [0.0, 0.1, 0.2]);
    assert_eq!(take.points[0].positions[1], None);
}

#[test]
fn a_mirrored_take_is_put_right() {
    // A point to the right of another, seen along the flight, stays there.
    let text = "t_s,a_x_m,a_y_m,a_z_m,b_x_m,b_y_m,b_z_m\n0,0,1,0,1,1,0\n0.1,0,1,1,1,1,1\n";
    let take = read(text.as_bytes(), &options()).expect("read");
    let up = Axis::parse("+y").expect("an axis");
    let turned = |left_handed| {
        let take = take.clone().with_z_up(up, left_handed);
        let at = |i: usize, sample: usize| take.points[i].positions[sample].expect("seen");
        let (a, b, later) = (at(0, 0), at(1, 0), at(0, 1));
        let forward = [later[0] - a[0], later[1] - a[1]];
        let side = [b[0] - a[0], b[1] - a[1]];
        (a[2], forward[0] * side[1] - forward[1] * side[0])
    };
    // x right, y up, z forward is left-handed; x left, y up, z forward right-handed.
    assert_eq!(turned(true), (1.0, -1.0));
    assert_eq!(turned(false), (1.0, 1.0));
}
