//! What the limits of a model say: bounds of quantities, and sums of squares that are not zero.

use crate::model::{Expr, ExprKind, Function, Model};

/// A range, SI.
type Range = (f64, f64);

/// What the limits of a model keep its quantities to.
pub(super) struct Kept<'m> {
    model: &'m Model,
    ranges: Vec<(&'m Expr, Range)>,
    /// Numbers and vectors that are not all zero.
    not_zero: Vec<Vec<Part<'m>>>,
}

/// A number or a vector whose square is a term of a sum.
#[derive(Clone, Copy)]
enum Part<'m> {
    State(usize),
    Other(&'m Expr),
}

impl<'m> Kept<'m> {
    pub fn new(model: &'m Model) -> Kept<'m> {
        Kept {
            model,
            ranges: Vec::new(),
            not_zero: Vec::new(),
        }
    }

    /// What the limits say, given the ranges of what they are made of.
    pub fn learned(model: &'m Model, range: impl Fn(&Expr) -> Option<Range>) -> Kept<'m> {
        let mut kept = Kept::new(model);
        for limit in &model.limits {
            let value = &limit.value;
            kept.ranges.push((value, (limit.bound, f64::INFINITY)));
            // `A - B > bound` keeps B below the greatest A.
            if let ExprKind::Sub(a, b) = &named(model, value).kind
                && let Some((_, greatest)) = range(a)
            {
                let above = greatest - limit.bound;
                kept.ranges.push(match &named(model, b).kind {
                    ExprKind::Call(Function::Abs, of) => (of, (-above, above)),
                    _ => (b, (f64::NEG_INFINITY, above)),
                });
            }
            if limit.bound >= 0.0 {
                let parts = kept.squares(value);
                kept.not_zero
                    .push(parts.unwrap_or_else(|| kept.root(value)));
            }
        }
        kept
    }

    /// Whether a limit keeps an expression above 0.
    pub fn is_positive(&self, e: &Expr) -> bool {
        // A limit is exclusive.
        let mut own = self.ranges.iter().filter(|(_, (least, _))| *least >= 0.0);
        own.any(|(of, _)| self.is_same(of, e))
    }

    /// Range to which limits keep an expression.
    pub fn range(&self, e: &Expr) -> Option<Range> {
        let own = self.ranges.iter().filter(|(of, _)| self.is_same(of, e));
        own.map(|(_, range)| *range)
            .reduce(|a, b| (a.0.max(b.0), a.1.min(b.1)))
    }

    /// Whether a limit keeps an expression, or the sum of squares that it is or has the root of, away from 0.
    pub fn is_never_zero(&self, e: &Expr) -> bool {
        if self.not_zero.is_empty() {
            return false;
        }
        let parts = self.squares(e).unwrap_or_else(|| self.root(e));
        let has = |part: &Part<'_>| parts.iter().any(|own| self.is_part(own, part));
        self.not_zero.iter().any(|known| known.iter().all(has))
    }

    /// Parts whose squares add up to an expression.
    fn squares<'e>(&self, e: &'e Expr) -> Option<Vec<Part<'e>>>
    where
        'm: 'e,
    {
        match &named(self.model, e).kind {
            ExprKind::Add(a, b) => Some([self.squares(a)?, self.squares(b)?].concat()),
            ExprKind::Pow(a, 4) => Some(self.root(a)),
            ExprKind::Mul(a, b) if a.same(b) => Some(self.root(a)),
            ExprKind::Dot(a, b) if a.same(b) => Some(self.of_vector(a)),
            _ => None,
        }
    }

    /// Parts whose squares add up to the square of an expression.
    fn root<'e>(&self, e: &'e Expr) -> Vec<Part<'e>>
    where
        'm: 'e,
    {
        let found = match &named(self.model, e).kind {
            ExprKind::Norm(of) => Some(self.of_vector(of)),
            ExprKind::Call(Function::Sqrt, of) | ExprKind::Pow(of, 1) => self.squares(of),
            ExprKind::Call(Function::Abs, of) | ExprKind::Neg(of) => Some(self.root(of)),
            _ => None,
        };
        found.unwrap_or_else(|| vec![self.part(e)])
    }

    fn of_vector<'e>(&self, v: &'e Expr) -> Vec<Part<'e>>
    where
        'm: 'e,
    {
        match &named(self.model, v).kind {
            ExprKind::Components(parts) => {
                let is_zero =
                    |part: &Expr| matches!(part.kind, ExprKind::Number { value: 0.0, .. });
                let parts = parts.iter().filter(|part| !is_zero(part));
                parts.flat_map(|part| self.root(part)).collect()
            }
            ExprKind::Reexpress(of) | ExprKind::Neg(of) => self.of_vector(of),
            kind => match self.states_of(kind) {
                Some(states) => states.map(Part::State).to_vec(),
                None => vec![Part::Other(v)],
            },
        }
    }

    fn part<'e>(&self, e: &'e Expr) -> Part<'e>
    where
        'm: 'e,
    {
        match &named(self.model, e).kind {
            ExprKind::State(state) => Part::State(*state),
            ExprKind::Component(of, axis) => {
                let states = self.states_of(&named(self.model, of).kind);
                let states = states.map(|states| states[usize::from(*axis) - 1]);
                states.map_or(Part::Other(e), Part::State)
            }
            _ => Part::Other(e),
        }
    }

    /// States that are the components of the velocity or position of the body.
    fn states_of(&self, vector: &ExprKind) -> Option<[usize; 3]> {
        let body = self.model.body.as_ref()?;
        match vector {
            ExprKind::Velocity => Some(body.velocity),
            ExprKind::Position => Some(body.position),
            _ => None,
        }
    }

    fn is_part(&self, a: &Part<'_>, b: &Part<'_>) -> bool {
        match (a, b) {
            (Part::State(a), Part::State(b)) => a == b,
            (Part::Other(a), Part::Other(b)) => self.is_same(a, b),
            _ => false,
        }
    }

    fn is_same(&self, a: &Expr, b: &Expr) -> bool {
        let [x, y] = [a, b].map(|e| named(self.model, e));
        a.same(b) || x.same(y) || a.same(y) || x.same(b)
    }
}

/// Defining expression of the auxiliary variable to which `e` refers; `e` itself if it does not refer to one.
pub(super) fn named<'m>(model: &'m Model, e: &'m Expr) -> &'m Expr {
    match &e.kind {
        ExprKind::AuxVariable(i) => model.aux_variables.get(*i).map_or(e, |l| &l.value),
        _ => e,
    }
}
