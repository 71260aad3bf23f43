//! Inference of units: units as products of powers of base units and of unknown units, and the solution of equations
//! between them.
//!
//! Units form an abelian group, so an equation between two units determines at most one unknown, without search.

use std::cell::RefCell;

use crate::diagnostic::Span;
use crate::unit::Unit;

const MAX_UNKNOWNS: usize = 32;

/// Maximum numerator and denominator of a unit exponent, so that sums stay within `i64`.
const MAX_PART: i32 = 4096;

/// Rational exponent in lowest terms, with positive denominator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Fraction {
    above: i32,
    below: i32,
}

impl Fraction {
    const ZERO: Fraction = Fraction { above: 0, below: 1 };
    pub const ONE: Fraction = Fraction { above: 1, below: 1 };
    pub const MINUS_ONE: Fraction = Fraction {
        above: -1,
        below: 1,
    };

    pub fn new(above: i64, below: i64) -> Option<Fraction> {
        if below == 0 {
            return None;
        }
        let divisor = gcd(above.unsigned_abs(), below.unsigned_abs()) as i64 * below.signum();
        let above = i32::try_from(above / divisor).ok()?;
        let below = i32::try_from(below / divisor).ok()?;
        (above.abs() <= MAX_PART && below <= MAX_PART).then_some(Fraction { above, below })
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

/// A unit as a product of powers of base units and of unknown units.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Term {
    /// Exponents of the base units, in the order of [`Base`](crate::unit::Base).
    base: [Fraction; 8],
    /// Indices of the unknown units with their nonzero exponents, in ascending order.
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
        let half = |d: i8| Fraction::new(d.into(), 2).unwrap_or(Fraction::ZERO);
        Term {
            base: unit.doubled.map(half),
            unknowns: Vec::new(),
        }
    }

    fn unknown(index: u32) -> Term {
        Term {
            unknowns: vec![(index, Fraction::ONE)],
            ..Term::one()
        }
    }

    /// `self` · `other`^`power`; `None` if an exponent or the number of unknowns is out of range.
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
        (unknowns.len() <= MAX_UNKNOWNS).then_some(Term { base, unknowns })
    }

    pub fn power(&self, power: Fraction) -> Option<Term> {
        Term::one().times_power(self, power)
    }

    /// The product as a unit; `None` with unknowns, or exponents that no unit has.
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

    /// Copy of the product without the unknown units: only the powers of base units.
    pub fn known_part(&self) -> Term {
        Term {
            base: self.base,
            unknowns: Vec::new(),
        }
    }
}

/// Unknown unit of a declared name, which is to be inferred.
struct Unknown {
    /// Declared name whose unit is unknown.
    name: String,
    /// Inferred unit, as a product that may contain other unknown units; `None` while undetermined.
    solution: RefCell<Option<Term>>,
    /// Source span of the expression that determined the solution; `None` while the solution is undetermined.
    at: Option<Span>,
}

/// The unknown units of a model, and their values as far as they are determined.
#[derive(Default)]
pub(super) struct Units {
    unknowns: Vec<Unknown>,
}

/// Error of [`Units::equate`]: the two units cannot be made equal by solving for an unknown unit.
pub(super) struct Differ;

impl Units {
    pub fn fresh(&mut self, name: &str) -> Term {
        self.unknowns.push(Unknown {
            name: name.to_owned(),
            solution: RefCell::new(None),
            at: None,
        });
        Term::unknown(self.unknowns.len() as u32 - 1)
    }

    pub fn name(&self, unknown: u32) -> &str {
        &self.unknowns[unknown as usize].name
    }

    /// Source span of the expression that determined an unknown unit; `None` while undetermined.
    pub fn determined_at(&self, unknown: u32) -> Option<Span> {
        self.unknowns[unknown as usize].at
    }

    /// Returns a unit in which each unknown unit is replaced by its solution, if inference has determined one so far.
    pub fn resolve(&self, term: &Term) -> Term {
        for unknown in term.unknowns() {
            self.compress(unknown);
        }
        self.substituted(term).unwrap_or_else(|| term.clone())
    }

    fn is_solved(&self, unknown: u32) -> bool {
        self.unknowns[unknown as usize].solution.borrow().is_some()
    }

    /// Whether the solution of the unknown unit with index `unknown` contains another unknown unit that is also solved.
    fn is_chained(&self, unknown: u32) -> bool {
        let solution = self.unknowns[unknown as usize].solution.borrow();
        let term = solution.as_ref();
        term.is_some_and(|term| term.unknowns().any(|u| self.is_solved(u)))
    }

    /// Replaces solved unknowns in `term` by their stored solutions, once.
    fn substituted(&self, term: &Term) -> Option<Term> {
        let mut result = term.known_part();
        for &(index, power) in &term.unknowns {
            result = match &*self.unknowns[index as usize].solution.borrow() {
                Some(solution) => result.times_power(solution, power)?,
                None => result.times_power(&Term::unknown(index), power)?,
            };
        }
        Some(result)
    }

    /// Path compression: leaves only undetermined unknowns in the stored solution.
    fn compress(&self, unknown: u32) {
        let mut path = vec![unknown];
        while let Some(&last) = path.last() {
            let slot = &self.unknowns[last as usize].solution;
            let Some(solution) = slot.borrow().clone() else {
                return;
            };
            match solution.unknowns().find(|&u| self.is_chained(u)) {
                Some(next) => path.push(next),
                None => {
                    let Some(term) = self.substituted(&solution) else {
                        return;
                    };
                    slot.replace(Some(term));
                    path.pop();
                }
            }
        }
    }

    /// Makes two units equal, solving for at most one unknown; `at` requires it.
    pub fn equate(&mut self, a: &Term, b: &Term, at: Span) -> Result<(), Differ> {
        let (a, b) = (self.resolve(a), self.resolve(b));
        let ratio = a.times_power(&b, Fraction::MINUS_ONE).ok_or(Differ)?;
        // Solving for the unknown that was created last prevents cyclic solutions.
        let Some(&(index, exponent)) = ratio.unknowns.last() else {
            let agrees = ratio.base[..7].iter().all(|e| e.is_zero());
            return agrees.then_some(()).ok_or(Differ);
        };
        let mut rest = ratio.clone();
        rest.unknowns.retain(|u| u.0 != index);
        let inverse = Fraction::new(-i64::from(exponent.below), i64::from(exponent.above));
        let solution = inverse.and_then(|i| rest.power(i)).ok_or(Differ)?;
        let unknown = &mut self.unknowns[index as usize];
        unknown.solution = RefCell::new(Some(solution));
        unknown.at = Some(at);
        Ok(())
    }

    /// Solution of an unknown unit, without solved unknowns.
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
