//! Reads and interpolates tables of aerodynamic coefficients.

use std::path::Path;

use crate::error::StudyError;
use crate::real_data::files::{bad_line, numbers, rows, text_of};

/// Row of a table of aerodynamic coefficients: their values at one angle of attack.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in super::super) struct Measured {
    /// Angle of attack of this row, rad.
    pub(in super::super) alpha: f64,
    /// Coefficients of lift, of drag, and of the pitching moment (negative nose up).
    pub(in super::super) coefficients: [f64; 3],
}

/// Reads a table with the columns `alpha_deg,CL,CD,CM`, in the order of the file. Angles are converted to rad. `CM` is
/// positive nose up in the file; its sign is reversed.
pub(in super::super) fn read(file: &Path) -> Result<Vec<Measured>, StudyError> {
    let text = text_of(file)?;
    let rows = rows(&text, 1).map(|row| {
        let [alpha, lift, drag, moment] = numbers(row.1)[..] else {
            return Err(bad_line(file, row, "four numbers"));
        };
        Ok(Measured {
            alpha: alpha.to_radians(),
            coefficients: [lift, drag, -moment],
        })
    });
    rows.collect()
}

/// Coefficients `[lift, drag, pitching moment]` at an angle of attack (rad), by linear interpolation. The rows must
/// have increasing angles; outside their range the end values are returned.
pub(in super::super) fn interpolated(rows: &[Measured], alpha: f64) -> [f64; 3] {
    let above = rows.partition_point(|row| row.alpha <= alpha);
    let below = above.checked_sub(1).and_then(|k| rows.get(k));
    match (below, rows.get(above)) {
        (Some(low), Some(high)) => {
            let fraction = (alpha - low.alpha) / (high.alpha - low.alpha);
            let (a, b) = (low.coefficients, high.coefficients);
            [0, 1, 2].map(|k| a[k] + fraction * (b[k] - a[k]))
        }
        (Some(end), None) | (None, Some(end)) => end.coefficients,
        (None, None) => [0.0; 3],
    }
}

/// Rows of a table whose angle of attack is from `low` to `high`, degrees, limits included.
pub(super) fn between(rows: &[Measured], low: f64, high: f64) -> Vec<Measured> {
    let within = |row: &&Measured| (low - 1e-9..=high + 1e-9).contains(&row.alpha.to_degrees());
    rows.iter().filter(within).copied().collect()
}
