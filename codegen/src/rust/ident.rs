//! Construction of Rust identifiers.

use proc_macro2::{Ident, Span};

/// Converts a name to a Rust identifier; an underscore is appended to a keyword.
pub(super) fn ident(name: &str) -> Ident {
    syn::parse_str(name).unwrap_or_else(|_| Ident::new(&format!("{name}_"), Span::call_site()))
}
