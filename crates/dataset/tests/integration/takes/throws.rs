//! Throws of made recordings are cut where they were released and where they ended.

use super::support::read;
use super::support::thrown::{End, Made, recording};
use std::ops::RangeInclusive;
use std::path::Path;

use dataset::Marker;
use dataset::takes::{
    Axis, Cause, ImportOptions, ImportedTake, LengthUnit, ReadOptions, Take, Throw, ThrowOptions,
    find_throws,
};

/// Maximum permitted error of a detected release or end of a flight, samples.
const WITHIN: f64 = 3.0;

fn z_up(text: &str) -> Take {
    let take = read(text.as_bytes(), &ReadOptions::default()).expect("a take");
    take.with_z_up(Axis::parse("+y").expect("an axis"), false)
}

/// Errors (detected − true) of release and end of each throw, in samples; `None` for a throw that was not detected.
/// Also returns the number of detected throws that do not overlap a true one.
fn errors(made: &Made) -> (Vec<Option<(f64, f64)>>, usize) {
    let take = z_up(&made.text);
    let found = find_throws(&take, &[], &ThrowOptions::default());
    let mut used = vec![false; found.throws.len()];
    let mut errors = Vec::new();
    for truth in &made.truths {
        let first = take
            .times
            .iter()
            .position(|&t| t - take.times[0] >= truth.release);
        let last = take
            .times
            .iter()
            .rposition(|&t| t - take.times[0] <= truth.end);
        let (first, last) = (first.expect("a sample"), last.expect("a sample"));
        let matching = found.throws.iter().position(|throw| {
            let range = throw.samples();
            range.start < last && first < range.end
        });
        errors.push(matching.map(|i| {
            used[i] = true;
            let throw = &found.throws[i];
            (
                throw.release.sample as f64 - first as f64,
                throw.end.sample as f64 - last as f64,
            )
        }));
        let ok = errors.last().copied().flatten();
        if !ok.is_some_and(|(a, b)| a.abs() <= WITHIN && b.abs() <= WITHIN) {
            eprintln!(
                "{truth:?} at {} Hz: {ok:?}; {:?} {:?}",
                made.rate, found.throws, found.notes
            );
        }
    }
    (errors, used.iter().filter(|used| !**used).count())
}

#[test]
fn releases_and_ends_are_within_three_samples_of_the_truth() {
    let (mut flights, mut good, mut false_throws, mut late) = (0, 0, 0, 0);
    for seed in 0..100 {
        let made = recording(seed, 2);
        let (errors, extra) = errors(&made);
        false_throws += extra;
        for error in errors {
            flights += 1;
            if let Some((release, end)) = error {
                good += usize::from(release.abs() <= WITHIN && end.abs() <= WITHIN);
                // A sample of the hand, or after the end, spoils a fit; one less costs little.
                late += usize::from(release < 0.0 || end > 0.0);
            }
        }
    }
    eprintln!(
        "{good} of {flights} flights within {WITHIN} samples at both ends; {late} with a sample outside; {false_throws} that are none"
    );
    assert_eq!(flights, 200);
    assert!(good * 100 >= flights * 95, "{good} of {flights}");
    assert!(false_throws <= 2, "{false_throws} that are none");
}

#[test]
fn each_cut_says_why() {
    let mut named = [0; 4];
    let mut ends = 0;
    for seed in 200..220 {
        let made = recording(seed, 1);
        let take = z_up(&made.text);
        let found = find_throws(&take, &[], &ThrowOptions::default());
        let Some(throw) = found.throws.first() else {
            continue;
        };
        ends += 1;
        named[0] += usize::from(matches!(throw.release.cause, Cause::Hand(_)));
        let is_right = match made.truths[0].kind {
            End::Ground => matches!(throw.end.cause, Cause::Ground(_)),
            End::Net | End::Catch => matches!(throw.end.cause, Cause::Stopped(_)),
        };
        named[1] += usize::from(is_right);
        if !is_right {
            eprintln!("{:?}: {}", made.truths[0].kind, throw.end.cause);
        }
    }
    eprintln!(
        "of {ends}: {} released by the hand, {} ends named rightly",
        named[0], named[1]
    );
    assert!(ends >= 19 && named[0] * 10 >= ends * 9 && named[1] * 10 >= ends * 9);
}

#[test]
fn a_body_that_is_carried_or_rests_is_not_thrown() {
    let rows = |position: &dyn Fn(f64) -> [f64; 3]| {
        let mut text = "t_s,m_x_m,m_y_m,m_z_m\n".to_owned();
        for i in 0..600 {
            let t = f64::from(i) / 120.0;
            let [x, y, z] = position(t);
            let noise = 0.0005 * (f64::from(i) * 12.9898).sin();
            text += &format!("{t},{},{},{}\n", x + noise, y - noise, z + noise);
        }
        text
    };
    let carried = rows(&|t| {
        [
            1.4 * t,
            0.1 * (5.0 * t).sin(),
            1.2 + 0.03 * (11.0 * t).sin(),
        ]
    });
    let swung = rows(&|t| [0.6 * (6.0 * t).sin(), 0.6 * (6.0 * t).cos(), 1.2]);
    let rests = rows(&|_| [0.0, 1.0, 0.0]);
    for text in [carried, swung, rests] {
        let take = read(text.as_bytes(), &ReadOptions::default()).expect("a take");
        let found = find_throws(&take, &["m"], &ThrowOptions::default());
        assert!(found.throws.is_empty(), "{:?}", found.throws);
    }
}

#[test]
fn a_long_gap_ends_a_flight_and_a_short_one_does_not() {
    let fall = |gaps: [std::ops::Range<i32>; 2]| {
        let mut text = "t_s,m_x_m,m_y_m,m_z_m\n".to_owned();
        for i in 0..200 {
            let t = f64::from(i) / 200.0;
            text += &match gaps.iter().any(|gap| gap.contains(&i)) {
                true => format!("{t},,,\n"),
                false => format!("{t},{},0,{}\n", 8.0 * t, 10.0 + 2.0 * t - 4.905 * t * t),
            };
        }
        let take = read(text.as_bytes(), &ReadOptions::default()).expect("a take");
        find_throws(&take, &["m"], &ThrowOptions::default()).throws
    };
    let [bridged] = &fall([0..0, 100..110])[..] else {
        panic!("one flight");
    };
    assert_eq!((bridged.samples(), bridged.unseen), (0..200, 10));
    assert_eq!(bridged.release.cause, Cause::Recording);
    assert!((bridged.acceleration[2] + 9.81).abs() < 1e-3);
    let [late] = &fall([0..20, 100..110])[..] else {
        panic!("one flight");
    };
    assert_eq!((late.samples(), late.unseen), (20..200, 10));
    // The second gap is shorter than a throw.
    for to in [140, 115] {
        let [first, second] = &fall([0..0, 80..to])[..] else {
            panic!("two flights");
        };
        assert_eq!(first.samples(), 0..80);
        assert_eq!(second.samples(), to as usize..200);
        assert!(matches!(first.end.cause, Cause::Gap(_)));
        assert!(matches!(second.release.cause, Cause::Gap(_)));
    }
}

/// Air could change the velocity of a fast body as much in the time of a few samples, but not at once.
#[test]
fn a_knock_ends_a_flight() {
    let mut text = "t_s,m_x_m,m_y_m,m_z_m\n".to_owned();
    for i in 0..200 {
        let t = f64::from(i) / 200.0;
        let aside = 1.6 * (t - 0.5).max(0.0);
        let noise = 0.0002 * (f64::from(i) * 12.9898).sin();
        let z = 10.0 + 2.0 * t - 4.905 * t * t;
        text += &format!("{t},{},{},{}\n", 20.0 * t + noise, aside - noise, z + noise);
    }
    let take = read(text.as_bytes(), &ReadOptions::default()).expect("a take");
    let found = find_throws(&take, &["m"], &ThrowOptions::default());
    let end = found.throws.first().expect("a throw").end;
    assert!((97..=103).contains(&end.sample), "{end:?}");
    assert_eq!(end.cause, Cause::Disturbed);
}

/// Recording of a body that a hand pushes and a net stops, with `aside(t)` across its way (m), without the samples of
/// `lost`: its throw as found, and the true samples of its flight.
fn pushed_and_stopped(
    rate: f64,
    aside: impl Fn(f64) -> f64,
    lost: &[usize],
) -> (Throw, RangeInclusive<usize>) {
    let (push, speed, release, end) = (120.0, 12.0, 0.4, 0.9);
    let along = |t: f64| match t {
        t if t < release - speed / push => 0.0,
        t if t < release => 0.5 * push * (t - release + speed / push).powi(2),
        t if t < end => 0.5 * speed * speed / push + speed * (t - release),
        t => {
            let since = (t - end).min(speed / push);
            0.5 * speed * speed / push + speed * (end - release + since)
                - 0.5 * push * since * since
        }
    };
    let fallen = |t: f64| 4.905 * (t - release).max(0.0).powi(2);
    let mut text = "t_s,m_x_m,m_y_m,m_z_m\n".to_owned();
    let count = (1.2 * rate) as usize;
    for i in 0..count {
        let t = i as f64 / rate;
        let noise =
            0.0005 * (2.0 * (43758.5453 * (i as f64 * 12.9898).sin()).rem_euclid(1.0) - 1.0);
        text += &match lost.contains(&i) {
            true => format!("{t},,,\n"),
            false => format!(
                "{t},{},{},{}\n",
                along(t) + noise,
                aside(t) - noise,
                2.0 - fallen(t) + noise
            ),
        };
    }
    let take = read(text.as_bytes(), &ReadOptions::default()).expect("a take");
    let found = find_throws(&take, &["m"], &ThrowOptions::default());
    let [throw] = &found.throws[..] else {
        panic!("one flight, not {found:?}");
    };
    let first = (release * rate).ceil() as usize;
    (throw.clone(), first..=(end * rate).floor() as usize)
}

/// A sample next to the change that is not seen says nothing about why the flight ends.
#[test]
fn a_change_of_motion_is_located_across_a_short_gap() {
    let (_, flight) = pushed_and_stopped(200.0, |_| 0.0, &[]);
    for after in 0..5 {
        let lost = [flight.start() - 1 - after, flight.end() + 1 + after];
        let (throw, flight) = pushed_and_stopped(200.0, |_| 0.0, &lost);
        assert!(flight.contains(&throw.release.sample), "{throw:?}");
        assert!(flight.contains(&throw.end.sample), "{throw:?}");
    }
}

/// Samples that deviate in flight too are examined with what lies beyond them: the net is seen before it is reached.
#[test]
fn a_body_that_wobbles_is_cut_where_it_is_released_and_stopped() {
    for rate in [150.0, 200.0, 250.0] {
        let (throw, flight) = pushed_and_stopped(rate, |t| 0.008 * (40.0 * t).sin(), &[]);
        let off = throw.end.sample.abs_diff(*flight.end());
        assert!(off <= 3, "{flight:?} at {rate} Hz: {throw:?}");
    }
    let (throw, flight) = pushed_and_stopped(200.0, |t| 0.0015 * (100.0 * t).sin(), &[]);
    let off = throw.release.sample.abs_diff(*flight.start());
    assert!(off <= 3, "{flight:?}: {throw:?}");
}

#[test]
fn a_wrong_unit_of_length_is_told() {
    // A ball that is held and thrown, `scale` units a metre.
    let thrown = |scale: f64| {
        let mut text = "t_s,m_x,m_y,m_z\n".to_owned();
        for i in 0..240 {
            let t = (f64::from(i) - 80.0) / 200.0;
            let noise = 0.0005 * (f64::from(i) * 12.9898).sin();
            let [x, z] = match t < 0.0 {
                true => [0.0, 1.5],
                false => [6.0 * t, 1.5 + 2.0 * t - 4.905 * t * t],
            };
            let [x, y, z] = [x + noise, 0.2 - noise, z + noise].map(|own| scale * own);
            text += &format!("{},{x},{y},{z}\n", f64::from(i) / 200.0);
        }
        text
    };
    let options = ImportOptions {
        markers: vec![Marker {
            name: "m".into(),
            position: [0.0; 3],
        }],
        up: Axis::parse("+z"),
        ..ImportOptions::default()
    };
    let imported = |scale: f64, length: LengthUnit| {
        let reading = ReadOptions {
            length: Some(length),
            ..ReadOptions::default()
        };
        let take = read(thrown(scale).as_bytes(), &reading).expect("a take");
        let imported = ImportedTake::new(&take, Path::new("take.csv"), &options);
        imported
            .map(|take| take.throws.len())
            .map_err(|error| error.to_string())
    };
    assert_eq!(imported(1e3, LengthUnit::Millimetre), Ok(1));
    for (scale, wrong, right) in [
        (1e3, LengthUnit::Metre, "mm"),
        (1.0, LengthUnit::Millimetre, "m"),
        (1.0 / 0.0254, LengthUnit::Metre, "in"),
    ] {
        let told = imported(scale, wrong).expect_err(right);
        assert!(
            told.ends_with(&format!("expected --length {right}")),
            "{told}"
        );
    }
}
