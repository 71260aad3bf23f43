//! Helper functions of generated `f64` code, with defined values at singular points.

use super::table_names;
use proc_macro2::{TokenStream, TokenTree};
use quote::quote;
use std::collections::BTreeSet;

/// Pairs of (method of `lanes::Real`, name of the `f64` helper function that replaces the method).
const HELPERS: [(&str, &str); 12] = [
    ("sqrt", "sqrt_or_zero"),
    ("recip_or_zero", "recip_or_zero"),
    ("log", "log_or_zero"),
    ("asin", "asin_clamped"),
    ("atan2", "atan2_or_zero"),
    ("min", "minimum"),
    ("max", "maximum"),
    ("sign", "sign"),
    ("heaviside", "heaviside"),
    ("if_zero", "if_zero"),
    (table_names::METHOD, table_names::METHOD),
    (table_names::METHOD_OF_TWO, table_names::METHOD_OF_TWO),
];

/// Name of the helper function that replaces a method of `lanes::Real`.
pub(super) fn for_method(method: &str) -> Option<&'static str> {
    let found = HELPERS.iter().find(|(known, _)| *known == method);
    found.map(|(_, helper)| *helper)
}

/// Whether a name is the name of a helper function: an `f64` function that replaces a method of `lanes::Real`.
pub(super) fn is_helper(name: &str) -> bool {
    HELPERS.iter().any(|(_, helper)| *helper == name)
}

/// Tokens that define those `f64` helper functions whose names occur in `tokens`.
pub(super) fn used_in(tokens: &TokenStream) -> TokenStream {
    let mut used = BTreeSet::new();
    collect(tokens.clone(), &mut used);
    used.into_iter().map(definition).collect()
}

fn collect(tokens: TokenStream, used: &mut BTreeSet<&'static str>) {
    for tree in tokens {
        match tree {
            TokenTree::Group(group) => collect(group.stream(), used),
            TokenTree::Ident(ident) => {
                let found = HELPERS.iter().find(|(_, helper)| ident == helper);
                used.extend(found.map(|(_, helper)| *helper));
            }
            TokenTree::Punct(_) | TokenTree::Literal(_) => {}
        }
    }
}

fn definition(helper: &str) -> TokenStream {
    match helper {
        "sqrt_or_zero" => quote! {
            /// Square root; 0 for arguments of 0 or less.
            fn sqrt_or_zero(x: f64) -> f64 {
                if x <= 0.0 { 0.0 } else { x.sqrt() }
            }
        },
        "recip_or_zero" => quote! {
            /// Reciprocal; 0 where `|x| < 1e-75`.
            fn recip_or_zero(x: f64) -> f64 {
                if x.abs() < 1e-75 { 0.0 } else { 1.0 / x }
            }
        },
        "log_or_zero" => quote! {
            /// Natural logarithm; 0 for arguments of 0 or less.
            fn log_or_zero(x: f64) -> f64 {
                if x <= 0.0 { 0.0 } else { x.ln() }
            }
        },
        "asin_clamped" => quote! {
            /// Arcsine of the argument clamped to [-1, 1].
            fn asin_clamped(x: f64) -> f64 {
                x.clamp(-1.0, 1.0).asin()
            }
        },
        "atan2_or_zero" => quote! {
            /// Polar angle of the point (x, y); 0 at the origin.
            fn atan2_or_zero(y: f64, x: f64) -> f64 {
                if x == 0.0 && y == 0.0 { 0.0 } else { y.atan2(x) }
            }
        },
        "minimum" => quote! {
            /// Minimum of two numbers; the second if either is NaN.
            fn minimum(a: f64, b: f64) -> f64 {
                if a < b { a } else { b }
            }
        },
        "maximum" => quote! {
            /// Maximum of two numbers; the second if either is NaN.
            fn maximum(a: f64, b: f64) -> f64 {
                if b < a { a } else { b }
            }
        },
        "sign" => quote! {
            /// Sign: -1, 0 or 1.
            fn sign(x: f64) -> f64 {
                if x > 0.0 { 1.0 } else if x < 0.0 { -1.0 } else { 0.0 }
            }
        },
        "heaviside" => quote! {
            /// Heaviside step: 1 where `x > 0`, else 0.
            fn heaviside(x: f64) -> f64 {
                if x > 0.0 { 1.0 } else { 0.0 }
            }
        },
        table_names::METHOD => table_names::helper(),
        table_names::METHOD_OF_TWO => table_names::helper_of_two(),
        _ => quote! {
            /// `then` where `|x| < 1e-75`, else `otherwise`.
            fn if_zero(x: f64, then: f64, otherwise: f64) -> f64 {
                if x.abs() < 1e-75 { then } else { otherwise }
            }
        },
    }
}
