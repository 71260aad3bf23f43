//! C3D files that real programs wrote; skipped where they are absent.

use std::path::PathBuf;

use dataset::takes::{LengthUnit, ReadOptions, Take, read};

/// Folder of measured C3D recordings beside the repository; `None`, with a message on standard error, if it is missing.
fn recordings() -> Option<PathBuf> {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let folder = root.join("../../../shared/data/c3d");
    if folder.is_dir() {
        return Some(folder);
    }
    eprintln!("skipped: no measured data c3d next to the repository");
    None
}

fn positions(take: &Take) -> impl Iterator<Item = (usize, usize, Option<[f64; 3]>)> {
    let points = take.points.iter().enumerate();
    points.flat_map(|(number, point)| {
        let each = point.positions.iter().enumerate();
        each.map(move |(frame, position)| (number, frame, *position))
    })
}

#[test]
fn six_forms_of_one_take_have_the_same_positions() {
    let Some(folder) = recordings() else { return };
    let forms = [
        "pc_real", "pc_int", "DEC_INT", "Dec_real", "sgi_int", "sgi_real",
    ]
    .map(|form| {
        let names = ["c3d", "C3D"].map(|ext| folder.join(format!("c3d.org_sample02_{form}.{ext}")));
        let file = names.into_iter().find(|name| name.is_file()).expect(form);
        read(&file, &ReadOptions::default()).expect(form)
    });
    let first = &forms[0];
    assert_eq!((first.points.len(), first.times.len()), (36, 89));
    assert!(first.notes.is_empty(), "{:?}", first.notes);
    let mut seen = 0;
    for other in &forms[1..] {
        assert_eq!(other.times, first.times);
        assert!(other.labels().eq(first.labels()));
        for (a, b) in positions(first).zip(positions(other)) {
            match (a.2, b.2) {
                (Some(a), Some(b)) => {
                    // Integers are within one step of the scale, 0.2812 mm.
                    let far = a.iter().zip(b).any(|(a, b)| (a - b).abs() > 2.82e-4);
                    assert!(!far, "{a:?} {b:?}");
                    seen += 1;
                }
                (None, None) => {}
                other => panic!("{other:?} of point {} in frame {}", a.0, a.1),
            }
        }
    }
    assert!(seen > 10_000, "{seen}");
}

#[test]
fn what_real_programs_wrote_wrongly_is_read_with_notes_or_refused() {
    let Some(folder) = recordings() else { return };
    let open = |name: &str, options: &ReadOptions| read(&folder.join(name), options);
    let noted = |name: &str, note: &str, points: usize, frames: usize| {
        let take = open(name, &ReadOptions::default()).expect(name);
        assert!(
            take.notes.iter().any(|it| it.contains(note)),
            "{name}: {:?}",
            take.notes
        );
        assert_eq!(
            (take.points.len(), take.times.len()),
            (points, frames),
            "{name}"
        );
        take
    };
    noted(
        "c3d.org_sample13_golfswing.c3d",
        "POINT:FRAMES = 515",
        29,
        514,
    );
    let take = noted("c3d.org_sample15_FP1.C3D", "\"mete\" was read as m", 8, 480);
    assert_eq!(take.length, LengthUnit::Metre);
    noted("ezc3d_Optotrak.c3d", "the 29 whole frames", 54, 29);
    noted(
        "c3d.org_sample24_MotionMonitorC3D.c3d",
        "112 analogue words",
        7,
        840,
    );
    noted("others_badParameterOffset.c3d", "are not scaled", 41, 111);
    let chosen = ReadOptions {
        length: Some(LengthUnit::Millimetre),
        ..ReadOptions::default()
    };
    let take = open("c3d.org_sample28_dynamic.C3D", &chosen).expect("labels with blanks");
    assert!(
        take.labels().any(|label| label == "r knee 1"),
        "{:?}",
        take.notes
    );
    noted(
        "c3d.org_sample18_bad_parameter_section.c3d",
        "read as the parameters before it",
        45,
        332,
    );
    // One program takes the scale of the header, another that of the parameters: two readings.
    let error = open("c3d.org_sample06_MACsample.c3d", &ReadOptions::default());
    assert!(
        error
            .expect_err("two scales")
            .to_string()
            .contains("POINT:SCALE")
    );
}

#[test]
fn every_recording_is_read_or_refused_with_a_reason() {
    let Some(folder) = recordings() else { return };
    let mut files: Vec<PathBuf> = std::fs::read_dir(folder)
        .expect("a folder")
        .map(|entry| entry.expect("an entry").path())
        .collect();
    files.sort();
    let mut refused = 0;
    for file in &files {
        match read(file, &ReadOptions::default()) {
            Ok(take) => eprintln!(
                "{}: {} points, {} frames, up {:?}, {:?}",
                file.file_name().unwrap_or_default().display(),
                take.points.len(),
                take.times.len(),
                take.up.map(|up| up.to_string()),
                take.notes
            ),
            Err(error) => {
                eprintln!("{error}");
                refused += 1;
            }
        }
    }
    assert!(refused <= 2, "{refused} of {} refused", files.len());
}

#[test]
fn force_platforms_say_what_is_up_before_the_screen_does() {
    let Some(folder) = recordings() else { return };
    let chosen = ReadOptions {
        length: Some(LengthUnit::Millimetre),
        ..ReadOptions::default()
    };
    let cases = [
        // The platforms and POINT:Y_SCREEN agree.
        ("c3d.org_sample02_pc_real.c3d", Some("+z"), None),
        ("ezc3d_Qualisys.c3d", Some("+z"), Some("draws -z upwards")),
        (
            "c3d.org_sample15_FP1.C3D",
            Some("+z"),
            Some("by the corners"),
        ),
        (
            "c3d.org_sample24_MotionMonitorC3D.c3d",
            Some("+y"),
            Some("by the corners"),
        ),
        (
            "c3d.org_sample28_dynamic.C3D",
            Some("+y"),
            Some("by the corners"),
        ),
        (
            "c3d.org_sample13_golfswing.c3d",
            Some("+z"),
            Some("by POINT:Y_SCREEN"),
        ),
        ("others_MyCube.c3d", Some("+z"), Some("by POINT:Y_SCREEN")),
        ("ezc3d_Optotrak.c3d", None, None),
        ("others_Analysis.c3d", None, None),
    ];
    for (name, up, note) in cases {
        let take = read(&folder.join(name), &chosen).expect(name);
        assert_eq!(take.up.map(|up| up.to_string()).as_deref(), up, "{name}");
        let mut notes = take.notes.iter().filter(|it| it.contains(" up"));
        match note {
            Some(note) => assert!(
                notes.any(|it| it.contains(note)),
                "{name}: {:?}",
                take.notes
            ),
            None => assert_eq!(notes.next(), None, "{name}"),
        }
    }
}
