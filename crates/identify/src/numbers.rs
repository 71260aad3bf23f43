//! Formatting of numbers: digits by the standard error, minus sign U+2212, and a dash for values that are not finite.

use model_spec::model::{Expr, ExprKind};
use model_spec::unit::Unit;

/// Formats a number with the given number of decimals; `–` if it is not finite.
pub fn plain(value: f64, decimals: usize) -> String {
    if !value.is_finite() {
        return "–".to_owned();
    }
    let text = format!("{:.*}", decimals.min(15), value);
    let zero = text.bytes().all(|b| matches!(b, b'-' | b'.' | b'0'));
    let text = if zero {
        text.trim_start_matches('-').to_owned()
    } else {
        text
    };
    text.replace('-', "−")
}

/// Format for a value and its standard error: common power of ten, and number of decimals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Digits {
    exponent: i32,
    decimals: usize,
}

impl Digits {
    /// Two significant digits of the standard error `error`, or five of the value if it is not positive.
    pub fn of(value: f64, error: f64) -> Digits {
        let value = if value.is_finite() { value.abs() } else { 0.0 };
        let known = error.is_finite() && error > 0.0;
        let size = if known { value.max(error) } else { value };
        if size == 0.0 {
            return Digits {
                exponent: 0,
                decimals: 1,
            };
        }
        // For example, an error of 0.0996 is rounded to 0.10.
        let last = if known {
            (error * 1.005).log10().floor() as i32 - 1
        } else {
            size.log10().floor() as i32 - 4
        };
        let first = size.log10().floor() as i32;
        let exponent = if (-3..6).contains(&first) { 0 } else { first };
        let last = last.max(first - 11);
        Digits {
            exponent,
            decimals: (exponent - last).clamp(0, 15) as usize,
        }
    }

    /// Formats the quotient of `value` and the power of ten of this format, without the power itself.
    fn mantissa(self, value: f64) -> String {
        // Division by 1e5 is correctly rounded; multiplication by 1e-5 is not.
        let scaled = if self.exponent < 0 {
            value * 10_f64.powi(-self.exponent)
        } else {
            value / 10_f64.powi(self.exponent)
        };
        plain(scaled, self.decimals)
    }

    /// Formats a number with the power of ten of this format, if it has one.
    pub fn one(self, value: f64) -> String {
        let text = self.mantissa(value);
        if self.exponent == 0 || !value.is_finite() {
            text
        } else {
            format!("{text} · 10{}", raised(self.exponent))
        }
    }

    /// Formats an interval (lower, upper) with a common power of ten, if this format has one.
    pub fn range(self, [low, high]: [f64; 2]) -> String {
        let (low, high) = (self.mantissa(low), self.mantissa(high));
        if self.exponent == 0 {
            format!("{low} … {high}")
        } else {
            format!("({low} … {high}) · 10{}", raised(self.exponent))
        }
    }
}

/// Formats a number with the given number of significant digits.
pub fn significant(value: f64, digits: i32) -> String {
    let unit = 10_f64.powf(value.abs().log10().floor() + 2.0 - f64::from(digits));
    Digits::of(value, unit).one(value)
}

/// Formats a length in m as mm with three significant digits; `–` if it is not finite.
pub fn millimetres(metres: f64) -> String {
    quantity(metres, "m")
}

/// Formats a value in SI units with three significant digits and its unit, lengths in mm; `–` if it is not finite.
pub fn quantity(value: f64, of: &str) -> String {
    if !value.is_finite() {
        return "–".to_owned();
    }
    let (scale, of) = displayed(of);
    format!("{}\u{a0}{}", significant(scale * value, 3), unit(of))
}

/// Unit in which residuals of the SI unit `of` are displayed, and its number in that unit: mm for lengths.
pub fn displayed(of: &str) -> (f64, &str) {
    match of {
        "" | "m" => (1e3, "mm"),
        of => (1.0, of),
    }
}

/// Formats a fraction (0 to 1) as a percentage; `–` if it is not finite.
pub fn percent(share: f64) -> String {
    if !share.is_finite() {
        return "–".to_owned();
    }
    let decimals = usize::from(share.abs() < 0.0995);
    format!("{}\u{a0}%", plain(100.0 * share, decimals))
}

/// Whether an expression is an angle, which is shown in degrees; a product with the unit rad may be a dimensionless ratio,
/// such as the spin ratio.
pub fn is_angle(expr: &Expr) -> bool {
    let is_function = matches!(expr.kind, ExprKind::Atan2(..) | ExprKind::Call(..));
    is_function && expr.unit == Unit::RADIAN
}

/// Typesets a unit, such as `m²` for `m^2`; empty for dimensionless quantities.
pub fn unit(text: &str) -> String {
    if text == "1" {
        return String::new();
    }
    let text = text.replace("^2", "²").replace("^3", "³");
    text.replace('*', "\u{a0}")
}

/// Label of an axis: a name and a unit, which is typeset; the name alone for dimensionless quantities.
pub fn with_unit(name: &str, unit_text: &str) -> String {
    match unit(unit_text).as_str() {
        "" => name.to_owned(),
        unit => format!("{name}, {unit}"),
    }
}

/// Formats a number as in a model file, without trailing zeros; `–` if it is not finite.
pub fn stated(value: f64) -> String {
    let size = value.abs();
    if !value.is_finite() {
        "–".to_owned()
    } else if size != 0.0 && !(1e-3..1e6).contains(&size) {
        let text = format!("{value:e}").replacen('-', "−", usize::from(value < 0.0));
        match text.split_once('e') {
            Some((number, power)) => format!("{number} · 10{}", raised(power.parse().unwrap_or(0))),
            None => text,
        }
    } else {
        format!("{value}").replace('-', "−")
    }
}

/// Typesets an exponent as a superscript.
pub fn raised(exponent: i32) -> String {
    let digit = |c: char| match c {
        '-' => '⁻',
        c => ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'][c as usize - '0' as usize],
    };
    exponent.to_string().chars().map(digit).collect()
}

/// Formats a p-value; `–` if it is not between 0 and 1.
pub fn probability(p: f64) -> String {
    if !(0.0..=1.0).contains(&p) {
        "–".to_owned()
    } else if p >= 1e-3 {
        plain(p, if p < 0.0995 { 3 } else { 2 })
    } else if p > 1e-300 {
        significant(p, 2)
    } else {
        format!("less than 10{}", raised(-300))
    }
}

/// Formats a p-value given as its natural logarithm, which may represent a value below the range of `f64`.
pub fn probability_of_ln(ln_p_value: f64) -> String {
    if ln_p_value.is_nan() || ln_p_value > 0.0 {
        return "–".to_owned();
    }
    if ln_p_value > -20.0 {
        return probability(ln_p_value.exp());
    }
    let power = ln_p_value / std::f64::consts::LN_10;
    if power < -1e9 {
        return "0".to_owned();
    }
    format!("10{}", raised(power.round() as i32))
}

/// Formats a standard normal quantile: one decimal below 99.95, none above.
pub fn equivalent_z(value: f64) -> String {
    plain(value, usize::from(value.abs() < 99.95))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_error_says_how_many_digits() {
        for (value, error, expected) in [
            (0.18812, 0.00314, "0.1881 ± 0.0031"),
            (0.18812, 0.00996, "0.188 ± 0.010"),
            (-3.4e-5, 1.21e-6, "−3.40 · 10⁻⁵ ± 0.12 · 10⁻⁵"),
            (2.37, 0.0, "2.3700 ± 0.0000"),
            (0.0, 0.02, "0.000 ± 0.020"),
            (f64::NAN, 0.02, "– ± 0.020"),
            (1.0, f64::INFINITY, "1.0000 ± –"),
            (1.5, 1e-30, "1.50000000000 ± 0.00000000000"),
            (3e7, 2e5, "3.000 · 10⁷ ± 0.020 · 10⁷"),
        ] {
            let digits = Digits::of(value, error);
            let found = format!("{} ± {}", digits.one(value), digits.one(error));
            assert_eq!(found, expected);
        }
        let digits = Digits::of(-3.4e-5, 1.21e-6);
        assert_eq!(digits.range([-3.6e-5, -3.2e-5]), "(−3.60 … −3.20) · 10⁻⁵");
    }

    #[test]
    fn lengths_and_shares() {
        assert_eq!(millimetres(0.0015234), "1.52\u{a0}mm");
        assert_eq!(millimetres(0.0), "0.0\u{a0}mm");
        assert_eq!(millimetres(f64::NAN), "–");
        assert_eq!(percent(0.0123), "1.2\u{a0}%");
        assert_eq!(percent(0.5), "50\u{a0}%");
        assert_eq!(stated(-3.4e-5), "−3.4 · 10⁻⁵");
        assert_eq!(stated(0.188), "0.188");
        assert_eq!(unit("N*m*s"), "N\u{a0}m\u{a0}s");
        assert_eq!(plain(-0.0001, 2), "0.00");
    }

    #[test]
    fn probabilities_are_written_however_small() {
        for (p, text) in [
            (0.314, "0.31"),
            (0.0042, "0.004"),
            (0.0, "less than 10⁻³⁰⁰"),
            (f64::NAN, "–"),
            (2.0, "–"),
        ] {
            assert_eq!(probability(p), text);
        }
        assert_eq!(probability(1.234e-5), "1.2 · 10⁻⁵");
        assert_eq!(probability_of_ln(-2302.585), "10⁻¹⁰⁰⁰");
        assert_eq!(probability_of_ln(0.314_f64.ln()), "0.31");
        assert_eq!(probability_of_ln(f64::NEG_INFINITY), "0");
    }
}
