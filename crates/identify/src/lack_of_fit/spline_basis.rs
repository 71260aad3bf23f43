//! Cubic B-splines on evenly spaced knots: a basis for motions that are smooth on the scale of the knot interval.

/// Number of cubic B-splines that are nonzero at a given time.
pub(super) const SUPPORT: usize = 4;

/// Basis of cubic B-splines with evenly spaced knots over a time interval.
#[derive(Clone, Copy, Debug)]
pub(super) struct SplineBasis {
    start: f64,
    knot_interval: f64,
    intervals: usize,
}

impl SplineBasis {
    /// Creates the basis over the interval `start` … `end`, s, with knots at most `knot_interval` seconds apart, or
    /// with [`MAX_INTERVALS`] knot intervals if more would be needed.
    pub fn new((start, end): (f64, f64), knot_interval: f64) -> Self {
        let span = (end - start).max(f64::MIN_POSITIVE);
        let intervals = (span / knot_interval).ceil().clamp(1.0, MAX_INTERVALS);
        Self {
            start,
            knot_interval: span / intervals,
            intervals: intervals as usize,
        }
    }

    /// Number of splines in the basis.
    pub fn len(&self) -> usize {
        self.intervals + SUPPORT - 1
    }

    /// Index of the first spline that is nonzero at `time`, s, and the values of this spline and the next three.
    pub fn at(&self, time: f64) -> (usize, [f64; SUPPORT]) {
        let place = (time - self.start) / self.knot_interval;
        let interval = (place.max(0.0) as usize).min(self.intervals - 1);
        let u = place - interval as f64;
        let v = 1.0 - u;
        let values = [
            v * v * v,
            3.0 * u * u * u - 6.0 * u * u + 4.0,
            3.0 * v * v * v - 6.0 * v * v + 4.0,
            u * u * u,
        ];
        (interval, values.map(|value| value / 6.0))
    }
}

/// Maximum number of knot intervals of a spline basis over one flight; bounds the memory.
const MAX_INTERVALS: f64 = 4096.0;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn splines_sum_to_one_and_reproduce_a_line() {
        let basis = SplineBasis::new((0.5, 2.5), 0.3);
        assert_eq!(basis.len(), 10);
        for k in 0..=20 {
            let time = 0.5 + 0.1 * f64::from(k);
            let (first, values) = basis.at(time);
            assert!(first + SUPPORT <= basis.len());
            assert!((values.iter().sum::<f64>() - 1.0).abs() < 1e-12);
            // The Greville abscissa of spline j is start + (j - 1) knot intervals.
            let line: f64 = (0..SUPPORT)
                .map(|k| values[k] * (0.5 + ((first + k) as f64 - 1.0) * 2.0 / 7.0))
                .sum();
            assert!((line - time).abs() < 1e-12, "{line} {time}");
        }
    }
}
