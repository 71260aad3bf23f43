//! Writing of the operations of a function body as Rust expressions.

use super::names::ident;
use super::scalar::{Binding, Expr, Scalar};
use crate::backend::body::{Body, Input};
use crate::functions::BinaryFunction;
use crate::program::{Binary, Op, Operand, Unary};
use proc_macro2::TokenStream;
use quote::quote;

/// Writes the operations of a function body as Rust expressions, on `f64` or on a type that implements `lanes::Real`.
#[derive(Clone, Copy)]
pub(super) struct Writer<'a> {
    pub body: &'a Body<'a>,
    pub scalar: Scalar,
}

impl Writer<'_> {
    /// Tokens of the right-hand side of the program statement with the index `k`.
    pub fn statement(&self, k: usize) -> TokenStream {
        self.op(self.body.op(k)).tokens
    }

    /// Tokens of an operand that is not the receiver of a method call, for example a function argument or a result.
    pub fn value(&self, operand: Operand) -> TokenStream {
        self.operand(operand, false).tokens
    }

    /// Tokens of an operand as the receiver of a method call.
    pub fn receiver(&self, operand: Operand) -> TokenStream {
        self.operand(operand, true).bound(Binding::Atom)
    }

    fn operand(&self, operand: Operand, typed: bool) -> Expr {
        match (self.body.variables.of(operand), operand) {
            (Some(name), _) => {
                let name = ident(name);
                Expr::atom(quote!(#name))
            }
            (None, Operand::Constant(value)) => self.scalar.constant(value, typed),
            (None, Operand::Temp(t)) => self.op(self.body.op(t as usize)),
            (None, _) => {
                let time = ident(Input::Time.name());
                Expr::atom(quote!(#time))
            }
        }
    }

    fn op(&self, op: &Op) -> Expr {
        // Literals carry a type suffix if no operand determines their type.
        let all_constant = op
            .operands()
            .iter()
            .all(|operand| matches!(operand, Operand::Constant(_)));
        let is_receiver = !matches!(
            op,
            Op::Binary(Binary::Add | Binary::Sub | Binary::Mul | Binary::Div, ..)
                | Op::Unary(Unary::Recip, _)
                | Op::Fused(..)
        );
        let first = |a: Operand| self.operand(a, all_constant || is_receiver);
        let rest = |a: Operand| self.operand(a, false);
        match *op {
            Op::Unary(unary, a) => {
                let tables = &self.body.function.program.tables;
                self.scalar.unary(unary, first(a), tables)
            }
            Op::Fused(fused, a, b, c) => self.scalar.fused(fused, first(a), rest(b), rest(c)),
            Op::IfZero(condition, then, otherwise) => {
                self.scalar
                    .if_zero(first(condition), rest(then), rest(otherwise))
            }
            Op::Binary(Binary::Call(BinaryFunction::Table(function)), a, b) => {
                let tables = &self.body.function.program.tables;
                self.scalar.lookup(function, first(a), rest(b), tables)
            }
            Op::Binary(Binary::Call(function), a, b) => {
                self.scalar.call(function.name(), first(a), &[rest(b)])
            }
            Op::Binary(binary, a, b) => first(a).infix(binary, rest(b)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn name(of: &str) -> Expr {
        let name = ident(of);
        Expr::atom(quote!(#name))
    }

    fn text(expr: &Expr) -> String {
        expr.tokens.to_string().replace(' ', "")
    }

    #[test]
    fn parentheses_follow_the_order_of_evaluation() {
        use Binary::{Add, Div, Mul, Sub};
        let inner = |binary| name("b").infix(binary, name("c"));
        let table = [
            (inner(Add), Sub, "a-(b+c)", "b+c-a"),
            (inner(Sub), Add, "a+(b-c)", "b-c+a"),
            (inner(Mul), Sub, "a-b*c", "b*c-a"),
            (inner(Add), Mul, "a*(b+c)", "(b+c)*a"),
            (inner(Mul), Div, "a/(b*c)", "b*c/a"),
            (inner(Div), Mul, "a*(b/c)", "b/c*a"),
            (name("b").negated(), Mul, "a*-b", "-b*a"),
            (
                name("b").method("sqrt", &[]),
                Div,
                "a/b.sqrt()",
                "b.sqrt()/a",
            ),
            (
                Scalar::Lanes.unary(Unary::Recip, name("b"), &crate::table::Tables::default()),
                Mul,
                "a*(T::splat(1.0)/b)",
                "T::splat(1.0)/b*a",
            ),
        ];
        for (inner, outer, right, left) in table {
            assert_eq!(text(&name("a").infix(outer, inner.clone())), right);
            assert_eq!(text(&inner.infix(outer, name("a"))), left);
        }
        let product = inner(Mul);
        assert_eq!(text(&product.clone().negated()), "-(b*c)");
        assert_eq!(text(&product.method("sqrt", &[])), "(b*c).sqrt()");
        assert_eq!(text(&name("b").negated().method("abs", &[])), "(-b).abs()");
        let sum = inner(Add).method("atan2", &[name("a")]);
        assert_eq!(text(&sum), "(b+c).atan2(a)");
    }

    #[test]
    fn plain_numbers_keep_sign_and_type() {
        use crate::functions::MathFunction;
        use crate::program::Fused;
        let minus_two = || Scalar::F64.constant(-2.0, true);
        assert_eq!(
            text(&Scalar::F64.unary(
                Unary::Call(MathFunction::Abs),
                minus_two(),
                &crate::table::Tables::default()
            )),
            "(-2.0_f64).abs()"
        );
        let a = || name("a");
        let difference = a().infix(Binary::Sub, Scalar::F64.constant(-2.0, false));
        assert_eq!(text(&difference), "a--2.0");
        let sum = || name("b").infix(Binary::Add, name("c"));
        assert_eq!(
            text(&Scalar::F64.fused(Fused::NegMulAdd, sum(), a(), sum())),
            "b+c-(b+c)*a"
        );
        assert_eq!(text(&Scalar::F64.constant(3.4e-5, false)), "3.4e-5");
        assert_eq!(text(&Scalar::Lanes.constant(-0.5, false)), "T::splat(-0.5)");
    }
}
