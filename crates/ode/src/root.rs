//! Bracketed root finding in one variable.

/// Iteration limit of the root search; bisection alone would reach adjacent floating-point numbers earlier.
const MAX_ITERATIONS: u32 = 400;

/// Narrows a bracket around a sign change of `f` to at most `width` and returns the end of the bracket past the root.
/// At that end, `f` has the sign of `at_high` or is 0.
///
/// `at_low` and `at_high` are the values of `f` at `low` and `high`, of opposite sign. The method is regula falsi
/// with the Illinois modification, and a bisection step wherever three iterations have not halved the bracket.
pub(crate) fn first_past_root(
    mut f: impl FnMut(f64) -> f64,
    (mut low, mut high): (f64, f64),
    (mut at_low, mut at_high): (f64, f64),
    width: f64,
) -> f64 {
    let rises = at_low < 0.0;
    let mut last_width = high - low;
    let mut last_moved_high = None;
    for iteration in 1..=MAX_ITERATIONS {
        if high - low <= width || at_high == 0.0 {
            break;
        }
        let mut middle = high - at_high * (high - low) / (at_high - at_low);
        if iteration % 3 == 0 {
            if high - low > 0.5 * last_width {
                middle = 0.5 * (low + high);
            }
            last_width = high - low;
        }
        // At least half a tolerance inside the bracket, so that both of its ends converge.
        middle = middle.max(low + 0.5 * width).min(high - 0.5 * width);
        if !(low < middle && middle < high) {
            break;
        }
        let value = f(middle);
        let moves_high = if rises { value >= 0.0 } else { value <= 0.0 };
        let same_end_again = last_moved_high.replace(moves_high) == Some(moves_high);
        let illinois_factor = if same_end_again { 0.5 } else { 1.0 };
        if moves_high {
            (high, at_high) = (middle, value);
            at_low *= illinois_factor;
        } else {
            (low, at_low) = (middle, value);
            at_high *= illinois_factor;
        }
    }
    high
}

#[cfg(test)]
mod tests {
    use super::first_past_root;
    use proptest::prelude::*;

    #[test]
    fn smooth_flat_and_discontinuous_functions() {
        let mut calls = 0;
        let mut find = |f: fn(f64) -> f64| {
            first_past_root(
                |x| {
                    calls += 1;
                    f(x)
                },
                (0.0, 1.0),
                (f(0.0), f(1.0)),
                1e-14,
            )
        };
        assert!((find(|x| x - 0.3) - 0.3).abs() < 2e-14);
        assert!((find(|x| 0.5 - x * x) - 0.5_f64.sqrt()).abs() < 2e-14);
        assert!((find(|x| (x - 0.123).powi(9)) - 0.123).abs() < 1e-6);
        assert!((find(|x| if x < 0.77 { -1e-300 } else { 1e300 }) - 0.77).abs() < 2e-14);
        // A bracket whose end is a root returns that end.
        assert_eq!(find(|x| 1.0 - x), 1.0);
        assert!(calls < 600, "{calls}");
    }

    proptest! {
        #[test]
        fn cubics(a in -3.0..3.0_f64, root in 0.01..0.99_f64, b in 0.1..5.0_f64) {
            let f = |x: f64| (x - root) * (b + (x - a).powi(2));
            let found = first_past_root(f, (0.0, 1.0), (f(0.0), f(1.0)), 1e-14);
            prop_assert!((found - root).abs() < 3e-14);
        }
    }
}
