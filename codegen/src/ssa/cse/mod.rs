//! Common-subexpression elimination: shares pairs of factors and pairs of terms that several definitions contain.

mod products;
mod sums;

use super::{DefId, Ssa};
use crate::graph::FastMap;
use model_spec::index::IndexVec;
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::hash::Hash;

pub(super) use products::share as share_products;
pub(super) use sums::share as share_sums;

/// Shares pairs of operands of the definitions in use, the pair with the highest score first; `replace` returns the
/// definitions that it has changed.
fn share<P: Copy + Ord + Hash>(
    ssa: &mut Ssa,
    pairs: fn(&Ssa, DefId) -> Vec<P>,
    score: fn(&Ssa, P, &[DefId]) -> Option<Score>,
    replace: fn(&mut Ssa, P, Vec<DefId>) -> Vec<DefId>,
) {
    let uses = ssa.uses();
    let mut candidates = Candidates::new();
    let mut changed: Vec<DefId> = ssa.defs.indices().filter(|&id| uses[id] > 0).collect();
    loop {
        for id in changed {
            for pair in pairs(ssa, id) {
                candidates.hold(pair, id);
            }
        }
        candidates.rate(|pair, users| score(ssa, pair, users));
        let Some((pair, users)) = candidates.next(|pair, users| score(ssa, pair, users)) else {
            return;
        };
        changed = replace(ssa, pair, users);
    }
}

/// Merges definitions with equal `parts`, and replaces those with a `single` part by that part.
fn merge_equal<P: Eq + Hash>(
    ssa: &mut Ssa,
    parts: impl Fn(&Ssa, DefId) -> &[P],
    single: impl Fn(&[P]) -> Option<DefId>,
) {
    let mut canonical: FastMap<&[P], DefId> = FastMap::default();
    let mut target: IndexVec<DefId, DefId> = ssa.defs.indices().collect();
    for id in ssa.defs.indices() {
        let parts = parts(ssa, id);
        if !parts.is_empty() {
            target[id] = single(parts).unwrap_or_else(|| *canonical.entry(parts).or_insert(id));
        }
    }
    ssa.redirect(&target);
}

/// Operations saved by sharing a pair, and whether it depends on parameters only.
type Score = (usize, bool);

/// Candidate pairs of operands, with the definitions that contain each pair and the number of operations saved by
/// computing the pair once.
///
/// A stored score may be outdated but is never too low; [`next`](Self::next) recomputes it before it returns the pair.
/// Pairs with equal scores are sorted by their operands, so that the result does not depend on the iteration order of a
/// hash map.
struct Candidates<P> {
    heap: BinaryHeap<(Score, Reverse<P>)>,
    holders: FastMap<P, Vec<DefId>>,
    touched: Vec<P>,
}

impl<P: Copy + Ord + Hash> Candidates<P> {
    fn new() -> Candidates<P> {
        Candidates {
            heap: BinaryHeap::new(),
            holders: FastMap::default(),
            touched: Vec::new(),
        }
    }

    fn hold(&mut self, pair: P, id: DefId) {
        let users = self.holders.entry(pair).or_default();
        if !users.contains(&id) {
            users.push(id);
            self.touched.push(pair);
        }
    }

    /// Scores the pairs recorded since the last call, and drops those without a score.
    fn rate(&mut self, score: impl Fn(P, &[DefId]) -> Option<Score>) {
        self.touched.sort_unstable();
        self.touched.dedup();
        for pair in std::mem::take(&mut self.touched) {
            if let Some(rated) = score(pair, &self.holders[&pair]) {
                self.heap.push((rated, Reverse(pair)));
            }
        }
    }

    /// Removes the pair with the highest score; returns it with its sorted users.
    fn next(&mut self, score: impl Fn(P, &[DefId]) -> Option<Score>) -> Option<(P, Vec<DefId>)> {
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
