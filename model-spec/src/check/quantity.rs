//! Evaluation of literals with units: SI values, and exact rational values where possible.

use super::Checker;
use super::unitless::Unitless;
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::syntax::ast::{File, Number, UnitExpr};
use crate::syntax::reserved::FIXED;
use crate::unit::{Unit, symbol};

/// Evaluated unit expression: SI unit and conversion factor to it.
#[derive(Clone, Debug)]
pub(super) struct Measure {
    pub unit: Unit,
    pub factor: f64,
    pub exact: Option<(i128, i128)>,
    /// Text of the unit: as written in the file if the conversion factor is 1, otherwise that of the SI unit.
    pub text: String,
}

impl Measure {
    pub fn one() -> Measure {
        Measure {
            unit: Unit::ONE,
            factor: 1.0,
            exact: Some((1, 1)),
            text: "1".to_owned(),
        }
    }

    /// SI value of a literal in this unit, and its exact (numerator, denominator) if they fit `i64`.
    pub fn of(&self, number: &Number) -> (f64, Option<(i64, i64)>) {
        let decimal = number.text.parse::<f64>().unwrap_or(0.0);
        let exact = self.exact.and_then(|(above, below)| {
            let (n, d) = fraction(&number.text)?;
            reduced(n.checked_mul(above)?, d.checked_mul(below)?)
        });
        const MAX_EXACT: u64 = 1 << 53;
        let value = match exact {
            // A division of two integers up to 2^53 rounds only once.
            Some((n, d)) if n.unsigned_abs() <= MAX_EXACT && d.unsigned_abs() <= MAX_EXACT => {
                n as f64 / d as f64
            }
            _ => decimal * self.factor,
        };
        (value, exact)
    }
}

/// Converts decimal text to a fraction (numerator, denominator), not reduced; `None` if it is too long for `i128`.
fn fraction(text: &str) -> Option<(i128, i128)> {
    let (mantissa, exponent) = match text.find(['e', 'E']) {
        Some(i) => (&text[..i], text[i + 1..].parse::<i32>().ok()?),
        None => (text, 0),
    };
    let (whole, decimals) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    if whole.len() + decimals.len() > 30 || exponent.abs() > 30 {
        return None;
    }
    let digits: i128 = format!("{whole}{decimals}").parse().ok()?;
    let shift = exponent - decimals.len() as i32;
    let power = 10_i128.checked_pow(shift.unsigned_abs())?;
    if shift >= 0 {
        Some((digits.checked_mul(power)?, 1))
    } else {
        Some((digits, power))
    }
}

/// Reduces a fraction to lowest terms; `None` if numerator or denominator exceeds `i64`.
fn reduced(above: i128, below: i128) -> Option<(i64, i64)> {
    let (mut a, mut b) = (above.unsigned_abs(), below.unsigned_abs());
    while b != 0 {
        (a, b) = (b, a % b);
    }
    let divisor = i128::try_from(a.max(1)).ok()?;
    Some((
        i64::try_from(above / divisor).ok()?,
        i64::try_from(below / divisor).ok()?,
    ))
}

/// SI value of a literal with a unit; `None` if a unit symbol is unknown or the unit is out of range.
pub(crate) fn si_value(number: &Number, unit: &UnitExpr) -> Option<f64> {
    let nothing = File::default();
    let measure = Checker::new(&nothing, &[], Unitless::default()).measure(unit)?;
    Some(measure.of(number).0)
}

impl Checker<'_> {
    /// SI unit and conversion factor of a unit expression; reports an invalid one.
    pub fn measure(&mut self, unit: &UnitExpr) -> Option<Measure> {
        let mut out = Measure::one();
        for factor in &unit.factors {
            let Some(found) = symbol::find(&factor.symbol) else {
                self.unknown_unit(&factor.symbol, factor.span);
                return None;
            };
            let product = found
                .unit
                .checked_pow_half(factor.doubled)
                .and_then(|u| out.unit.checked_mul(u));
            let Some(product) = product else {
                let message = format!("the unit `{unit}` has a power out of range");
                let fault = Diagnostic::new(Kind::Value, unit.span, message);
                return self
                    .refuse(fault.note("powers of units are whole or half numbers up to 63"));
            };
            out.unit = product;
            if factor.doubled % 2 == 0 {
                let power = factor.doubled / 2;
                out.factor *= found.factor.powi(power);
                out.exact = out
                    .exact
                    .zip(found.exact)
                    .and_then(|((n, d), (above, below))| {
                        let p = power.unsigned_abs();
                        let (above, below) = (above.checked_pow(p)?, below.checked_pow(p)?);
                        let (above, below) = if power < 0 {
                            (below, above)
                        } else {
                            (above, below)
                        };
                        Some((n.checked_mul(above)?, d.checked_mul(below)?))
                    });
            } else {
                out.factor *= found.factor.powf(f64::from(factor.doubled) / 2.0);
                out.exact = out.exact.filter(|_| found.factor == 1.0);
            }
        }
        // The rational factor is more accurate than the product of rounded factors.
        if let Some((n, d)) = out.exact {
            out.factor = n as f64 / d as f64;
        }
        if out.factor == 0.0 || !out.factor.is_finite() {
            let message = format!("the unit `{unit}` is too small or too large for a number");
            return self.refuse(Diagnostic::new(Kind::Value, unit.span, message));
        }
        // A pure number has one name, however the file writes it.
        out.text = if out.factor == 1.0 && !unit.factors.is_empty() {
            unit.to_string()
        } else {
            out.unit.to_string()
        };
        Some(out)
    }

    fn unknown_unit(&mut self, symbol: &str, span: Span) {
        if symbol == UnitExpr::INFERRED {
            let message = "a unit is inferred only where a number is declared";
            let fault = Diagnostic::new(Kind::Name, span, message);
            self.report(fault.help("write the unit, or leave it out"));
            return;
        }
        let mut fault = Diagnostic::new(Kind::Name, span, format!("there is no unit `{symbol}`"));
        let name = crate::syntax::spelling::plain(symbol);
        if self.scope.find(&name).is_some() || FIXED.contains(&name.as_str()) {
            let note = "a name right behind a number is read as its unit";
            fault = fault
                .note(note)
                .help(format!("to multiply, write `*` before `{symbol}`"))
                .fix(span.before(), "*");
        } else {
            fault = fault.note(format!("units are made of {}", symbol::listed()));
            if let Some(near) = symbol::suggest(symbol) {
                fault = fault.suggest(near);
            }
        }
        self.report(fault);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_are_exact() {
        let number = |t: &str| Number {
            text: t.to_owned(),
            span: Span::default(),
        };
        let one = Measure::one();
        assert_eq!(one.of(&number("0.175")), (0.175, Some((7, 40))));
        assert_eq!(one.of(&number("-3.4e-5")), (-3.4e-5, Some((-17, 500_000))));
        assert_eq!(one.of(&number("1e300")), (1e300, None));
        let gram = Measure {
            factor: 0.001,
            exact: Some((1, 1000)),
            ..Measure::one()
        };
        assert_eq!(gram.of(&number("175")), (0.175, Some((7, 40))));
    }
}
