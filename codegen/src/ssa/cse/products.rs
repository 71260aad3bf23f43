//! Products that several products contain are computed once: greedily, the most frequent pair first.

use super::candidates::{Candidates, Score};
use crate::graph::FastMap;
use crate::ssa::{DefId, Ssa, SsaDef};
use model_spec::index::IndexVec;

type Pair = (DefId, DefId);

/// Splits all products into pairs, sharing them.
pub fn share(ssa: &mut Ssa) {
    let uses = ssa.uses();
    let mut candidates = Candidates::new();
    for id in ssa.defs.indices() {
        if uses[id] > 0 {
            register(ssa, id, &mut candidates);
        }
    }
    candidates.rate(|pair, users| score(ssa, pair, users));
    while let Some((pair, mut users)) = candidates.next(|pair, users| score(ssa, pair, users)) {
        users.retain(|&id| count(factors(ssa, id), pair) > 0);
        let shared = ssa.product(vec![pair.0, pair.1]);
        for id in users {
            if id == shared {
                continue;
            }
            let SsaDef::Product(list) = &mut ssa.defs[id] else {
                continue;
            };
            let times = count(list, pair);
            for _ in 0..times {
                for part in [pair.0, pair.1] {
                    if let Some(at) = list.iter().position(|&f| f == part) {
                        list.remove(at);
                    }
                }
                list.push(shared);
            }
            list.sort_unstable();
            register(ssa, id, &mut candidates);
        }
        candidates.rate(|pair, users| score(ssa, pair, users));
    }
    alias(ssa);
}

fn factors(ssa: &Ssa, id: DefId) -> &[DefId] {
    match &ssa.defs[id] {
        SsaDef::Product(factors) => factors,
        _ => &[],
    }
}

fn register(ssa: &Ssa, id: DefId, candidates: &mut Candidates<Pair>) {
    let list = factors(ssa, id);
    for a in 0..list.len() {
        for b in a + 1..list.len() {
            candidates.hold((list[a], list[b]), id);
        }
    }
}

/// How often a pair can be taken from a list of factors.
fn count(list: &[DefId], pair: Pair) -> usize {
    let of = |id| list.iter().filter(|&&f| f == id).count();
    if pair.0 == pair.1 {
        of(pair.0) / 2
    } else {
        of(pair.0).min(of(pair.1))
    }
}

/// What a pair saves: one multiplication at each place but one, at every place where it depends on
/// parameters alone.
fn score(ssa: &Ssa, pair: Pair, users: &[DefId]) -> Option<Score> {
    let (mut places, mut whole) = (0, 0);
    for &id in users {
        let list = factors(ssa, id);
        let times = count(list, pair);
        places += times;
        whole += usize::from(times == 1 && list.len() == 2);
    }
    let fixed = ssa.facts[pair.0].fixed && ssa.facts[pair.1].fixed;
    // a product that is nothing but the pair is no place where it is to be replaced
    let saved = if fixed {
        places - whole
    } else {
        places.saturating_sub(1)
    };
    (saved > 0 && places > whole).then_some((saved, fixed))
}

/// Products that have become a single factor, or equal to each other, are one definition.
fn alias(ssa: &mut Ssa) {
    let mut canonical: FastMap<Vec<DefId>, DefId> = FastMap::default();
    let mut target: IndexVec<DefId, DefId> = ssa.defs.indices().collect();
    for (id, def) in ssa.defs.iter_enumerated() {
        if let SsaDef::Product(list) = def {
            match list.as_slice() {
                [single] => target[id] = *single,
                _ => target[id] = *canonical.entry(list.clone()).or_insert(id),
            }
        }
    }
    ssa.redirect(&target);
}
