//! Products of the whitened residuals' derivatives by many terms at once, as least squares needs them.
//!
//! A term changes the state by L(t) c(t), where L are the derivatives by the initial state and c is a sum of steps. What
//! follows a step is summed from the end of the flight first, so that each step is multiplied once by the sum and not by
//! each residual after it.

use nalgebra::{DMatrix, DVector};

use super::term_sums::{AddRow, OfTarget, Sample, Shape, Step, SumSegment, sum_backwards, zeros};
use super::weighted_rows::RowSum;
use crate::least_squares::{GramAccumulator, LANES, NormalBlock, TestedParameters};

/// Number of samples whose sums are kept.
const SEGMENT: usize = 64;

/// A term is the product of one of the targets, which have a vector of the local parameters at each sample, and one of
/// the functions of time. A residual depends on a term by u c(t₋) + a Δc: u are its whitened derivatives by the local
/// parameters, a those without the autocorrelation, c(t₋) is that of the sample before and Δc its last step.
pub(super) struct TermProducts {
    gram: GramAccumulator,
    shape: Shape,
    samples: Vec<Sample>,
    /// The last sample of the segment before.
    before: Option<Step>,
    targets: Vec<OfTarget>,
}

impl TermProducts {
    /// Creates the sums for a flight, by the numbers of its local and global parameters and of the targets and functions of
    /// the terms.
    pub fn new((locals, globals): (usize, usize), (targets, functions): (usize, usize)) -> Self {
        let all = locals + globals;
        let shape = Shape {
            locals,
            local_blocks: locals.div_ceil(LANES),
            blocks: GramAccumulator::width(all) / LANES,
            functions,
        };
        Self {
            gram: GramAccumulator::new((0..locals).collect(), (locals..all).collect()),
            shape,
            samples: Vec::with_capacity(SEGMENT),
            before: None,
            targets: (0..targets).map(|_| OfTarget::new(shape)).collect(),
        }
    }

    /// Begins the next sample, at `time`, s, where the targets add the columns of `added` to the rates of the local
    /// parameters, each times the `functions`.
    pub fn begin(&mut self, time: f64, added: &DMatrix<f64>, functions: impl Iterator<Item = f64>) {
        if self.samples.len() == SEGMENT {
            self.sum_segment();
        }
        let Shape {
            locals,
            local_blocks,
            blocks,
            ..
        } = self.shape;
        let mut padded = zeros(added.ncols() * local_blocks);
        for (to, from) in padded
            .chunks_exact_mut(local_blocks)
            .zip(added.column_iter())
        {
            to.as_flattened_mut()[..locals].copy_from_slice(from.as_slice());
        }
        self.samples.push(Sample {
            step: Step {
                time,
                added: padded,
                functions: functions.collect(),
            },
            whitened: zeros(locals * blocks),
            last: zeros(locals * blocks),
            squares: zeros(locals * local_blocks),
        });
    }

    /// Normal equations of the flight, and the products of the terms, target by target.
    pub fn finish(mut self) -> (NormalBlock, TestedParameters) {
        self.sum_segment();
        let Shape {
            locals, functions, ..
        } = self.shape;
        let block = self.gram.block();
        let globals = block.global.nrows();
        let terms = self.targets.len() * functions;
        let at = |row: usize, term: usize| {
            let of_target = &self.targets[term / functions].products;
            of_target[row / LANES * functions + term % functions][row % LANES]
        };
        let information = self.targets.iter().flat_map(|own| &own.information);
        let information: Vec<f64> = information.map(|lanes| lanes.iter().sum()).collect();
        let tested = TestedParameters {
            by_local: DMatrix::from_fn(locals, terms, at),
            by_global: DMatrix::from_fn(globals, terms, |i, k| at(locals + i, k)),
            score: DVector::from_fn(terms, |k, _| at(locals + globals, k)),
            information: information.into(),
        };
        (block, tested)
    }

    fn sum_segment(&mut self) {
        let mut samples = std::mem::take(&mut self.samples);
        let whole = sum_backwards(self.shape, &mut samples);
        for (index, target) in self.targets.iter_mut().enumerate() {
            lanes::dispatch(SumSegment {
                shape: self.shape,
                index,
                target,
                before: self.before.as_ref(),
                samples: &samples,
                whole: &whole,
            });
        }
        self.before = samples.pop().map(|last| last.step);
    }
}

impl RowSum for TermProducts {
    fn residual(&self) -> usize {
        self.gram.residual()
    }

    fn add(&mut self, row: &[f64], before: Option<(f64, &[f64])>, scale: f64, extra: f64) {
        let whitened = self.gram.add(row, before, scale, extra);
        if let Some(sample) = self.samples.last_mut() {
            lanes::dispatch(AddRow {
                shape: self.shape,
                row: row.as_chunks().0,
                weight: scale,
                whitened: whitened.as_chunks().0,
                sample,
            });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_are_those_of_a_column_for_each_term() {
        let (locals, globals, targets, functions, per_sample) = (3, 2, 2, 3, 2);
        let (samples, kept, scale) = (3 * SEGMENT / 2, 0.6, 2.0);
        let all = locals + globals;
        let value = |k: usize, i: usize| ((k * 31 + i * 17) as f64 * 0.37).sin();
        let mut products = TermProducts::new((locals, globals), (targets, functions));
        let terms = targets * functions;
        // The same with a column for each term, after those of the global parameters.
        let others = (locals..all + terms).collect();
        let mut whole = GramAccumulator::new((0..locals).collect(), others);
        let mut combination = DMatrix::zeros(locals, terms);
        let mut earlier: Option<(DMatrix<f64>, f64)> = None;
        let mut before = vec![None; per_sample];
        for sample in 0..samples {
            let time = 0.01 * sample as f64 + 0.002 * value(sample, 5);
            let added = DMatrix::from_fn(locals, targets, |i, k| value(sample, i + 5 * k));
            let weights: Vec<f64> = (0..functions).map(|f| value(sample, 40 + f)).collect();
            products.begin(time, &added, weights.iter().copied());
            let now = DMatrix::from_fn(locals, terms, |i, k| {
                added[(i, k / functions)] * weights[k % functions]
            });
            if let Some((last, at)) = &earlier {
                combination += (last + &now) * (0.5 * (time - at));
            }
            earlier = Some((now, time));
            for (channel, before) in before.iter_mut().enumerate() {
                let mut row = vec![0.0; GramAccumulator::width(all)];
                for (i, own) in row.iter_mut().enumerate().take(all + 1) {
                    *own = value(per_sample * sample + channel, 60 + i);
                }
                let by_local = DVector::from_row_slice(&row[..locals]);
                let mut with_terms = vec![0.0; GramAccumulator::width(all + terms)];
                with_terms[..all].copy_from_slice(&row[..all]);
                let by_terms = combination.tr_mul(&by_local);
                with_terms[all..all + terms].copy_from_slice(by_terms.as_slice());
                with_terms[all + terms] = row[all];
                let last = before.replace((row.clone(), with_terms.clone()));
                let last = last.as_ref();
                products.add(&row, last.map(|(row, _)| (kept, &row[..])), scale, 0.0);
                whole.add(
                    &with_terms,
                    last.map(|(_, row)| (kept, &row[..])),
                    scale,
                    0.0,
                );
            }
        }
        let ((block, found), expected) = (products.finish(), whole.block());
        let is_same = |one: f64, other: f64| (one - other).abs() < 1e-9 * (1.0 + other.abs());
        assert_eq!(block.count, expected.count);
        assert!((&block.local - &expected.local).amax() < 1e-9);
        for k in 0..terms {
            let at = globals + k;
            assert!(is_same(found.score[k], expected.global_gradient[at]));
            assert!(
                is_same(found.information[k], expected.global[(at, at)]),
                "{k}"
            );
            for i in 0..locals {
                assert!(is_same(found.by_local[(i, k)], expected.cross[(i, at)]));
            }
            for i in 0..globals {
                assert!(is_same(found.by_global[(i, k)], expected.global[(i, at)]));
            }
        }
    }
}
