//! Limits of what a page shows, and reduction of the number of points in figures, so that pages remain small.

use model_spec::sort_by_number;

/// Maximum number of points of a curve in a figure.
pub(crate) const MAX_CURVE_POINTS: usize = 400;
/// Maximum number of dots of one kind in a panel.
pub(crate) const MAX_DOTS: usize = 1500;
/// Maximum number of rows of a table or a chart, and of items of a list.
pub(crate) const MAX_ROWS: usize = 60;
/// Maximum number of flights in a figure that shows all flights, and maximum number of figures of single flights.
pub(crate) const MAX_FLIGHTS: usize = 12;
/// Maximum number of figures of one kind other than of flights, and of lines in a figure.
pub(crate) const MAX_FIGURES: usize = 24;

/// Every n-th of `points`, with the smallest n for which at most `most` points remain.
pub(crate) fn stride<T: Copy>(points: &[T], most: usize) -> Vec<T> {
    let step = points.len().div_ceil(most.max(1)).max(1);
    points.iter().copied().step_by(step).collect()
}

/// Thins a curve to about `most` points, so that peaks and gaps (NaN) remain.
pub(crate) fn curve(points: &[(f64, f64)], most: usize) -> Vec<(f64, f64)> {
    if points.len() <= most {
        return points.to_vec();
    }
    let length = points.len().div_ceil((most / 3).max(1));
    let mut kept = Vec::with_capacity(most);
    for part in points.chunks(length) {
        let by = |a: &usize, b: &usize| part[*a].1.total_cmp(&part[*b].1);
        // NaN is an extreme in the total order; it is retained and interrupts the line.
        let extremes = [
            0,
            (0..part.len()).min_by(by).unwrap_or(0),
            (0..part.len()).max_by(by).unwrap_or(0),
        ];
        let mut extremes = extremes.to_vec();
        extremes.sort_unstable();
        extremes.dedup();
        kept.extend(extremes.into_iter().map(|i| part[i]));
    }
    kept
}

/// The items in their order or, if there are more than `most`, the largest first; NaN is largest, no size smallest.
pub(crate) fn largest_first<T>(
    mut items: Vec<T>,
    most: usize,
    size: impl Fn(&T) -> Option<f64>,
) -> Vec<T> {
    if items.len() > most {
        sort_by_number(&mut items, |item| match size(item) {
            Some(size) if size.is_nan() => f64::NEG_INFINITY,
            Some(size) => -size,
            None => f64::INFINITY,
        });
    }
    items
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn peaks_and_gaps_survive() {
        let mut points: Vec<(f64, f64)> = (0..10_000).map(|i| (f64::from(i), 0.0)).collect();
        points[4321].1 = 7.0;
        points[1234].1 = f64::NAN;
        let thin = curve(&points, 400);
        assert!(thin.len() <= 402, "{}", thin.len());
        assert!(thin.contains(&(4321.0, 7.0)) && thin.iter().any(|p| p.1.is_nan()));
        assert!(thin.is_sorted_by(|a, b| a.0 < b.0));
        assert_eq!(stride(&points, 400).len(), 400);
        assert!(stride::<u8>(&[], 400).is_empty());
    }
}
