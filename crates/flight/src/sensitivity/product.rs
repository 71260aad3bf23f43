//! The product J S: J by its entries, S by its rows.

use super::PADDING;
use lanes::{Kernel, Lanes};
use std::ops::Range;

/// As many rows as have their sums in registers.
const TOGETHER: usize = 3;

/// Where the entries of J stand, made ready for S whose rows are so long.
pub(super) struct Product {
    /// The shortest first: loops that are as long as the last one are foreseen.
    blocks: Vec<Block>,
    /// First groups of the rows of S that the blocks' columns are, block by block.
    columns: Vec<usize>,
    /// Lines of `PADDING` numbers that are summed together.
    lines: usize,
    /// How many times as many a row of S is.
    groups: usize,
}

/// Rows of J that have the same columns: a row of S is then read once for all of them.
struct Block {
    count: usize,
    /// First group of each row.
    rows: [usize; TOGETHER],
    /// First entry of each row; the others stand behind it.
    entries: [usize; TOGETHER],
    /// Where its columns stand among those of all blocks.
    columns: Range<usize>,
}

impl Product {
    /// Of entries that stand row by row.
    pub fn new(pattern: &[(usize, usize)], states: usize, stride: usize) -> Self {
        let all = stride / PADDING;
        let lines = [4, 3, 2].into_iter().find(|n| all.is_multiple_of(*n));
        let lines = lines.unwrap_or(1);
        let groups = all / lines;
        let mut blocks: Vec<Block> = Vec::with_capacity(states);
        let mut columns = Vec::with_capacity(pattern.len());
        for row in 0..states {
            let first = pattern.partition_point(|(at, _)| *at < row);
            let own = pattern[first..].iter().take_while(|(at, _)| *at == row);
            let own = own.map(|(_, column)| column * groups);
            let alike = |block: &&mut Block| {
                let theirs: &[usize] = &columns[block.columns.clone()];
                block.count < TOGETHER && theirs.iter().copied().eq(own.clone())
            };
            if let Some(block) = blocks.iter_mut().find(alike) {
                block.rows[block.count] = row * groups;
                block.entries[block.count] = first;
                block.count += 1;
            } else {
                let begin = columns.len();
                columns.extend(own);
                blocks.push(Block {
                    count: 1,
                    rows: [row * groups; TOGETHER],
                    entries: [first; TOGETHER],
                    columns: begin..columns.len(),
                });
            }
        }
        blocks.sort_by_key(|block| block.columns.len());
        Product {
            blocks,
            columns,
            lines,
            groups,
        }
    }

    /// `ds = J s`, J of these entries.
    pub fn write(&self, values: &[f64], s: &[f64], ds: &mut [f64]) {
        match self.lines {
            4 => self.by::<4>(values, s, ds),
            3 => self.by::<3>(values, s, ds),
            2 => self.by::<2>(values, s, ds),
            _ => self.by::<1>(values, s, ds),
        }
    }

    fn by<const LINES: usize>(&self, values: &[f64], s: &[f64], ds: &mut [f64]) {
        lanes::dispatch(Sums::<LINES> {
            blocks: &self.blocks,
            columns: &self.columns,
            groups: self.groups,
            values,
            s: s.as_chunks().0.as_chunks().0,
            ds: ds.as_chunks_mut().0.as_chunks_mut().0,
        });
    }
}

/// Lines that are summed together.
type Group<const LINES: usize> = [[f64; PADDING]; LINES];

/// The sums of all blocks, which stay where they are summed.
struct Sums<'a, const LINES: usize> {
    blocks: &'a [Block],
    columns: &'a [usize],
    groups: usize,
    values: &'a [f64],
    s: &'a [Group<LINES>],
    ds: &'a mut [Group<LINES>],
}

impl<const LINES: usize> Sums<'_, LINES> {
    /// One group of each of the first `ROWS` rows of a block.
    #[inline(always)]
    fn sum<T: Lanes, const ROWS: usize>(&mut self, block: &Block, group: usize) {
        let columns = &self.columns[block.columns.clone()];
        let values: [&[f64]; ROWS] =
            std::array::from_fn(|row| &self.values[block.entries[row]..][..columns.len()]);
        for part in (0..PADDING).step_by(T::WIDTH) {
            let mut sums = [[T::splat(0.0); LINES]; ROWS];
            // By number: so the lengths, which are the same, are not looked at again.
            for entry in 0..columns.len() {
                let from = &self.s[columns[entry] + group];
                let from: [T; LINES] = std::array::from_fn(|line| T::load(&from[line][part..]));
                for row in 0..ROWS {
                    let value = T::splat(values[row][entry]);
                    for line in 0..LINES {
                        sums[row][line] = value.mul_add(from[line], sums[row][line]);
                    }
                }
            }
            for (row, sums) in block.rows.iter().zip(sums) {
                let to = &mut self.ds[row + group];
                for (to, sum) in to.iter_mut().zip(sums) {
                    sum.store(&mut to[part..]);
                }
            }
        }
    }
}

impl<const LINES: usize> Kernel for Sums<'_, LINES> {
    type Output = ();

    #[inline(always)]
    fn run<T: Lanes>(mut self) {
        const { assert!(PADDING.is_multiple_of(T::WIDTH)) };
        for group in 0..self.groups {
            for block in self.blocks {
                match block.count {
                    1 => self.sum::<T, 1>(block, group),
                    2 => self.sum::<T, 2>(block, group),
                    _ => self.sum::<T, TOGETHER>(block, group),
                }
            }
        }
    }
}
