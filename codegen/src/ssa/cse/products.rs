//! Common-subexpression elimination in products, by greedy extraction of pairs.

use super::{Replaced, Score, merge_equal, pairs_of};
use crate::ssa::{DefId, Ssa, SsaDef};

type Pair = (DefId, DefId);

pub fn share(ssa: &mut Ssa) {
    super::share(ssa, pairs, score, replace);
    merge_equal(ssa, factors, |factors| match factors {
        [single] => Some(*single),
        _ => None,
    });
}

fn replace(ssa: &mut Ssa, pair: Pair, mut users: Vec<DefId>) -> Replaced {
    users.retain(|&id| count(factors(ssa, id), pair) > 0);
    let shared = ssa.product(vec![pair.0, pair.1]);
    users.retain(|&id| id != shared);
    for &id in &users {
        let SsaDef::Product(list) = &mut ssa.defs[id] else {
            continue;
        };
        for _ in 0..count(list, pair) {
            for part in [pair.0, pair.1] {
                if let Some(at) = list.iter().position(|&f| f == part) {
                    list.remove(at);
                }
            }
            list.push(shared);
        }
        list.sort_unstable();
    }
    (shared, users)
}

fn factors(ssa: &Ssa, id: DefId) -> &[DefId] {
    match &ssa.defs[id] {
        SsaDef::Product(factors) => factors,
        _ => &[],
    }
}

fn pairs(ssa: &Ssa, id: DefId, with: Option<DefId>) -> Vec<Pair> {
    pairs_of(factors(ssa, id), with, |factor| factor).collect()
}

/// Number of disjoint occurrences of a pair in a list of factors.
fn count(list: &[DefId], pair: Pair) -> usize {
    let of = |id| list.iter().filter(|&&f| f == id).count();
    if pair.0 == pair.1 {
        of(pair.0) / 2
    } else {
        of(pair.0).min(of(pair.1))
    }
}

/// Multiplications saved by a shared pair: occurrences less 1, or of a fixed pair those in longer products.
fn score(ssa: &Ssa, pair: Pair, users: &[DefId]) -> Option<Score> {
    let (mut places, mut whole) = (0, 0);
    for &id in users {
        let list = factors(ssa, id);
        let times = count(list, pair);
        places += times;
        whole += usize::from(times == 1 && list.len() == 2);
    }
    let fixed = ssa.facts[pair.0].fixed && ssa.facts[pair.1].fixed;
    // a product equal to the pair needs no replacement
    let saved = if fixed {
        places - whole
    } else {
        places.saturating_sub(1)
    };
    (saved > 0 && places > whole).then_some((saved, fixed))
}
