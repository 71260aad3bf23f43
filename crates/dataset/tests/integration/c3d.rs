//! C3D files are read as they were written, and no spoiled one does harm.

use std::time::{Duration, Instant};

use crate::support::c3d::File;
use crate::support::{folder, read};
use dataset::Dataset;

const MANIFEST: &str = r#"model = "disc"
[[markers]]
name = "m2"
position = [0.1, 0.0, 0.0]
[[markers]]
name = "m1"
position = [0.0, 0.1, 0.0]
[[flights]]
file = "trial.c3d"
"#;

fn read_trial(bytes: &[u8]) -> Result<Dataset, String> {
    read(folder(&[("dataset.toml", MANIFEST.as_bytes()), ("trial.c3d", bytes)]).path())
}

/// A C3D file in millimetres, with a label that the dataset does not declare, and with a missing position.
fn trial() -> File {
    let row = |frame: u8| {
        let x = 10.0 * f32::from(frame);
        let rim = (frame != 3).then_some([x + 0.2, 123.4, 1500.6]);
        vec![Some([x, 0.5, 1500.0]), Some([1.0, 2.0, 3.0]), rim]
    };
    let mut file = File::new(&["m1", "elbow", "m2"], (0..9).map(row).collect());
    file.first = 25;
    file
}

#[track_caller]
fn assert_is_trial(dataset: &Dataset, tolerance: f64) {
    let flight = &dataset.flights[0];
    assert_eq!(flight.times.len(), 9);
    for (frame, (time, row)) in flight.times.iter().zip(&flight.positions).enumerate() {
        assert!(
            (time - (25.0 + frame as f64) / 120.0).abs() < 1e-12,
            "{time}"
        );
        let x = 0.01 * frame as f64;
        let close = |found: Option<[f64; 3]>, expected: [f64; 3]| {
            let found = found.expect("seen");
            let far = found
                .iter()
                .zip(expected)
                .any(|(a, b)| (a - b).abs() > tolerance);
            assert!(!far, "{found:?} {expected:?}");
        };
        close(row[1], [x, 0.0005, 1.5]);
        if frame == 3 {
            assert_eq!(row[0], None);
        } else {
            close(row[0], [x + 0.0002, 0.1234, 1.5006]);
        }
    }
}

#[test]
fn what_was_written_is_read() {
    assert_is_trial(&read_trial(&trial().bytes()).expect("a good file"), 1e-6);
}

#[test]
fn integers_other_machines_other_units_and_analogue_channels_make_no_difference() {
    let mut integers = trial();
    integers.scale = 0.1;
    integers.analog = 7;
    assert_is_trial(&read_trial(&integers.bytes()).expect("integers"), 1e-6);
    let mut mips = trial();
    mips.processor = 86;
    assert_is_trial(&read_trial(&mips.bytes()).expect("MIPS"), 1e-6);
    for (unit, factor) in [("m", 1e-3), ("cm", 0.1), ("MM", 1.0)] {
        let mut file = trial();
        file.units = Some(unit.into());
        for position in file.frames.iter_mut().flatten().flatten() {
            *position = position.map(|x| x * factor);
        }
        assert_is_trial(&read_trial(&file.bytes()).expect(unit), 1e-6);
    }
}

#[test]
fn a_coordinate_that_is_no_number_is_a_dropout() {
    let mut file = trial();
    file.frames[3][2] = Some([f32::NAN, 1.0, 2.0]);
    assert_is_trial(&read_trial(&file.bytes()).expect("a good file"), 1e-6);
}

#[test]
fn frames_beyond_sixteen_bits_are_counted_by_the_parameters() {
    let mut file = trial();
    let long = |value: u32| [value as u16, (value >> 16) as u16];
    let bytes = |value: u32| {
        long(value)
            .iter()
            .flat_map(|word| word.to_le_bytes())
            .collect()
    };
    file.more = vec![
        ("ACTUAL_START_FIELD", 2, vec![2], bytes(100_000)),
        ("ACTUAL_END_FIELD", 2, vec![2], bytes(100_008)),
    ];
    // The writer knows one group: it does as well under this name.
    let mut with_trial = file.bytes();
    let group = with_trial
        .windows(5)
        .position(|name| name == b"POINT")
        .expect("the group");
    assert_eq!(&with_trial[group..group + 5], b"POINT");
    // A second name for the same group.
    let entry = [&[5, 0xff], &b"TRIAL"[..], &[3, 0, 0]].concat();
    let section: Vec<u8> = with_trial.splice(group + 8..group + 8, entry).collect();
    assert!(section.is_empty());
    let end = 2 * 512;
    with_trial.drain(end..end + 10);
    let dataset = read_trial(&with_trial).expect("a good file");
    assert_eq!(dataset.flights[0].times[0], 100_000.0 / 120.0);
}

#[test]
fn another_reader_reads_the_same() {
    for scale in [-0.1, 0.1] {
        let mut file = trial();
        file.scale = scale;
        let mut bytes = file.bytes();
        // It wants whole blocks.
        bytes.resize(bytes.len().next_multiple_of(512), 0);
        let peer = c3dio::C3d::from_bytes(&bytes).expect("the peer reads it");
        let ours = read_trial(&bytes).expect("a good file");
        assert_eq!(peer.points.labels, ["m1", "elbow", "m2"]);
        assert_eq!(peer.points.frame_rate, 120.0);
        for (frame, row) in ours.flights[0].positions.iter().enumerate() {
            for (place, point) in [(2, row[0]), (0, row[1])] {
                let Some(point) = point else { continue };
                for (axis, value) in point.iter().enumerate() {
                    let theirs = 1e-3 * f64::from(peer.points[frame][place].point[axis]);
                    assert!((theirs - value).abs() < 1e-6, "{theirs} {value}");
                }
            }
        }
    }
}

/// Next number of a linear congruential generator with the state `seed`; the same on every machine.
fn noise(seed: &mut u64) -> usize {
    *seed = seed
        .wrapping_mul(6364136223846793005)
        .wrapping_add(1442695040888963407);
    (*seed >> 33) as usize
}

#[test]
fn flipped_bytes_are_read_or_refused_and_do_no_harm() {
    let begun = Instant::now();
    let whole = trial().bytes();
    let (mut seed, mut refused) = (1, 0);
    for case in 0..2000 {
        let mut bytes = whole.clone();
        for _ in 0..=case % 5 {
            // Mostly where the counts are, and the parameters.
            let reach = [24, 800, bytes.len()][noise(&mut seed) % 3];
            let at = noise(&mut seed) % reach;
            bytes[at] = noise(&mut seed) as u8;
        }
        match read_trial(&bytes) {
            Ok(dataset) => assert!(dataset.flights[0].times.len() <= bytes.len()),
            Err(error) => {
                assert!(error.contains(", expected "), "{error}");
                refused += 1;
            }
        }
    }
    assert!((200..2000).contains(&refused), "{refused}");
    assert!(
        begun.elapsed() < Duration::from_secs(60),
        "{:?}",
        begun.elapsed()
    );
}

#[test]
fn a_file_cut_anywhere_is_refused() {
    let whole = trial().bytes();
    for length in (0..whole.len()).step_by(97) {
        read_trial(&whole[..length]).expect_err("half a file");
    }
}
