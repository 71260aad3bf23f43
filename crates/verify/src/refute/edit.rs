//! Generates small corrections of an equation, as candidate explanations of a misprint.

use model_spec::model::{Expr, ExprKind, Function, Model};

/// A small change, such as another sign, of an expression in a model file that may correct a misprint.
#[derive(Clone)]
pub struct Edit {
    /// Mistake that the change corrects; part of a sentence.
    pub says: String,
    /// Rank of likelihood: 0 extra factor, 1 wrong sign, 2 divisor of too many terms, 3 sine for cosine or vice versa,
    /// 4 missing factor.
    pub rank: u8,
    /// The complete corrected expression, which replaces the original one.
    pub to: Expr,
}

/// Generates small changes that may correct a misprint in an equation.
pub struct Editor<'a> {
    model: &'a Model,
    factors: Vec<(String, Expr)>,
}

impl<'a> Editor<'a> {
    /// Generator without missing factors.
    pub fn new(model: &'a Model) -> Self {
        Self {
            model,
            factors: Vec::new(),
        }
    }

    /// Generator that also multiplies a term of a sum by one of the factors (name, expression).
    pub fn lacking(model: &'a Model, factors: Vec<(String, Expr)>) -> Self {
        Self { model, factors }
    }

    /// All corrections with one change in `e`. `term` is the text of the term of a sum in which `e` occurs.
    pub fn edits(&self, e: &Expr, term: &str) -> Vec<Edit> {
        let mut out = Vec::new();
        self.edits_of_root(e, term, &mut out);
        let is_sum = matches!(
            e.kind,
            ExprKind::Add(..) | ExprKind::Sub(..) | ExprKind::Neg(..)
        );
        for (k, child) in e.children().into_iter().enumerate() {
            // The operands of a sum are terms; subexpressions of a term belong to that term.
            let inner = match is_sum {
                true => self.text(child),
                false => term.to_owned(),
            };
            for edit in self.edits(child, &inner) {
                let mut to = e.clone();
                *to.children_mut().swap_remove(k) = edit.to;
                out.push(Edit { to, ..edit });
            }
        }
        out
    }

    fn edits_of_root(&self, e: &Expr, term: &str, out: &mut Vec<Edit>) {
        let mut push = |rank, says: String, to: Expr| out.push(Edit { says, rank, to });
        match &e.kind {
            ExprKind::Mul(a, b) => {
                for (gone, left) in [(b, a), (a, b)] {
                    if left.shape == e.shape {
                        let says = format!(
                            "the term `{term}` carries a factor `{}` too many",
                            self.text(gone)
                        );
                        push(0, says, (**left).clone());
                    }
                }
            }
            ExprKind::Div(a, b) => {
                let says = format!(
                    "the term `{term}` carries a divisor `{}` too many",
                    self.text(b)
                );
                push(0, says, (**a).clone());
                self.divisor_of_some(a, b, &mut push);
            }
            ExprKind::Add(a, b) | ExprKind::Sub(a, b) => {
                let kind = match &e.kind {
                    ExprKind::Add(..) => ExprKind::Sub(a.clone(), b.clone()),
                    _ => ExprKind::Add(a.clone(), b.clone()),
                };
                let says = format!("the term `{}` has the wrong sign", self.text(b));
                push(1, says, Expr { kind, ..e.clone() });
            }
            ExprKind::Call(function @ (Function::Sin | Function::Cos), a) => {
                let (was, is, other) = match function {
                    Function::Sin => ("sine", "cosine", Function::Cos),
                    _ => ("cosine", "sine", Function::Sin),
                };
                let says = format!(
                    "the term `{term}` has a {was} for a {is} of `{}`",
                    self.text(a)
                );
                let kind = ExprKind::Call(other, a.clone());
                push(3, says, Expr { kind, ..e.clone() });
            }
            _ => {}
        }
        if let ExprKind::Add(a, b) | ExprKind::Sub(a, b) = &e.kind {
            for (k, part) in [a, b].into_iter().enumerate() {
                for (name, factor) in &self.factors {
                    let mut to = e.clone();
                    *to.children_mut().swap_remove(k) = Expr {
                        kind: ExprKind::Mul(part.clone(), Box::new(factor.clone())),
                        ..(**part).clone()
                    };
                    let says = format!("the term `{}` lacks a factor `{name}`", self.text(part));
                    push(4, says, to);
                }
            }
        }
    }

    /// Corrections of `(a ± b ± …)/d` in which only the leading terms are divided, such as `a/d ± b`, passed to `push`
    /// as (rank, description, expression).
    fn divisor_of_some(&self, sum: &Expr, divisor: &Expr, push: &mut impl FnMut(u8, String, Expr)) {
        let (ExprKind::Add(left, _) | ExprKind::Sub(left, _)) = &sum.kind else {
            return;
        };
        let divided = |e: &Expr| Expr {
            kind: ExprKind::Div(Box::new(e.clone()), Box::new(divisor.clone())),
            ..e.clone()
        };
        // Visits the leading parts of the sum in turn: a - b + c is ((a - b) + c).
        let mut outer: Vec<&Expr> = vec![sum];
        let mut part: &Expr = left;
        loop {
            let mut to = divided(part);
            for level in outer.iter().rev() {
                let mut rebuilt = (*level).clone();
                *rebuilt.children_mut().swap_remove(0) = to;
                to = rebuilt;
            }
            let says = format!(
                "the divisor `{}` belongs to `{}` alone",
                self.text(divisor),
                self.text(part)
            );
            push(2, says, to);
            match &part.kind {
                ExprKind::Add(next, _) | ExprKind::Sub(next, _) => {
                    outer.push(part);
                    part = next;
                }
                _ => break,
            }
        }
    }

    fn text(&self, e: &Expr) -> String {
        self.model.text(e.span)
    }
}
