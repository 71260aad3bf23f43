//! Construction of Rust identifiers.

use proc_macro2::{Ident, Span};

/// Identifier of a name; a keyword gets a trailing underscore.
pub(super) fn ident(name: &str) -> Ident {
    syn::parse_str(name).unwrap_or_else(|_| Ident::new(&format!("{name}_"), Span::call_site()))
}
