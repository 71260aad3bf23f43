//! Distribution of the score statistics and of the smallest p-value under the null hypothesis.

use nalgebra::{DMatrix, SymmetricEigen};
use rand::SeedableRng;
use rand_chacha::ChaCha12Rng;
use rand_distr::{Distribution, StandardNormal};
use statrs::function::gamma::ln_gamma;

/// Maximum number of terms of the series and the continued fraction of the incomplete gamma function.
const MAX_TERMS: usize = 500;

/// ln P(χ²(degrees_of_freedom) > statistic); strong effects have p-values below the range of `f64`.
pub(crate) fn chi2_ln_sf(statistic: f64, degrees_of_freedom: usize) -> f64 {
    let (a, x) = (degrees_of_freedom as f64 / 2.0, statistic / 2.0);
    if degrees_of_freedom == 0 || x <= 0.0 {
        return 0.0;
    }
    let front = a * x.ln() - x - ln_gamma(a);
    if x < a + 1.0 {
        return (-lower_series(a, x, front)).ln_1p().min(0.0);
    }
    (front + upper_fraction(a, x).ln()).min(0.0)
}

/// Regularized lower incomplete gamma function P(a, x) by its power series; `front` is ln(xᵃ e⁻ˣ / Γ(a)).
fn lower_series(a: f64, x: f64, front: f64) -> f64 {
    let (mut term, mut sum) = (1.0 / a, 1.0 / a);
    for n in 1..MAX_TERMS {
        term *= x / (a + n as f64);
        sum += term;
        if term < sum * 1e-16 {
            break;
        }
    }
    (front + sum.ln()).exp()
}

/// Continued fraction of the upper incomplete gamma function, by Lentz's method; multiplied by xᵃ e⁻ˣ it is Γ(a, x).
fn upper_fraction(a: f64, x: f64) -> f64 {
    let tiny = 1e-300;
    let away_from_0 = |value: f64| if value.abs() < tiny { tiny } else { value };
    let mut b = x + 1.0 - a;
    let (mut c, mut d) = (1.0 / tiny, 1.0 / b);
    let mut fraction = d;
    for n in 1..MAX_TERMS {
        let n = n as f64;
        let numerator = -n * (n - a);
        b += 2.0;
        d = 1.0 / away_from_0(numerator * d + b);
        c = away_from_0(b + numerator / c);
        fraction *= d * c;
        if (d * c - 1.0).abs() < 1e-15 {
            break;
        }
    }
    fraction
}

/// Equivalent z of a p-value: the two-sided standard normal quantile of exp(`ln_p_value`).
pub(crate) fn ln_p_to_z(ln_p_value: f64) -> f64 {
    let (mut low, mut high) = (0.0_f64, 1e4_f64);
    for _ in 0..100 {
        let middle = (low + high) / 2.0;
        if chi2_ln_sf(middle * middle, 1) > ln_p_value {
            low = middle;
        } else {
            high = middle;
        }
    }
    (low + high) / 2.0
}

/// Number of draws of the smallest p-value of all tests, and the familywise level that is simulated; other thresholds are
/// extrapolated.
const SIMULATED: (usize, f64) = (2000, 0.05);

/// Familywise min-P thresholds (Westfall and Young 1993): the log p-value below which the smallest of all tests falls
/// with each probability in `levels`. Each of `whitenings` maps scores with covariance `covariance` to independent
/// normal variables of one test; `independent` further tests have one degree of freedom. Other levels than 5 % are
/// extrapolated in proportion, as for independent tests.
pub(crate) fn minp_thresholds(
    covariance: &DMatrix<f64>,
    whitenings: &[DMatrix<f64>],
    independent: usize,
    levels: &[f64],
    seed: u64,
) -> Vec<f64> {
    let mut random = ChaCha12Rng::seed_from_u64(seed);
    let mut normal = || -> f64 { StandardNormal.sample(&mut random) };
    let size = covariance.nrows();
    let all = stacked(whitenings, size) * square_root(covariance);
    let drawn = all * DMatrix::from_fn(size, SIMULATED.0, |_, _| normal());
    let dofs: Vec<usize> = whitenings.iter().map(DMatrix::nrows).collect();
    let mut least: Vec<f64> = (0..SIMULATED.0)
        .map(|draw| {
            let least = least_ln_p(&dofs, drawn.column(draw).as_slice());
            let others = (0..independent).map(|_| chi2_ln_sf(normal().powi(2), 1));
            others.fold(least, f64::min)
        })
        .collect();
    least.sort_by(f64::total_cmp);
    let simulated = least[(SIMULATED.1 * SIMULATED.0 as f64) as usize];
    let threshold = |level: &f64| simulated + (level / SIMULATED.1).ln();
    levels.iter().map(threshold).collect()
}

/// Stacks the rows of all whitening matrices, one matrix for each test, into one matrix.
fn stacked(whitenings: &[DMatrix<f64>], columns: usize) -> DMatrix<f64> {
    let mut all = DMatrix::zeros(whitenings.iter().map(DMatrix::nrows).sum(), columns);
    let mut row = 0;
    for whitening in whitenings {
        all.rows_mut(row, whitening.nrows()).copy_from(whitening);
        row += whitening.nrows();
    }
    all
}

/// Matrix square root R of a covariance matrix, with R Rᵀ equal to the covariance.
fn square_root(covariance: &DMatrix<f64>) -> DMatrix<f64> {
    if covariance.nrows() == 0 {
        return covariance.clone();
    }
    let eigen = SymmetricEigen::new(covariance.clone());
    let mut root = eigen.eigenvectors;
    for (mut column, value) in root.column_iter_mut().zip(eigen.eigenvalues.iter()) {
        column *= value.max(0.0).sqrt();
    }
    root
}

/// Smallest log p-value of χ² tests with degrees of freedom `dofs`, whose whitened scores are in `normal`.
fn least_ln_p(dofs: &[usize], normal: &[f64]) -> f64 {
    // Among tests with equal degrees of freedom, the largest statistic has the smallest p-value.
    let mut greatest: Vec<f64> = vec![0.0; 1 + dofs.iter().copied().max().unwrap_or(0)];
    let mut first = 0;
    for &degrees_of_freedom in dofs {
        let statistic = normal[first..first + degrees_of_freedom]
            .iter()
            .map(|v| v * v)
            .sum::<f64>();
        greatest[degrees_of_freedom] = greatest[degrees_of_freedom].max(statistic);
        first += degrees_of_freedom;
    }
    let each = greatest.iter().enumerate();
    each.map(|(degrees_of_freedom, statistic)| chi2_ln_sf(*statistic, degrees_of_freedom))
        .fold(0.0, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;
    use statrs::distribution::{ChiSquared, ContinuousCDF};

    #[test]
    fn the_survival_function_agrees_with_statrs_and_its_asymptote() {
        for degrees_of_freedom in [1, 2, 3, 7, 40] {
            let chi = ChiSquared::new(degrees_of_freedom as f64).unwrap();
            for statistic in [0.1, 1.0, 3.84, 9.0, 40.0, 90.0] {
                let (own, other) = (
                    chi2_ln_sf(statistic, degrees_of_freedom),
                    chi.sf(statistic).ln(),
                );
                assert!(
                    (own - other).abs() < 1e-8 * (1.0 + other.abs()),
                    "{statistic} {degrees_of_freedom}: {own} {other}"
                );
            }
        }
        // Compared with the asymptotic form exp(-x/2) sqrt(2/(pi x)).
        let far = chi2_ln_sf(1e6, 1);
        let expected = -5e5 + 0.5 * (2.0 / (std::f64::consts::PI * 1e6)).ln();
        assert!((far - expected).abs() < 1e-5, "{far} {expected}");
    }

    #[test]
    fn thresholds_depend_on_how_many_tests_are_independent() {
        let whitening = |index: usize, size: usize| {
            DMatrix::from_fn(1, size, |_, j| f64::from(u8::from(index == j)))
        };
        let one = minp_thresholds(&DMatrix::identity(1, 1), &[whitening(0, 1)], 0, &[0.05], 1)[0];
        assert!((one.exp() / 0.05 - 1.0).abs() < 0.3, "{}", one.exp());
        let ten: Vec<_> = (0..10).map(|i| whitening(i, 10)).collect();
        let independent = minp_thresholds(&DMatrix::identity(10, 10), &ten, 0, &[0.05], 2)[0];
        let expected = 1.0 - 0.95_f64.powf(0.1);
        assert!((independent.exp() / expected - 1.0).abs() < 0.3);
        // Ten perfectly correlated tests are equivalent to one.
        let same = DMatrix::from_element(10, 10, 1.0);
        let same = minp_thresholds(&same, &ten, 0, &[0.05], 3)[0];
        assert!((same.exp() / 0.05 - 1.0).abs() < 0.3);
    }

    #[test]
    fn z_of_p_is_the_two_sided_normal_quantile() {
        assert!((ln_p_to_z(0.05_f64.ln()) - 1.959_964).abs() < 1e-5);
    }
}
