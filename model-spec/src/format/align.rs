//! Columns that the author has aligned: the `=` of declarations, and comments at the ends of lines.

use super::lines::Line;
use super::piece::{Piece, width};

/// Aligns what was aligned.
pub(super) fn align(lines: &mut [Line], pieces: &[Piece<'_>]) {
    let equals = |line: &Line| {
        let mut parts = line.pieces.iter();
        let at = parts.position(|&(piece, _)| pieces[piece].is("="))?;
        Some((at, line.pieces[at].0))
    };
    for group in groups(lines, pieces, |line| Some(equals(line)?.1)) {
        let is_padded = |&at: &usize| pieces[at].gap > 1;
        let own = |&line: &usize| equals(&lines[line]);
        if group.len() < 2 || !group.iter().filter_map(own).any(|(_, at)| is_padded(&at)) {
            continue;
        }
        let before = |line: usize| {
            let (at, _) = equals(&lines[line]).unwrap_or_default();
            let parts = lines[line].pieces[..at].iter();
            lines[line].indent
                + parts
                    .map(|&(i, n)| n + width(pieces[i].text))
                    .sum::<usize>()
        };
        let widths: Vec<usize> = group.iter().map(|&line| before(line)).collect();
        let column = widths.iter().max().map_or(0, |most| most + 1);
        for (line, width) in group.into_iter().zip(widths) {
            if let Some((at, _)) = equals(&lines[line]) {
                lines[line].pieces[at].1 = column - width;
            }
        }
    }
    for group in groups(lines, pieces, |line| Some(line.comment?.0)) {
        let widths: Vec<usize> = group
            .iter()
            .map(|&line| lines[line].width(pieces))
            .collect();
        let gaps = group.iter().filter_map(|&line| lines[line].comment);
        let least = gaps.map(|(_, spaces)| spaces).min().unwrap_or(1);
        let column = widths.iter().max().map_or(0, |most| most + least);
        for (line, width) in group.into_iter().zip(widths) {
            if let Some((_, spaces)) = &mut lines[line].comment {
                *spaces = column - width;
            }
        }
    }
}

/// Groups of lines, with no blank line between, in which a certain piece stood in one column of the text.
fn groups(
    lines: &[Line],
    pieces: &[Piece<'_>],
    piece: impl Fn(&Line) -> Option<usize>,
) -> Vec<Vec<usize>> {
    let mut groups: Vec<Vec<usize>> = Vec::new();
    let mut column = None;
    for (i, line) in lines.iter().enumerate() {
        if line.follows_blank {
            column = None;
        }
        let Some(own) = piece(line).map(|at| pieces[at].column) else {
            continue;
        };
        match groups.last_mut() {
            Some(group) if column == Some(own) => group.push(i),
            _ => groups.push(vec![i]),
        }
        column = Some(own);
    }
    groups
}
