//! Text of a stability analysis for the terminal.

use crate::Table;
use analysis::stability::{Instant, Mode};

use super::words::{INSTANT, lead, nutation, of_criteria, steady};
use super::{Found, page};

/// Number of instants of the flight in the text for the terminal.
const INSTANTS: usize = 8;

/// Text of the modes and stability criteria in `found`, for the terminal.
pub fn text(model: &str, found: &Found) -> String {
    let mut text = format!("{model}: {}\n", lead(found).join(" "));
    text += &page::table(&found.release.modes).text(usize::MAX);
    if !found.release.modes.is_symmetric {
        text += &format!("{INSTANT}\n");
    }
    text += &(of_criteria(&found.release).join("\n") + "\n\n");
    text += &match &found.trim {
        Some((trim, modes)) => format!("{}\n{}", steady(trim), page::table(modes).text(usize::MAX)),
        None => "No steady flight was found at this spin.\n".to_owned(),
    };
    if let Some(last) = found.flight.last() {
        let table = along(&found.flight).text(usize::MAX);
        text += &format!(
            "\nAlong the flight, {:.2} s, the modes of each instant:\n{table}",
            last.time
        );
    }
    let stable = found.map.iter().filter(|i| i.criteria.is_stable()).count();
    let points = found.map.len();
    text + &format!("over speed and spin: all three criteria hold at {stable} of {points} points\n")
}

/// Table of the nutation at some instants of the flight, the last among them.
fn along(flight: &[Instant]) -> Table {
    let step = (flight.len() / INSTANTS).max(1);
    let number = |instant: &Instant, of: fn(&Mode) -> f64| {
        format!("{:.3}", nutation(&instant.modes).map_or(f64::NAN, of))
    };
    Table::of(flight.iter().step_by(step).chain(flight.last()))
        .number("time, s", |instant| format!("{:.3}", instant.time))
        .number("speed, m/s", |instant| {
            format!("{:.2}", instant.throw.speed)
        })
        .number("nutation, rad/s", |instant| {
            number(instant, Mode::frequency)
        })
        .number("decay, 1/s", |instant| number(instant, Mode::decay))
        .table()
}
