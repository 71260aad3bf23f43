//! The best pair first, again and again, without looking at every pair each time.

use crate::graph::FastMap;
use crate::ssa::DefId;
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::hash::Hash;

/// Operations saved, and whether the pair depends on parameters alone.
pub type Score = (usize, bool);

/// Pairs, who holds them, and what taking them out would save.
///
/// A score in the heap may be out of date but never too low: it is looked at again when it comes up.
/// Where scores are equal the smaller pair wins, so that the order never depends on a map's.
#[derive(Debug)]
pub struct Candidates<P> {
    heap: BinaryHeap<(Score, Reverse<P>)>,
    holders: FastMap<P, Vec<DefId>>,
    touched: Vec<P>,
}

impl<P: Copy + Ord + Hash> Candidates<P> {
    /// None yet.
    pub fn new() -> Candidates<P> {
        Candidates {
            heap: BinaryHeap::new(),
            holders: FastMap::default(),
            touched: Vec::new(),
        }
    }

    /// A definition holds a pair.
    pub fn hold(&mut self, pair: P, id: DefId) {
        let users = self.holders.entry(pair).or_default();
        if !users.contains(&id) {
            users.push(id);
            self.touched.push(pair);
        }
    }

    /// Rates the pairs that got a new holder.
    pub fn rate(&mut self, score: impl Fn(P, &[DefId]) -> Option<Score>) {
        self.touched.sort_unstable();
        self.touched.dedup();
        for pair in std::mem::take(&mut self.touched) {
            if let Some(rated) = score(pair, &self.holders[&pair]) {
                self.heap.push((rated, Reverse(pair)));
            }
        }
    }

    /// The best pair and its holders, in order.
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
