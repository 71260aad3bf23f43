//! From text to tokens.

use std::ops::Range;

use logos::Logos;

use super::spelling;
use crate::diagnostic::{Diagnostic, Kind, Span};

/// The kinds of token.
#[derive(Logos, Clone, Copy, Debug, PartialEq, Eq)]
#[logos(skip r"[ \t\r\n\u{000C}\u{00A0}\u{FEFF}]+")]
pub(super) enum Token {
    #[regex(r"//[^\n]*", allow_greedy = true)]
    Comment,
    #[regex(r"[A-Za-z_°µ\u{0370}-\u{03FF}\u{1E00}-\u{1EFF}żġ][A-Za-z0-9_µ\u{0370}-\u{03FF}\u{1E00}-\u{1EFF}żġ\u{0307}\u{0308}]*")]
    Name,
    #[regex(r"[0-9]+(\.[0-9]+)?([eE][+\-−]?[0-9]+)?")]
    Number,
    #[regex(r#""[^"\n]*""#)]
    Text,
    #[regex(r#""[^"\n]*"#)]
    OpenText,
    #[regex(r"[⁺⁻]?[⁰¹²³⁴⁵⁶⁷⁸⁹]+")]
    Superscript,
    #[token("+")]
    Plus,
    #[token("-")]
    #[token("−")]
    Minus,
    #[token("*")]
    Star,
    #[token("·")]
    #[token("⋅")]
    Dot,
    #[token("×")]
    Times,
    #[token("/")]
    Slash,
    #[token("^")]
    Caret,
    #[token("**")]
    StarStar,
    #[token("(")]
    Open,
    #[token(")")]
    Close,
    #[token("[")]
    OpenSquare,
    #[token("]")]
    CloseSquare,
    #[token("{")]
    OpenBrace,
    #[token("}")]
    CloseBrace,
    #[token(",")]
    Comma,
    #[token(";")]
    Semicolon,
    #[token(":")]
    Colon,
    #[token("=")]
    Equals,
    #[token(">")]
    Greater,
    #[token("<")]
    Less,
    #[token("..")]
    To,
    #[token(".")]
    Point,
    /// What could not be read; the lexer itself never yields it.
    Bad,
    /// The end of the text; the lexer itself never yields it.
    End,
}

/// A token and its place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lexeme {
    pub token: Token,
    pub start: u32,
    pub end: u32,
    /// Whether it is the first on its line.
    pub first: bool,
}

/// What the lexer makes of a text.
pub(super) struct Lexed {
    /// Tokens without comments; the last is [`Token::End`].
    pub tokens: Vec<Lexeme>,
    /// `///` lines, each with the index of the token that follows it.
    pub docs: Vec<(usize, String)>,
    /// The `//!` lines.
    pub file_doc: String,
    /// Faults.
    pub diagnostics: Vec<Diagnostic>,
}

/// Cuts a text into tokens. What cannot be read is reported, once for each run of it, and left out.
pub(super) fn lex(text: &str, source: u16) -> Lexed {
    let mut lexed = Lexed {
        tokens: Vec::with_capacity(text.len() / 4),
        docs: Vec::new(),
        file_doc: String::new(),
        diagnostics: Vec::new(),
    };
    let mut lexer = Token::lexer(text);
    let (mut last_end, mut first, mut faulty_line) = (0, true, false);
    let mut bad: Option<Run> = None;
    while let Some(token) = lexer.next() {
        let range = lexer.span();
        if text[last_end..range.start].contains('\n') {
            (first, faulty_line) = (true, false);
        }
        last_end = range.end;
        match token {
            Ok(Token::Comment) => {
                comment(&mut lexed, &text[range.clone()]);
                continue;
            }
            Err(()) => {
                match &mut bad {
                    Some(run) if run.end == range.start => run.end = range.end,
                    _ => {
                        report(&mut lexed, text, source, bad.take());
                        let Range { start, end } = range;
                        bad = Some(Run {
                            start,
                            end,
                            told: faulty_line,
                        });
                        // The parser gives up the statement, and says nothing more about it.
                        let (start, end) = (start as u32, end as u32);
                        lexed.tokens.push(Lexeme {
                            token: Token::Bad,
                            start,
                            end,
                            first,
                        });
                    }
                }
                (first, faulty_line) = (false, true);
                continue;
            }
            Ok(Token::OpenText) => {
                faulty_line = true;
                let span = place(range.start, range.end, source);
                lexed.diagnostics.push(
                    Diagnostic::new(
                        Kind::Lexical,
                        span,
                        "this text has no closing quotation mark",
                    )
                    .help("close it with `\"` on the same line"),
                );
            }
            Ok(_) => {}
        }
        let (start, end) = (range.start as u32, range.end as u32);
        lexed.tokens.push(Lexeme {
            token: token.unwrap_or(Token::Bad),
            start,
            end,
            first,
        });
        first = false;
    }
    report(&mut lexed, text, source, bad);
    let end = text.trim_end().len() as u32;
    lexed.tokens.push(Lexeme {
        token: Token::End,
        start: end,
        end,
        first: true,
    });
    lexed
}

/// A run of characters that mean nothing.
struct Run {
    start: usize,
    end: usize,
    /// Whether something on the same line has been reported already.
    told: bool,
}

fn comment(lexed: &mut Lexed, line: &str) {
    let line = line.trim_end();
    let body = |mark: &str| {
        let rest = line.strip_prefix(mark)?;
        Some(rest.strip_prefix(' ').unwrap_or(rest).to_owned())
    };
    if let Some(doc) = body("//!") {
        if !lexed.file_doc.is_empty() {
            lexed.file_doc.push('\n');
        }
        lexed.file_doc.push_str(&doc);
    } else if !line.starts_with("////")
        && let Some(doc) = body("///")
    {
        lexed.docs.push((lexed.tokens.len(), doc));
    }
}

fn place(start: usize, end: usize, source: u16) -> Span {
    Span {
        start: start as u32,
        end: end as u32,
        source,
    }
}

fn report(lexed: &mut Lexed, text: &str, source: u16, run: Option<Run>) {
    let Some(Run {
        start,
        end,
        told: false,
    }) = run
    else {
        return;
    };
    let found = &text[start..end];
    let span = place(start, end, source);
    let mut chars = found.chars();
    let first = chars.next().unwrap_or(' ');
    let fault = if found.chars().all(|c| c == '\0') {
        Diagnostic::new(
            Kind::Lexical,
            span,
            match found.len() {
                1 => "a NUL byte cannot stand here".to_owned(),
                n => format!("{n} NUL bytes cannot stand here"),
            },
        )
        .note("a model file is plain text in UTF-8; this looks like another kind of file")
    } else if first.is_control() {
        let message = format!(
            "the control character U+{:04X} cannot stand here",
            first as u32
        );
        Diagnostic::new(Kind::Lexical, span, message)
            .note("a model file is plain text in UTF-8; this looks like another kind of file")
    } else {
        let shown: String = found.chars().take(12).collect();
        let more = if found.chars().nth(12).is_some() {
            "…"
        } else {
            ""
        };
        Diagnostic::new(
            Kind::Lexical,
            span,
            format!("`{shown}{more}` means nothing in this language"),
        )
        .help_if(instead(first))
    };
    lexed.diagnostics.push(fault);
}

/// What was probably meant by a character that the language does not have.
fn instead(c: char) -> Option<String> {
    let text = match c {
        '\u{2018}' | '\u{2019}' | '\'' | '`' => "texts stand between `\"` marks",
        '\u{201C}' | '\u{201D}' => "use the plain quotation mark `\"`",
        '\u{2013}' | '\u{2014}' => "use `-` for minus",
        '\u{00F7}' | '\\' => "use `/` to divide",
        '\u{2022}' | '\u{2217}' => "use `*` or `·` to multiply",
        '#' | '%' => "comments begin with `//`",
        '₀'..='₉' => return Some(format!("write an index as `_{}`", c as u32 - '₀' as u32)),
        '√' => "write `sqrt(…)`",
        '∥' | '|' => "write `norm(…)` for a length, `abs(…)` for a magnitude",
        '≤' | '≥' | '<' => "a limit is written `limit quantity > number \"reason\";`",
        '∂' | '∫' | '∑' => "derivatives of states are written `der(state)`",
        '!' | '&' | '?' | '@' | '$' | '~' => return None,
        _ if c.is_alphabetic() => "names are made of Latin and Greek letters, digits and `_`",
        _ => return None,
    };
    Some(text.to_owned())
}

/// What a token is called in a message.
pub(super) fn name_of(lexeme: Lexeme, text: &str) -> String {
    let raw = &text[lexeme.start as usize..lexeme.end as usize];
    match lexeme.token {
        Token::End => "the end of the file".to_owned(),
        Token::Number => format!("the number {}", clip(raw)),
        Token::Text | Token::OpenText => format!("the text {}", clip(raw)),
        _ => format!("`{}`", clip(raw)),
    }
}

/// A text cut to a length that fits in a message.
pub(crate) fn clip(raw: &str) -> String {
    const MOST: usize = 60;
    if raw.chars().nth(MOST).is_none() {
        return raw.to_owned();
    }
    let head: String = raw.chars().take(MOST - 1).collect();
    format!("{head}…")
}

/// The plain spelling of a name token.
pub(super) fn plain_name(raw: &str) -> String {
    spelling::plain(raw)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tokens(text: &str) -> Vec<Token> {
        lex(text, 0).tokens.iter().map(|t| t.token).collect()
    }

    #[test]
    fn numbers_do_not_swallow_ranges_and_axes() {
        use Token::*;
        assert_eq!(tokens("-1 .. 0"), [Minus, Number, To, Number, End]);
        assert_eq!(tokens("0..1"), [Number, To, Number, End]);
        assert_eq!(tokens("N.3*2"), [Name, Point, Number, Star, Number, End]);
        assert_eq!(tokens("3.4e-5 m²"), [Number, Name, Superscript, End]);
        assert_eq!(tokens("φ̇·ρ − 2"), [Name, Dot, Name, Minus, Number, End]);
    }

    #[test]
    fn bad_characters_are_reported_once_for_a_run() {
        let lexed = lex("a \0\0\0\0 b ¿¿ c", 0);
        // The second run is on the same line.
        assert_eq!(lexed.diagnostics.len(), 1);
        assert!(lexed.diagnostics[0].message.contains("4 NUL bytes"));
        assert_eq!(lexed.tokens.len(), 6);
    }

    #[test]
    fn comments_are_sorted_by_their_marks() {
        let lexed = lex("//! file\r\n/// doc\r\nparam // note\n//// rule\n", 0);
        assert_eq!(lexed.file_doc, "file");
        assert_eq!(lexed.docs, [(0, "doc".to_owned())]);
        assert_eq!(lexed.tokens.len(), 2);
    }
}
