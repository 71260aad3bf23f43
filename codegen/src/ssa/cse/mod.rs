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

/// Shares pairs of operands of the definitions in use, the pair with the highest score first. `pairs` lists those of a
/// definition, all or those with one operand.
fn share<P: Copy + Ord + Hash>(
    ssa: &mut Ssa,
    pairs: fn(&Ssa, DefId, Option<DefId>) -> Vec<P>,
    score: fn(&Ssa, P, &[DefId]) -> Option<Score>,
    replace: fn(&mut Ssa, P, Vec<DefId>) -> Replaced,
) {
    let uses = ssa.uses();
    let mut candidates = Candidates::new();
    let mut changed: Vec<DefId> = ssa.defs.indices().filter(|&id| uses[id] > 0).collect();
    let mut new = None;
    loop {
        for id in changed {
            for pair in pairs(ssa, id, new) {
                candidates.hold(pair, id);
            }
        }
        candidates.rate(|pair, users| score(ssa, pair, users));
        let Some((pair, users)) = candidates.next(|pair, users| score(ssa, pair, users)) else {
            return;
        };
        let (shared, users) = replace(ssa, pair, users);
        (new, changed) = (Some(shared), users);
    }
}

/// Pairs of the operands of a definition, in order: all, or those with the operand `with`.
fn pairs_of<T: Copy>(
    operands: &[T],
    with: Option<DefId>,
    id: impl Fn(T) -> DefId,
) -> impl Iterator<Item = (T, T)> {
    let is_wanted = move |operand: T| with.is_none_or(|with| id(operand) == with);
    operands.iter().enumerate().flat_map(move |(k, &a)| {
        let all = is_wanted(a);
        let rest = operands[k + 1..].iter().copied();
        let wanted: Vec<(T, T)> = rest
            .filter(|&b| all || is_wanted(b))
            .map(|b| (a, b))
            .collect();
        wanted
    })
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

/// What has been put in place of a pair, and the definitions in which it has been.
type Replaced = (DefId, Vec<DefId>);

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
    holders: FastMap<P, Holders>,
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
        let holders = self.holders.entry(pair).or_default();
        if holders.add(id) && !std::mem::replace(&mut holders.is_touched, true) {
            self.touched.push(pair);
        }
    }

    /// Scores the pairs recorded since the last call, and drops those without a score.
    fn rate(&mut self, score: impl Fn(P, &[DefId]) -> Option<Score>) {
        for pair in self.touched.drain(..) {
            let Some(holders) = self.holders.get_mut(&pair) else {
                continue;
            };
            holders.is_touched = false;
            if let Some(rated) = score(pair, holders.ids()) {
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
            match score(pair, users.ids()) {
                Some(now) if now == rated => {
                    let mut users = users.ids().to_vec();
                    self.holders.remove(&pair);
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

/// Definitions that contain a pair; most pairs are in one alone, which needs no list.
#[derive(Default)]
struct Holders {
    first: Option<DefId>,
    /// All of them, once there are two.
    all: Vec<DefId>,
    /// Whether they have changed since the pair was rated.
    is_touched: bool,
}

impl Holders {
    fn ids(&self) -> &[DefId] {
        if self.all.is_empty() {
            self.first.as_slice()
        } else {
            &self.all
        }
    }

    /// Adds a definition; whether it is new.
    fn add(&mut self, id: DefId) -> bool {
        if self.ids().contains(&id) {
            return false;
        }
        match self.first {
            None => self.first = Some(id),
            Some(first) => {
                if self.all.is_empty() {
                    self.all.push(first);
                }
                self.all.push(id);
            }
        }
        true
    }
}
