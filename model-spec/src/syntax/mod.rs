//! From text to tree: an own lexer, statements by recursive descent, expressions by precedence.
//!
//! A fault is reported once; the parser then goes on at the next statement, so that all faults of a file
//! come out in one pass.

pub mod ast;
mod block;
mod effect;
mod expr;
mod parser;
mod print;
mod print_file;
mod quantity;
mod spans;
pub mod spelling;
mod statement;
pub(crate) mod token;
mod walk;

pub(crate) use expr::HIGHEST;

use crate::diagnostic::{Diagnostic, Kind};
use crate::source::{Source, Span};

/// The longest text that is read, in bytes.
pub const MAX_SOURCE_BYTES: usize = 1_000_000;

/// A file that was read, with what was wrong about it.
#[derive(Clone, Debug)]
pub struct Parsed {
    /// The tree; statements that could not be read are missing from it.
    pub file: ast::File,
    /// The text it came from.
    pub source: Source,
    /// What was wrong.
    pub diagnostics: Vec<Diagnostic>,
}

/// Reads a model file.
pub fn parse(name: &str, text: &str) -> Parsed {
    parse_as(name, text, 0)
}

/// Reads a file whose places carry the number `source`; effects that are applied to a model count from 1.
pub fn parse_as(name: &str, text: &str, source: u16) -> Parsed {
    let text = text.strip_prefix('\u{FEFF}').unwrap_or(text);
    if text.len() > MAX_SOURCE_BYTES {
        return too_long(name, text.len(), source);
    }
    let mut parser = parser::Parser::new(text, source);
    let file = parser.file();
    let diagnostics = parser.finish();
    Parsed {
        file,
        source: Source {
            name: name.to_owned(),
            text: text.to_owned(),
        },
        diagnostics,
    }
}

/// A file that is too long is not looked at.
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
        source: Source {
            name: name.to_owned(),
            text: String::new(),
        },
        diagnostics: vec![
            Diagnostic::new(Kind::Limit, span, message).help("is this the file you meant?"),
        ],
    }
}
