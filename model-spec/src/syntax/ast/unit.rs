//! Syntax tree of unit expressions, such as `kg*m/s^2`.

use crate::location::Span;
use crate::unit::Unit;

/// Unit expression: a product of powers of unit symbols, or [`UnitExpr::INFERRED`] alone.
#[derive(Clone, Debug, PartialEq)]
pub struct UnitExpr {
    /// Powers of unit symbols whose product is the unit.
    pub factors: Vec<UnitFactor>,
    /// Source span of the unit expression.
    pub span: Span,
}

impl UnitExpr {
    pub(crate) fn of(unit: Unit, span: Span) -> UnitExpr {
        let factors = unit.powers().map(|(symbol, doubled)| UnitFactor {
            symbol: symbol.to_owned(),
            doubled: doubled.into(),
            span,
        });
        UnitExpr {
            factors: factors.collect(),
            span,
        }
    }

    /// A unit by its symbol alone.
    pub(crate) fn symbol(symbol: &str, span: Span) -> UnitExpr {
        let factor = UnitFactor {
            symbol: symbol.to_owned(),
            doubled: 2,
            span,
        };
        UnitExpr {
            factors: vec![factor],
            span,
        }
    }

    /// Symbol `?` of a unit to be inferred, as in the declaration `param k = 2 [?];`.
    pub const INFERRED: &str = "?";

    /// Whether the unit is `[?]`, so that it is inferred from the uses of the declared name.
    pub fn is_inferred(&self) -> bool {
        matches!(&self.factors[..], [only] if only.symbol == UnitExpr::INFERRED)
    }
}

/// One power of a unit symbol.
#[derive(Clone, Debug, PartialEq)]
pub struct UnitFactor {
    /// Unit symbol, such as `kg`.
    pub symbol: String,
    /// Twice the exponent of the symbol, so that half powers are stored as integers.
    pub doubled: i32,
    /// Source span of the symbol with its exponent.
    pub span: Span,
}
