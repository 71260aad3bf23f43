//! Units that may still be unknown: products of powers of base units and of unknowns, and their solution.
//!
//! Units form an abelian group, so that an equation between two of them determines at most one unknown,
//! and solving never has to guess.

use crate::diagnostic::Span;
use crate::unit::Unit;

/// More unknowns than this in one product are refused rather than carried along.
const MOST_UNKNOWNS: usize = 32;

/// A fraction of small whole numbers, in lowest terms, denominator positive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Fraction {
    above: i32,
    below: i32,
}

impl Fraction {
    const ZERO: Fraction = Fraction { above: 0, below: 1 };
    pub const ONE: Fraction = Fraction { above: 1, below: 1 };

    pub fn new(above: i64, below: i64) -> Option<Fraction> {
        if below == 0 {
            return None;
        }
        let divisor = gcd(above.unsigned_abs(), below.unsigned_abs()) as i64 * below.signum();
        let above = i32::try_from(above / divisor).ok()?;
        let below = i32::try_from(below / divisor).ok()?;
        // Nothing physical has exponents like this; it also keeps sums within range.
        (above.abs() <= 4096 && below <= 4096).then_some(Fraction { above, below })
    }

    fn plus(self, other: Fraction) -> Option<Fraction> {
        let (a, b) = (i64::from(self.above), i64::from(self.below));
        let (c, d) = (i64::from(other.above), i64::from(other.below));
        Fraction::new(a * d + c * b, b * d)
    }

    fn times(self, other: Fraction) -> Option<Fraction> {
        Fraction::new(
            i64::from(self.above) * i64::from(other.above),
            i64::from(self.below) * i64::from(other.below),
        )
    }

    fn is_zero(self) -> bool {
        self.above == 0
    }
}

fn gcd(a: u64, b: u64) -> u64 {
    if b == 0 { a.max(1) } else { gcd(b, a % b) }
}

/// A unit with unknowns.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Term {
    base: [Fraction; 8],
    /// Unknowns and their exponents, none of them zero, in order.
    unknowns: Vec<(u32, Fraction)>,
}

impl Term {
    pub fn one() -> Term {
        Term {
            base: [Fraction::ZERO; 8],
            unknowns: Vec::new(),
        }
    }

    pub fn known(unit: Unit) -> Term {
        let base = unit.doubled.map(|d| {
            let d = i32::from(d);
            if d % 2 == 0 {
                Fraction {
                    above: d / 2,
                    below: 1,
                }
            } else {
                Fraction { above: d, below: 2 }
            }
        });
        Term {
            base,
            unknowns: Vec::new(),
        }
    }

    fn unknown(index: u32) -> Term {
        Term {
            unknowns: vec![(index, Fraction::ONE)],
            ..Term::one()
        }
    }

    /// The product with a power of another; none where it leaves the range.
    pub fn times_power(&self, other: &Term, power: Fraction) -> Option<Term> {
        let mut base = self.base;
        for (b, o) in base.iter_mut().zip(other.base) {
            *b = b.plus(o.times(power)?)?;
        }
        let mut unknowns = self.unknowns.clone();
        for &(index, exponent) in &other.unknowns {
            let exponent = exponent.times(power)?;
            match unknowns.binary_search_by_key(&index, |u| u.0) {
                Ok(i) => {
                    unknowns[i].1 = unknowns[i].1.plus(exponent)?;
                    if unknowns[i].1.is_zero() {
                        unknowns.remove(i);
                    }
                }
                Err(i) => unknowns.insert(i, (index, exponent)),
            }
        }
        unknowns.retain(|u| !u.1.is_zero());
        (unknowns.len() <= MOST_UNKNOWNS).then_some(Term { base, unknowns })
    }

    pub fn power(&self, power: Fraction) -> Option<Term> {
        Term::one().times_power(self, power)
    }

    /// The unit, where nothing is unknown and every exponent is a half number within range.
    pub fn unit(&self) -> Option<Unit> {
        if !self.unknowns.is_empty() {
            return None;
        }
        let mut unit = Unit::ONE;
        for (d, e) in unit.doubled.iter_mut().zip(self.base) {
            let twice = e.times(Fraction { above: 2, below: 1 })?;
            if twice.below != 1 {
                return None;
            }
            *d = i8::try_from(twice.above).ok()?;
        }
        Some(unit)
    }

    pub fn has_unknowns(&self) -> bool {
        !self.unknowns.is_empty()
    }

    pub fn unknowns(&self) -> impl Iterator<Item = u32> + '_ {
        self.unknowns.iter().map(|u| u.0)
    }

    /// The known part alone.
    pub fn known_part(&self) -> Term {
        Term {
            base: self.base,
            unknowns: Vec::new(),
        }
    }
}

/// A constant whose unit is to be inferred.
struct Unknown {
    name: String,
    solution: Option<Term>,
    /// Where it was determined.
    at: Option<Span>,
}

/// All unknowns, and what has been found out about them.
#[derive(Default)]
pub(super) struct Units {
    unknowns: Vec<Unknown>,
}

/// Two units that cannot be made equal.
pub(super) struct Differ;

impl Units {
    pub fn fresh(&mut self, name: &str) -> Term {
        self.unknowns.push(Unknown {
            name: name.to_owned(),
            solution: None,
            at: None,
        });
        Term::unknown(self.unknowns.len() as u32 - 1)
    }

    pub fn name(&self, unknown: u32) -> &str {
        &self.unknowns[unknown as usize].name
    }

    /// Where an unknown was determined.
    pub fn determined_at(&self, unknown: u32) -> Option<Span> {
        self.unknowns[unknown as usize].at
    }

    /// A term with all that is known put in.
    pub fn resolve(&self, term: &Term) -> Term {
        let mut term = term.clone();
        // A solution names only unknowns that had none when it was found, so that this ends.
        for _ in 0..=self.unknowns.len() {
            let Some(&(index, power)) = term
                .unknowns
                .iter()
                .find(|u| self.unknowns[u.0 as usize].solution.is_some())
            else {
                break;
            };
            let mut rest = term.clone();
            rest.unknowns.retain(|u| u.0 != index);
            let Some(solution) = &self.unknowns[index as usize].solution else {
                break;
            };
            match rest.times_power(solution, power) {
                Some(next) => term = next,
                None => break,
            }
        }
        term
    }

    /// Makes two units equal, determining an unknown where that is needed.
    pub fn equate(&mut self, a: &Term, b: &Term, at: Span) -> Result<(), Differ> {
        let (a, b) = (self.resolve(a), self.resolve(b));
        let Some(ratio) = a.times_power(
            &b,
            Fraction {
                above: -1,
                below: 1,
            },
        ) else {
            return Err(Differ);
        };
        // The unknown that was declared last is determined by those before it.
        let Some(&(index, exponent)) = ratio.unknowns.last() else {
            return if ratio.base[..7].iter().all(|e| e.is_zero()) {
                Ok(())
            } else {
                Err(Differ)
            };
        };
        let mut rest = ratio.clone();
        rest.unknowns.retain(|u| u.0 != index);
        let inverse = Fraction::new(-i64::from(exponent.below), i64::from(exponent.above));
        let solution = inverse.and_then(|i| rest.power(i)).ok_or(Differ)?;
        let unknown = &mut self.unknowns[index as usize];
        unknown.solution = Some(solution);
        unknown.at = Some(at);
        Ok(())
    }

    /// What an unknown came out as.
    pub fn solution(&self, unknown: u32) -> Term {
        self.resolve(&Term::unknown(unknown))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn metre(power: i64) -> Term {
        Term::known(Unit::METRE)
            .power(Fraction::new(power, 1).unwrap())
            .unwrap()
    }

    #[test]
    fn an_equation_determines_one_unknown() {
        let mut units = Units::default();
        let a = units.fresh("a");
        let b = units.fresh("b");
        let ab = a.times_power(&b, Fraction::ONE).unwrap();
        let at = Span::default();
        assert!(units.equate(&ab, &metre(3), at).is_ok());
        assert!(units.resolve(&b).has_unknowns());
        assert!(units.equate(&a, &metre(1), at).is_ok());
        assert_eq!(units.solution(1).unit(), Unit::METRE.checked_powi(2));
        assert!(units.equate(&b, &metre(1), at).is_err());
    }

    #[test]
    fn roots_are_solved_and_thirds_are_no_units() {
        let mut units = Units::default();
        let a = units.fresh("a");
        let squared = a.power(Fraction::new(2, 1).unwrap()).unwrap();
        assert!(units.equate(&squared, &metre(1), Span::default()).is_ok());
        assert_eq!(units.solution(0).unit(), Unit::METRE.checked_pow_half(1));
        let b = units.fresh("b");
        let cubed = b.power(Fraction::new(3, 1).unwrap()).unwrap();
        assert!(units.equate(&cubed, &metre(1), Span::default()).is_ok());
        assert_eq!(units.solution(1).unit(), None);
    }

    #[test]
    fn exponents_out_of_range_are_refused() {
        let mut term = Term::known(Unit::METRE);
        let big = Fraction::new(64, 1).unwrap();
        term = term.power(big).unwrap();
        assert_eq!(term.unit(), None);
        assert_eq!(term.power(big).and_then(|t| t.power(big)), None);
    }
}
