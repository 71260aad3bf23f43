//! Lexer: splits source text into tokens, documentation lines and errors.

use std::ops::Range;

use super::token::{Token, clip, first_token, leading_space};
use crate::diagnostic::{Diagnostic, Kind, Span};

#[derive(Clone, Copy, Debug)]
pub(crate) struct Lexeme {
    pub token: Token,
    pub start: u32,
    pub end: u32,
    pub first: bool,
}

pub(crate) struct Lexed {
    /// Tokens without comments; the last is [`Token::End`].
    pub tokens: Vec<Lexeme>,
    /// `///` lines, each with the index of the token that follows.
    pub docs: Vec<(usize, String)>,
    /// The `//!` lines of the file without the leading `//!`, joined by newlines.
    pub file_doc: String,
    pub diagnostics: Vec<Diagnostic>,
}

/// Splits a text into tokens, documentation and errors, with spans in `source`. A run of invalid characters is one
/// [`Token::Bad`], and a line has at most one such error.
pub(crate) fn lex(text: &str, source: u16) -> Lexed {
    let mut lexer = Lexer {
        text,
        source,
        lexed: Lexed {
            tokens: Vec::with_capacity(text.len() / 4),
            docs: Vec::new(),
            file_doc: String::new(),
            diagnostics: Vec::new(),
        },
        unread: None,
        is_first: true,
        line_has_fault: false,
    };
    let mut start = 0;
    while start < text.len() {
        let rest = &text[start..];
        let space = leading_space(rest);
        if space > 0 {
            if rest[..space].contains('\n') {
                (lexer.is_first, lexer.line_has_fault) = (true, false);
            }
            start += space;
            continue;
        }
        let token = first_token(rest);
        let length = token.map_or_else(
            || rest.chars().next().map_or(1, char::len_utf8),
            |(_, length)| length,
        );
        let range = start..start + length;
        start = range.end;
        match token {
            Some((Token::Comment, _)) => lexer.comment(&text[range]),
            Some((Token::OpenText, _)) => lexer.open_text(range),
            Some((token, _)) => lexer.push(token, range),
            None => lexer.unread(range),
        }
    }
    lexer.report_unread();
    let end = text.trim_end().len();
    lexer.is_first = true;
    lexer.push(Token::End, end..end);
    lexer.lexed
}

struct Lexer<'a> {
    text: &'a str,
    source: u16,
    lexed: Lexed,
    /// Byte range of the last run of invalid characters, if it is not yet reported; otherwise `None`.
    unread: Option<Range<usize>>,
    is_first: bool,
    line_has_fault: bool,
}

impl Lexer<'_> {
    fn push(&mut self, token: Token, range: Range<usize>) {
        self.lexed.tokens.push(Lexeme {
            token,
            start: range.start as u32,
            end: range.end as u32,
            first: self.is_first,
        });
        self.is_first = false;
    }

    fn comment(&mut self, line: &str) {
        let line = line.trim_end();
        let body = |mark: &str| {
            let rest = line.strip_prefix(mark)?;
            Some(rest.strip_prefix(' ').unwrap_or(rest).to_owned())
        };
        let lexed = &mut self.lexed;
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

    fn open_text(&mut self, range: Range<usize>) {
        self.line_has_fault = true;
        let message = "this text has no closing quotation mark";
        let fault = Diagnostic::new(Kind::Lexical, self.span(&range), message)
            .help("close it with `\"` on the same line");
        self.lexed.diagnostics.push(fault);
        self.push(Token::OpenText, range);
    }

    fn unread(&mut self, range: Range<usize>) {
        let last = self.lexed.tokens.last_mut();
        let end = (range.start as u32, Token::Bad);
        if let Some(last) = last.filter(|last| (last.end, last.token) == end) {
            last.end = range.end as u32;
            if let Some(run) = &mut self.unread {
                run.end = range.end;
            }
        } else {
            self.report_unread();
            if !self.line_has_fault {
                self.unread = Some(range.clone());
            }
            // The parser abandons the statement at this token without a second error.
            self.push(Token::Bad, range);
        }
        self.line_has_fault = true;
    }

    fn span(&self, range: &Range<usize>) -> Span {
        Span {
            start: range.start as u32,
            end: range.end as u32,
            source: self.source,
        }
    }

    /// Reports the last run of invalid characters, if it is not yet reported.
    fn report_unread(&mut self) {
        const BINARY: &str =
            "a model file is plain text in UTF-8; this looks like another kind of file";
        let Some(range) = self.unread.take() else {
            return;
        };
        let found = &self.text[range.clone()];
        let fault = |message| Diagnostic::new(Kind::Lexical, self.span(&range), message);
        let first = found.chars().next().unwrap_or(' ');
        let fault = if found.chars().all(|c| c == '\0') {
            let bytes = match found.len() {
                1 => "a NUL byte".to_owned(),
                n => format!("{n} NUL bytes"),
            };
            fault(format!("{bytes} cannot stand here")).note(BINARY)
        } else if first.is_control() {
            let code = first as u32;
            fault(format!(
                "the control character U+{code:04X} cannot stand here"
            ))
            .note(BINARY)
        } else if is_invisible(first) {
            let code = first as u32;
            fault(format!(
                "the invisible character U+{code:04X} means nothing in this language"
            ))
            .help("remove it")
            .fix(
                self.span(&(range.start..range.start + first.len_utf8())),
                "",
            )
        } else {
            let shown: String = found.chars().take(12).collect();
            let is_cut = found.chars().nth(12).is_some();
            let more = if is_cut { "…" } else { "" };
            let message = format!("`{shown}{more}` means nothing in this language");
            let fault = fault(message).help_if(instead(first));
            match found {
                "\u{2013}" | "\u{2014}" => fault.fix(self.span(&range), "-"),
                "\u{00F7}" => fault.fix(self.span(&range), "/"),
                "\u{2022}" | "\u{2217}" => fault.fix(self.span(&range), "*"),
                _ => fault,
            }
        };
        self.lexed.diagnostics.push(fault);
    }
}

/// Whether a character takes no visible place: soft hyphens, marks of direction, joiners and spaces without width.
fn is_invisible(c: char) -> bool {
    matches!(c, '\u{AD}' | '\u{200B}'..='\u{200F}' | '\u{2028}'..='\u{202E}' | '\u{2060}'..='\u{206F}' | '\u{FEFF}')
}

/// Suggests a replacement for a character that is not part of the language; `None` if there is no suggestion.
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
        '!' | '&' | '@' | '$' | '~' => return None,
        _ if c.is_alphabetic() => "names are made of Latin and Greek letters, digits and `_`",
        _ => return None,
    };
    Some(text.to_owned())
}

/// Description of a token for error messages.
pub(super) fn name_of(lexeme: Lexeme, text: &str) -> String {
    let raw = &text[lexeme.start as usize..lexeme.end as usize];
    match lexeme.token {
        Token::End => "the end of the file".to_owned(),
        Token::Number => format!("the number {}", clip(raw)),
        Token::Text | Token::OpenText => format!("the text {}", clip(raw)),
        _ => format!("`{}`", clip(raw)),
    }
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
        assert_eq!(
            tokens("-1 .. 0"),
            [Sign("-"), Number, Sign(".."), Number, End]
        );
        assert_eq!(tokens("0..1"), [Number, Sign(".."), Number, End]);
        assert_eq!(
            tokens("N.3*2"),
            [Name, Sign("."), Number, Sign("*"), Number, End]
        );
        assert_eq!(tokens("3.4e-5 m²"), [Number, Name, Superscript, End]);
        assert_eq!(
            tokens("φ̇·ρ − 2"),
            [Name, Sign("·"), Name, Sign("-"), Number, End]
        );
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
    fn a_sign_alone_is_no_superscript() {
        use Token::*;
        assert_eq!(tokens("m⁻²·s"), [Name, Superscript, Sign("·"), Name, End]);
        assert_eq!(tokens("m⁻ 2"), [Name, Bad, Number, End]);
        assert_eq!(tokens("m⁺⁻²"), [Name, Bad, Superscript, End]);
    }

    #[test]
    fn comments_are_sorted_by_their_marks() {
        let lexed = lex("//! file\r\n/// doc\r\nparam // note\n//// rule\n", 0);
        assert_eq!(lexed.file_doc, "file");
        assert_eq!(lexed.docs, [(0, "doc".to_owned())]);
        assert_eq!(lexed.tokens.len(), 2);
    }
}
