//! Spoiled files are read or refused; none ends in a panic, takes long, or gives more than it holds.

use std::time::{Duration, Instant};

use super::support::{self, read};
use dataset::takes::{LengthUnit, ReadOptions, ThrowOptions, TimeUnit, find_throws};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Number of randomly damaged files per file format; all ten formats together have 20,000.
const EACH: usize = 2000;

/// Damages a file at one to five random positions: changes, removes, repeats or exchanges bytes, or truncates the file.
fn spoil(bytes: &mut Vec<u8>, random: &mut ChaCha8Rng, is_text: bool) {
    for _ in 0..random.random_range(1..6) {
        if bytes.len() < 8 {
            return;
        }
        // Mostly where the counts and names are.
        let reach = match random.random_range(0..3) {
            0 => bytes.len().min(64),
            1 => bytes.len().min(700),
            _ => bytes.len(),
        };
        let at = random.random_range(0..reach);
        let end = (at + random.random_range(1..40)).min(bytes.len());
        const MARKS: &[u8] = b",;\t\n\"0129-.eENa#X_ \r\0\xff";
        match random.random_range(0..7) {
            0 if is_text => bytes[at] = MARKS[random.random_range(0..MARKS.len())],
            0 | 1 => bytes[at] = random.random(),
            2 => drop(bytes.drain(at..end)),
            3 => {
                let part = bytes[at..end].to_vec();
                let place = random.random_range(0..bytes.len());
                drop(bytes.splice(place..place, part));
            }
            4 => {
                let other = random.random_range(0..bytes.len());
                bytes.swap(at, other);
            }
            5 if random.random_bool(0.2) => bytes.truncate(at),
            _ => bytes[at] = bytes[at].wrapping_add(1),
        }
    }
}

#[test]
fn twenty_thousand_spoiled_files() {
    let mut integers = support::c3d();
    integers.scale = 0.1;
    integers.processor = 86;
    let kinds: [(&str, Vec<u8>); 10] = [
        ("c3d", support::c3d().bytes()),
        ("c3d of integers", integers.bytes()),
        ("vicon", support::vicon().into_bytes()),
        ("qualisys", support::qualisys(false, false).into_bytes()),
        (
            "qualisys with times",
            support::qualisys(true, true).into_bytes(),
        ),
        ("qualisys-6dof", support::qualisys_poses().into_bytes()),
        ("optitrack", support::optitrack().into_bytes()),
        ("dltdv", support::dltdv().into_bytes()),
        ("poses", support::poses().into_bytes()),
        ("plain", support::plain().into_bytes()),
    ];
    let options = ReadOptions {
        format: None,
        length: Some(LengthUnit::Millimetre),
        time: Some(TimeUnit::Second),
        rate: Some(120.0),
    };
    let begun = Instant::now();
    for (number, (kind, good)) in kinds.iter().enumerate() {
        let mut random = ChaCha8Rng::seed_from_u64(number as u64);
        let mut refused = 0;
        for case in 0..EACH {
            let mut bytes = good.clone();
            spoil(&mut bytes, &mut random, !kind.starts_with("c3d"));
            // Half of them meet the reader of their format whatever their beginning is.
            let mut options = options;
            if case % 2 == 1 {
                options.format = read(good, &options).ok().map(|take| take.format);
            }
            match read(&bytes, &options) {
                Ok(take) => {
                    assert!(take.times.len() <= bytes.len(), "{kind} {case}");
                    assert!(
                        take.times.windows(2).all(|pair| pair[0] < pair[1]),
                        "{kind} {case}"
                    );
                    let points = take.points.iter().flat_map(|point| &point.positions);
                    let finite = points.flatten().flatten().all(|x| x.is_finite());
                    assert!(finite, "{kind} {case}");
                    for throw in find_throws(&take, &[], &ThrowOptions::default()).throws {
                        assert!(throw.samples().end <= take.times.len(), "{kind} {case}");
                    }
                }
                Err(error) => {
                    assert!(
                        error.contains(": found ") && error.contains(", expected "),
                        "{error}"
                    );
                    refused += 1;
                }
            }
        }
        assert!(
            (EACH / 10..EACH).contains(&refused),
            "{kind}: {refused} refused"
        );
    }
    assert!(
        begun.elapsed() < Duration::from_secs(120),
        "{:?}",
        begun.elapsed()
    );
}

#[test]
fn claims_of_great_counts_take_no_memory() {
    // 65,535 points in 65,535 frames, in a file of two kilobytes.
    let mut bytes = support::c3d().bytes();
    bytes[2..4].fill(0xff);
    bytes[8..10].fill(0xff);
    read(&bytes, &ReadOptions::default()).expect_err("they are not there");
    let wide = format!("t_s,{}\n", "a_x_m,".repeat(100_000));
    read(wide.as_bytes(), &ReadOptions::default()).expect_err("a column twice");
    let names: String = (0..6000)
        .map(|i| format!(",p{i}_x_m,p{i}_y_m,p{i}_z_m"))
        .collect();
    let error = read(
        format!("t_s{names}\n0\n").as_bytes(),
        &ReadOptions::default(),
    );
    assert!(error.expect_err("too many").contains("at most 4096"));
}
