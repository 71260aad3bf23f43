//! Formatting of numbers in sentences.

/// Formats a number with about three significant figures: no decimal from 100 on, two decimals from 1 on, four decimals
/// below 1. Absolute values below 0.001 (other than 0) and from 10 000 on are in exponential notation with two
/// decimals.
pub(crate) fn three_figures(value: f64) -> String {
    if value != 0.0 && (value.abs() < 1e-3 || value.abs() >= 1e4) {
        format!("{value:.2e}")
    } else if value.abs() >= 100.0 {
        format!("{value:.0}")
    } else if value.abs() >= 1.0 {
        format!("{value:.2}")
    } else {
        format!("{value:.4}")
    }
}

/// Formats a length in m as millimetres with one decimal.
pub(crate) fn millimetres(metres: f64) -> String {
    format!("{:.1} mm", 1e3 * metres)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_three_figures() {
        let cases = [
            (0.0, "0.0000"),
            (0.01234, "0.0123"),
            (-2.5, "-2.50"),
            (312.4, "312"),
            (2.5e-4, "2.50e-4"),
            (31_000.0, "3.10e4"),
        ];
        for (value, text) in cases {
            assert_eq!(three_figures(value), text);
        }
        assert_eq!(millimetres(0.01234), "12.3 mm");
    }
}
