//! How likely it is that a statistic is as great as it is by chance.

use nalgebra::{DMatrix, SymmetricEigen};
use rand::SeedableRng;
use rand_chacha::ChaCha12Rng;
use rand_distr::{Distribution, StandardNormal};
use statrs::function::gamma::ln_gamma;

/// Terms and fractions after which a tail is as exact as numbers are.
const TERMS: usize = 500;

/// The natural logarithm of the probability that chi squared of so many degrees of freedom is greater than this: as a
/// logarithm, because the statistics of strong effects go far beyond what a probability can be written for.
pub fn ln_tail(statistic: f64, freedom: usize) -> f64 {
    let (a, x) = (freedom as f64 / 2.0, statistic / 2.0);
    if freedom == 0 || x <= 0.0 {
        return 0.0;
    }
    let front = a * x.ln() - x - ln_gamma(a);
    if x < a + 1.0 {
        // The lower tail by its series.
        let (mut term, mut sum) = (1.0 / a, 1.0 / a);
        for n in 1..TERMS {
            term *= x / (a + n as f64);
            sum += term;
            if term < sum * 1e-16 {
                break;
            }
        }
        return (-(front + sum.ln()).exp()).ln_1p().min(0.0);
    }
    // The upper tail by its continued fraction (Lentz).
    let tiny = 1e-300;
    let mut b = x + 1.0 - a;
    let (mut c, mut d) = (1.0 / tiny, 1.0 / b);
    let mut fraction = d;
    for n in 1..TERMS {
        let n = n as f64;
        let numerator = -n * (n - a);
        b += 2.0;
        d = numerator * d + b;
        d = 1.0 / if d.abs() < tiny { tiny } else { d };
        c = b + numerator / c;
        c = if c.abs() < tiny { tiny } else { c };
        fraction *= d * c;
        if (d * c - 1.0).abs() < 1e-15 {
            break;
        }
    }
    (front + fraction.ln()).min(0.0)
}

/// The size of a standard normal number that is exceeded, either way, with the probability of this logarithm.
pub fn normal_size(ln_probability: f64) -> f64 {
    let (mut low, mut high) = (0.0_f64, 1e4_f64);
    for _ in 0..100 {
        let middle = (low + high) / 2.0;
        if ln_tail(middle * middle, 1) > ln_probability {
            low = middle;
        } else {
            high = middle;
        }
    }
    (low + high) / 2.0
}

/// A group of columns whose statistic is looked at.
pub struct Group {
    /// Directions within its columns, each scaled so that its part of the scores is standard normal: rows over
    /// all columns.
    pub whitening: DMatrix<f64>,
}

/// How often the greatest statistic of all is drawn.
const DRAWS: usize = 2000;

/// The part of the draws from whose limit those of smaller parts are told.
const PART: f64 = 0.05;

/// The logarithm of the least probability, over all groups at once, that chance alone reaches with each probability of
/// `levels`: the scores are drawn with the correlations that the candidates have. `others` more statistics are drawn
/// apart. Far out the least of many falls as it would for so many that are independent; how many that are is told by
/// the limit that 5 % of the draws reach.
pub fn thresholds(
    covariance: &DMatrix<f64>,
    groups: &[Group],
    others: usize,
    levels: &[f64],
    seed: u64,
) -> Vec<f64> {
    let mut random = ChaCha12Rng::seed_from_u64(seed);
    let mut normal = || -> f64 { StandardNormal.sample(&mut random) };
    let size = covariance.nrows();
    let mut root = covariance.clone();
    if size > 0 {
        let eigen = SymmetricEigen::new(root);
        root = eigen.eigenvectors;
        for (mut column, value) in root.column_iter_mut().zip(eigen.eigenvalues.iter()) {
            column *= value.max(0.0).sqrt();
        }
    }
    let rows: usize = groups.iter().map(|group| group.whitening.nrows()).sum();
    let mut all = DMatrix::zeros(rows, size);
    let mut at = 0;
    for group in groups {
        let count = group.whitening.nrows();
        all.rows_mut(at, count).copy_from(&group.whitening);
        at += count;
    }
    let drawn = all * root * DMatrix::from_fn(size, DRAWS, |_, _| normal());
    let sizes: Vec<usize> = groups.iter().map(|group| group.whitening.nrows()).collect();
    let mut least: Vec<f64> = (0..DRAWS)
        .map(|draw| {
            // Of those with as many degrees of freedom only the greatest counts.
            let mut greatest: Vec<f64> = vec![0.0; 1 + sizes.iter().copied().max().unwrap_or(0)];
            let mut at = 0;
            for &count in &sizes {
                let statistic = drawn.view((at, draw), (count, 1)).norm_squared();
                greatest[count] = greatest[count].max(statistic);
                at += count;
            }
            let each = greatest.iter().enumerate();
            let least = each.map(|(count, statistic)| ln_tail(*statistic, count));
            let apart = (0..others).map(|_| ln_tail(normal().powi(2), 1));
            least.chain(apart).fold(0.0, f64::min)
        })
        .collect();
    least.sort_by(f64::total_cmp);
    let limit = least[(PART * DRAWS as f64) as usize];
    levels
        .iter()
        .map(|level| limit + (level / PART).ln())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use statrs::distribution::{ChiSquared, ContinuousCDF};

    #[test]
    fn the_tail_is_that_of_a_library_where_that_has_one() {
        for freedom in [1, 2, 3, 7, 40] {
            let chi = ChiSquared::new(freedom as f64).unwrap();
            for statistic in [0.1, 1.0, 3.84, 9.0, 40.0, 90.0] {
                let (local, other) = (ln_tail(statistic, freedom), chi.sf(statistic).ln());
                assert!(
                    (local - other).abs() < 1e-8 * (1.0 + other.abs()),
                    "{statistic} {freedom}: {local} {other}"
                );
            }
        }
        // By its asymptotic form, exp(-x/2) sqrt(2/(pi x)).
        let far = ln_tail(1e6, 1);
        let expected = -5e5 + 0.5 * (2.0 / (std::f64::consts::PI * 1e6)).ln();
        assert!((far - expected).abs() < 1e-5, "{far} {expected}");
    }

    #[test]
    fn the_greatest_of_one_is_its_own_quantile_and_of_ten_apart_is_that_of_ten() {
        let group = |index: usize, size: usize| Group {
            whitening: DMatrix::from_fn(1, size, |_, j| f64::from(u8::from(index == j))),
        };
        let one = thresholds(&DMatrix::identity(1, 1), &[group(0, 1)], 0, &[0.05], 1)[0];
        assert!((one.exp() / 0.05 - 1.0).abs() < 0.3, "{}", one.exp());
        let ten: Vec<Group> = (0..10).map(|i| group(i, 10)).collect();
        let apart = thresholds(&DMatrix::identity(10, 10), &ten, 0, &[0.05], 2)[0];
        let expected = 1.0 - 0.95_f64.powf(0.1);
        assert!((apart.exp() / expected - 1.0).abs() < 0.3);
        // Ten that say the same are as one.
        let same = thresholds(&DMatrix::from_element(10, 10, 1.0), &ten, 0, &[0.05], 3)[0];
        assert!((same.exp() / 0.05 - 1.0).abs() < 0.3);
    }

    #[test]
    fn a_normal_number_of_two_sizes() {
        assert!((normal_size(0.05_f64.ln()) - 1.959_964).abs() < 1e-5);
    }
}
