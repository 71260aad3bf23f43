//! Summary statistics of samples.

/// Median of the finite values; the mean of the middle two if their number is even. `None` if no value is finite.
pub(crate) fn median(values: impl IntoIterator<Item = f64>) -> Option<f64> {
    let finite = values.into_iter().filter(|value| value.is_finite());
    let mut finite: Vec<f64> = finite.collect();
    (!finite.is_empty()).then(|| dataset::statistics::median(&mut finite))
}

/// Mean and sample standard deviation (divisor n − 1) of `values`. The standard deviation of fewer than two values, and
/// the mean of none, are 0.
pub(crate) fn mean_and_deviation(values: &[f64]) -> (f64, f64) {
    let count = values.len().max(1) as f64;
    let mean = values.iter().sum::<f64>() / count;
    let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
    (mean, (squares / (count - 1.0).max(1.0)).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_median_leaves_out_what_is_no_number() {
        assert_eq!(median([3.0, f64::NAN, 1.0, 2.0]), Some(2.0));
        assert_eq!(median([4.0, 1.0]), Some(2.5));
        assert_eq!(median([f64::NAN]), None);
    }
}
