//! Formatter of model files. It works on tokens and comments, so that it needs no rule for each statement: brackets
//! indent, a statement has its line, and inside a statement lines break where the author broke them.

mod align;
mod lines;
mod piece;
mod spacing;
#[cfg(test)]
mod tests;
mod wrap;

use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::read::LoadError;
use crate::syntax::parse_statements;
use piece::{Piece, Structure, pieces};

/// Greatest width of a line that is broken by the formatter, characters; a comment behind it is not counted.
const WIDTH: usize = 140;

/// Number of times that a text is laid out until it stays as it is.
const MAX_PASSES: usize = 12;

/// Formats the text of a model or of an effect, to which messages refer as `name`: the same tokens and comments, in
/// the same order, with other white space. Formatting the result again changes nothing. Line ends stay LF or CRLF.
pub fn format(name: &str, text: &str) -> Result<String, LoadError> {
    let parsed = parse_statements(name, text, 0);
    let refused = |diagnostics| LoadError::Faults {
        diagnostics,
        sources: vec![parsed.source.clone()],
    };
    if !parsed.diagnostics.is_empty() {
        return Err(refused(parsed.diagnostics.clone()));
    }
    let formatted = settled(&parsed.source.text);
    formatted.ok_or_else(|| {
        let message = "this text cannot be formatted without changing its meaning";
        let fault = Diagnostic::new(Kind::Limit, Span::default(), message);
        refused(vec![
            fault.help("leave it as it is; this is an error of hyzer"),
        ])
    })
}

/// The text that is laid out as itself, with the tokens and comments of `text`; `None` if none is found.
fn settled(text: &str) -> Option<String> {
    let mut current = laid_out(text)?;
    for _ in 0..MAX_PASSES {
        let next = laid_out(&current)?;
        if next == current {
            let is_windows = text.contains("\r\n");
            let formatted = if is_windows {
                current.replace('\n', "\r\n")
            } else {
                current
            };
            return is_same(text, &formatted).then_some(formatted);
        }
        current = next;
    }
    None
}

/// Whether two texts have the same tokens and comments.
fn is_same(text: &str, other: &str) -> bool {
    let parts = |text| {
        let pieces: Option<Vec<Piece<'_>>> = pieces(text);
        pieces.map(|all| all.iter().map(|p| (p.token, p.text)).collect::<Vec<_>>())
    };
    parts(text) == parts(other)
}

/// One pass over a text; `None` if something in it is no token, or brackets do not pair.
fn laid_out(text: &str) -> Option<String> {
    let pieces = pieces(text)?;
    let structure = Structure::of(&pieces)?;
    let mut lines = lines::lines(&pieces, &structure);
    align::align(&mut lines, &pieces);
    let lines = lines.into_iter();
    let lines = lines.flat_map(|line| wrap::wrapped(line, &pieces, &structure));
    let mut out = String::with_capacity(text.len() + 64);
    for line in lines {
        if line.follows_blank {
            out.push('\n');
        }
        out.extend(std::iter::repeat_n(' ', line.indent));
        for &(piece, spaces) in line.pieces.iter().chain(&line.comment) {
            out.extend(std::iter::repeat_n(' ', spaces));
            out.push_str(pieces[piece].text);
        }
        out.push('\n');
    }
    Some(out)
}
