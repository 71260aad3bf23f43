//! Rust expressions as tokens, parenthesized by operator precedence.

use super::ident::ident;
use crate::program::Binary;
use proc_macro2::TokenStream;
use quote::quote;

/// Precedence of an expression's outermost operator, weakest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Binding {
    Sum,
    Product,
    Negation,
    Atom,
}

/// Tokens of an expression, together with the precedence of the outermost operator of the expression.
#[derive(Clone, Debug)]
pub(super) struct Expr {
    pub tokens: TokenStream,
    pub binding: Binding,
}

impl Expr {
    /// Expression that never needs parentheses: a name, literal or call.
    pub fn atom(tokens: TokenStream) -> Expr {
        Expr {
            tokens,
            binding: Binding::Atom,
        }
    }

    /// Expression of the negation `-self`.
    pub fn negated(self) -> Expr {
        let operand = self.bound(Binding::Atom);
        Expr {
            tokens: quote!(-#operand),
            binding: Binding::Negation,
        }
    }

    /// Expression of the method call `self.name(arguments)`.
    pub fn method(self, name: &str, arguments: &[Expr]) -> Expr {
        let method = ident(name);
        let receiver = self.bound(Binding::Atom);
        let arguments = arguments.iter().map(|e| &e.tokens);
        Expr::atom(quote!(#receiver.#method(#(#arguments),*)))
    }

    /// Expression with a binary operator: `self + other`, `self - other`, …
    ///
    /// # Panics
    /// If `binary` is not an operator of Rust.
    pub fn infix(self, binary: Binary, other: Expr) -> Expr {
        // Operators associate to the left: the right operand must bind more strongly.
        let (operator, binding, right) = match binary {
            Binary::Add => (quote!(+), Binding::Sum, Binding::Product),
            Binary::Sub => (quote!(-), Binding::Sum, Binding::Product),
            Binary::Mul => (quote!(*), Binding::Product, Binding::Negation),
            Binary::Div => (quote!(/), Binding::Product, Binding::Negation),
            Binary::Atan2 | Binary::Min | Binary::Max => {
                unreachable!("a function, not an operator")
            }
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
