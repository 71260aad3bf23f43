//! Parser for literals with units.

use super::ast::{Number, Quantity, UnitExpr, UnitFactor};
use super::parser::{Parser, Read};
use super::spelling;
use super::token::Token;
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::unit::symbol;

/// Keywords that may follow a literal and must not be parsed as units.
pub(crate) const FOLLOWING: [&str; 6] = ["in", "within", "about", "on", "for", "relative"];

/// Symbol of the inch, which is also a keyword.
pub(crate) const INCH: &str = "in";

const MAX_DOUBLED_EXPONENT: i32 = 126;

impl Parser<'_> {
    pub fn digits(&mut self, what: &str) -> Read<Number> {
        if self.peek() != Token::Number {
            return self.expected(what);
        }
        let number = Number {
            text: self.raw().replace('−', "-"),
            span: self.here(),
        };
        self.advance();
        if let Some((what, bound)) = beyond_range(&number.text) {
            let message = format!("the number {} is too {what}", number.text);
            self.report(Diagnostic::new(Kind::Value, number.span, message).note(bound));
        }
        Ok(number)
    }

    pub fn number(&mut self, what: &str) -> Read<Number> {
        let start = self.here();
        let negative = self.eat(Token::Sign("-"));
        if !negative {
            self.eat(Token::Sign("+"));
        }
        if self.peek() == Token::Name || self.peek() == Token::Sign("(") {
            let is_infinite = ["inf", "infinity", "nan"]
                .iter()
                .any(|word| self.raw().eq_ignore_ascii_case(word));
            let help = match (is_infinite, &*spelling::plain(self.raw())) {
                (true, _) => "every number is finite".to_owned(),
                (_, "pi") => format!(
                    "a quantity that is computed is named with `let`; `pi` is {}",
                    std::f64::consts::PI
                ),
                _ => "a quantity that is computed is named with `let`".to_owned(),
            };
            return self.expected_help(what, Some(help));
        }
        let digits = self.digits(what)?;
        let text = if negative {
            format!("-{}", digits.text)
        } else {
            digits.text
        };
        Ok(Number {
            text,
            span: start.to(digits.span),
        })
    }

    pub fn quantity(&mut self, what: &str) -> Read<Quantity> {
        let number = self.number(what)?;
        let unit = self.optional_unit()?;
        let span = unit
            .as_ref()
            .map_or(number.span, |u| number.span.to(u.span));
        Ok(Quantity { number, unit, span })
    }

    /// Whether the name here begins a line and is no unit, so that a `;` before it was forgotten.
    pub fn begins_anew(&self) -> bool {
        self.first_on_line() && symbol::find(self.raw()).is_none()
    }

    fn at_unit(&self) -> bool {
        match self.peek() {
            Token::Name if self.raw() == INCH => !self.at_keyword_in(),
            Token::Name => !FOLLOWING.contains(&self.raw()) && !self.begins_anew(),
            Token::Sign("/" | "[") => true,
            Token::Number => self.raw() == "1" && self.peek_at(1) == Token::Sign("/"),
            _ => false,
        }
    }

    /// Whether the next token `in` is the keyword before bounds, a range or a frame, rather than the inch.
    pub fn at_keyword_in(&self) -> bool {
        let after = self.raw_at(1);
        match self.peek_at(1) {
            Token::Number | Token::Sign("-" | "+") => true,
            Token::Name => !FOLLOWING.contains(&after),
            _ => false,
        }
    }

    /// Parses the unit that may follow a literal in a declaration; `Ok(None)` if there is no unit.
    pub fn optional_unit(&mut self) -> Read<Option<UnitExpr>> {
        if !self.at_unit() {
            return Ok(None);
        }
        if self.peek() == Token::Sign("[") {
            return self.square_unit().map(Some);
        }
        let unit = self.unit()?;
        if self.at_unit() && self.peek() == Token::Name && !self.first_on_line() {
            let found = self.raw();
            let message = format!("expected the end of the unit, found `{found}`");
            let between = Span {
                start: self.behind().end,
                end: self.here().start,
                ..self.here()
            };
            let fault = Diagnostic::new(Kind::Grammar, self.here(), message)
                .help("write `*` or `·` between units, as in `kg*m^2`")
                .fix(between, "*");
            return self.refuse(fault);
        }
        Ok(Some(unit))
    }

    /// Parses the unit that a declaration may state after the name, as in `: m/s`; `Ok(None)` if there is no colon.
    pub fn unit_behind_colon(&mut self) -> Read<Option<UnitExpr>> {
        if !self.eat(Token::Sign(":")) {
            return Ok(None);
        }
        self.unit_in_brackets_or_not().map(Some)
    }

    /// Parses a unit, such as `m/s` or `[1]`.
    pub fn unit_in_brackets_or_not(&mut self) -> Read<UnitExpr> {
        match self.peek() {
            Token::Sign("[") => self.square_unit(),
            _ => self.unit(),
        }
    }

    /// Parses a unit in square brackets, such as `[m/s^2]`.
    pub fn square_unit(&mut self) -> Read<UnitExpr> {
        let start = self.here();
        self.need(Token::Sign("["), "`[`")?;
        let mut unit = if self.peek() == Token::Sign("?") {
            self.inferred_unit()
        } else {
            self.unit()?
        };
        self.need(Token::Sign("]"), "`]` after the unit")?;
        unit.span = start.to(self.behind());
        Ok(unit)
    }

    fn inferred_unit(&mut self) -> UnitExpr {
        let span = self.here();
        self.advance();
        UnitExpr::symbol(UnitExpr::INFERRED, span)
    }

    /// Parses a product or quotient of powers of unit symbols, such as `kg*m/s^2`; it may begin with `/`.
    pub fn unit(&mut self) -> Read<UnitExpr> {
        let start = self.here();
        let mut factors = Vec::new();
        let mut sign = if self.eat(Token::Sign("/")) { -1 } else { 1 };
        loop {
            self.unit_factor(sign, &mut factors)?;
            sign = match self.peek() {
                Token::Sign("*" | "·") => 1,
                Token::Sign("/") => -1,
                _ => break,
            };
            self.advance();
        }
        Ok(UnitExpr {
            factors,
            span: start.to(self.behind()),
        })
    }

    fn unit_factor(&mut self, sign: i32, factors: &mut Vec<UnitFactor>) -> Read<()> {
        match self.peek() {
            Token::Number if self.raw() == "1" => {
                self.advance();
                Ok(())
            }
            Token::Sign("(") => {
                self.advance();
                let inner = self.nested(Self::unit)?;
                self.need(Token::Sign(")"), "`)` in the unit")?;
                factors.extend(inner.factors.into_iter().map(|f| UnitFactor {
                    doubled: f.doubled * sign,
                    ..f
                }));
                Ok(())
            }
            Token::Name => {
                let factor = self.unit_power()?;
                factors.push(UnitFactor {
                    doubled: factor.doubled * sign,
                    ..factor
                });
                Ok(())
            }
            _ => self.expected("a unit such as `kg` or `m/s^2`"),
        }
    }

    /// Parses one unit symbol with its exponent: `m`, `m^2`, `s⁻¹`, `m^(1/2)`.
    pub fn unit_power(&mut self) -> Read<UnitFactor> {
        let symbol = self.raw().to_owned();
        let start = self.here();
        self.need(Token::Name, "a unit")?;
        let mut doubled = 2;
        if self.peek() == Token::Superscript {
            let n = superscript_value(self.raw());
            self.advance();
            doubled = self.unit_exponent(n.map(|n| n * 2.0), self.behind())?;
        } else if self.eat(Token::Sign("^")) {
            let at = self.here();
            let bracket = self.eat(Token::Sign("("));
            let mut n: Option<f64> = self.number("the power of a unit")?.text.parse().ok();
            if bracket {
                if self.eat(Token::Sign("/")) {
                    let below: Option<f64> = self.digits("a number")?.text.parse().ok();
                    n = n.zip(below).map(|(a, b)| a / b);
                }
                self.need(Token::Sign(")"), "`)` after the power")?;
            }
            doubled = self.unit_exponent(n.map(|n| n * 2.0), at.to(self.behind()))?;
        }
        Ok(UnitFactor {
            symbol,
            doubled,
            span: start.to(self.behind()),
        })
    }

    fn unit_exponent(&mut self, doubled: Option<f64>, span: Span) -> Read<i32> {
        match doubled {
            Some(d) if d.fract() == 0.0 && d.abs() <= f64::from(MAX_DOUBLED_EXPONENT) => {
                Ok(d as i32)
            }
            _ => {
                let message = format!("a unit cannot have the power `{}`", self.slice(span));
                let fault = Diagnostic::new(Kind::Value, span, message);
                self.refuse(fault.note("powers of units are whole or half numbers up to 63"))
            }
        }
    }
}

/// Whether a number is too large or too small to be represented, and the bound; `None` if it is neither.
pub(crate) fn beyond_range(text: &str) -> Option<(&'static str, &'static str)> {
    let value: f64 = text.parse().ok()?;
    let mantissa = text.split(['e', 'E']).next().unwrap_or_default();
    if !value.is_finite() {
        Some(("large", "the largest number is about 1.8e308"))
    } else if value == 0.0 && mantissa.contains(|c| matches!(c, '1'..='9')) {
        Some(("small", "the smallest number above 0 is about 4.9e-324"))
    } else {
        None
    }
}

/// Value of an integer written in superscript digits, such as `⁻²`; `None` if the text is malformed.
pub(super) fn superscript_value(raw: &str) -> Option<f64> {
    let plain: String = raw
        .chars()
        .filter_map(|c| match c {
            '⁺' => None,
            '⁻' => Some('-'),
            '¹' => Some('1'),
            '²' => Some('2'),
            '³' => Some('3'),
            '⁰' => Some('0'),
            other => char::from_digit(other as u32 - '⁴' as u32 + 4, 10),
        })
        .collect();
    plain.parse().ok()
}
