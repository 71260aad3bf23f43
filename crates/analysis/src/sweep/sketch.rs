//! Quantiles of a stream of values from counts in logarithmic bins (Masson, Rim & Lee, "DDSketch", PVLDB 12, 2019).
//! Counts add up, so the result does not depend on the order of the values or on how they are divided into parts.

/// Maximum relative error of a quantile.
pub(crate) const ACCURACY: f64 = 1e-4;
/// Smallest magnitude that the bins resolve; smaller ones are in the bin of their sign that is nearest to zero.
const MIN_MAGNITUDE: f64 = 1e-9;
/// Maximum bin number, for magnitudes from about 1e12; it limits the memory.
const MAX_BIN: i32 = 242_000;

/// Counts of values in logarithmic bins, ascending; negative bins hold negative values, bin 0 zeros.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Sketch(Vec<(i32, u64)>);

/// Natural logarithm of the ratio of the bounds of a bin.
fn log_ratio() -> f64 {
    ((1.0 + ACCURACY) / (1.0 - ACCURACY)).ln()
}

impl Sketch {
    /// Counts values, none of which is NaN.
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

    /// Adds the counts of another sketch.
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

    /// Quantile at the probability `q`, linear between the values of neighbouring ranks (type 7 of Hyndman and Fan, The
    /// American Statistician 50, 1996); NaN if there are no values.
    pub(crate) fn quantile(&self, q: f64) -> f64 {
        let total: u64 = self.0.iter().map(|(_, count)| count).sum();
        let rank = q * (total.saturating_sub(1)) as f64;
        let (below, above) = (self.ranked(rank.floor()), self.ranked(rank.ceil()));
        below + (above - below) * rank.fract()
    }

    /// Value of a rank, from 0 for the smallest; NaN if there are fewer values.
    fn ranked(&self, rank: f64) -> f64 {
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
        let two = Sketch::of([1.0, 3.0].into_iter());
        for (q, expected) in [(0.05, 1.1), (0.5, 2.0), (0.95, 2.9)] {
            assert!((two.quantile(q) - expected).abs() < 3e-4, "{q}");
        }
        assert!(Sketch::default().quantile(0.5).is_nan());
        assert!(Sketch::of([1e300, -1e300].into_iter()).quantile(1.0) > 1e11);
    }
}
