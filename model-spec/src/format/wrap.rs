//! Breaking of long lines, before the loosest operators or behind commas.

use super::WIDTH;
use super::lines::Line;
use super::piece::{Piece, Structure, width};
use crate::syntax::token::Token;

/// Where a line may break: the less, the looser.
type Looseness = (usize, u8);

/// Breaks a line that is too long, if it can be broken, as often as needed.
pub(super) fn wrapped(line: Line, pieces: &[Piece<'_>], structure: &Structure) -> Vec<Line> {
    if line.width(pieces) <= WIDTH {
        return vec![line];
    }
    let places = places(&line, pieces, structure);
    let Some(&loosest) = places.iter().flatten().min() else {
        return vec![line];
    };
    // The indentation follows from the structure when the text is laid out again.
    let indent = line.indent + 2;
    let comment = line.comment;
    let mut lines = vec![Line {
        pieces: Vec::new(),
        comment: None,
        ..line
    }];
    let mut at = line.indent;
    let mut rest = line.pieces.as_slice();
    while !rest.is_empty() {
        let from = line.pieces.len() - rest.len();
        let next = (from + 1..line.pieces.len()).find(|&next| places[next] == Some(loosest));
        let (part, others) = rest.split_at(next.unwrap_or(line.pieces.len()) - from);
        let parts = part.iter();
        let length: usize = parts
            .map(|&(i, spaces)| spaces + width(pieces[i].text))
            .sum();
        if from > 0 && at + length > WIDTH {
            lines.push(Line {
                indent,
                ..Line::default()
            });
            at = indent;
        }
        if let Some(last) = lines.last_mut() {
            last.pieces.extend(part);
        }
        at += length;
        rest = others;
    }
    for own in &mut lines {
        if let Some((_, spaces)) = own.pieces.first_mut() {
            *spaces = 0;
        }
    }
    if let Some(last) = lines.last_mut() {
        last.comment = comment;
    }
    lines
}

/// For each piece of a line, how loose the operator is that it begins with, or the comma behind which it stands.
fn places(line: &Line, pieces: &[Piece<'_>], structure: &Structure) -> Vec<Option<Looseness>> {
    // A list of names or needs; a comma between the words behind a table cannot end a line.
    let is_list = !line
        .pieces
        .iter()
        .any(|&(at, _)| pieces[at].is("=") || pieces[at].is("}"));
    let mut depth = 0_usize;
    let mut places = Vec::with_capacity(line.pieces.len());
    let mut last: Option<&Piece<'_>> = None;
    for &(at, _) in &line.pieces {
        let piece = &pieces[at];
        let is_closing = structure.partner[at].is_some_and(|partner| partner < at);
        depth = depth.saturating_sub(usize::from(is_closing));
        let is_behind_comma = last.is_some_and(|last| last.is(","));
        let class = match piece.token {
            _ if is_behind_comma && (is_list || structure.inside[at].is_some()) => Some(0),
            Token::Sign("+" | "-") if !structure.is_unary[at] => Some(1),
            Token::Sign("*" | "/" | "·" | "×") => Some(2),
            _ => None,
        };
        places.push(class.filter(|_| last.is_some()).map(|class| (depth, class)));
        let is_opening = structure.partner[at].is_some_and(|partner| partner > at);
        depth += usize::from(is_opening);
        last = Some(piece);
    }
    places
}
