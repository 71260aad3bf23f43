//! The disc's coefficient curves beside those measured in a wind tunnel.

pub mod effects_page;
pub mod page;
pub mod paper_page;

use std::path::Path;

use nalgebra::{DMatrix, DVector};

/// One row of the table: angle of attack, rad; lift, drag, and the pitching moment about d2 (nose-up negative).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// Angle of attack, rad.
    pub alpha: f64,
    /// Lift, drag, moment coefficients.
    pub coefficients: [f64; 3],
}

/// Reads `potts_crowther.csv`: `alpha_deg,CL,CD,CM`, the moment nose-up positive.
///
/// # Errors
/// In words, with the line.
pub fn read(file: &Path) -> Result<Vec<Measured>, String> {
    let text = std::fs::read_to_string(file).map_err(|e| format!("{}: {e}", file.display()))?;
    let rows = text
        .lines()
        .enumerate()
        .skip(1)
        .filter(|(_, line)| !line.trim().is_empty());
    rows.map(|(index, line)| {
        let numbers: Vec<f64> = line
            .split(',')
            .filter_map(|cell| cell.trim().parse().ok())
            .collect();
        let [alpha, lift, drag, moment] = numbers[..] else {
            return Err(format!(
                "{}:{}: found {line:?}, expected four numbers",
                file.display(),
                index + 1
            ));
        };
        Ok(Measured {
            alpha: alpha.to_radians(),
            coefficients: [lift, drag, -moment],
        })
    })
    .collect()
}

/// A curve of the disc's model: a constant and a multiple of a power of the angle of attack.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Curve {
    /// The constant.
    pub constant: f64,
    /// The multiple.
    pub multiple: f64,
    /// The power.
    pub power: i32,
}

impl Curve {
    /// Its value at an angle of attack, rad.
    pub fn at(&self, alpha: f64) -> f64 {
        self.constant + self.multiple * alpha.powi(self.power)
    }

    /// Root mean square of the measured values less it.
    pub fn rms(&self, rows: &[Measured], which: usize) -> f64 {
        let squares: f64 = rows
            .iter()
            .map(|row| (row.coefficients[which] - self.at(row.alpha)).powi(2))
            .sum();
        (squares / rows.len().max(1) as f64).sqrt()
    }

    /// The curve of this form that is nearest to the rows; the constant stays 0 where `through_zero`.
    pub fn fitted(
        rows: &[Measured],
        which: usize,
        power: i32,
        through_zero: bool,
    ) -> Option<Curve> {
        let design = DMatrix::from_fn(rows.len(), 2, |row, column| match column {
            0 if through_zero => 0.0,
            0 => 1.0,
            _ => rows[row].alpha.powi(power),
        });
        let values = DVector::from_fn(rows.len(), |row, _| rows[row].coefficients[which]);
        let found = design.svd(true, true).solve(&values, 1e-12).ok()?;
        Some(Curve {
            constant: if through_zero { 0.0 } else { found[0] },
            multiple: found[1],
            power,
        })
    }
}

/// A sum of multiples of given curves that is nearest to the rows, and the root mean square of what it leaves; none where the rows do
/// not determine it.
pub fn nearest(
    rows: &[Measured],
    which: usize,
    curves: &[fn(f64) -> f64],
) -> Option<(Vec<f64>, f64)> {
    if rows.len() < curves.len() {
        return None;
    }
    let design = DMatrix::from_fn(rows.len(), curves.len(), |row, curve| {
        curves[curve](rows[row].alpha)
    });
    let values = DVector::from_fn(rows.len(), |row, _| rows[row].coefficients[which]);
    let found = design.clone().svd(true, true).solve(&values, 1e-12).ok()?;
    let left = (values - design * &found).norm_squared() / rows.len() as f64;
    Some((found.iter().copied().collect(), left.sqrt()))
}

/// The angle (rad) at which a parabola through the rows is lowest; none where it has no lowest point.
pub fn lowest(rows: &[Measured], which: usize) -> Option<f64> {
    let design = DMatrix::from_fn(rows.len(), 3, |row, power| {
        rows[row].alpha.powi(power as i32)
    });
    let values = DVector::from_fn(rows.len(), |row, _| rows[row].coefficients[which]);
    let found = design.svd(true, true).solve(&values, 1e-12).ok()?;
    (found[2] > 0.0).then(|| -found[1] / (2.0 * found[2]))
}

/// The coefficients at an angle (rad) by straight lines between the rows, which are in order; beyond them the last.
pub fn interpolated(rows: &[Measured], alpha: f64) -> [f64; 3] {
    let above = rows.partition_point(|row| row.alpha <= alpha);
    match (
        above.checked_sub(1).and_then(|k| rows.get(k)),
        rows.get(above),
    ) {
        (Some(low), Some(high)) => {
            let part = (alpha - low.alpha) / (high.alpha - low.alpha);
            [0, 1, 2]
                .map(|k| low.coefficients[k] + part * (high.coefficients[k] - low.coefficients[k]))
        }
        (Some(end), None) | (None, Some(end)) => end.coefficients,
        (None, None) => [0.0; 3],
    }
}

/// The rows between two angles, degrees.
pub fn between(rows: &[Measured], low: f64, high: f64) -> Vec<Measured> {
    let within = |row: &&Measured| (low - 1e-9..=high + 1e-9).contains(&row.alpha.to_degrees());
    rows.iter().filter(within).copied().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_sum_of_curves_is_found_and_what_it_leaves() {
        let rows: Vec<Measured> = (-4..=4)
            .map(|k| f64::from(k) * 0.1)
            .map(|alpha| Measured {
                alpha,
                coefficients: [1.0 + 2.0 * alpha - 3.0 * alpha.powi(3), 0.0, 0.0],
            })
            .collect();
        let curves: [fn(f64) -> f64; 3] = [|_| 1.0, |a| a, |a| a.powi(3)];
        let (found, left) = nearest(&rows, 0, &curves).unwrap();
        assert!((found[2] + 3.0).abs() < 1e-9 && left < 1e-12, "{found:?}");
        let (_, left) = nearest(&rows, 0, &curves[..2]).unwrap();
        assert!((0.01..0.1).contains(&left), "{left}");
        assert!(nearest(&rows[..2], 0, &curves).is_none());
    }

    #[test]
    fn a_curve_is_found_again() {
        let curve = Curve {
            constant: 0.1,
            multiple: 2.0,
            power: 2,
        };
        let rows: Vec<Measured> = (0..9)
            .map(|k| f64::from(k) * 0.05)
            .map(|alpha| Measured {
                alpha,
                coefficients: [0.0, curve.at(alpha), 3.0 * alpha],
            })
            .collect();
        let found = Curve::fitted(&rows, 1, 2, false).unwrap();
        assert!((found.constant - 0.1).abs() < 1e-12 && (found.multiple - 2.0).abs() < 1e-12);
        assert!(found.rms(&rows, 1) < 1e-12);
        let moment = Curve::fitted(&rows, 2, 1, true).unwrap();
        assert!(moment.constant == 0.0 && (moment.multiple - 3.0).abs() < 1e-12);
    }
}
