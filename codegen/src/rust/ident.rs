//! Identifiers.

use proc_macro2::{Ident, Span};

/// An identifier; a keyword is given an underscore.
pub(super) fn ident(name: &str) -> Ident {
    syn::parse_str(name).unwrap_or_else(|_| Ident::new(&format!("{name}_"), Span::call_site()))
}
