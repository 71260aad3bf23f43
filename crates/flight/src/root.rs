//! Where a function of one variable changes its sign.

/// Narrows a bracket (`low`, `high`), at whose ends `f` has the values given, of different signs, until it is
/// no wider than `within`, and gives the end where `f` has the sign of `at_high` or is 0: just past the crossing.
///
/// Illinois' false position, and halving whenever that has not halved the bracket in three rounds, so that it
/// always ends.
pub(crate) fn just_past(
    mut f: impl FnMut(f64) -> f64,
    (mut low, mut high): (f64, f64),
    (mut at_low, mut at_high): (f64, f64),
    within: f64,
) -> f64 {
    let rises = at_low < 0.0;
    let mut width = high - low;
    let mut last_moved_high = None;
    for round in 1..=400 {
        if high - low <= within || at_high == 0.0 {
            break;
        }
        let mut middle = high - at_high * (high - low) / (at_high - at_low);
        if round % 3 == 0 {
            if high - low > 0.5 * width {
                middle = 0.5 * (low + high);
            }
            width = high - low;
        }
        // Half a tolerance inside the bracket, so that both of its ends come nearer.
        middle = middle.max(low + 0.5 * within).min(high - 0.5 * within);
        if !(low < middle && middle < high) {
            break;
        }
        let value = f(middle);
        let moves_high = if rises { value >= 0.0 } else { value <= 0.0 };
        let again = last_moved_high.replace(moves_high) == Some(moves_high);
        if moves_high {
            (high, at_high) = (middle, value);
            at_low *= if again { 0.5 } else { 1.0 };
        } else {
            (low, at_low) = (middle, value);
            at_high *= if again { 0.5 } else { 1.0 };
        }
    }
    high
}

#[cfg(test)]
mod tests {
    use super::just_past;
    use proptest::prelude::*;

    #[test]
    fn easy_and_nasty_functions() {
        let mut calls = 0;
        let mut find = |f: fn(f64) -> f64| {
            just_past(
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
        // An end where it is 0 already counts as past.
        assert_eq!(find(|x| 1.0 - x), 1.0);
        assert!(calls < 600, "{calls}");
    }

    proptest! {
        #[test]
        fn cubics(a in -3.0..3.0_f64, root in 0.01..0.99_f64, b in 0.1..5.0_f64) {
            let f = |x: f64| (x - root) * (b + (x - a).powi(2));
            let found = just_past(f, (0.0, 1.0), (f(0.0), f(1.0)), 1e-14);
            prop_assert!((found - root).abs() < 3e-14);
        }
    }
}
