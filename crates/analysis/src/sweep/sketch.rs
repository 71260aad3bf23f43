//! Quantiles of a stream of values from counts in logarithmic bins (Masson, Rim & Lee, "DDSketch", PVLDB 12, 2019).
//! Counts add up, so the result does not depend on the order of the values or on how they are divided into parts.

/// Maximum relative error of a quantile that is estimated from the bins of a [`Sketch`].
pub(crate) const ACCURACY: f64 = 1e-4;
/// Smallest magnitude that the bins of the quantile sketch resolve. Smaller nonzero magnitudes are counted in the bin
/// of their sign that is nearest to zero.
const MIN_MAGNITUDE: f64 = 1e-9;
/// Maximum bin number of the quantile sketch, which counts all magnitudes of about 1e12 and above; together with
/// [`MIN_MAGNITUDE`] it limits the number of bins and thus the memory.
const MAX_BIN: i32 = 242_000;

/// Counts of values in logarithmic bins, from which quantiles are estimated: (bin, count) pairs of the nonempty bins,
/// in ascending order of the values. Negative bins hold negative values, and bin 0 holds zeros.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Sketch(Vec<(i32, u64)>);

/// Natural logarithm of the ratio of the upper to the lower bound of a bin of the quantile sketch; all bins have the
/// same ratio.
fn log_ratio() -> f64 {
    ((1.0 + ACCURACY) / (1.0 - ACCURACY)).ln()
}

impl Sketch {
    /// Counts the values in the bins; none of the values may be NaN.
    pub(crate) fn of(values: impl Iterator<Item = f64>) -> Sketch {
        let one_over = 1.0 / log_ratio();
        let class = |value: f64| {
            let magnitude = value.abs();
            if magnitude == 0.0 {
                return 0;
            }
            let class =
                ((magnitude / MIN_MAGNITUDE).ln() * one_over).clamp(0.0, f64::from(MAX_BIN));
            let class = 1 + class as i32;
            if value > 0.0 { class } else { -class }
        };
        let mut classes: Vec<i32> = values.map(class).collect();
        classes.sort_unstable();
        let mut counts: Vec<(i32, u64)> = Vec::new();
        for class in classes {
            match counts.last_mut() {
                Some((last, count)) if *last == class => *count += 1,
                _ => counts.push((class, 1)),
            }
        }
        Sketch(counts)
    }

    /// Adds the counts of the bins of another sketch to those of this one.
    pub(crate) fn merge(&mut self, other: &Sketch) {
        let mut merged = Vec::with_capacity(self.0.len() + other.0.len());
        let (mut a, mut b) = (self.0.iter().peekable(), other.0.iter().peekable());
        loop {
            match (a.peek(), b.peek()) {
                (Some((x, n)), Some((y, m))) if x == y => {
                    merged.push((*x, n + m));
                    a.next();
                    b.next();
                }
                (Some((x, _)), Some((y, _))) if x < y => merged.extend(a.next()),
                (Some(_), None) => merged.extend(a.next()),
                (_, Some(_)) => merged.extend(b.next()),
                (None, None) => break,
            }
        }
        self.0 = merged;
    }

    /// Estimate of the quantile of the counted values at the probability `q`, from 0 to 1; NaN if there are no values.
    pub(crate) fn quantile(&self, q: f64) -> f64 {
        let total: u64 = self.0.iter().map(|(_, count)| count).sum();
        let rank = q * (total.saturating_sub(1)) as f64;
        let mut below = 0;
        for (class, count) in &self.0 {
            below += count;
            if below as f64 > rank {
                let middle = f64::from(class.abs()) - 0.5;
                let magnitude = MIN_MAGNITUDE * (middle * log_ratio()).exp();
                return f64::from(class.signum()) * magnitude;
            }
        }
        f64::NAN
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_within_the_accuracy_however_the_numbers_are_divided() {
        let numbers: Vec<f64> = (0..10_001)
            .map(|k| (f64::from(k) - 3000.0) * 0.01)
            .collect();
        let whole = Sketch::of(numbers.iter().copied());
        let mut parts = Sketch::default();
        for part in numbers.rchunks(77) {
            parts.merge(&Sketch::of(part.iter().copied()));
        }
        assert_eq!(whole, parts);
        for (q, expected) in [
            (0.0, -30.0),
            (0.1, -20.0),
            (0.3, 0.0),
            (0.5, 20.0),
            (1.0, 70.0),
        ] {
            let found = whole.quantile(q);
            assert!(
                (found - expected).abs() <= 1.01e-4 * expected.abs(),
                "{q}: {found}"
            );
        }
        assert!(Sketch::default().quantile(0.5).is_nan());
        assert!(Sketch::of([1e300, -1e300].into_iter()).quantile(1.0) > 1e11);
    }
}
