//! Lines of a formatted text: where they break, how far they are indented.

use super::WIDTH;
use super::piece::{Piece, Structure, width};
use super::spacing::space_before;
use crate::syntax::token::Token;

const INDENT: usize = 2;

/// A line: its pieces with the spaces before them, and the comment that ends it.
#[derive(Default)]
pub(super) struct Line {
    pub indent: usize,
    pub follows_blank: bool,
    /// Index of each piece, and the number of spaces before it.
    pub pieces: Vec<(usize, usize)>,
    /// Index of the comment behind the pieces, and the number of spaces before it.
    pub comment: Option<(usize, usize)>,
}

impl Line {
    /// Width without the comment behind.
    pub fn width(&self, pieces: &[Piece<'_>]) -> usize {
        let parts = self.pieces.iter();
        let parts = parts.map(|&(piece, spaces)| spaces + width(pieces[piece].text));
        self.indent + parts.sum::<usize>()
    }
}

/// Breaks a text into lines; those of a statement that are too long stay so.
pub(super) fn lines(pieces: &[Piece<'_>], structure: &Structure) -> Vec<Line> {
    let mut builder = Builder {
        pieces,
        structure,
        in_spanning: structure.spanning(pieces),
        lines: Vec::new(),
        opened: Vec::new(),
        blocks: 0,
        inline: None,
    };
    for at in 0..pieces.len() {
        builder.add(at);
    }
    builder.lines
}

struct Builder<'a> {
    pieces: &'a [Piece<'a>],
    structure: &'a Structure,
    in_spanning: Vec<bool>,
    lines: Vec<Line>,
    /// Open brackets other than those around statements, with the indentation of their lines.
    opened: Vec<(usize, usize)>,
    /// Number of open blocks.
    blocks: usize,
    /// The brace that ends a block which stands on one line.
    inline: Option<usize>,
}

impl Builder<'_> {
    fn add(&mut self, at: usize) {
        let piece = &self.pieces[at];
        let is_block = self.structure.is_block[at];
        if is_block && piece.is("}") {
            self.blocks -= 1;
        }
        if self.breaks_before(at) {
            let line = Line {
                indent: self.indent(at),
                follows_blank: self.keeps_blank(at),
                pieces: vec![(at, 0)],
                comment: None,
            };
            self.lines.push(line);
        } else {
            self.append(at);
        }
        self.track(at);
    }

    fn append(&mut self, at: usize) {
        let piece = &self.pieces[at];
        let kept = self.in_spanning[at] && piece.gap > 1;
        let spaces = if kept {
            piece.gap
        } else if piece.is_comment() {
            piece.gap.max(1)
        } else {
            space_before(self.pieces, self.structure, at)
        };
        let Some(line) = self.lines.last_mut() else {
            return;
        };
        if piece.is_comment() {
            line.comment = Some((at, spaces));
        } else {
            line.pieces.push((at, spaces));
        }
    }

    /// Follows brackets beyond the piece that was added.
    fn track(&mut self, at: usize) {
        let Some(partner) = self.structure.partner[at] else {
            return;
        };
        let is_opening = partner > at;
        if self.structure.is_block[at] {
            self.blocks += usize::from(is_opening);
            if is_opening && self.fits_on_line(at, partner) {
                self.inline = Some(partner);
            } else if self.inline == Some(at) {
                self.inline = None;
            }
        } else if is_opening {
            let indent = self.lines.last().map_or(0, |line| line.indent);
            self.opened.push((at, indent));
        } else {
            self.opened.pop();
        }
    }

    fn breaks_before(&self, at: usize) -> bool {
        let piece = &self.pieces[at];
        let Some(last) = at.checked_sub(1).map(|last| &self.pieces[last]) else {
            return true;
        };
        if last.is_comment() {
            return true;
        }
        if piece.is_comment() {
            return piece.newlines > 0;
        }
        let is_block = self.structure.is_block[at];
        if piece.is(";") || piece.is(",") || is_block && piece.is("{") {
            return false;
        }
        if self.structure.is_block[at - 1] && is_block {
            // An empty block.
            return last.is("}");
        }
        let ends = is_block || self.structure.begins[at];
        match self.inline {
            Some(_) if ends => false,
            _ => ends || piece.newlines > 0,
        }
    }

    fn keeps_blank(&self, at: usize) -> bool {
        let is_block = |at: usize, sign| self.structure.is_block[at] && self.pieces[at].is(sign);
        let is_first = at == 0 || is_block(at - 1, "{");
        self.pieces[at].newlines > 1 && !is_first && !is_block(at, "}")
    }

    fn indent(&self, at: usize) -> usize {
        let (piece, structure) = (&self.pieces[at], self.structure);
        let of_block = INDENT * self.blocks;
        if structure.is_block[at] || structure.begins[at] {
            return of_block;
        }
        match (self.opened.last(), structure.partner[at]) {
            (Some(&(_, indent)), Some(partner)) if partner < at => indent,
            (Some(&(open, indent)), _) => indent + INDENT + self.beyond_others(piece, open),
            (None, _) => of_block + INDENT,
        }
    }

    /// Spaces by which a number is set off from the leftmost line of its bracket, to stand in a column.
    fn beyond_others(&self, piece: &Piece<'_>, open: usize) -> usize {
        let is_number = |piece: &Piece<'_>| matches!(piece.token, Token::Number | Token::Sign("-"));
        let Some(close) = self.structure.partner[open].filter(|_| is_number(piece)) else {
            return 0;
        };
        let first = (open + 1..close)
            .filter(|&at| self.structure.inside[at] == Some(open))
            .map(|at| &self.pieces[at])
            .filter(|own| own.newlines > 0 && is_number(own))
            .map(|own| own.column)
            .min();
        piece.column - first.unwrap_or(piece.column).min(piece.column)
    }

    /// Whether the block between two braces stays on the line: the author wrote it so, and it has one statement.
    fn fits_on_line(&self, open: usize, close: usize) -> bool {
        let inner = &self.pieces[open + 1..=close];
        let statements = inner.iter().filter(|piece| piece.is(";")).count();
        let is_plain = |piece: &Piece<'_>| piece.newlines == 0 && !piece.is_comment();
        let has_block = self.structure.is_block[open + 1..close].contains(&true);
        if self.inline.is_some() || statements > 1 || has_block || !inner.iter().all(is_plain) {
            return false;
        }
        let before = self.lines.last().map_or(0, |line| line.width(self.pieces));
        let inner = open + 1..=close;
        let inner = inner
            .map(|at| space_before(self.pieces, self.structure, at) + width(self.pieces[at].text));
        before + inner.sum::<usize>() < WIDTH
    }
}
