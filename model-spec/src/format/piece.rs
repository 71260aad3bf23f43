//! Tokens and comments of a text with the white space before them, and how brackets join them.

use crate::syntax::token::{Token, first_token, leading_space};

/// A token or a comment.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece<'a> {
    pub token: Token,
    /// Text; of a comment without the white space at its end.
    pub text: &'a str,
    /// Line ends between the previous piece and this one.
    pub newlines: usize,
    /// Characters between the previous piece and this one, if both are on one line; else 0.
    pub gap: usize,
    /// Characters of the line before the piece.
    pub column: usize,
}

impl Piece<'_> {
    pub fn is(&self, sign: &'static str) -> bool {
        self.token == Token::Sign(sign)
    }

    pub fn is_comment(&self) -> bool {
        self.token == Token::Comment
    }

    pub fn is_word(&self, words: &[&str]) -> bool {
        self.token == Token::Name && words.contains(&self.text)
    }

    pub fn follows_space(&self) -> bool {
        self.gap + self.newlines > 0
    }
}

/// Characters that a text takes on a line: combining marks take none.
pub(super) fn width(text: &str) -> usize {
    let combining = |c: &char| matches!(c, '\u{300}'..='\u{36F}');
    text.chars().filter(|c| !combining(c)).count()
}

/// The pieces of a text; `None` if something in it is no token.
pub(super) fn pieces(text: &str) -> Option<Vec<Piece<'_>>> {
    let mut pieces: Vec<Piece<'_>> = Vec::with_capacity(text.len() / 4);
    let (mut at, mut column) = (0, 0);
    while at < text.len() {
        let space = &text[at..at + leading_space(&text[at..])];
        let newlines = space.matches('\n').count();
        if newlines > 0 {
            column = 0;
        }
        let last = space.rsplit('\n').next().unwrap_or_default();
        let gap = width(last);
        column += gap;
        at += space.len();
        if at == text.len() {
            break;
        }
        let (token, length) = first_token(&text[at..])?;
        if token == Token::OpenText {
            return None;
        }
        let own = text[at..at + length].trim_end();
        pieces.push(Piece {
            token,
            text: own,
            newlines,
            gap: if newlines > 0 { 0 } else { gap },
            column,
        });
        at += length;
        column += width(own);
    }
    Some(pieces)
}

/// How brackets and statements join the pieces of a text, by their indices.
pub(super) struct Structure {
    /// Index of the other bracket of a pair.
    pub partner: Vec<Option<usize>>,
    /// Whether a piece is a brace around statements; the braces of a table are not.
    pub is_block: Vec<bool>,
    /// Whether a piece, or a comment before it, begins a statement.
    pub begins: Vec<bool>,
    /// Innermost bracket around a piece that is no brace around statements.
    pub inside: Vec<Option<usize>>,
    /// Whether a `+` or `-` is a sign, not an operator.
    pub is_unary: Vec<bool>,
}

impl Structure {
    /// `None` if brackets do not pair.
    pub fn of(pieces: &[Piece<'_>]) -> Option<Structure> {
        let count = pieces.len();
        let mut found = Structure {
            partner: vec![None; count],
            is_block: vec![false; count],
            begins: vec![false; count],
            inside: vec![None; count],
            is_unary: vec![false; count],
        };
        let mut open: Vec<usize> = Vec::new();
        let mut before: Option<usize> = None;
        let mut begins = true;
        for (i, piece) in pieces.iter().enumerate() {
            found.begins[i] = begins;
            let of_block = |found: &Structure, open: &[usize]| {
                let last = open.last();
                last.is_none_or(|&last| found.is_block[last])
            };
            if piece.is_comment() {
                found.inside[i] = inner(&found, &open);
                continue;
            }
            begins = false;
            match piece.token {
                Token::Sign("(" | "[" | "{") => {
                    let of_value = before.is_some_and(|before| pieces[before].is("="));
                    found.is_block[i] = piece.is("{") && !of_value && of_block(&found, &open);
                    begins = found.is_block[i];
                    found.inside[i] = inner(&found, &open);
                    open.push(i);
                }
                Token::Sign(closing @ (")" | "]" | "}")) => {
                    let opened = open.pop()?;
                    let pair = matches!(
                        (pieces[opened].text, closing),
                        ("(", ")") | ("[", "]") | ("{", "}")
                    );
                    if !pair {
                        return None;
                    }
                    (found.partner[i], found.partner[opened]) = (Some(opened), Some(i));
                    found.is_block[i] = found.is_block[opened];
                    begins = found.is_block[i];
                    found.inside[i] = inner(&found, &open);
                }
                Token::Sign(sign) => {
                    begins = sign == ";" && of_block(&found, &open);
                    found.inside[i] = inner(&found, &open);
                    if matches!(sign, "+" | "-") {
                        found.is_unary[i] = found.is_sign(pieces, i, before);
                    }
                }
                _ => found.inside[i] = inner(&found, &open),
            }
            before = Some(i);
        }
        open.is_empty().then_some(found)
    }

    /// Whether a `+` or `-` behind the piece `before` is a sign.
    fn is_sign(&self, pieces: &[Piece<'_>], at: usize, before: Option<usize>) -> bool {
        let Some(before) = before else { return true };
        let last = pieces[before];
        match last.token {
            Token::Sign(")" | "]" | "}" | "?") => false,
            Token::Sign(_) => true,
            // No statement begins with an expression.
            Token::Name if self.begins[before] => true,
            // The unit of the body part `angular velocity`, and words before an expression or a number.
            Token::Name if last.text == "in" => is_bound(pieces, at),
            Token::Name => {
                let of_body = last.text == "velocity"
                    && before > 0
                    && pieces[before - 1].text == "angular"
                    && self.begins[before - 1];
                of_body || ["within", "return", "or", "by", "turned"].contains(&last.text)
            }
            _ => false,
        }
    }

    /// Whether a piece is in a bracket, other than one around statements, that the author broke into lines.
    pub fn spanning(&self, pieces: &[Piece<'_>]) -> Vec<bool> {
        let mut spanning = vec![false; pieces.len()];
        for (open, close) in self.partner.iter().enumerate() {
            let Some(close) = close.filter(|&close| close > open && !self.is_block[close]) else {
                continue;
            };
            let inner = self.inside[open].is_some_and(|outer| spanning[outer]);
            let breaks = || pieces[open + 1..=close].iter().any(|p| p.newlines > 0);
            spanning[open] = inner || breaks();
        }
        let in_spanning = |around: &Option<usize>| around.is_some_and(|open| spanning[open]);
        self.inside.iter().map(in_spanning).collect()
    }
}

fn inner(found: &Structure, open: &[usize]) -> Option<usize> {
    open.last().copied().filter(|&last| !found.is_block[last])
}

/// Whether a range follows, as in `in -2 m .. 2 m`, before the statement ends.
fn is_bound(pieces: &[Piece<'_>], at: usize) -> bool {
    let mut rest = pieces[at..].iter();
    rest.find(|piece| matches!(piece.token, Token::Sign(".." | ";" | "," | "=")))
        .is_some_and(|piece| piece.is(".."))
}
