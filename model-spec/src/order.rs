//! Stable sorting by a floating-point key.

/// Sorts values by a floating-point key, in the order of [`f64::total_cmp`]; the sort is stable. `number` returns the
/// key of a value and is called once for each value. For decreasing order, negate the key.
///
/// ```
/// let mut named = [("a", 2.0), ("b", -3.0), ("c", 2.0)];
/// model_spec::sort_by_number(&mut named, |(_, size): &(&str, f64)| -size.abs());
/// assert_eq!(named, [("b", -3.0), ("a", 2.0), ("c", 2.0)]);
/// ```
pub fn sort_by_number<T>(values: &mut [T], number: impl FnMut(&T) -> f64) {
    let mut order: Vec<(f64, usize)> = values.iter().map(number).zip(0..).collect();
    sort(&mut order);
    for to in 0..values.len() {
        // The value may have been swapped away by an earlier step; its place is then where that step put it.
        let mut from = order[to].1;
        while from < to {
            from = order[from].1;
        }
        order[to].1 = from;
        values.swap(to, from);
    }
}

// Apart, so that the sort is compiled once instead of for each type of value.
fn sort(order: &mut [(f64, usize)]) {
    order.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_order_is_that_of_a_stable_sort(numbers in prop::collection::vec(prop::sample::select(
            vec![0.0, -0.0, 1.5, -2.0, f64::INFINITY, f64::NAN, -f64::NAN, 1e-300]), 0..40)) {
            let mut values: Vec<(f64, usize)> = numbers.into_iter().zip(0..).collect();
            let mut expected = values.clone();
            expected.sort_by(|a, b| a.0.total_cmp(&b.0));
            sort_by_number(&mut values, |value| value.0);
            let places = |values: &[(f64, usize)]| values.iter().map(|value| value.1).collect::<Vec<_>>();
            prop_assert_eq!(places(&values), places(&expected));
        }
    }
}
