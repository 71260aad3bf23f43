//! Priority queue of pairs of operands for greedy common-subexpression elimination; scores are updated lazily.

use crate::graph::FastMap;
use crate::ssa::DefId;
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::hash::Hash;

/// Operations saved by sharing a pair, and whether it depends on parameters only.
pub type Score = (usize, bool);

/// Candidate pairs of operands, with the definitions that contain each pair and the number of operations saved by
/// computing the pair once.
///
/// A stored score may be outdated but is never too low; [`next`](Self::next) recomputes it before it returns the pair.
/// Pairs with equal scores are sorted by their operands, so that the result does not depend on the iteration order of a
/// hash map.
#[derive(Debug)]
pub struct Candidates<P> {
    heap: BinaryHeap<(Score, Reverse<P>)>,
    holders: FastMap<P, Vec<DefId>>,
    touched: Vec<P>,
}

impl<P: Copy + Ord + Hash> Candidates<P> {
    /// Creates an empty set of candidates.
    pub fn new() -> Candidates<P> {
        Candidates {
            heap: BinaryHeap::new(),
            holders: FastMap::default(),
            touched: Vec::new(),
        }
    }

    /// Records that the SSA definition `id` contains the pair of operands `pair`.
    pub fn hold(&mut self, pair: P, id: DefId) {
        let users = self.holders.entry(pair).or_default();
        if !users.contains(&id) {
            users.push(id);
            self.touched.push(pair);
        }
    }

    /// Scores the pairs recorded since the last call, and drops those without a score.
    pub fn rate(&mut self, score: impl Fn(P, &[DefId]) -> Option<Score>) {
        self.touched.sort_unstable();
        self.touched.dedup();
        for pair in std::mem::take(&mut self.touched) {
            if let Some(rated) = score(pair, &self.holders[&pair]) {
                self.heap.push((rated, Reverse(pair)));
            }
        }
    }

    /// Removes the pair with the highest score; returns it with its sorted users.
    pub fn next(
        &mut self,
        score: impl Fn(P, &[DefId]) -> Option<Score>,
    ) -> Option<(P, Vec<DefId>)> {
        while let Some((rated, Reverse(pair))) = self.heap.pop() {
            let Some(users) = self.holders.get(&pair) else {
                continue;
            };
            match score(pair, users) {
                Some(now) if now == rated => {
                    let mut users = self.holders.remove(&pair)?;
                    users.sort_unstable();
                    return Some((pair, users));
                }
                Some(now) => self.heap.push((now, Reverse(pair))),
                None => {}
            }
        }
        None
    }
}
