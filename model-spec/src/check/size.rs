//! Bounds on the size of a compiled model: thirty lines `let a = b*b;` define a power of 2³⁰. Nested sums are one sum,
//! and nested products one product, as the compiler makes them.

use super::Checker;
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::model::{Expr, ExprKind, Function, Shape};

pub(crate) const MAX_FACTORS: u64 = 1_000;

/// Bounds the time in which a model is compiled; the disc with all effects of the catalogue has more than 20,000.
pub(crate) const MAX_OPERATIONS: u64 = 25_000;

#[derive(Clone, Copy)]
struct Size {
    /// Number of terms in each component after nested sums are merged; 1 for an expression that is not a sum.
    terms: u64,
    /// Number of factors in each component after nested products are merged; a power counts as repeated factors.
    factors: u64,
    /// Number of operations that compute it and its first derivatives, those of the quantities that it is made of
    /// included.
    work: Work,
}

/// Derivatives within one another whose operations are counted one by one, as many as `der(partial(…))` of a `der(…)` has.
const DERIVATIVES: usize = 3;

/// Numbers of operations of an expression, of its derivative, of the derivative of that, and so on: an operation on a
/// product of k factors has k terms in the derivative, a product of k factors each.
#[derive(Clone, Copy, Default)]
struct Work([u64; DERIVATIVES + 1]);

impl Work {
    /// Work of operations on products of so many factors.
    fn of(operations: u64, factors: u64) -> Self {
        let each = factors.max(OF_PRODUCT);
        let mut work = [operations; DERIVATIVES + 1];
        for k in 1..work.len() {
            work[k] = work[k - 1].saturating_mul(each);
        }
        Work(work)
    }

    fn plus(self, other: Self) -> Self {
        Work(std::array::from_fn(|k| {
            self.0[k].saturating_add(other.0[k])
        }))
    }

    fn min(self, other: Self) -> Self {
        Work(std::array::from_fn(|k| self.0[k].min(other.0[k])))
    }

    /// Work of the derivative of an expression with so many factors.
    fn differentiated(self, factors: u64) -> Self {
        let beyond = self.0[DERIVATIVES].saturating_mul(factors.max(OF_PRODUCT));
        Work(std::array::from_fn(|k| {
            self.0.get(k + 1).copied().unwrap_or(beyond)
        }))
    }
}

const ATOM: Size = Size::of(1, 1);

impl Size {
    /// Size before its operations are counted.
    const fn of(terms: u64, factors: u64) -> Self {
        Size {
            terms,
            factors,
            work: Work([0; DERIVATIVES + 1]),
        }
    }
}

/// Operations of the derivative of a product of two factors.
const OF_PRODUCT: u64 = 3;

/// Sizes of the auxiliary variables and number of operations of the model, accumulated so far.
struct Sizes {
    variables: Vec<Size>,
    work: Work,
    /// Those of derivatives of expressions among them.
    of_rates: u64,
    /// Number of frames, an upper bound of the number of rotations in a change of frame.
    frames: u64,
}

impl Checker<'_> {
    pub fn size(&mut self) {
        let model = &self.model;
        let mut sizes = Sizes {
            variables: Vec::with_capacity(model.aux_variables.len()),
            work: Work::default(),
            of_rates: 0,
            frames: model.frames.len() as u64,
        };
        for variable in &model.aux_variables {
            let size = sizes.of(&variable.value);
            sizes.variables.push(size);
            if let Some(fault) = sizes.fault(size, &variable.name, variable.span) {
                self.report(fault);
                return;
            }
        }
        for system in &model.systems {
            let unknowns = system.unknowns.len() as u64;
            sizes.count(Work::of(unknowns.pow(3) / 3, 2));
        }
        let mut statements = model.statements().into_iter();
        let fault = statements.find_map(|(_, name, value, span)| {
            let size = sizes.of(value);
            sizes.fault(size, name, span)
        });
        if let Some(fault) = fault {
            self.report(fault);
        }
    }
}

impl Sizes {
    /// Error if the statement `name`, of the given size, exceeds a bound.
    fn fault(&self, size: Size, name: &str, span: Span) -> Option<Diagnostic> {
        let help =
            "a name that is used twice in the definition of the next doubles the size each time";
        if size.factors > MAX_FACTORS {
            let message = format!(
                "`{name}` is a product of {} factors, powers counted as repeated factors; at most {MAX_FACTORS} are possible",
                shown(size.factors)
            );
            return Some(Diagnostic::new(Kind::Limit, span, message).note(help));
        }
        (self.operations() > MAX_OPERATIONS).then(|| {
            // That of a block has its own marks.
            let name = name.trim_matches('`');
            let message = format!(
                "with `{name}` the model has {} operations; at most {MAX_OPERATIONS} are possible",
                shown(self.operations())
            );
            let help = match self.of_rates > self.operations() / 2 {
                true => {
                    "differentiate fewer and shorter expressions: bodies that `constraint`s hold together need fewer \
                     operations than one Lagrangian"
                }
                false => "write fewer and shorter sums, or leave parts of the model out",
            };
            Diagnostic::new(Kind::Limit, span, message).help(help).note(
                "sums of sums count each of their terms, vectors each of their components, `der(…)` each operation of \
                 what it differentiates",
            )
        })
    }

    fn operations(&self) -> u64 {
        self.work.0[0]
    }

    fn of(&mut self, e: &Expr) -> Size {
        use ExprKind as K;
        let each = match e.shape {
            Shape::Scalar => 1,
            Shape::Vector(_) => 3,
        };
        let merges = matches!(e.kind, K::Add(..) | K::Sub(..) | K::Mul(..) | K::Div(..));
        let mut sizes = Vec::with_capacity(3);
        for child in e.children() {
            let size = self.of(child);
            if merges && matches!(child.kind, K::AuxVariable(_)) {
                let parts = size.terms.max(size.factors);
                let merged = parts.saturating_sub(1).saturating_mul(each);
                self.count(Work::of(merged, size.factors));
            }
            sizes.push(size);
        }
        let [a, b, c] = [0, 1, 2].map(|k| sizes.get(k).copied().unwrap_or(ATOM));
        let mut derivative = None;
        let (own, size) = match &e.kind {
            K::Number { .. } => (0, Size::of(1, 0)),
            K::Axis(..) => {
                let factors = self.frames;
                (0, Size::of(1, factors))
            }
            K::AuxVariable(i) => (0, self.variables.get(*i).copied().unwrap_or(ATOM)),
            K::Neg(_) | K::Component(..) => (0, a),
            K::Add(..) | K::Sub(..) => {
                // A common factor of all terms may become a factor of the sum.
                let factors = a.factors.max(b.factors);
                let terms = a.terms.saturating_add(b.terms);
                (each, Size::of(terms, factors))
            }
            K::Mul(..) | K::Div(..) | K::Ratio(_) => (each, product(a, b)),
            K::Dot(..) | K::Cross(..) => {
                let operations = if each == 1 { 5 } else { 9 };
                let factors = product(a, b).factors;
                (operations, Size::of(3, factors))
            }
            K::Pow(_, doubled) => {
                let times = u64::from(doubled.unsigned_abs()).div_ceil(2).max(1);
                let factors = a.factors.max(1).saturating_mul(times);
                (each, Size::of(1, factors))
            }
            // Each operation is differentiated once; a product has a term for each factor.
            K::Rate(..) | K::Partial(..) => {
                let factors = { sizes.iter().skip(1) }.fold(a.factors, |most, rate| {
                    most.max(a.factors.saturating_add(rate.factors))
                });
                let terms = a.terms.saturating_mul(a.factors.max(1));
                derivative = Some(a.work.differentiated(a.factors));
                (0, Size::of(terms, factors))
            }
            // By the laws of motion: a sum of loads over an inertia, in another frame.
            K::BodyRate(..) => {
                let factors = { sizes.iter() }.fold(self.frames, |most, load| {
                    most.max(load.factors.saturating_add(self.frames))
                });
                let own = self.frames.saturating_mul(4).saturating_add(9);
                (own, Size::of(3, factors))
            }
            K::Norm(_) => (6, Size { terms: 1, ..a }),
            K::Direction(..) => (9, product(a, a)),
            K::Reexpress(_) => {
                let factors = a.factors.saturating_add(self.frames);
                (self.frames.saturating_mul(4), Size::of(3, factors))
            }
            K::Call(Function::Abs | Function::Sqrt, _) => (1, Size { terms: 1, ..a }),
            K::Components(_) => {
                let terms = a.terms.max(b.terms).max(c.terms).max(1);
                let factors = a.factors.max(b.factors).max(c.factors).max(1);
                (0, Size::of(terms, factors))
            }
            K::Atan2(..) | K::Min(..) | K::Max(..) | K::Call(..) | K::Lookup(..) => (1, ATOM),
            _ => (0, ATOM),
        };
        let own = derivative.unwrap_or_else(|| Work::of(own, size.factors));
        if derivative.is_some() {
            self.of_rates = self.of_rates.saturating_add(own.0[0]);
        }
        self.count(own);
        let work = match e.kind {
            K::AuxVariable(_) => size.work,
            _ => { sizes.iter() }.fold(own, |sum, part| sum.plus(part.work)),
        };
        // What is used twice is computed once.
        let work = work.min(self.work);
        Size { work, ..size }
    }

    fn count(&mut self, work: Work) {
        self.work = self.work.plus(work);
    }
}

fn product(a: Size, b: Size) -> Size {
    Size::of(1, a.factors.saturating_add(b.factors))
}

fn shown(count: u64) -> String {
    const MANY: u64 = 1_000_000_000;
    if count > MANY {
        "over a billion".to_owned()
    } else {
        count.to_string()
    }
}
