//! Characteristics of a simulated flight as text and as JSON.

use std::fmt::Write;

use flight::throw::{FlownThrow, Throw};
use report::{Table, Units, hundredths};
use serde_json::{Value, json};

/// Table of the characteristics of a flight.
pub fn table(flown: &FlownThrow, units: Units) -> String {
    let mut text = String::new();
    let is_right = flown.sideways < 0.0;
    let side = if is_right { "right" } else { "left" };
    let length = |metres: f64| units.of_metres(metres);
    let m = units.length();
    let [x, y, z] = flown.landing.map(|own| hundredths(length(own)));
    let (range, sideways) = (length(flown.range), length(flown.sideways.abs()));
    let ends = if flown.ended_by == "ground" {
        "lands"
    } else {
        "ends"
    };
    let _ = writeln!(
        text,
        "  range {range:.2} {m}, {sideways:.2} {m} to the {side} of the throw's line; {ends} at x {x:.2}, y {y:.2}, z {z:.2} {m}"
    );
    let _ = writeln!(
        text,
        "  greatest height {:.2} {m} at {:.2} s; time {:.2} s; top speed {:.2} {}",
        length(flown.apex.0),
        flown.apex.1,
        flown.seconds,
        units.of(flown.top_speed, "m/s"),
        units.speed()
    );
    if let Some((least, greatest)) = flown.alpha {
        let _ = writeln!(text, "  angle of attack {least:.1} to {greatest:.1} deg");
    }
    let fields = flight::throw::FIELDS.into_iter();
    let rows = fields.filter_map(|(name, unit, ..)| {
        let (shown, size) = units.instead_of(unit);
        let end = |throw: &Throw| Some(throw.field(name)? / size);
        let ends = (end(&flown.release)?, end(&flown.end)?);
        Some((format!("{name}, {shown}"), ends))
    });
    let number = |value: f64| format!("{:.2}", hundredths(value));
    let table = Table::of(rows)
        .name("", |(name, _)| name.clone())
        .number("release", |(_, (release, _))| number(*release))
        .number("end", |(_, (_, end))| number(*end))
        .table();
    text + &table.text(usize::MAX)
}

/// The characteristics of a flight as JSON, with units in the keys.
pub fn json(flown: &FlownThrow, model: &str) -> Value {
    let motion = |throw: &Throw| {
        json!({
            "speed_m_s": throw.speed, "heading_deg": throw.heading, "launch_deg": throw.launch,
            "nose_deg": throw.nose, "hyzer_deg": throw.hyzer, "spin_rpm": throw.spin,
            "height_m": throw.height, "wobble_deg": throw.wobble,
        })
    };
    json!({
        "schema": "hyzer.flight/1",
        "model": model,
        "seconds": flown.seconds,
        "ended_by": flown.ended_by,
        "range_m": flown.range,
        "left_m": flown.sideways,
        "apex_m": flown.apex.0,
        "apex_s": flown.apex.1,
        "top_speed_m_s": flown.top_speed,
        "landing_m": flown.landing,
        "release": motion(&flown.release),
        "end": motion(&flown.end),
        "alpha_deg": flown.alpha.map(|(least, greatest)| json!({ "least": least, "greatest": greatest })),
    })
}
