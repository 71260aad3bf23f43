//! The files of the throws: a disc's table, launches, tracks.

use std::path::Path;

use super::{Disc, RAD, Throw};
use crate::real_data::wind_tunnel::Measured;

/// Reads `dd2.yaml`.
///
/// # Errors
/// In words.
pub fn disc(file: &Path) -> Result<Disc, String> {
    let text = std::fs::read_to_string(file).map_err(|e| format!("{}: {e}", file.display()))?;
    let lacks = |key: &str| format!("{}: found no {key}", file.display());
    let after = |key: &str| {
        let place = text.find(&format!("{key}:")).ok_or_else(|| lacks(key))?;
        Ok::<&str, String>(&text[place + key.len() + 1..])
    };
    let number = |key: &str| {
        let word = after(key)?.split_whitespace().next();
        word.and_then(|word| word.parse::<f64>().ok())
            .ok_or_else(|| lacks(key))
    };
    let list = |key: &str| {
        let text = after(key)?.split_once('[').ok_or_else(|| lacks(key))?.1;
        let cells = text.split(']').next().unwrap_or_default().split(',');
        let all: Option<Vec<f64>> = cells.map(|cell| cell.trim().parse().ok()).collect();
        all.ok_or_else(|| lacks(key))
    };
    let [alpha, lift, drag, moment] = [list("alpha")?, list("Cl")?, list("Cd")?, list("Cm")?];
    if [&lift, &drag, &moment]
        .iter()
        .any(|column| column.len() != alpha.len())
    {
        return Err(format!("{}: columns of different lengths", file.display()));
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

/// Reads `throw_params.csv` and the tracks beside it.
///
/// # Errors
/// In words.
pub fn throws(folder: &Path) -> Result<Vec<Throw>, String> {
    let read =
        |file: &Path| std::fs::read_to_string(file).map_err(|e| format!("{}: {e}", file.display()));
    let file = folder.join("throw_params.csv");
    let text = read(&file)?;
    let lines = text.lines().skip(1).filter(|line| !line.trim().is_empty());
    lines
        .map(|line| {
            let cells: Vec<f64> = line
                .split(',')
                .filter_map(|c| c.trim().parse().ok())
                .collect();
            let [number, pitch, roll, nose, speed, spin, yaw, wind, _, height] = cells[..] else {
                return Err(format!(
                    "{}: found {line:?}, expected ten numbers",
                    file.display()
                ));
            };
            let track = read(&folder.join(format!("throw{number}.tsv")))?;
            let rows = track.lines().skip(2).filter_map(|line| {
                let cells: Vec<f64> = line
                    .split_whitespace()
                    .filter_map(|c| c.parse().ok())
                    .collect();
                (cells.len() >= 3).then(|| (cells[0], [cells[1], cells[2]]))
            });
            let rows: Vec<(f64, [f64; 2])> = rows.collect();
            let first = rows
                .first()
                .ok_or(format!("throw {number} has no track"))?
                .0;
            Ok(Throw {
                number: number as u32,
                launch: [
                    speed,
                    pitch * RAD,
                    roll * RAD,
                    nose * RAD,
                    yaw * RAD,
                    wind,
                    0.0,
                ],
                spin_and_height: [spin, height],
                track: rows
                    .into_iter()
                    .map(|(t, place)| (t - first, place))
                    .collect(),
            })
        })
        .collect()
}
