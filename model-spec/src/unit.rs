//! Units of measure as exponents of the seven SI base units and of the radian.
//!
//! The radian is stored so that messages can state `rad/s`, but units are compared without it, as in the SI.

use std::fmt;

pub mod symbol;

/// A base unit of SI, or the radian, by its index in [`Unit::doubled`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[allow(missing_docs)]
pub enum Base {
    Metre,
    Kilogram,
    Second,
    Ampere,
    Kelvin,
    Mole,
    Candela,
    Radian,
}

/// A unit of measure as twice the exponents of the base units, for square roots.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Unit {
    /// Twice the exponent of each [`Base`] unit, in the order of the enum.
    pub doubled: [i8; 8],
}

/// Symbols of the base units, in the order of [`Base`].
const SYMBOLS: [&str; 8] = ["m", "kg", "s", "A", "K", "mol", "cd", "rad"];

/// Indices into [`SYMBOLS`] in printing order, in which kg precedes m.
const PRINT_ORDER: [usize; 8] = [1, 0, 2, 3, 4, 5, 6, 7];

impl Unit {
    /// The unit 1 of dimensionless quantities.
    pub const ONE: Unit = Unit { doubled: [0; 8] };
    /// Metre, m.
    pub const METRE: Unit = Unit::of([1, 0, 0, 0, 0, 0, 0, 0]);
    /// Kilogram, kg.
    pub const KILOGRAM: Unit = Unit::of([0, 1, 0, 0, 0, 0, 0, 0]);
    /// Second, s.
    pub const SECOND: Unit = Unit::of([0, 0, 1, 0, 0, 0, 0, 0]);
    /// Radian, rad.
    pub const RADIAN: Unit = Unit::of([0, 0, 0, 0, 0, 0, 0, 1]);
    /// Metre per second, m/s.
    pub const SPEED: Unit = Unit::of([1, 0, -1, 0, 0, 0, 0, 0]);
    /// Radian per second, rad/s.
    pub const RATE: Unit = Unit::of([0, 0, -1, 0, 0, 0, 0, 1]);
    /// Metre per second squared, m/s².
    pub const ACCELERATION: Unit = Unit::of([1, 0, -2, 0, 0, 0, 0, 0]);
    /// Radian per second squared, rad/s².
    pub const ANGULAR_ACCELERATION: Unit = Unit::of([0, 0, -2, 0, 0, 0, 0, 1]);
    /// Newton, kg m/s².
    pub const NEWTON: Unit = Unit::of([1, 1, -2, 0, 0, 0, 0, 0]);
    /// Newton metre, kg m²/s².
    pub const NEWTON_METRE: Unit = Unit::of([2, 1, -2, 0, 0, 0, 0, 0]);
    /// Kilogram square metre, kg m².
    pub const INERTIA: Unit = Unit::of([2, 1, 0, 0, 0, 0, 0, 0]);

    /// Unit with the given integer exponents, in the order of [`Base`].
    pub const fn of(exponents: [i8; 8]) -> Unit {
        let mut doubled = [0; 8];
        let mut i = 0;
        while i < 8 {
            doubled[i] = exponents[i] * 2;
            i += 1;
        }
        Unit { doubled }
    }

    /// Unit of the product of two quantities; `None` if an exponent overflows.
    pub fn checked_mul(self, other: Unit) -> Option<Unit> {
        let mut doubled = [0; 8];
        for (i, d) in doubled.iter_mut().enumerate() {
            *d = self.doubled[i].checked_add(other.doubled[i])?;
        }
        Some(Unit { doubled })
    }

    /// Unit of the quotient of two quantities; `None` if an exponent overflows.
    pub fn checked_div(self, other: Unit) -> Option<Unit> {
        self.checked_mul(other.checked_powi(-1)?)
    }

    /// Unit of the `n`-th power of a quantity that has this unit; `None` if an exponent overflows.
    pub fn checked_powi(self, n: i32) -> Option<Unit> {
        self.checked_pow_half(n.checked_mul(2)?)
    }

    /// The unit to the power `twice / 2`; `None` if an exponent is no multiple of 1/2 or overflows.
    pub fn checked_pow_half(self, twice: i32) -> Option<Unit> {
        let mut doubled = [0; 8];
        for (i, d) in doubled.iter_mut().enumerate() {
            let product = i32::from(self.doubled[i]).checked_mul(twice)?;
            if product % 2 != 0 {
                return None;
            }
            *d = i8::try_from(product / 2).ok()?;
        }
        Some(Unit { doubled })
    }

    /// The unit to the power `above / below`; `None` if an exponent is no multiple of 1/2 or overflows.
    pub fn checked_pow(self, above: i64, below: i64) -> Option<Unit> {
        let mut doubled = [0; 8];
        for (power, own) in doubled.iter_mut().zip(self.doubled) {
            let product = i64::from(own).checked_mul(above)?;
            *power = i8::try_from(product.checked_div(below)?).ok()?;
            if i64::from(*power).checked_mul(below)? != product {
                return None;
            }
        }
        Some(Unit { doubled })
    }

    /// Whether two units are equal; the radian counts as 1.
    pub fn agrees(self, other: Unit) -> bool {
        self.doubled[..7] == other.doubled[..7]
    }

    /// Whether the unit is dimensionless; angles count as dimensionless.
    pub fn is_pure(self) -> bool {
        self.agrees(Unit::ONE)
    }

    /// Removes a radian beside base units other than the second (`m*rad/s²` is `m/s²`), above the power 1, or in a divisor
    /// beside the second.
    #[must_use]
    pub fn tidy(self) -> Unit {
        let mut tidied = self;
        let others = [0, 1, 3, 4, 5, 6].iter().any(|&i| self.doubled[i] != 0);
        if others || self.doubled[7] > 2 || self.doubled[7] < 0 && self.doubled[2] != 0 {
            tidied.doubled[7] = 0;
        }
        tidied
    }

    /// Text of the unit with dots and superscripts, such as `kg·m²/s²`.
    pub fn pretty(self) -> String {
        self.written("·", |twice| {
            if twice % 2 == 0 {
                superscript(i32::from(twice) / 2)
            } else {
                format!("^({twice}/2)")
            }
        })
    }

    /// Symbol of the derived SI unit, such as `N`, if one is known.
    pub fn named(self) -> Option<&'static str> {
        let unit = self.tidy();
        let units = [
            ("N", Unit::NEWTON),
            ("N·m", Unit::NEWTON_METRE),
            ("Pa", Unit::of([-1, 1, -2, 0, 0, 0, 0, 0])),
            ("W", Unit::of([2, 1, -3, 0, 0, 0, 0, 0])),
            ("N·s/m", Unit::of([0, 1, -1, 0, 0, 0, 0, 0])),
        ];
        let found = units.into_iter().find(|(_, known)| known.agrees(unit));
        found.map(|(name, _)| name)
    }

    /// Name of the physical quantity, singular and plural, if one is known.
    pub fn quantity(self) -> Option<(&'static str, &'static str)> {
        const NAMES: [([i8; 3], &str, &str); 18] = [
            ([1, 0, 0], "a length", "lengths"),
            ([2, 0, 0], "an area", "areas"),
            ([3, 0, 0], "a volume", "volumes"),
            ([0, 1, 0], "a mass", "masses"),
            ([0, 0, 1], "a time", "times"),
            ([1, 0, -1], "a velocity", "velocities"),
            ([1, 0, -2], "an acceleration", "accelerations"),
            ([1, 1, -2], "a force", "forces"),
            ([2, 1, -2], "a moment or an energy", "moments or energies"),
            ([2, 1, 0], "a moment of inertia", "moments of inertia"),
            ([2, 1, -1], "an angular momentum", "angular momenta"),
            ([1, 1, -1], "a momentum", "momenta"),
            ([2, 1, -3], "a power", "powers"),
            ([-3, 1, 0], "a density", "densities"),
            ([-1, 1, -2], "a pressure", "pressures"),
            ([0, 0, -1], "a rate", "rates"),
            (
                [0, 0, -2],
                "an angular acceleration",
                "angular accelerations",
            ),
            ([0, 0, 0], "a pure number", "pure numbers"),
        ];
        if self.is_pure() && self.doubled[7] == 2 {
            return Some(("an angle", "angles"));
        }
        NAMES
            .iter()
            .find(|([m, kg, s], _, _)| Unit::of([*m, *kg, *s, 0, 0, 0, 0, 0]).agrees(self))
            .map(|&(_, one, many)| (one, many))
    }

    /// Text such as `N = kg·m/s²`, or only base units, such as `m/s²`.
    pub fn explained(self) -> String {
        let tidy = self.tidy();
        match self.named() {
            Some(name) => format!("{name} = {}", tidy.pretty()),
            None => tidy.pretty(),
        }
    }

    /// Iterates over the base units with nonzero exponents, in printing order: symbol, and twice the exponent.
    pub(crate) fn powers(self) -> impl Iterator<Item = (&'static str, i8)> {
        let power = move |&i: &usize| (SYMBOLS[i], self.doubled[i]);
        PRINT_ORDER
            .iter()
            .map(power)
            .filter(|&(_, doubled)| doubled != 0)
    }

    /// Numerator over denominator; `power` returns the text of twice an exponent.
    fn written(self, times: &str, power: impl Fn(i8) -> String) -> String {
        let side = |sign: i8| -> Vec<String> {
            PRINT_ORDER
                .iter()
                .filter(|&&i| self.doubled[i].signum() == sign)
                .map(|&i| {
                    let twice = self.doubled[i].saturating_mul(sign);
                    let power = if twice == 2 {
                        String::new()
                    } else {
                        power(twice)
                    };
                    format!("{}{power}", SYMBOLS[i])
                })
                .collect()
        };
        let (above, below) = (side(1), side(-1));
        let mut text = if above.is_empty() {
            "1".to_owned()
        } else {
            above.join(times)
        };
        match below.len() {
            0 => {}
            1 => text += &format!("/{}", below[0]),
            _ => text += &format!("/({})", below.join(times)),
        }
        text
    }
}

/// Formats the unit in the notation of model files, such as `kg*m^2/s^2`.
impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.written("*", |twice| {
            if twice % 2 == 0 {
                format!("^{}", twice / 2)
            } else {
                format!("^({twice}/2)")
            }
        }))
    }
}

/// Text of an integer in superscript digits, such as `⁻²`.
pub fn superscript(n: i32) -> String {
    n.to_string()
        .chars()
        .map(|c| match c {
            '-' => '⁻',
            '0' => '⁰',
            '1' => '¹',
            '2' => '²',
            '3' => '³',
            other => char::from_u32('⁴' as u32 + (other as u32 - '4' as u32)).unwrap_or(other),
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_written_as_people_write_them() {
        for (unit, plain, pretty) in [
            (Unit::ONE, "1", "1"),
            (Unit::NEWTON, "kg*m/s^2", "kg·m/s²"),
            (Unit::of([0, 0, 0, 0, 0, 0, 0, -2]), "1/rad^2", "1/rad²"),
            (
                Unit::of([-1, 1, -2, 0, 0, 0, 0, 0]),
                "kg/(m*s^2)",
                "kg/(m·s²)",
            ),
            (
                Unit {
                    doubled: [1, 0, 0, 0, 0, 0, 0, 0],
                },
                "m^(1/2)",
                "m^(1/2)",
            ),
            (Unit::of([12, 0, 0, 0, 0, 0, 0, 0]), "m^12", "m¹²"),
        ] {
            assert_eq!(unit.to_string(), plain);
            assert_eq!(unit.pretty(), pretty);
        }
        assert_eq!(Unit::NEWTON.explained(), "N = kg·m/s²");
    }

    #[test]
    fn the_radian_is_soft() {
        let swept = Unit::SPEED.checked_mul(Unit::RATE).unwrap();
        assert!(swept.agrees(Unit::of([1, 0, -2, 0, 0, 0, 0, 0])));
        assert_eq!(swept.tidy().to_string(), "m/s^2");
        assert_eq!(Unit::RATE.tidy(), Unit::RATE);
        assert_eq!(
            Unit::of([0, 0, -1, 0, 0, 0, 0, -1]).tidy().to_string(),
            "1/s"
        );
        assert_eq!(swept.quantity().unwrap().0, "an acceleration");
    }

    #[test]
    fn exponents_that_leave_the_range_are_refused() {
        assert_eq!(Unit::METRE.checked_powi(64), None);
        assert_eq!(Unit::METRE.checked_powi(i32::MAX), None);
        assert!(Unit::METRE.checked_powi(63).is_some());
        assert_eq!(Unit::METRE.checked_pow_half(1).unwrap().doubled[0], 1);
    }
}
