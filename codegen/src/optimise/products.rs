//! Products that several products contain are computed once: greedily, the most frequent pair first.

use super::greedy::{Candidates, Score};
use super::{Dag, Def, DefId};
use crate::graph::FastMap;

type Pair = (DefId, DefId);

/// Splits all products into pairs, sharing them.
pub fn share(dag: &mut Dag) {
    let uses = dag.uses();
    let mut candidates = Candidates::new();
    for id in 0..dag.defs.len() as DefId {
        if uses[id as usize] > 0 {
            register(dag, id, &mut candidates);
        }
    }
    candidates.rate(|pair, users| score(dag, pair, users));
    while let Some((pair, mut users)) = candidates.next(|pair, users| score(dag, pair, users)) {
        users.retain(|&id| count(factors(dag, id), pair) > 0);
        let shared = dag.product(vec![pair.0, pair.1]);
        for id in users {
            if id == shared {
                continue;
            }
            let Def::Product(list) = &mut dag.defs[id as usize] else {
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
            register(dag, id, &mut candidates);
        }
        candidates.rate(|pair, users| score(dag, pair, users));
    }
    alias(dag);
}

fn factors(dag: &Dag, id: DefId) -> &[DefId] {
    match &dag.defs[id as usize] {
        Def::Product(factors) => factors,
        _ => &[],
    }
}

fn register(dag: &Dag, id: DefId, candidates: &mut Candidates<Pair>) {
    let list = factors(dag, id);
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
fn score(dag: &Dag, pair: Pair, users: &[DefId]) -> Option<Score> {
    let (mut places, mut whole) = (0, 0);
    for &id in users {
        let list = factors(dag, id);
        let times = count(list, pair);
        places += times;
        whole += usize::from(times == 1 && list.len() == 2);
    }
    let fixed = dag.facts[pair.0 as usize].fixed && dag.facts[pair.1 as usize].fixed;
    // a product that is nothing but the pair is no place where it is to be replaced
    let saved = if fixed {
        places - whole
    } else {
        places.saturating_sub(1)
    };
    (saved > 0 && places > whole).then_some((saved, fixed))
}

/// Products that have become a single factor, or equal to each other, are one definition.
fn alias(dag: &mut Dag) {
    let mut canonical: FastMap<Vec<DefId>, DefId> = FastMap::default();
    let mut target: Vec<DefId> = (0..dag.defs.len() as DefId).collect();
    for (id, def) in dag.defs.iter().enumerate() {
        if let Def::Product(list) = def {
            match list.as_slice() {
                [single] => target[id] = *single,
                _ => target[id] = *canonical.entry(list.clone()).or_insert(id as DefId),
            }
        }
    }
    dag.redirect(&target);
}
