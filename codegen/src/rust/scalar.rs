//! Number types of generated code, and the Rust expression of each operation.

use super::names::ident;
use super::{helpers, table_names};
use crate::functions::MathFunction;
use crate::program::{Binary, Fused, Unary};
use crate::table::{TableFunction, Tables};
use proc_macro2::{Literal, TokenStream};
use quote::quote;
use std::f64::consts::{FRAC_PI_2, PI};

/// Number type with which generated code computes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scalar {
    /// `f64`, with functions of the standard library and helpers for guarded functions.
    F64,
    Lanes,
}

impl Scalar {
    /// Type of a number in generated signatures: `f64` or `T`.
    pub fn kind(self) -> TokenStream {
        match self {
            Scalar::F64 => quote!(f64),
            Scalar::Lanes => quote!(T),
        }
    }

    pub fn generics(self) -> TokenStream {
        match self {
            Scalar::F64 => TokenStream::new(),
            Scalar::Lanes => quote!(<T: Real>),
        }
    }

    /// Expression of a numeric constant; `typed` requests a literal with a type suffix.
    pub fn constant(self, value: f64, typed: bool) -> Expr {
        let path = match value {
            _ if value == PI => Some(quote!(std::f64::consts::PI)),
            _ if value == FRAC_PI_2 => Some(quote!(std::f64::consts::FRAC_PI_2)),
            _ if value.is_nan() => Some(quote!(f64::NAN)),
            _ if value == f64::INFINITY => Some(quote!(f64::INFINITY)),
            _ if value == f64::NEG_INFINITY => Some(quote!(f64::NEG_INFINITY)),
            _ => None,
        };
        let is_literal = path.is_none();
        let tokens = path.unwrap_or_else(|| {
            let suffix = if typed && self == Scalar::F64 {
                "_f64"
            } else {
                ""
            };
            literal(value, suffix)
        });
        match self {
            Scalar::Lanes => Expr::atom(quote!(T::splat(#tokens))),
            Scalar::F64 if is_literal && value.is_sign_negative() => Expr {
                tokens,
                binding: Binding::Negation,
            },
            Scalar::F64 => Expr::atom(tokens),
        }
    }

    /// A multiply-add: fused for lanes, separate operations for `f64`.
    pub fn fused(self, fused: Fused, a: Expr, b: Expr, c: Expr) -> Expr {
        if self == Scalar::Lanes {
            let method = match fused {
                Fused::MulAdd => "mul_add",
                Fused::MulSub => "mul_sub",
                Fused::NegMulAdd => "neg_mul_add",
            };
            return a.method(method, &[b, c]);
        }
        let product = a.infix(Binary::Mul, b);
        match fused {
            Fused::MulAdd => product.infix(Binary::Add, c),
            Fused::MulSub => product.infix(Binary::Sub, c),
            Fused::NegMulAdd => c.infix(Binary::Sub, product),
        }
    }

    /// Lookup of `a` and `b` in a table of two arguments.
    pub fn lookup(self, function: TableFunction<2>, a: Expr, b: Expr, tables: &Tables) -> Expr {
        let [x, y, cells] = table_names::of_two(tables, function);
        let orders = function.orders().map(Literal::u8_unsuffixed);
        let arguments = [
            b,
            Expr::atom(quote!([#(#orders),*])),
            Expr::atom(quote!([&#x, &#y])),
            Expr::atom(quote!(&#cells)),
        ];
        self.call(table_names::METHOD_OF_TWO, a, &arguments)
    }

    pub fn unary(self, unary: Unary, a: Expr, tables: &Tables) -> Expr {
        let name = match unary {
            Unary::Call(MathFunction::Table(function)) => {
                let names = table_names::names(tables, function);
                let arguments = names.map(|name| Expr::atom(quote!(&#name)));
                return self.call(table_names::METHOD, a, &arguments);
            }
            Unary::Neg => return a.negated(),
            Unary::Recip => return self.constant(1.0, false).infix(Binary::Div, a),
            Unary::RecipOrZero => "recip_or_zero",
            Unary::Call(MathFunction::NonZero) => {
                let [zero, one] = [0.0, 1.0].map(|value| self.constant(value, false));
                return self.if_zero(a, zero, one);
            }
            Unary::Call(function @ (MathFunction::Sin | MathFunction::Cos)) => {
                return self.sin_or_cos(function, a);
            }
            Unary::Call(function) => function.rust_method().trim_end_matches("()"),
        };
        self.call(name, a, &[])
    }

    /// Expression of the sine or cosine of an angle, for functions that compute only one of the two for this angle.
    fn sin_or_cos(self, function: MathFunction, angle: Expr) -> Expr {
        let element = match function {
            MathFunction::Sin => Literal::usize_unsuffixed(0),
            _ => Literal::usize_unsuffixed(1),
        };
        match self {
            Scalar::F64 => angle.method(function.name(), &[]),
            Scalar::Lanes => {
                let pair = angle.method("sin_cos", &[]).tokens;
                Expr::atom(quote!(#pair.#element))
            }
        }
    }

    /// Expression of a selection: `then` where `condition` is 0, else `otherwise`.
    pub fn if_zero(self, condition: Expr, then: Expr, otherwise: Expr) -> Expr {
        self.call("if_zero", condition, &[then, otherwise])
    }

    /// A call of a `lanes::Real` method; for `f64`, of its helper function if there is one.
    pub fn call(self, name: &str, first: Expr, rest: &[Expr]) -> Expr {
        let helper = match self {
            Scalar::F64 => helpers::for_method(name),
            Scalar::Lanes => None,
        };
        let Some(helper) = helper else {
            return first.method(name, rest);
        };
        let helper = ident(helper);
        let arguments = std::iter::once(&first).chain(rest).map(|e| &e.tokens);
        Expr::atom(quote!(#helper(#(#arguments),*)))
    }
}

/// Shortest literal that parses to exactly the given finite number.
fn literal(value: f64, suffix: &str) -> TokenStream {
    let digits = format!("{:?}{suffix}", value.abs());
    let literal: Option<Literal> = digits.parse().ok();
    let literal = literal.unwrap_or_else(|| Literal::f64_suffixed(value.abs()));
    if value.is_sign_negative() {
        quote!(-#literal)
    } else {
        quote!(#literal)
    }
}

/// Precedence of an expression's outermost operator, weakest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Binding {
    Sum,
    Product,
    Negation,
    Atom,
}

#[derive(Clone, Debug)]
pub(super) struct Expr {
    pub tokens: TokenStream,
    pub binding: Binding,
}

impl Expr {
    pub fn atom(tokens: TokenStream) -> Expr {
        Expr {
            tokens,
            binding: Binding::Atom,
        }
    }

    pub fn negated(self) -> Expr {
        let operand = self.bound(Binding::Atom);
        Expr {
            tokens: quote!(-#operand),
            binding: Binding::Negation,
        }
    }

    pub fn method(self, name: &str, arguments: &[Expr]) -> Expr {
        let method = ident(name);
        let receiver = self.bound(Binding::Atom);
        let arguments = arguments.iter().map(|e| &e.tokens);
        Expr::atom(quote!(#receiver.#method(#(#arguments),*)))
    }

    /// Expression with a binary operator: `self + other`, `self - other`, …
    pub fn infix(self, binary: Binary, other: Expr) -> Expr {
        // Operators associate to the left: the right operand must bind more strongly.
        let (operator, binding, right) = match binary {
            Binary::Add => (quote!(+), Binding::Sum, Binding::Product),
            Binary::Sub => (quote!(-), Binding::Sum, Binding::Product),
            Binary::Mul => (quote!(*), Binding::Product, Binding::Negation),
            Binary::Div => (quote!(/), Binding::Product, Binding::Negation),
            Binary::Call(_) => unreachable!("a function, not an operator"),
        };
        let (a, b) = (self.bound(binding), other.bound(right));
        Expr {
            tokens: quote!(#a #operator #b),
            binding,
        }
    }

    /// Tokens of the expression, in parentheses if its precedence is below the minimum `least`.
    pub fn bound(self, least: Binding) -> TokenStream {
        let tokens = self.tokens;
        if self.binding < least {
            quote!((#tokens))
        } else {
            tokens
        }
    }
}
