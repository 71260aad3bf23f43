//! Construction of Rust identifiers.

use proc_macro2::{Ident, Span};

/// Converts a name to a Rust identifier; an underscore is appended to a keyword.
pub(super) fn ident(name: &str) -> Ident {
    parsed(name).unwrap_or_else(|| Ident::new(&format!("{name}_"), Span::call_site()))
}

/// A name as a Rust identifier; `None` if it is a keyword of any edition, or has no form of an identifier.
pub(super) fn parsed(name: &str) -> Option<Ident> {
    // The parser knows the keywords up to edition 2021.
    if name == "gen" {
        return None;
    }
    syn::parse_str(name).ok()
}
