//! Spaces between two tokens of a line.

use super::piece::{Piece, Structure};
use crate::syntax::token::{Token, first_token};

/// Words of the language between which and a bracket stands a space; other names before a bracket are called.
const BEFORE_BRACKET: [&str; 10] = [
    "position",
    "velocity",
    "inertia",
    "quaternion",
    "in",
    "within",
    "by",
    "or",
    "about",
    "for",
];

/// Number of spaces before the token `at`, which follows another on a line.
pub(super) fn space_before(pieces: &[Piece<'_>], structure: &Structure, at: usize) -> usize {
    let (last, own) = (pieces[at - 1], pieces[at]);
    let spaces = usize::from(is_spaced(pieces, structure, at));
    if spaces == 0 && own.follows_space() {
        // `. .` is not `..`.
        let next = pieces.get(at + 1).map_or("", |next| next.text);
        let joined = format!("{}{}{next}", last.text, own.text);
        let kept = first_token(&joined).is_some_and(|(_, length)| length == last.text.len());
        return usize::from(!kept);
    }
    spaces
}

fn is_spaced(pieces: &[Piece<'_>], structure: &Structure, at: usize) -> bool {
    let (last, own) = (pieces[at - 1], pieces[at]);
    match (last.token, own.token) {
        (_, Token::Sign(";" | "," | ":" | ")" | "]" | "." | "?") | Token::Superscript) => false,
        (Token::Sign("(" | "[" | "." | "?"), _) => false,
        (Token::Sign("{"), Token::Sign("}")) => false,
        (Token::Sign(";" | "," | ":" | "{" | "}" | "=" | ">" | "<"), _) => true,
        (_, Token::Sign("{" | "}" | "=" | ">" | "<")) => true,
        (Token::Sign(".."), _) => !is_index_range(pieces, at - 1),
        (_, Token::Sign("..")) => !is_index_range(pieces, at),
        (Token::Sign("+" | "-"), _) => !structure.is_unary[at - 1],
        (Token::Sign(sign), _) if is_factor(sign) => is_loose(pieces, at - 1, sign),
        (_, Token::Sign("+" | "-")) if !structure.is_unary[at] => true,
        // `2.37 /rad` is a number and its unit.
        (Token::Number, Token::Sign("/")) => {
            let is_unit = pieces
                .get(at + 1)
                .is_some_and(|p| p.token == Token::Name || p.is("("));
            is_unit && own.follows_space()
        }
        (_, Token::Sign(sign)) if is_factor(sign) => is_loose(pieces, at, sign),
        (Token::Name, Token::Sign("(")) => {
            let is_word = structure.begins[at - 1] && last.text != "der";
            is_word || last.is_word(&BEFORE_BRACKET)
        }
        (Token::Name, Token::Sign("[")) => last.is_word(&["in"]),
        (Token::Sign(")" | "]"), Token::Sign("(" | "[")) => own.follows_space(),
        _ => true,
    }
}

fn is_factor(sign: &str) -> bool {
    matches!(sign, "*" | "**" | "/" | "^" | "·" | "×")
}

/// Whether spaces stand around a factor's operator: around `·` and `×` as the author wrote it, and where it begins a line.
fn is_loose(pieces: &[Piece<'_>], at: usize, sign: &str) -> bool {
    if pieces[at].newlines > 0 {
        return true;
    }
    let is_wide = matches!(sign, "·" | "×");
    is_wide && pieces[at].follows_space() && pieces.get(at + 1).is_some_and(Piece::follows_space)
}

/// Whether `..` is in a range of an index, `for i in 1..8` or `sum(i in 1..8, …)`, rather than in bounds.
fn is_index_range(pieces: &[Piece<'_>], at: usize) -> bool {
    let [.., before, index, word, first] = &pieces[..at] else {
        return false;
    };
    let begins = before.is("(") || before.is(",") || before.is_word(&["for"]);
    begins && index.token == Token::Name && word.is_word(&["in"]) && first.token == Token::Number
}
