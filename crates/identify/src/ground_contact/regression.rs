//! Least-squares regression of a vector on a few functions of time, with noise that is correlated between samples.
//!
//! A [`Design`] contains everything that does not depend on the measured vectors. Windows of a regularly sampled flight
//! share it.

use lanes::{Lanes, ScalarKernel, ScalarLane};
use nalgebra::{SMatrix, SVector, Vector3};

/// Relative increase of the diagonal of the normal matrix, which makes the matrix invertible if basis functions are
/// nearly collinear.
const RIDGE: f64 = 1e-9;

/// One measured vector and the values of the basis functions at its time.
#[derive(Clone, Copy, Debug)]
pub struct Row<const N: usize> {
    /// Index of the sample in the flight.
    pub sample: usize,
    /// Values of the basis functions at the time of this sample.
    pub functions: SVector<f64, N>,
    /// Measured vector in this sample: a position, m, or the direction of an axis.
    pub value: Vector3<f64>,
}

/// Measured vectors of the rows of a regression matrix, relative to the first vector and whitened.
#[derive(Clone, Debug)]
pub struct Whitened {
    origin: Vector3<f64>,
    /// Whitened vectors, each with a fourth component of 0, so that they fill the registers of the processor.
    vectors: Vec<[f64; 4]>,
    /// Sum of the squared whitened vectors.
    squares: f64,
}

impl Whitened {
    /// Measured vectors relative to the first one; they need no whitening because their noise is not correlated.
    pub fn white(values: impl Iterator<Item = Vector3<f64>>) -> Self {
        Self::new(values, |_, value| value)
    }

    /// Measured vectors relative to the first one, each whitened by the function `whiten`, which receives the preceding
    /// vector (`None` for the first one) and the vector.
    fn new(
        values: impl Iterator<Item = Vector3<f64>>,
        mut whiten: impl FnMut(Option<Vector3<f64>>, Vector3<f64>) -> Vector3<f64>,
    ) -> Self {
        let (mut origin, mut previous) = (None, None);
        let vectors = values.map(|value| {
            let value = value - *origin.get_or_insert(value);
            let [x, y, z] = whiten(previous.replace(value), value).into();
            [x, y, z, 0.0]
        });
        let vectors: Vec<[f64; 4]> = vectors.collect();
        Self {
            squares: vectors.iter().map(square).sum(),
            vectors,
            origin: origin.unwrap_or_default(),
        }
    }
}

/// Least-squares fit of `N` basis functions of time to measured vectors.
#[derive(Clone, Debug)]
pub struct Regression<const N: usize> {
    /// Coefficients of the basis functions; one column per component of the measured vectors.
    pub coefficients: SMatrix<f64, N, 3>,
    /// Sum of squared whitened residuals, plus the penalty by the priors of the coefficients.
    pub squares: f64,
    inverse: SMatrix<f64, N, N>,
    origin: Vector3<f64>,
    correlation: f64,
}

/// Minimum of 1 − leverage as a divisor: smaller values, which are rounding errors, are replaced by this one.
const MIN_PART: f64 = 0.05;

impl<const N: usize> Regression<N> {
    /// Squared innovation of the measured vector of `row`, to which the regression was not fitted. The innovation is
    /// the difference between the whitened vector and its prediction by the regression. Its squared length is divided
    /// by the variance that each of its components has for noise of variance 1. `previous` is the preceding row, whose
    /// noise is correlated with that of `row`.
    pub fn innovation(&self, previous: &Row<N>, row: &Row<N>) -> f64 {
        let whitening = Whitening::of(Some(previous.sample), row.sample, self.correlation);
        let functions = whitening.apply(Some(previous.functions), row.functions);
        let value = whitening.apply(Some(previous.value - self.origin), row.value - self.origin);
        let square = (value - self.coefficients.tr_mul(&functions)).norm_squared();
        square / (1.0 + functions.dot(&(self.inverse * functions)))
    }
}

/// Regression matrix, which contains the values of the whitened basis functions, with its factorized normal equations.
#[derive(Clone, Debug)]
pub struct Design<const N: usize> {
    whitenings: Vec<Whitening>,
    /// Values of the whitened basis functions, one array per row of the regression matrix.
    rows: Vec<[f64; N]>,
    /// 1 − leverage of each row of the regression matrix; the leverage is the diagonal entry of the hat matrix.
    free_parts: Vec<f64>,
    inverse: SMatrix<f64, N, N>,
    precisions: [f64; N],
    /// Amounts by which the diagonal entries of the normal matrix were increased (see `RIDGE`).
    ridges: [f64; N],
    correlation: f64,
}

impl<const N: usize> Design<N> {
    /// Computes the regression matrix of some rows, whose measured vectors are not used, and factorizes its normal
    /// equations. `precisions` are the ratios of the noise variance to the prior variance of each coefficient about 0;
    /// 0 for a coefficient without prior. `correlation` is the correlation of the noise between successive samples, 0
    /// to 0.9. `None` if the rows do not determine the coefficients.
    pub fn new(rows: &[Row<N>], precisions: &[f64; N], correlation: f64) -> Option<Self> {
        let whitened = rows.iter().enumerate().map(|(index, row)| {
            let previous = index.checked_sub(1).map(|previous| &rows[previous]);
            let before = previous.map(|row| row.sample);
            let whitening = Whitening::of(before, row.sample, correlation);
            let functions = whitening.apply(previous.map(|row| row.functions), row.functions);
            (whitening, functions)
        });
        let (whitenings, functions): (Vec<_>, Vec<SVector<f64, N>>) = whitened.unzip();
        let mut normal = SMatrix::<f64, N, N>::zeros();
        for row in &functions {
            // The Cholesky factorisation reads the lower triangle alone.
            for column in 0..N {
                for index in column..N {
                    normal[(index, column)] += row[index] * row[column];
                }
            }
        }
        let ridges = std::array::from_fn(|index| RIDGE * normal[(index, index)]);
        for (index, (precision, ridge)) in precisions.iter().zip(ridges).enumerate() {
            normal[(index, index)] += ridge + precision;
        }
        let inverse = normal.cholesky()?.inverse();
        let free_part = |row: &SVector<f64, N>| 1.0 - row.dot(&(inverse * row));
        let free_parts: Vec<f64> = functions.iter().map(free_part).collect();
        Some(Self {
            free_parts,
            rows: functions.iter().map(|row| (*row).into()).collect(),
            whitenings,
            inverse,
            precisions: *precisions,
            ridges,
            correlation,
        })
    }

    /// Whitens measured vectors, one for each row of the regression matrix. The result is valid for every regression
    /// with the same samples and the same correlation of the noise.
    pub fn whiten(&self, values: impl Iterator<Item = Vector3<f64>>) -> Whitened {
        let mut whitenings = self.whitenings.iter();
        Whitened::new(values, |previous, value| match whitenings.next() {
            Some(whitening) => whitening.apply(previous, value),
            None => value,
        })
    }

    /// Sum of squared whitened residuals of the linear least-squares fit to whitened measured vectors, one for each row
    /// of the regression matrix, plus the penalty by the priors of the coefficients.
    pub fn squares(&self, values: &Whitened) -> f64 {
        let right = products(&self.rows, &values.vectors);
        let coefficients = self.inverse * right;
        let mut squares = values.squares - coefficients.dot(&right);
        for (index, ridge) in self.ridges.iter().enumerate() {
            squares -= ridge * coefficients.row(index).norm_squared();
        }
        squares
    }

    /// Fits the basis functions to whitened measured vectors, one for each row of the regression matrix, by linear least
    /// squares with the priors of the coefficients. Also returns the whitened residual of each row.
    pub fn solve(&self, values: &Whitened) -> (Regression<N>, Residuals) {
        let right = products(&self.rows, &values.vectors);
        let coefficients = self.inverse * right;
        let mut residuals = values.vectors.clone();
        lanes::dispatch_scalar(SubtractFit {
            rows: &self.rows,
            coefficients: &std::array::from_fn(|index| {
                let [x, y, z]: [f64; 3] = coefficients.row(index).transpose().into();
                [x, y, z, 0.0]
            }),
            residuals: &mut residuals,
        });
        let mut squares: f64 = residuals.iter().map(square).sum();
        for (index, precision) in self.precisions.iter().enumerate() {
            squares += precision * coefficients.row(index).norm_squared();
        }
        let regression = Regression {
            coefficients,
            squares,
            inverse: self.inverse,
            origin: values.origin,
            correlation: self.correlation,
        };
        (regression, Residuals(residuals))
    }

    /// For each row of the regression matrix, the decrease of the sum of squares if the row is removed: its squared
    /// residual divided by 1 − leverage.
    pub fn removals(&self, residuals: &Residuals) -> impl Iterator<Item = f64> {
        let rows = residuals.0.iter().zip(&self.free_parts);
        rows.map(|(residual, free_part)| square(residual) / free_part.max(MIN_PART))
    }

    /// Extends the regression by `K` further basis functions without priors, given by their values for each row of the
    /// regression matrix; `None` if the rows do not determine their coefficients.
    pub fn extended<const K: usize>(
        &self,
        functions: &[SVector<f64, K>],
    ) -> Option<Extension<N, K>> {
        let mut previous = None;
        let whitened = self.whitenings.iter().zip(functions);
        let rows = whitened.map(|(whitening, functions)| {
            let row = whitening.apply(previous.replace(*functions), *functions);
            <[f64; K]>::from(row)
        });
        let rows: Vec<[f64; K]> = rows.collect();
        let pairs = || self.rows.iter().zip(&rows);
        let (mut cross, mut schur) = (SMatrix::<f64, N, K>::zeros(), SMatrix::zeros());
        for (known, row) in pairs() {
            let (known, row) = (SVector::from(*known), SVector::<f64, K>::from(*row));
            cross += known * row.transpose();
            schur += row * row.transpose();
        }
        for index in 0..K {
            schur[(index, index)] *= 1.0 + RIDGE;
        }
        let explained = self.inverse * cross;
        schur -= cross.tr_mul(&explained);
        let inverse = schur.cholesky()?.inverse();
        let leverages = pairs().map(|(known, row)| {
            let known = SVector::<f64, N>::from(*known);
            let row = SVector::<f64, K>::from(*row) - explained.tr_mul(&known);
            row.dot(&(inverse * row))
        });
        let free = self.free_parts.iter().sum::<f64>() - leverages.sum::<f64>();
        Some(Extension {
            rows,
            explained,
            inverse,
            freedom: (3.0 * free).max(3.0),
        })
    }
}

/// Whitened residuals of a regression of vectors: one vector per row of the regression matrix, with a fourth component
/// of 0.
#[derive(Clone, Debug)]
pub struct Residuals(Vec<[f64; 4]>);

/// `K` further basis functions of a regression ([`Design`]) with `N` functions. Their coefficients are computed from
/// the residuals of the regression without them, by the Schur complement of the normal equations.
#[derive(Clone, Debug)]
pub struct Extension<const N: usize, const K: usize> {
    /// Values of the `K` whitened further functions, one array per row of the regression matrix.
    rows: Vec<[f64; K]>,
    /// Coefficients of the least-squares fit of the `N` original basis functions to each of the `K` further functions.
    explained: SMatrix<f64, N, K>,
    /// Inverse of the Schur complement of the normal equations for the further functions.
    inverse: SMatrix<f64, K, K>,
    /// Degrees of freedom of the residuals of the fit with the further functions; a value below 3 is replaced by 3.
    freedom: f64,
}

/// Least-squares fit of the `N` basis functions of a regression together with `K` further functions.
#[derive(Clone, Debug)]
pub struct Extended<const N: usize, const K: usize> {
    /// Coefficients of the original `N` basis functions; one column per component of the measured vectors.
    pub coefficients: SMatrix<f64, N, 3>,
    /// Coefficients of the `K` further functions; one column per component of the measured vectors.
    pub further: SMatrix<f64, K, 3>,
    /// Decrease of the sum of squared whitened residuals if the further functions are included in the fit.
    pub gain: f64,
    /// Sum of squared whitened residuals, plus the penalty by the priors of the coefficients.
    pub squares: f64,
    /// Residual variance: sum of squared residuals per degree of freedom.
    pub variance: f64,
}

impl<const N: usize, const K: usize> Extension<N, K> {
    /// Adds the `K` further basis functions to the least-squares fit `of`, whose whitened residuals are `residuals`,
    /// and returns the fit of all `N` + `K` functions.
    pub fn solve(&self, of: &Regression<N>, residuals: &Residuals) -> Extended<N, K> {
        let right = products(&self.rows, &residuals.0);
        let further = self.inverse * right;
        let gain = further.dot(&right);
        let squares = (of.squares - gain).max(0.0);
        Extended {
            coefficients: of.coefficients - self.explained * further,
            further,
            gain,
            squares,
            variance: squares / self.freedom,
        }
    }
}

/// Matrix product `rows`ᵀ `vectors`: entry (i, k) is the sum, over the rows of the regression matrix, of the value of
/// basis function i times component k of the vector. The fourth component of the vectors is ignored.
fn products<const N: usize>(rows: &[[f64; N]], vectors: &[[f64; 4]]) -> SMatrix<f64, N, 3> {
    let mut sums = [[0.0; 4]; N];
    lanes::dispatch_scalar(Products {
        rows,
        vectors,
        sums: &mut sums,
    });
    SMatrix::from_fn(|row, column| sums[row][column])
}

/// Kernel of [`products`]; the results are written to `sums`.
struct Products<'a, const N: usize> {
    rows: &'a [[f64; N]],
    vectors: &'a [[f64; 4]],
    sums: &'a mut [[f64; 4]; N],
}

impl<const N: usize> ScalarKernel for Products<'_, N> {
    #[inline(always)]
    fn run<T: ScalarLane>(self) {
        let mut sums = [[T::splat(0.0); 4]; N];
        for (row, vector) in self.rows.iter().zip(self.vectors) {
            for (sum, function) in sums.iter_mut().zip(T::slice(row)) {
                add_scaled(sum, *function, T::slice(vector));
            }
        }
        for (to, sum) in self.sums.iter_mut().zip(sums) {
            T::slice_mut(to).copy_from_slice(&sum);
        }
    }
}

/// Kernel that subtracts a least-squares fit from the measured vectors in `residuals`: for each row of the regression
/// matrix, the sum of the basis functions times their coefficients.
struct SubtractFit<'a, const N: usize> {
    rows: &'a [[f64; N]],
    coefficients: &'a [[f64; 4]; N],
    residuals: &'a mut [[f64; 4]],
}

impl<const N: usize> ScalarKernel for SubtractFit<'_, N> {
    #[inline(always)]
    fn run<T: ScalarLane>(self) {
        for (row, residual) in self.rows.iter().zip(self.residuals) {
            let residual = T::slice_mut(residual);
            for (coefficient, function) in self.coefficients.iter().zip(T::slice(row)) {
                add_scaled(residual, -*function, T::slice(coefficient));
            }
        }
    }
}

fn square([x, y, z, _]: &[f64; 4]) -> f64 {
    x * x + y * y + z * z
}

/// Adds `factor` × `vector` to `sum`; both have four components.
#[inline(always)]
fn add_scaled<T: Lanes>(sum: &mut [T], factor: T, vector: &[T]) {
    let (sum, vector) = (&mut sum[..4], &vector[..4]);
    for component in 0..4 {
        sum[component] = factor.mul_add(vector[component], sum[component]);
    }
}

/// AR(1) whitening of a regression row: makes its noise independent of the noise of the previous row, and gives all
/// rows the same noise variance.
#[derive(Clone, Copy, Debug)]
struct Whitening {
    /// Correlation between the noise of a regression row and that of the previous row.
    shared: f64,
    scale: f64,
}

impl Whitening {
    /// Creates the whitening of the row with the sample index `sample`. `previous` is the sample index of the preceding
    /// row, `None` for the first row; `correlation` is that of the noise of successive samples.
    fn of(previous: Option<usize>, sample: usize, correlation: f64) -> Self {
        let fresh = 1.0 - correlation * correlation;
        let shared = previous.map_or(0.0, |previous| {
            let interval = sample.saturating_sub(previous).max(1);
            correlation.powi(i32::try_from(interval).unwrap_or(i32::MAX))
        });
        Self {
            shared,
            scale: (fresh / (1.0 - shared * shared)).sqrt(),
        }
    }

    /// Whitens `row`: subtracts the fraction `shared` of the row `previous`, and multiplies the difference by `scale`.
    fn apply<const M: usize>(
        self,
        previous: Option<SVector<f64, M>>,
        row: SVector<f64, M>,
    ) -> SVector<f64, M> {
        match previous {
            Some(previous) => (row - previous * self.shared) * self.scale,
            None => row * self.scale,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_extension_is_the_regression_with_all_functions() {
        let at = |sample: usize, salt: usize| ((sample * 37 + salt * 101) % 17) as f64 / 17.0;
        let samples: Vec<usize> = (0..14).filter(|sample| *sample != 5).collect();
        let rows = samples.iter().map(|&sample| Row {
            sample,
            functions: SVector::<f64, 5>::from([0, 1, 2, 3, 4].map(|salt| at(sample, salt))),
            value: Vector3::new(at(sample, 6), at(sample, 7), at(sample, 8)),
        });
        let rows: Vec<Row<5>> = rows.collect();
        let known = rows.iter().map(|row| Row {
            sample: row.sample,
            functions: row.functions.fixed_rows::<3>(0).into_owned(),
            value: row.value,
        });
        let known: Vec<Row<3>> = known.collect();
        let further = rows.iter().map(|row| row.functions.fixed_rows::<2>(3));
        let further: Vec<SVector<f64, 2>> = further.map(nalgebra::Matrix::into_owned).collect();
        let values = || rows.iter().map(|row| row.value);

        let design = Design::new(&rows, &[0.0, 0.3, 0.0, 0.0, 0.0], 0.4).unwrap();
        let (all, _) = design.solve(&design.whiten(values()));
        let squares = design.squares(&design.whiten(values()));
        assert!((squares - all.squares).abs() < 1e-12 * all.squares);
        let design = Design::new(&known, &[0.0, 0.3, 0.0], 0.4).unwrap();
        let (some, residuals) = design.solve(&design.whiten(values()));
        let extended = design.extended(&further).unwrap();
        let freedom = extended.freedom;
        let extended = extended.solve(&some, &residuals);

        let coefficients = all.coefficients.fixed_rows::<3>(0);
        assert!((extended.coefficients - coefficients).amax() < 1e-6);
        assert!((extended.further - all.coefficients.fixed_rows::<2>(3)).amax() < 1e-6);
        assert!((extended.squares - all.squares).abs() < 1e-7 * all.squares);
        assert!((extended.gain - (some.squares - all.squares)).abs() < 1e-7 * some.squares);
        // 13 rows, 4 coefficients without a prior and most of one with a prior.
        assert!((3.0 * 8.0..3.0 * 9.0).contains(&freedom), "{freedom}");
        assert_eq!(extended.variance, extended.squares / freedom);
    }
}
