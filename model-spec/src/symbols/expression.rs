//! Names, units and words in expressions and quantities.

use std::ops::Range;

use super::scan::{Found, Scanner};
use super::{Namespace, SymbolKind};
use crate::syntax::quantity::{FOLLOWING, INCH};
use crate::syntax::spelling::plain;
use crate::syntax::token::Token;
use crate::unit::symbol;

/// Tokens of a unit or type, beyond which its end is not searched.
const MAX_UNIT_TOKENS: usize = 40;

/// Words that stand inside statements.
pub const INNER: [&str; 16] = [
    "in",
    "turned",
    "about",
    "by",
    "quaternion",
    "within",
    "relative",
    "for",
    "on",
    "or",
    "vector",
    "monotone",
    "constant",
    "linear",
    "fixed",
    "axis",
];

impl Scanner<'_> {
    /// Reads an expression, or in a `quantity` a number whose unit has several factors.
    pub fn expression(&mut self, tokens: Range<usize>, quantity: bool) {
        let mut at = tokens.start;
        while at < tokens.end {
            at = match self.token(at) {
                Token::Number | Token::Superscript => {
                    self.unit_behind(at + 1, tokens.end, quantity)
                }
                Token::Sign(")") if quantity => self.unit_behind(at + 1, tokens.end, quantity),
                Token::Sign(":") if !quantity || self.token(at + 1) == Token::Name => {
                    let stop = self.end_of_type(at + 1, tokens.end);
                    self.of_type(at + 1..stop);
                    stop
                }
                Token::Name => self.name(at, &tokens),
                _ => at + 1,
            };
        }
    }

    /// Reads the unit at `at`, if there is one; returns the index of the token behind it.
    fn unit_behind(&mut self, at: usize, end: usize, quantity: bool) -> usize {
        if at >= end {
            return end;
        }
        if self.text(at) == "[" {
            let stop = (at..end)
                .find(|&next| self.text(next) == "]")
                .unwrap_or(end);
            self.of_type(at + 1..stop);
            return stop;
        }
        let is_unit = |scanner: &Self, at: usize| {
            let text = scanner.text(at);
            let is_inch =
                text == INCH && !quantity && matches!(scanner.token(at + 1), Token::Sign(_));
            let is_word = FOLLOWING.contains(&text) && !is_inch;
            scanner.token(at) == Token::Name
                && !is_word
                && scanner.text(at + 1) != "("
                && symbol::find(text).is_some()
        };
        if quantity && self.text(at) == "/" && self.text(at + 1) == "(" {
            // `1 /(kg*m^2)`, unless a quantity is meant.
            let near = end.min(at + MAX_UNIT_TOKENS);
            let stop = (at..near).find(|&next| self.text(next) == ")");
            let stop = stop.unwrap_or(at + 1);
            let is_unit = |next: usize| symbol::find(self.text(next)).is_some();
            if stop > at + 1 && { at + 2..stop }
                .all(|next| self.token(next) != Token::Name || is_unit(next))
            {
                self.of_type(at + 2..stop);
                return stop;
            }
        }
        let mut next = at;
        if quantity && self.text(next) == "/" {
            next += 1;
        }
        while next < end && is_unit(self, next) {
            self.word(next, Found::Unit);
            next += 1;
            // A power.
            while next < end && matches!(self.text(next), "^" | "-")
                || self.token(next) == Token::Superscript
            {
                next += 1;
                if self.token(next) == Token::Number {
                    next += 1;
                }
            }
            let goes_on = quantity && matches!(self.text(next), "*" | "/" | "·");
            if !goes_on || !is_unit(self, next + 1) {
                return next;
            }
            next += 1;
        }
        at
    }

    /// Index of the token that ends a type or unit.
    pub fn end_of_type(&self, at: usize, end: usize) -> usize {
        let is_end =
            |&next: &usize| matches!(self.text(next), "=" | "," | ")" | "{" | "}" | ";" | "or");
        let end = end.min(at + MAX_UNIT_TOKENS);
        (at..end).find(is_end).unwrap_or(end)
    }

    /// Reads `UNIT` or `vector UNIT in FRAME`.
    pub fn of_type(&mut self, tokens: Range<usize>) {
        for at in tokens {
            let follows_in = at > 0 && self.text(at - 1) == "in";
            match self.text(at) {
                "vector" | "in" => self.keyword(at),
                _ if follows_in => self.word(at, Found::Name(Namespace::Frame)),
                _ => self.word(at, Found::Unit),
            }
        }
    }

    /// Reads the name at `at`; returns the index of the next token.
    fn name(&mut self, at: usize, tokens: &Range<usize>) -> usize {
        let (text, next) = (self.text(at), self.text(at + 1));
        if next == "in" && self.token(at + 2) == Token::Number && self.text(at + 3) == ".." {
            // An index is known in its statement.
            let scope = self.range(tokens.start).start..self.range(tokens.end).end;
            self.declare_in(at, SymbolKind::Index, scope, false);
            self.keyword(at + 1);
            return at + 4;
        }
        if text == "in" {
            self.keyword(at);
            if self.token(at + 1) == Token::Name && next != "der" {
                self.word(at + 1, Found::Name(Namespace::Frame));
                return at + 2;
            }
            return at + 1;
        }
        if next == "("
            && let Some(frame) = text.strip_prefix("in_").filter(|f| *f != "frame_of")
        {
            let range = self.range(at);
            let start = range.end - frame.len();
            let words = &mut self.scanned.words;
            words.push((range.start..start, Found::Keyword));
            words.push((start..range.end, Found::Name(Namespace::Frame)));
            return at + 1;
        }
        let is_part = next == "." && self.token(at + 2) == Token::Number;
        let is_known = || self.scanned.names.contains(&plain(text));
        let found = match next {
            "(" => Found::Name(Namespace::Callable),
            _ if is_part => Found::Name(Namespace::FrameOrValue),
            _ if INNER.contains(&text) && !is_known() => Found::Keyword,
            _ => Found::Name(Namespace::Value),
        };
        self.word(at, found);
        at + 1
    }
}
