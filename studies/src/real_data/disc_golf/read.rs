//! Reads the files of the throws: the disc's aerodynamic table, the launches, the tracks.

use std::path::Path;

use super::throw::{Disc, RAD, Throw, TrackPoint};
use crate::error::StudyError;
use crate::real_data::files::{absent, bad_line, numbers, rows, text_of};
use crate::real_data::wind_tunnel::Measured;

/// Reads diameter, moments of inertia and aerodynamic table of a disc from a YAML file.
pub(super) fn disc(file: &Path) -> Result<Disc, StudyError> {
    let text = text_of(file)?;
    let number = |key: &str| number(&text, key).ok_or_else(|| absent(file, key));
    let list = |key: &str| list(&text, key).ok_or_else(|| absent(file, key));
    let (alpha, lift, drag, moment) = (list("alpha")?, list("Cl")?, list("Cd")?, list("Cm")?);
    let is_short = |column: &Vec<f64>| column.len() != alpha.len();
    if [&lift, &drag, &moment].into_iter().any(is_short) {
        return Err(absent(file, "columns of the same length"));
    }
    let rows = (0..alpha.len()).map(|k| Measured {
        alpha: alpha[k].to_radians(),
        coefficients: [lift[k], drag[k], -moment[k]],
    });
    Ok(Disc {
        diameter: number("diameter")?,
        inertia: [number("J_xy")?, number("J_z")?],
        table: rows.collect(),
    })
}

/// Remainder of `text` after the first occurrence of `key:`; `None` if `key:` does not occur.
fn after<'t>(text: &'t str, key: &str) -> Option<&'t str> {
    let key = format!("{key}:");
    Some(text.split_once(&key)?.1)
}

/// Parses the number that follows the first occurrence of `key:` in `text`; `None` if no number follows.
fn number(text: &str, key: &str) -> Option<f64> {
    after(text, key)?.split_whitespace().next()?.parse().ok()
}

/// Parses the first bracketed list of numbers after the first `key:` in `text`; `None` if there is no valid list.
fn list(text: &str, key: &str) -> Option<Vec<f64>> {
    let list = after(text, key)?.split_once('[')?.1;
    let cells = list.split(']').next()?.split(',');
    cells.map(|cell| cell.trim().parse().ok()).collect()
}

/// Reads the throws of a folder: the launch conditions from `throw_params.csv`, and the track (measured path) of each
/// throw from a file of its own.
pub(crate) fn throws(folder: &Path) -> Result<Vec<Throw>, StudyError> {
    let file = folder.join("throw_params.csv");
    let text = text_of(&file)?;
    let throws = rows(&text, 1).map(|row| {
        let [number, pitch, roll, nose, speed, spin, yaw, wind, _, height] = numbers(row.1)[..]
        else {
            return Err(bad_line(&file, row, "ten numbers"));
        };
        let launch = [
            speed,
            pitch * RAD,
            roll * RAD,
            nose * RAD,
            yaw * RAD,
            wind,
            0.0,
        ];
        Ok(Throw {
            number: number as u32,
            launch,
            spin,
            height,
            track: track(&folder.join(format!("throw{number}.tsv")))?,
        })
    });
    throws.collect()
}

/// Reads a track from a file with two header lines. Each further line starts with a time (s) and the horizontal
/// coordinates x and y (m); lines with fewer than three numbers are skipped. Times are shifted to start at 0.
fn track(file: &Path) -> Result<Vec<TrackPoint>, StudyError> {
    let text = text_of(file)?;
    let points = rows(&text, 2).filter_map(|(_, line)| {
        let cells = line.split_whitespace();
        let cells: Vec<f64> = cells.filter_map(|cell| cell.parse().ok()).collect();
        (cells.len() >= 3).then(|| (cells[0], [cells[1], cells[2]]))
    });
    let points: Vec<TrackPoint> = points.collect();
    let (first, _) = *points.first().ok_or_else(|| absent(file, "track"))?;
    let from_first = points.into_iter();
    Ok(from_first.map(|(t, at)| (t - first, at)).collect())
}
