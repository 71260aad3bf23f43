//! Medians, and a robust standard deviation computed from one.

use nalgebra::Vector3;

/// Ratio of the standard deviation of normal values with mean 0 to their median absolute value.
const SIGMA_PER_MEDIAN: f64 = 1.4826;

/// Median: the middle value, or the mean of the two middle values; 0 for no values. Reorders the values.
#[inline] // compiled at the optimisation level of the caller
pub fn median(values: &mut [f64]) -> f64 {
    if values.is_empty() {
        return 0.0;
    }
    let middle = values.len() / 2;
    let is_even = values.len().is_multiple_of(2);
    let (below, &mut upper, _) = values.select_nth_unstable_by(middle, f64::total_cmp);
    match is_even {
        true => {
            let lower = below.iter().copied().max_by(f64::total_cmp);
            lower.map_or(upper, |lower| lower.midpoint(upper))
        }
        false => upper,
    }
}

/// Median of the values of an iterator; `None` for no values.
pub fn median_of(values: impl IntoIterator<Item = f64>) -> Option<f64> {
    let mut values: Vec<f64> = values.into_iter().collect();
    (!values.is_empty()).then(|| median(&mut values))
}

/// Component-wise median of vectors; `None` for no vectors.
pub fn median_vector(vectors: &[Vector3<f64>]) -> Option<Vector3<f64>> {
    let component = |axis: usize| median_of(vectors.iter().map(|vector| vector[axis]));
    Some(Vector3::new(component(0)?, component(1)?, component(2)?))
}

/// Robust standard deviation of normal values with mean 0: 1.4826 times the median size. Reorders the values.
pub fn robust_sigma(absolute_values: &mut [f64]) -> f64 {
    SIGMA_PER_MEDIAN * median(absolute_values)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_even_count_has_the_mean_of_the_middle_pair() {
        assert_eq!(median(&mut [4.0, 1.0]), 2.5);
        assert_eq!(median(&mut [3.0, 9.0, 1.0, 2.0]), 2.5);
        assert_eq!(median(&mut [3.0, 1.0, 2.0]), 2.0);
        assert_eq!(median(&mut []), 0.0);
        assert_eq!(
            median(&mut [f64::INFINITY, 1.0, f64::INFINITY, 2.0]),
            f64::INFINITY
        );
    }

    #[test]
    fn outliers_do_not_move_it() {
        assert_eq!(median(&mut [1.0, 1.1, 0.9, 1e9, 1.0]), 1.0);
    }
}
