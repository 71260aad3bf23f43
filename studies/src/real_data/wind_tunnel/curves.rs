//! Least-squares fits of curves to the wind tunnel's table.

use nalgebra::{DMatrix, DVector};

use super::table::Measured;

/// Index of a coefficient in a row of an aerodynamic table: lift 0, drag 1, pitching moment 2.
pub(super) type Coefficient = usize;

/// A basis function of the angle of attack, rad.
pub(super) type Shape = fn(f64) -> f64;

/// In a least-squares fit, singular values below this fraction of the maximum singular value count as 0.
const RANK_TOLERANCE: f64 = 1e-12;

pub(super) const ONE: Shape = |_| 1.0;
pub(super) const ALPHA: Shape = |alpha| alpha;
pub(super) const SQUARE: Shape = |alpha| alpha * alpha;
pub(super) const CUBE: Shape = |alpha| alpha * alpha * alpha;
/// Basis function of the effect `stall`: zero up to an angle of attack of 8°, a falling parabola above.
pub(super) const STALL: Shape = |alpha| -(alpha - 8_f64.to_radians()).max(0.0).powi(2);

/// A linear combination of basis functions of the angle of attack.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Curve {
    pub(super) multiples: Vec<f64>,
    shapes: &'static [Shape],
}

impl Curve {
    /// Creates a curve with given coefficients of the basis functions.
    pub(super) fn new(shapes: &'static [Shape], multiples: Vec<f64>) -> Self {
        Self { multiples, shapes }
    }

    /// Fits a linear combination of the basis functions `shapes` to one coefficient in the rows of an aerodynamic table
    /// by least squares; `None` if there are fewer rows than basis functions.
    pub(super) fn fitted(
        rows: &[Measured],
        coefficient: Coefficient,
        shapes: &'static [Shape],
    ) -> Option<Self> {
        if rows.len() < shapes.len() {
            return None;
        }
        let design = DMatrix::from_fn(rows.len(), shapes.len(), |row, shape| {
            shapes[shape](rows[row].alpha)
        });
        let values = DVector::from_fn(rows.len(), |row, _| rows[row].coefficients[coefficient]);
        let svd = design.svd(true, true);
        let multiples = svd.solve(&values, RANK_TOLERANCE).ok()?;
        Some(Self {
            multiples: multiples.iter().copied().collect(),
            shapes,
        })
    }

    /// Value of the curve, which is a dimensionless coefficient, at the angle of attack `alpha`, rad.
    pub(super) fn at(&self, alpha: f64) -> f64 {
        let each = self.multiples.iter().zip(self.shapes);
        each.map(|(multiple, shape)| multiple * shape(alpha)).sum()
    }

    /// RMS residual (table − curve) of one coefficient over the rows `rows` of an aerodynamic table.
    pub(super) fn rms(&self, rows: &[Measured], coefficient: Coefficient) -> f64 {
        let residuals = rows
            .iter()
            .map(|row| row.coefficients[coefficient] - self.at(row.alpha));
        let squares: f64 = residuals.map(|residual| residual * residual).sum();
        (squares / rows.len().max(1) as f64).sqrt()
    }
}

/// Angle (rad) of the minimum of the parabola `a + b α + c α²`; `None` if it has no minimum.
pub(super) fn minimum([_, b, c]: [f64; 3]) -> Option<f64> {
    (c > 0.0).then(|| -b / (2.0 * c))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(alpha: f64, coefficients: [f64; 3]) -> Measured {
        Measured {
            alpha,
            coefficients,
        }
    }

    #[test]
    fn the_nearest_sum_of_curves_is_found_and_what_it_leaves() {
        let alphas = (-4..=4).map(|k| f64::from(k) * 0.1);
        let cubic = |a: f64| 1.0 + 2.0 * a - 3.0 * a.powi(3);
        let rows: Vec<Measured> = alphas.map(|a| row(a, [cubic(a), 0.0, 0.0])).collect();
        let found = Curve::fitted(&rows, 0, &[ONE, ALPHA, CUBE]).unwrap();
        assert!((found.multiples[2] + 3.0).abs() < 1e-9, "{found:?}");
        assert!(found.rms(&rows, 0) < 1e-12, "{found:?}");
        let straight = Curve::fitted(&rows, 0, &[ONE, ALPHA]).unwrap();
        assert!((0.01..0.1).contains(&straight.rms(&rows, 0)));
        assert!(Curve::fitted(&rows[..2], 0, &[ONE, ALPHA, CUBE]).is_none());
    }

    #[test]
    fn a_curve_is_found_again() {
        let curve = Curve::new(&[ONE, SQUARE], vec![0.1, 2.0]);
        let alphas = (0..9).map(|k| f64::from(k) * 0.05);
        let rows: Vec<Measured> = alphas
            .map(|a| row(a, [0.0, curve.at(a), 3.0 * a]))
            .collect();
        let found = Curve::fitted(&rows, 1, &[ONE, SQUARE]).unwrap();
        assert!((found.multiples[0] - 0.1).abs() < 1e-12);
        assert!((found.multiples[1] - 2.0).abs() < 1e-12);
        assert!(found.rms(&rows, 1) < 1e-12);
        let moment = Curve::fitted(&rows, 2, &[ALPHA]).unwrap();
        assert!((moment.multiples[0] - 3.0).abs() < 1e-12);
    }
}
