//! Sums that several sums contain are computed once, whatever their sign.

use super::{Dag, Def, DefId, Signed};
use crate::graph::FastMap;

/// Two terms and whether their signs differ.
type Pair = (DefId, DefId, bool);

/// Takes common pairs of terms out of all sums.
pub fn share(dag: &mut Dag) {
    let uses = dag.uses();
    let mut holders: FastMap<Pair, Vec<DefId>> = FastMap::default();
    for id in 0..dag.defs.len() as DefId {
        if uses[id as usize] > 0 {
            register(dag, id, &mut holders);
        }
    }
    while let Some(pair) = best(dag, &holders) {
        let mut users = holders.remove(&pair).unwrap_or_default();
        users.sort_unstable();
        users.dedup();
        // the sum that is nothing but the pair is the one to share
        let whole = users
            .iter()
            .copied()
            .find(|&id| terms(dag, id).len() == 2 && sign(terms(dag, id), pair).is_some());
        let (flipped, shared) = match whole {
            Some(id) => (sign(terms(dag, id), pair) == Some(true), id),
            None => {
                let both = vec![(false, pair.0), (pair.2, pair.1)];
                let facts = dag.sum_facts(&both);
                (false, dag.define(Def::Sum(both), facts, None))
            }
        };
        for id in users {
            if id == shared {
                continue;
            }
            let Some(minus) = sign(terms(dag, id), pair) else {
                continue;
            };
            let Def::Sum(list) = &mut dag.defs[id as usize] else {
                continue;
            };
            list.retain(|&(_, term)| term != pair.0 && term != pair.1);
            list.push((minus != flipped, shared));
            list.sort_unstable_by_key(|&(minus, def)| (def, minus));
            register(dag, id, &mut holders);
        }
    }
    alias(dag);
}

fn terms(dag: &Dag, id: DefId) -> &[Signed] {
    match &dag.defs[id as usize] {
        Def::Sum(terms) => terms,
        _ => &[],
    }
}

fn register(dag: &Dag, id: DefId, holders: &mut FastMap<Pair, Vec<DefId>>) {
    let list = terms(dag, id);
    for a in 0..list.len() {
        for b in a + 1..list.len() {
            let pair = (list[a].1, list[b].1, list[a].0 != list[b].0);
            let users = holders.entry(pair).or_default();
            if users.last() != Some(&id) {
                users.push(id);
            }
        }
    }
}

/// Whether a sum holds the pair, and with which sign.
fn sign(list: &[Signed], pair: Pair) -> Option<bool> {
    let once = |wanted| {
        let mut found = list.iter().filter(|&&(_, id)| id == wanted);
        let first = found.next()?.0;
        found.next().is_none().then_some(first)
    };
    let (first, second) = (once(pair.0)?, once(pair.1)?);
    (pair.0 != pair.1 && (first != second) == pair.2).then_some(first)
}

fn best(dag: &Dag, holders: &FastMap<Pair, Vec<DefId>>) -> Option<Pair> {
    let mut best: Option<((usize, bool), Pair)> = None;
    for (&pair, users) in holders {
        if pair.0 == pair.1 || best.is_some_and(|(score, _)| users.len() < score.0) {
            continue;
        }
        let mut distinct = users.clone();
        distinct.sort_unstable();
        distinct.dedup();
        let places = distinct
            .iter()
            .filter(|&&id| sign(terms(dag, id), pair).is_some())
            .count();
        let whole = distinct
            .iter()
            .filter(|&&id| terms(dag, id).len() == 2 && sign(terms(dag, id), pair).is_some())
            .count();
        let fixed = dag.facts[pair.0 as usize].fixed && dag.facts[pair.1 as usize].fixed;
        let saved = if fixed {
            places - whole
        } else {
            places.saturating_sub(1)
        };
        if saved == 0 || whole == places && whole < 2 {
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

/// Sums that have become a single positive term are that term.
fn alias(dag: &mut Dag) {
    let mut target: Vec<DefId> = (0..dag.defs.len() as DefId).collect();
    let mut canonical: FastMap<Vec<Signed>, DefId> = FastMap::default();
    for (id, def) in dag.defs.iter().enumerate() {
        if let Def::Sum(list) = def {
            match list.as_slice() {
                [(false, single)] => target[id] = *single,
                _ => target[id] = *canonical.entry(list.clone()).or_insert(id as DefId),
            }
        }
    }
    dag.redirect(&target);
}
