//! Points beside the places where a model switches: where an expression passes a knot of a table, or the number that it is
//! compared with.

use super::between;
use crate::random::Random;
use model_spec::model::{Expr, ExprKind, Function, Model};
use oracle::{Point, Tree};

/// Maximum number of halvings of the way between two points on both sides of a switch: to within some 10⁻⁵ of its length,
/// where the switch is still much wider than rounding.
const MAX_HALVINGS: u64 = 16;

/// Where a model switches: where the difference of two expressions, or one alone, passes one of some numbers.
struct Switch<'a> {
    of: (&'a Expr, Option<&'a Expr>),
    at: Vec<f64>,
}

impl<'a> Switch<'a> {
    fn passing_zero(of: &'a Expr) -> Self {
        Self {
            of: (of, None),
            at: vec![0.0],
        }
    }

    /// The switches of one operation. A norm and a quotient switch at a single place only, which has no other side.
    fn of(model: &'a Model, e: &'a Expr) -> Vec<Self> {
        use Function as F;
        let knots = |of: &'a Expr, table: usize, argument: usize| Self {
            of: (of, None),
            at: model.tables[table].arguments[argument].knots.clone(),
        };
        match &e.kind {
            ExprKind::Call(F::Abs | F::Sign | F::Step | F::Sqrt | F::Log, a) => {
                vec![Self::passing_zero(a)]
            }
            ExprKind::Call(F::Asin | F::Acos, a) => vec![Self {
                of: (a, None),
                at: vec![-1.0, 1.0],
            }],
            ExprKind::Call(F::Table(table), a) => vec![knots(a, *table, 0)],
            ExprKind::Lookup(table, a, b) => vec![knots(a, *table, 0), knots(b, *table, 1)],
            ExprKind::Pow(a, halves) if halves % 2 != 0 => vec![Self::passing_zero(a)],
            ExprKind::RealPower(a, _) => vec![Self::passing_zero(a)],
            ExprKind::Min(a, b) | ExprKind::Max(a, b) => vec![Self {
                of: (a, Some(b)),
                at: vec![0.0],
            }],
            _ => Vec::new(),
        }
    }

    fn value(&self, tree: &Tree<'_, f64>) -> f64 {
        let (a, b) = self.of;
        tree.scalar(a) - b.map_or(0.0, |b| tree.scalar(b))
    }

    /// The numbers that are passed between two points.
    fn passed<'b>(&'b self, trees: &[Tree<'_, f64>; 2]) -> Vec<(&'b Self, f64)> {
        let [one, other] = [0, 1].map(|k| self.value(&trees[k]));
        let passes = |at: &f64| (one > *at) != (other > *at) && (one - other).is_finite();
        let passed = self.at.iter().copied().filter(passes);
        passed.map(|at| (self, at)).collect()
    }
}

fn switches(model: &Model) -> Vec<Switch<'_>> {
    let parts = model.expressions().into_iter().flat_map(Expr::nodes);
    parts.flat_map(|e| Switch::of(model, e)).collect()
}

/// A point on the way between two, beside one of the switches between them, on either side and as far from it as chance
/// will have it; `None` if both are on the same side of every switch.
pub(super) fn beside_one(
    model: &Model,
    ends: [&Point<f64>; 2],
    random: &mut Random,
) -> Option<Point<f64>> {
    let all = switches(model);
    let trees = ends.map(|end| Tree::new(model, end));
    let passed: Vec<_> = all.iter().map(|switch| switch.passed(&trees)).collect();
    let passed: Vec<_> = passed.iter().filter(|own| !own.is_empty()).collect();
    let of_switch = one_of(&passed, random)?;
    let (switch, at) = one_of(of_switch, random)?;
    let start = switch.value(&trees[0]) > *at;
    let (mut before, mut after) = (0.0, 1.0);
    for _ in 0..random.next() % MAX_HALVINGS {
        let middle = 0.5 * (before + after);
        let point = between(ends[0], ends[1], middle);
        if (switch.value(&Tree::new(model, &point)) > *at) == start {
            before = middle;
        } else {
            after = middle;
        }
    }
    let part = if random.once_in(2) { before } else { after };
    Some(between(ends[0], ends[1], part))
}

fn one_of<'a, T>(all: &'a [T], random: &mut Random) -> Option<&'a T> {
    let index = random.next().checked_rem(all.len() as u64)?;
    all.get(index as usize)
}
