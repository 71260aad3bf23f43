//! Products that several products contain are computed once: greedily, the most frequent pair first.

use super::{Dag, Def, DefId};
use crate::graph::FastMap;

type Pair = (DefId, DefId);

/// Splits all products into pairs, sharing them.
pub fn share(dag: &mut Dag) {
    let uses = dag.uses();
    let mut holders: FastMap<Pair, Vec<DefId>> = FastMap::default();
    let products: Vec<DefId> = (0..dag.defs.len() as DefId)
        .filter(|&id| uses[id as usize] > 0 && matches!(dag.defs[id as usize], Def::Product(_)))
        .collect();
    for &id in &products {
        register(dag, id, &mut holders);
    }
    while let Some(pair) = best(dag, &holders) {
        let mut users = holders.remove(&pair).unwrap_or_default();
        users.sort_unstable();
        users.dedup();
        users.retain(|&id| count(factors(dag, id), pair) > 0);
        let known = dag.defs.len();
        let shared = dag.product(vec![pair.0, pair.1]);
        if shared as usize == known {
            register(dag, shared, &mut FastMap::default());
        }
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
            register(dag, id, &mut holders);
        }
    }
    alias(dag);
}

fn factors(dag: &Dag, id: DefId) -> &[DefId] {
    match &dag.defs[id as usize] {
        Def::Product(factors) => factors,
        _ => &[],
    }
}

fn register(dag: &Dag, id: DefId, holders: &mut FastMap<Pair, Vec<DefId>>) {
    let list = factors(dag, id);
    for a in 0..list.len() {
        for b in a + 1..list.len() {
            let users = holders.entry((list[a], list[b])).or_default();
            if users.last() != Some(&id) {
                users.push(id);
            }
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

/// The pair that saves most: one multiplication at each place but one, at every place where it depends
/// on parameters alone.
fn best(dag: &Dag, holders: &FastMap<Pair, Vec<DefId>>) -> Option<Pair> {
    let mut best: Option<((usize, bool), Pair)> = None;
    for (&pair, users) in holders {
        let bound = users.len() * 4;
        if best.is_some_and(|(score, _)| bound < score.0) {
            continue;
        }
        let mut distinct = users.clone();
        distinct.sort_unstable();
        distinct.dedup();
        let (mut places, mut whole) = (0, 0);
        for &id in &distinct {
            let list = factors(dag, id);
            let times = count(list, pair);
            places += times;
            whole += usize::from(times == 1 && list.len() == 2);
        }
        let fixed = dag.facts[pair.0 as usize].fixed && dag.facts[pair.1 as usize].fixed;
        // a product that is nothing but the pair is no place where it is to be replaced
        let saved = if fixed {
            places - whole.min(places)
        } else {
            places.saturating_sub(1)
        };
        if saved == 0 || places == whole {
            continue;
        }
        let score = (saved, fixed);
        let better = match best {
            None => true,
            Some((known, chosen)) => score > known || score == known && pair < chosen,
        };
        if better {
            best = Some((score, pair));
        }
    }
    best.map(|(_, pair)| pair)
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
