//! Ranges, ticks and tick labels of an axis.

/// Smallest interval (minimum, maximum) that contains all finite values; 0 to 1 if there are none.
pub(crate) fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let finite = values.filter(|v| v.is_finite());
    let (low, high) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| {
        (low.min(v), high.max(v))
    });
    if low > high { (0.0, 1.0) } else { (low, high) }
}

/// Widens a range by 6 % of its length at both ends; a range of zero length becomes one of positive length.
pub(super) fn with_room((low, high): (f64, f64)) -> (f64, f64) {
    let size = low.abs().max(high.abs());
    let least = if size == 0.0 { 1.0 } else { 1e-3 * size };
    let room = (0.06 * (high - low)).max(0.5 * (least - (high - low)).max(0.0));
    (low - room, high + room)
}

/// About `most` round values within a range, and the number of decimals of their labels.
pub(crate) fn ticks((low, high): (f64, f64), most: usize) -> (Vec<f64>, usize) {
    let rough = (high - low) / most as f64;
    let power = 10_f64.powf(rough.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .map(|m| m * power)
        .find(|s| *s >= rough * 0.999)
        .unwrap_or(10.0 * power);
    let (first, last) = ((low / step).ceil(), (high / step).floor());
    // Adding 0 avoids −0.
    let ticks = (0..=(last - first) as usize)
        .map(|i| (first + i as f64) * step + 0.0)
        .collect();
    let decimals = (-(step * 1.001).log10().floor()).clamp(0.0, 12.0) as usize;
    (ticks, decimals)
}

/// Formats a tick label with the given number of decimals; exponential notation from 10⁶.
pub(crate) fn number(value: f64, decimals: usize) -> String {
    if value.abs() >= 1e6 {
        return format!("{value:.1e}");
    }
    let text = format!("{value:.decimals$}");
    // A minus sign (U+2212) is as wide as a plus sign.
    text.replace('-', "−")
}

/// Power of ten by which values up to `largest` are divided so that tick labels are readable; 0 if they are as they are.
pub(crate) fn power_of_ten(largest: f64) -> i32 {
    match largest.log10().floor() as i32 {
        power if largest > 0.0 && !(-3..5).contains(&power) => power,
        _ => 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_within() {
        for (range, expected) in [
            ((0.0, 1.0), "0.0 0.2 0.4 0.6 0.8 1.0"),
            ((-0.4, 0.31), "−0.4 −0.2 0.0 0.2"),
            ((-37.2, -35.1), "−37.0 −36.5 −36.0 −35.5"),
            ((0.0, 12345.0), "0 5000 10000"),
            (
                (1.000099, 1.0001201),
                "1.000100 1.000105 1.000110 1.000115 1.000120",
            ),
        ] {
            let (ticks, decimals) = ticks(range, 5);
            assert_eq!(
                ticks
                    .iter()
                    .map(|t| number(*t, decimals))
                    .collect::<Vec<_>>()
                    .join(" "),
                expected
            );
        }
    }

    #[test]
    fn ranges_are_never_empty() {
        assert_eq!(range([f64::NAN].into_iter()), (0.0, 1.0));
        for value in [0.0, 5.0, -1e-9, 1e300] {
            let (low, high) = with_room((value, value));
            assert!(low < value && value < high);
        }
    }
}
