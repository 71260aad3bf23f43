//! Parser and printer of model files: recursive descent for statements, precedence climbing for expressions.
//!
//! After an error, the parser continues at the next statement, so one pass reports all syntax errors.

pub mod ast;
mod block;
mod body_parts;
pub(crate) mod case;
mod effect;
pub(crate) mod expand;
mod expr;
mod function;
pub(crate) mod lexer;
pub(crate) mod parser;
mod print;
mod print_file;
pub(crate) mod quantity;
pub(crate) mod reserved;
mod solve;
pub mod spelling;
mod statement;
pub(crate) mod token;
mod walk;
pub mod words;

pub(crate) use body_parts::{Parts, lacking, stated_twice};
pub(crate) use walk::{of_kind, preorder};

pub(crate) use expr::MAX_HEIGHT;
use function::{MAX_ELEMENTS, element_name};

use crate::diagnostic::{Diagnostic, Kind};
use crate::location::{Source, Span};

/// Maximum length of the text of a model or of an effect, bytes. A longer text is reported as an error and not parsed.
pub const MAX_SOURCE_BYTES: usize = 1_000_000;

/// Result of [`parse`]: syntax tree, with arrays and calls of functions written out, source and diagnostics.
#[derive(Clone, Debug)]
pub struct Parsed {
    /// Syntax tree without the statements that have errors.
    pub file: ast::File,
    /// Source text that was parsed; empty if it was too long.
    pub source: Source,
    /// Lexical and syntax errors, in the order of their source spans.
    pub diagnostics: Vec<Diagnostic>,
}

/// Parses the text of a model file, which messages call `name`.
pub fn parse(name: &str, text: &str) -> Parsed {
    parse_as(name, text, 0)
}

/// Parses the text of a model file with this [`Span::source`].
pub fn parse_as(name: &str, text: &str, source: u16) -> Parsed {
    let mut parsed = parse_statements(name, text, source);
    // Arrays and functions of an incomplete tree would be reported as missing.
    if parsed.diagnostics.is_empty() {
        parsed.diagnostics = expand::expand(&mut parsed.file);
    }
    parsed
}

/// Parses a text without writing out its arrays and calls of functions.
pub(crate) fn parse_statements(name: &str, text: &str, source: u16) -> Parsed {
    let text = text.strip_prefix('\u{FEFF}').unwrap_or(text);
    if text.len() > MAX_SOURCE_BYTES {
        return too_long(name, text.len(), source);
    }
    let mut parser = parser::Parser::new(text, source);
    let file = parser.file();
    let diagnostics = parser.finish();
    Parsed {
        file,
        source: Source::new(name, text),
        diagnostics,
    }
}

pub(crate) fn too_long(name: &str, length: usize, source: u16) -> Parsed {
    let span = Span {
        source,
        ..Span::default()
    };
    let message =
        format!("the file has {length} bytes; a model file has at most {MAX_SOURCE_BYTES}");
    Parsed {
        file: ast::File {
            end: span,
            ..ast::File::default()
        },
        source: Source::new(name, ""),
        diagnostics: vec![
            Diagnostic::new(Kind::Limit, span, message).help("is this the file you meant?"),
        ],
    }
}
