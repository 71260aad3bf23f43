//! Headers and times as programs write them: axes behind names, names over axes and units, times of day.

use super::formats::{has_points, has_times, options};
use super::support::{LABELS, RATE, SAMPLES, read, truth};
use dataset::takes::LengthUnit;

/// A plain table of the truth in mm with the header lines `header`; `time` writes the time of a sample.
fn table(header: &str, time: impl Fn(usize) -> String) -> String {
    let mut text = format!("{header}\n");
    for sample in 0..SAMPLES {
        text += &time(sample);
        for number in 0..LABELS.len() {
            match truth(sample, number) {
                Some(at) => at.iter().for_each(|own| text += &format!(",{}", 1e3 * own)),
                None => text += ",,,",
            }
        }
        text.push('\n');
    }
    text
}

fn seconds(sample: usize) -> String {
    format!("{}", sample as f64 / RATE)
}

#[test]
fn axes_in_capitals_behind_a_name_are_coordinates() {
    let axes = LABELS.map(|label| {
        ["X", "Y", "Z"]
            .map(|axis| format!("{label}{axis}"))
            .join(",")
    });
    let mut chosen = options();
    chosen.length = Some(LengthUnit::Millimetre);
    let text = table(&format!("t_s,{}", axes.join(",")), seconds);
    let take = read(text.as_bytes(), &chosen).expect("read");
    has_times(&take, 0.0);
    has_points(&take, &LABELS);
}

#[test]
fn headers_of_two_and_three_lines() {
    let names = LABELS
        .map(|label| format!("{label}_x,{label}_y,{label}_z"))
        .join(",");
    let units = vec!["mm"; 3 * LABELS.len()].join(",");
    let points = LABELS.map(|label| format!("{label},,")).join(",");
    let axes = vec!["X,Y,Z"; LABELS.len()].join(",");
    for header in [
        format!("t,{names}\ns,{units}"),
        format!(",{points}\nTime,{axes}\n[s],{units}"),
    ] {
        let take = read(table(&header, seconds).as_bytes(), &options()).expect("read");
        assert_eq!(take.length, LengthUnit::Millimetre);
        has_times(&take, 0.0);
        has_points(&take, &LABELS);
    }
}

#[test]
fn times_of_day_are_read_across_midnight() {
    let names = LABELS
        .map(|label| format!("{label}_x_mm,{label}_y_mm,{label}_z_mm"))
        .join(",");
    let late = 86_400.0 - 5.0 / RATE;
    let clock = |sample: usize| {
        let time = (late + sample as f64 / RATE) % 86_400.0;
        let minutes = (time / 60.0).floor();
        let hours = (minutes / 60.0).floor();
        format!(
            "{:02}:{:02}:{:012.9}",
            hours,
            minutes % 60.0,
            time - 60.0 * minutes
        )
    };
    let take = read(
        table(&format!("time,{names}"), clock).as_bytes(),
        &options(),
    )
    .expect("read");
    has_times(&take, late);
    has_points(&take, &LABELS);
}
