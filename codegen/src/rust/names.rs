//! Conversion of names of models and variables to valid Rust identifiers.

use super::{helpers, signature, table_names};
use proc_macro2::{Ident, Span};

/// Names of the constants that are generated for each model, and what they are.
pub(super) const CONSTANTS: [(&str, &str); 16] = [
    ("STATES", "Names of the states, in order."),
    ("INITIAL", "Default initial state."),
    (
        "PARAMETERS",
        "Names of the parameters: constants, then coefficients, then components of the inputs.",
    ),
    ("DEFAULTS", "Default values of the parameters."),
    (
        "PARAMS",
        "Number of constants; they come first among the parameters.",
    ),
    (
        "COEFFICIENTS",
        "Number of coefficients; they follow the constants.",
    ),
    (
        "PREPARED",
        "Names of the invariants that `prepare` computes.",
    ),
    (
        "QUANTITIES",
        "Names of the auxiliary variables that `quantities` computes.",
    ),
    (
        "LIMITS",
        "Lower bounds of the domain of validity, one per result of `limits`.",
    ),
    (
        "LIMIT_REASONS",
        "Why the model does not hold beyond each limit.",
    ),
    (
        "J_PATTERN",
        "(row, column) of each entry of `j` = ∂dx/∂state.",
    ),
    (
        "JP_PATTERN",
        "(row, column) of each entry of `jp` = ∂dx/∂parameters.",
    ),
    (
        "DY_DX_PATTERN",
        "(row, column) of each entry of `dy_dx` = ∂observed/∂state.",
    ),
    (
        "DY_DP_PATTERN",
        "(row, column) of each entry of `dy_dp` = ∂observed/∂parameters.",
    ),
    (
        "DY_DMARKER_PATTERN",
        "(row, column) of each entry of `dy_dmarker` = ∂observed/∂marker.",
    ),
    (
        "SOURCE_HASH",
        "Hash of the model's source texts (64-bit FNV-1a).",
    ),
];

/// Variants of enumerations that are in scope everywhere, which no `let` can shadow.
const VARIANTS: [&str; 4] = ["Some", "None", "Ok", "Err"];

/// Whether a name cannot be a local variable: no identifier, or an argument or item that a `let` would shadow.
pub(super) fn is_reserved(name: &str) -> bool {
    parsed(name).is_none()
        || VARIANTS.contains(&name)
        || signature::is_argument(name)
        || CONSTANTS.iter().any(|(constant, _)| *constant == name)
        || helpers::is_helper(name)
        || table_names::is_constant(name)
}

/// Module name of a model; a raw identifier if the name is a keyword.
pub(super) fn module_ident(model: &str) -> Ident {
    let stem = file_stem(model);
    parsed(&stem)
        .or_else(|| parsed(&format!("r#{stem}")))
        .unwrap_or_else(|| ident(&format!("{stem}_")))
}

/// File stem of a model's module: its name as an identifier, raw if need be.
pub(super) fn file_stem(model: &str) -> String {
    let letters = model.chars();
    let mut stem: String = letters
        .map(|c| if c.is_alphanumeric() { c } else { '_' })
        .collect();
    let starts_well = stem.starts_with(|c: char| c.is_alphabetic() || c == '_');
    let unraw = ["", "_", "self", "Self", "super", "crate"];
    if !starts_well {
        stem.insert(0, '_');
    }
    if unraw.contains(&stem.as_str()) {
        stem.push_str("_model");
    }
    stem
}

pub(super) fn type_ident(model: &str) -> Ident {
    let words = model.split(|c: char| !c.is_alphanumeric());
    let camel: String = words
        .filter_map(|word| {
            let mut letters = word.chars();
            let first = letters.next()?;
            Some(first.to_uppercase().chain(letters).collect::<String>())
        })
        .collect();
    ident(&file_stem(&camel))
}

pub(super) fn ident(name: &str) -> Ident {
    parsed(name).unwrap_or_else(|| Ident::new(&format!("{name}_"), Span::call_site()))
}

/// A name as a Rust identifier; `None` if it is a keyword of any edition, or has no form of an identifier.
pub(super) fn parsed(name: &str) -> Option<Ident> {
    // No keyword begins with a letter and has a digit or `_`, as most names do.
    let is_letter = |c: u8| c.is_ascii_alphabetic();
    let is_other = |c: u8| c.is_ascii_digit() || c == b'_';
    if name.bytes().next().is_some_and(is_letter)
        && name.bytes().all(|c| is_letter(c) || is_other(c))
        && name.bytes().any(is_other)
    {
        return Some(Ident::new(name, Span::call_site()));
    }
    // The parser knows the keywords up to edition 2021.
    if name == "gen" {
        return None;
    }
    syn::parse_str(name).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_models_become_modules_and_types() {
        let table = [
            ("disc_quaternion", "disc_quaternion", "DiscQuaternion"),
            ("match", "r#match", "Match"),
            ("gen", "r#gen", "Gen"),
            ("self", "self_model", "Self_model"),
            ("2d-kite", "_2d_kite", "_2dKite"),
        ];
        for (model, module, kind) in table {
            assert_eq!(module_ident(model).to_string(), module);
            assert_eq!(type_ident(model).to_string(), kind);
        }
    }

    #[test]
    fn keywords_arguments_constants_and_helpers_are_reserved() {
        for name in [
            "yield",
            "gen",
            "Self",
            "_",
            "state",
            "dx",
            "STATES",
            "sqrt_or_zero",
            "None",
        ] {
            assert!(is_reserved(name), "{name}");
        }
        for name in ["alpha", "C_La", "T", "f", "π"] {
            assert!(!is_reserved(name), "{name}");
        }
    }
}
