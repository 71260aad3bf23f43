//! Bounds on the size of a compiled model. A short text can define a huge expression: thirty lines `let a = b*b;`
//! define a power of 2³⁰. Sizes are estimated on the checked tree, with names replaced by their definitions where the
//! compiler does so: nested sums become one sum, and nested products one product.

use super::Checker;
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::model::{Expr, ExprKind, Function, Shape};

/// Maximum number of factors of a product, where a power counts as repeated factors; more are reported as an error. It
/// bounds the size of the compiled model.
pub(crate) const MAX_FACTORS: u64 = 1_000;

/// Maximum number of scalar operations of a model, counted before differentiation; more are reported as an error. It
/// bounds the size of the compiled model.
pub(crate) const MAX_OPERATIONS: u64 = 10_000;

/// Estimated size of an expression in the compiled model, where nested sums form one sum and nested products one
/// product.
#[derive(Clone, Copy)]
struct Size {
    /// Number of terms in each component after nested sums are merged; 1 for an expression that is not a sum.
    terms: u64,
    /// Number of factors in each component after nested products are merged; a power counts as repeated factors.
    factors: u64,
}

const ATOM: Size = Size {
    terms: 1,
    factors: 1,
};

/// Sizes of the auxiliary variables and number of operations of the model, accumulated so far.
struct Sizes {
    variables: Vec<Size>,
    operations: u64,
    /// Number of frames, an upper bound of the number of rotations in a change of frame.
    frames: u64,
}

impl Checker<'_> {
    /// Reports the first definition or statement with which the model becomes too large to be compiled.
    pub fn size(&mut self) {
        let model = &self.model;
        let mut sizes = Sizes {
            variables: Vec::with_capacity(model.aux_variables.len()),
            operations: 0,
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
        let loads = model.forces.iter().chain(&model.moments);
        let loads = loads.map(|load| (&load.value, load.name.as_str(), load.span));
        let rates = model.equations.iter().map(|equation| {
            let state = &model.states[equation.state].name;
            (&equation.value, state.as_str(), equation.span)
        });
        let seen = model.observation.iter();
        let seen = seen.map(|o| (&o.value, o.name.as_str(), o.span));
        let clock = model.clock.iter().map(|c| (&c.value, "clock", c.span));
        let limits = model.limits.iter().map(|l| (&l.value, "limit", l.span));
        let claimed = model.claim.iter().flat_map(|claim| {
            let expressions = claim.expressions().into_iter();
            expressions.map(|e| (e, claim.name.as_str(), e.span))
        });
        let statements = loads.chain(rates).chain(seen).chain(clock).chain(limits);
        let statements = statements.chain(claimed);
        let fault = { statements }.find_map(|(value, name, span)| {
            let size = sizes.of(value);
            sizes.fault(size, name, span)
        });
        if let Some(fault) = fault {
            self.report(fault);
        }
    }
}

impl Sizes {
    /// Error if the statement `name` has more than [`MAX_FACTORS`] factors, or if the model has more than
    /// [`MAX_OPERATIONS`] operations up to and including this statement; `None` otherwise. `size` is the size of the
    /// statement.
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
        (self.operations > MAX_OPERATIONS).then(|| {
            let message = format!(
                "with `{name}` the model has {} operations; at most {MAX_OPERATIONS} are possible",
                shown(self.operations)
            );
            Diagnostic::new(Kind::Limit, span, message)
                .note("sums of sums count each of their terms, vectors each of their components")
        })
    }

    /// Estimates the size of an expression, and adds its operations to the total of the model.
    fn of(&mut self, e: &Expr) -> Size {
        use ExprKind as K;
        let each = match e.shape {
            Shape::Scalar => 1,
            Shape::Vector(_) => 3,
        };
        match &e.kind {
            K::Number { .. } => Size { factors: 0, ..ATOM },
            K::Pi
            | K::Time
            | K::Param(_)
            | K::Coefficient(_)
            | K::Input(_)
            | K::State(_)
            | K::Position
            | K::Velocity
            | K::AngularVelocity
            | K::SpecificForce
            | K::AngularAcceleration
            | K::Marker => ATOM,
            K::Axis(..) => Size {
                factors: self.frames,
                ..ATOM
            },
            K::AuxVariable(i) => self.variables.get(*i).copied().unwrap_or(ATOM),
            K::Neg(a) | K::Component(a, _) => self.of(a),
            K::Add(a, b) | K::Sub(a, b) => {
                let sizes = [self.merged(a, each), self.merged(b, each)];
                self.count(each);
                Size {
                    terms: sizes[0].terms.saturating_add(sizes[1].terms),
                    // A common factor of all terms may become a factor of the sum.
                    factors: sizes[0].factors.max(sizes[1].factors),
                }
            }
            K::Mul(a, b) | K::Div(a, b) => {
                let sizes = [self.merged(a, each), self.merged(b, each)];
                self.count(each);
                product(sizes[0], sizes[1])
            }
            K::Dot(a, b) | K::Cross(a, b) => {
                let sizes = [self.of(a), self.of(b)];
                self.count(if each == 1 { 5 } else { 9 });
                Size {
                    terms: 3,
                    ..product(sizes[0], sizes[1])
                }
            }
            K::Ratio(parts) => {
                let sizes = [self.of(&parts[0]), self.of(&parts[1])];
                self.of(&parts[2]);
                self.count(each);
                product(sizes[0], sizes[1])
            }
            K::Pow(a, doubled) => {
                let times = u64::from(doubled.unsigned_abs()).div_ceil(2).max(1);
                let size = self.of(a);
                self.count(each);
                Size {
                    terms: 1,
                    factors: size.factors.max(1).saturating_mul(times),
                }
            }
            K::Norm(v) => {
                let size = self.of(v);
                self.count(6);
                Size { terms: 1, ..size }
            }
            K::Direction(v, otherwise) => {
                let size = self.of(v);
                if let Some(otherwise) = otherwise {
                    self.of(otherwise);
                }
                self.count(9);
                product(size, size)
            }
            K::Reexpress(v) => {
                let size = self.of(v);
                self.count(self.frames.saturating_mul(4));
                Size {
                    terms: 3,
                    factors: size.factors.saturating_add(self.frames),
                }
            }
            K::Call(Function::Abs | Function::Sqrt, a) => {
                let size = self.of(a);
                self.count(1);
                Size { terms: 1, ..size }
            }
            K::Components(_) | K::Atan2(..) | K::Min(..) | K::Max(..) | K::Call(..) => {
                let mut largest = ATOM;
                let is_vector = matches!(e.kind, K::Components(_));
                e.children(&mut |child| {
                    let size = self.of(child);
                    if is_vector {
                        largest.terms = largest.terms.max(size.terms);
                        largest.factors = largest.factors.max(size.factors);
                    }
                });
                self.count(u64::from(!is_vector));
                largest
            }
        }
    }

    /// Size of an operand `e` of a sum or product; `each` is the number of components of the operand (1 for a scalar, 3
    /// for a vector). If `e` is an auxiliary variable, the compiler copies its definition into the sum or product. The
    /// operations of the copy are therefore added to the total of the model.
    fn merged(&mut self, e: &Expr, each: u64) -> Size {
        let size = self.of(e);
        if matches!(e.kind, ExprKind::AuxVariable(_)) {
            let parts = size.terms.max(size.factors).saturating_sub(1);
            self.count(parts.saturating_mul(each));
        }
        size
    }

    fn count(&mut self, operations: u64) {
        self.operations = self.operations.saturating_add(operations);
    }
}

fn product(a: Size, b: Size) -> Size {
    Size {
        terms: 1,
        factors: a.factors.saturating_add(b.factors),
    }
}

/// Formats a count for messages; a count above a billion becomes `over a billion`.
fn shown(count: u64) -> String {
    const MANY: u64 = 1_000_000_000;
    if count > MANY {
        "over a billion".to_owned()
    } else {
        count.to_string()
    }
}
