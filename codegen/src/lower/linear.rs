//! Symbolic elimination of linear systems.
//!
//! Pivots are chosen in this order: the only entry of a row or column; entries that parameters alone determine and that
//! cannot vanish but by a parameter, such as masses, with the fewest new entries; of the rest, up to three unknowns by
//! Cramer's rule, which divides by the determinant alone. Of more, the pivots are those that are large, for their row, at
//! [typical points](super::typical), and keep their sign; where no entry does, the row is chosen at run time. What pivots
//! lose to cancellation is the determinacy.

use super::solve::{cramer, determinant};
use super::typical::{self, Typical};
use crate::functions::{BinaryFunction, MathFunction};
use crate::graph::{ExprGraph, Node, NodeId, Symbol};
use crate::number::Number;

/// Largest remainder that is solved by Cramer's rule.
const CRAMER: usize = 3;

/// Least size of a pivot relative to the best one at typical points, where it makes fewer new entries.
const THRESHOLD: f64 = 0.1;

/// Solution of a linear system.
pub(crate) struct Solution {
    /// Values of the unknowns; 0 where the system is singular.
    pub unknowns: Vec<NodeId>,
    /// Least, over the steps, of the size of a pivot or determinant over the sum of the sizes of its terms.
    pub determinacy: NodeId,
}

/// Solves a square system.
pub(crate) fn solve(
    graph: &mut ExprGraph,
    matrix: Vec<Vec<NodeId>>,
    right: Vec<NodeId>,
    points: &[Typical],
) -> Solution {
    let sizes = { matrix.iter() }
        .map(|row| row.iter().map(|&a| size(graph, a)).collect())
        .collect();
    let entries: Vec<NodeId> = matrix.concat();
    let (one, count) = (graph.whole(1), right.len());
    let numbers = { points.iter() }
        .map(|point| point.values(graph, &entries))
        .map(|values| values.chunks(count.max(1)).map(<[f64]>::to_vec).collect())
        .collect();
    let mut elimination = Elimination {
        graph,
        matrix,
        sizes,
        numbers,
        right,
        rows: (0..count).collect(),
        columns: (0..count).collect(),
        steps: Vec::new(),
        determinacy: one,
    };
    while let Some((row, column)) = elimination.sure_pivot() {
        elimination.eliminate(row, column);
    }
    let mut found = vec![None; count];
    if elimination.columns.len() <= CRAMER {
        elimination.cramer(&mut found);
    } else {
        while let Some((row, column)) = elimination.large_pivot() {
            if !elimination.keeps_sign(row, column) {
                elimination.choose_row(row, column);
            }
            elimination.eliminate(row, column);
        }
    }
    elimination.substitute(found)
}

struct Elimination<'g> {
    graph: &'g mut ExprGraph,
    matrix: Vec<Vec<NodeId>>,
    /// Sums of the sizes of the terms of each entry.
    sizes: Vec<Vec<NodeId>>,
    /// Values of the entries at each typical point, and at each point far from it.
    numbers: Vec<Vec<Vec<f64>>>,
    right: Vec<NodeId>,
    /// Rows and columns that are not eliminated yet.
    rows: Vec<usize>,
    columns: Vec<usize>,
    /// Row and column of each pivot, in order.
    steps: Vec<(usize, usize)>,
    determinacy: NodeId,
}

impl Elimination<'_> {
    fn is_entry(&self, row: usize, column: usize) -> bool {
        !self.graph.is_zero(self.matrix[row][column])
    }

    fn entries_of_row(&self, row: usize) -> usize {
        let columns = self.columns.iter();
        columns.filter(|&&c| self.is_entry(row, c)).count()
    }

    fn entries_of_column(&self, column: usize) -> usize {
        let rows = self.rows.iter();
        rows.filter(|&&r| self.is_entry(r, column)).count()
    }

    /// A pivot that needs no comparison at run time; `None` if there is none.
    fn sure_pivot(&self) -> Option<(usize, usize)> {
        let mut best: Option<(usize, (usize, usize))> = None;
        for &row in &self.rows {
            for &column in self.columns.iter().filter(|&&c| self.is_entry(row, c)) {
                let others = (self.entries_of_row(row) - 1) * (self.entries_of_column(column) - 1);
                let is_sure = others == 0 || is_constant(self.graph, self.matrix[row][column]);
                if is_sure && best.is_none_or(|(fewest, _)| others < fewest) {
                    best = Some((others, (row, column)));
                }
            }
        }
        best.map(|(_, place)| place)
    }

    /// A pivot that is large at typical points, with few new entries.
    fn large_pivot(&self) -> Option<(usize, usize)> {
        let mut found: Vec<(f64, usize, (usize, usize))> = Vec::new();
        for &row in &self.rows {
            for &column in self.columns.iter().filter(|&&c| self.is_entry(row, c)) {
                let typical = &self.numbers[..typical::POINTS];
                let mut shares: Vec<f64> = { typical.iter() }
                    .map(|numbers| {
                        let entries = self.columns.iter().map(|&c| numbers[row][c].abs());
                        numbers[row][column].abs() / entries.fold(0.0, f64::max)
                    })
                    .collect();
                shares.sort_by(f64::total_cmp);
                // One point may be a singular one.
                let share = shares.get(1).copied().filter(|share| !share.is_nan());
                let others = (self.entries_of_row(row) - 1) * (self.entries_of_column(column) - 1);
                found.push((share.unwrap_or(0.0), others, (row, column)));
            }
        }
        let best = found.iter().map(|own| own.0).fold(0.0, f64::max);
        let large = found.iter().filter(|own| own.0 >= THRESHOLD * best);
        let first = large
            .min_by_key(|&&(_, others, (row, column))| (!self.keeps_sign(row, column), others));
        first.map(|own| own.2)
    }

    /// Whether an entry has the same sign at all points; between two signs it vanishes.
    fn keeps_sign(&self, row: usize, column: usize) -> bool {
        let values = self.numbers.iter().map(|numbers| numbers[row][column]);
        let mut values = values.filter(|value| !value.is_nan());
        values.clone().all(|value| value > 0.0) || values.all(|value| value < 0.0)
    }

    /// Exchanges a row, where the column is small in it, with the one in which it is largest, relative to what rows
    /// usually contain.
    fn choose_row(&mut self, row: usize, column: usize) {
        let others = self.rows.iter().copied();
        let others = others.filter(|&other| other != row && self.is_entry(other, column));
        for other in others.collect::<Vec<_>>() {
            let [own, theirs] = [row, other].map(|r| {
                let entry = size(self.graph, self.matrix[r][column]);
                let weight = self.graph.number(Number::literal(self.weight(r), None));
                self.graph.mul(weight, entry)
            });
            let (less, zero) = (self.graph.sub(theirs, own), self.graph.whole(0));
            let is_larger = self.graph.call2(BinaryFunction::Max, less, zero);
            let mut exchange = |a: &mut NodeId, b: &mut NodeId| {
                let (above, below) = (*a, *b);
                *a = self.graph.if_zero(is_larger, above, below);
                *b = self.graph.if_zero(is_larger, below, above);
            };
            let [upper, lower] = self
                .matrix
                .get_disjoint_mut([row, other])
                .expect("two rows");
            let [larger, smaller] = self.sizes.get_disjoint_mut([row, other]).expect("two rows");
            for &c in &self.columns {
                exchange(&mut upper[c], &mut lower[c]);
                exchange(&mut larger[c], &mut smaller[c]);
            }
            let [above, below] = self.right.get_disjoint_mut([row, other]).expect("two rows");
            exchange(above, below);
            let [own, theirs] = [row, other].map(|r| self.weight(r));
            for numbers in &mut self.numbers {
                if theirs * numbers[other][column].abs() > own * numbers[row][column].abs() {
                    numbers.swap(row, other);
                }
            }
        }
    }

    /// Power of two near the inverse of the usual size of a row's entries.
    fn weight(&self, row: usize) -> f64 {
        let greatest = { self.numbers.iter() }.map(|numbers| {
            let entries = self.columns.iter().map(|&c| numbers[row][c].abs());
            entries.fold(0.0, f64::max)
        });
        let mut greatest: Vec<f64> = greatest.filter(|size| *size > 0.0).collect();
        greatest.sort_by(f64::total_cmp);
        let usual = greatest.get(greatest.len() / 2).copied().unwrap_or(1.0);
        (-usual.log2()).round().clamp(-60.0, 60.0).exp2()
    }

    /// Takes the entry as pivot, and subtracts its row from the others.
    fn eliminate(&mut self, row: usize, column: usize) {
        self.rows.retain(|&r| r != row);
        self.columns.retain(|&c| c != column);
        let (pivot, terms) = (self.matrix[row][column], self.sizes[row][column]);
        if is_constant(self.graph, pivot) {
            self.graph.assume_nonzero(pivot);
        } else {
            self.judge(pivot, terms);
        }
        for other in self.rows.clone() {
            if !self.is_entry(other, column) {
                continue;
            }
            let factor = self.graph.div(self.matrix[other][column], pivot);
            let factor_size = size(self.graph, factor);
            for c in self.columns.clone() {
                let less = self.graph.mul(factor, self.matrix[row][c]);
                let entry = self.graph.sub(self.matrix[other][c], less);
                let more = self.graph.mul(factor_size, self.sizes[row][c]);
                self.matrix[other][c] = entry;
                self.sizes[other][c] = match self.graph.is_zero(entry) {
                    true => entry,
                    false => self.graph.add(self.sizes[other][c], more),
                };
            }
            let less = self.graph.mul(factor, self.right[row]);
            self.right[other] = self.graph.sub(self.right[other], less);
            for numbers in &mut self.numbers {
                let factor = numbers[other][column] / numbers[row][column];
                for &c in &self.columns {
                    numbers[other][c] -= factor * numbers[row][c];
                }
            }
        }
        self.steps.push((row, column));
    }

    /// Counts a pivot or determinant, with the sum of the sizes of its terms, towards the determinacy.
    fn judge(&mut self, pivot: NodeId, terms: NodeId) {
        let pivot = size(self.graph, pivot);
        let share = self.graph.div(pivot, terms);
        let least = BinaryFunction::Min;
        self.determinacy = match self.graph.is_one(self.determinacy) {
            true => share,
            false => self.graph.call2(least, self.determinacy, share),
        };
    }

    /// Solves the rest by Cramer's rule.
    fn cramer(&mut self, found: &mut [Option<NodeId>]) {
        if self.columns.is_empty() {
            return;
        }
        let part = |of: &[Vec<NodeId>]| -> Vec<Vec<NodeId>> {
            let row = |&r: &usize| self.columns.iter().map(|&c| of[r][c]).collect();
            self.rows.iter().map(row).collect()
        };
        let (system, sizes) = (part(&self.matrix), part(&self.sizes));
        let whole = determinant(self.graph, &system);
        let terms = permanent(self.graph, &sizes);
        self.judge(whole, terms);
        let right: Vec<NodeId> = self.rows.iter().map(|&row| self.right[row]).collect();
        let unknowns = cramer(self.graph, &system, &right, whole);
        for (&column, unknown) in self.columns.iter().zip(unknowns) {
            found[column] = Some(unknown);
        }
    }

    /// Values of all unknowns, the last pivot's first.
    fn substitute(mut self, mut found: Vec<Option<NodeId>>) -> Solution {
        let zero = self.graph.whole(0);
        for (row, column) in std::mem::take(&mut self.steps).into_iter().rev() {
            let mut rest = self.right[row];
            for (c, value) in found.iter().enumerate() {
                if let Some(value) = value {
                    let less = self.graph.mul(self.matrix[row][c], *value);
                    rest = self.graph.sub(rest, less);
                }
            }
            found[column] = Some(self.graph.div(rest, self.matrix[row][column]));
        }
        Solution {
            determinacy: match found.contains(&None) {
                true => zero,
                false => self.determinacy,
            },
            unknowns: found.into_iter().map(|own| own.unwrap_or(zero)).collect(),
        }
    }
}

fn size(graph: &mut ExprGraph, node: NodeId) -> NodeId {
    graph.call(MathFunction::Abs, node)
}

/// Sum of the products of a square matrix of sizes over all permutations.
fn permanent(graph: &mut ExprGraph, m: &[Vec<NodeId>]) -> NodeId {
    if m.len() == 1 {
        return m[0][0];
    }
    let terms = (0..m.len()).map(|k| {
        let without = |row: &Vec<NodeId>| [&row[..k], &row[k + 1..]].concat();
        let minor: Vec<Vec<NodeId>> = m[1..].iter().map(without).collect();
        let inner = permanent(graph, &minor);
        (Number::ONE, graph.mul(inner, m[0][k]))
    });
    let terms = terms.collect();
    graph.sum(terms, Number::ZERO)
}

/// Whether a value is made of parameters that are constant during a flight, and vanishes only where one of them does.
fn is_constant(graph: &ExprGraph, node: NodeId) -> bool {
    let facts = graph.facts(node);
    if !facts.fixed {
        return false;
    }
    facts.nonzero
        || match graph.node(node) {
            Node::Symbol(symbol) => matches!(symbol, Symbol::Parameter(_)),
            Node::Product(factors) => factors.iter().all(|&(own, _)| is_constant(graph, own)),
            Node::Sum(terms, constant) => {
                let signs = { terms.iter() }.map(|(factor, _)| factor.is_negative());
                let all: Vec<bool> = match constant.is_zero() {
                    true => signs.collect(),
                    false => signs.chain([constant.is_negative()]).collect(),
                };
                all.windows(2).all(|pair| pair[0] == pair[1])
                    && terms.iter().all(|&(_, own)| is_constant(graph, own))
            }
            _ => false,
        }
}
