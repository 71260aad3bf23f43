//! Sums that several sums contain are computed once, whatever their sign.

use super::greedy::{Candidates, Score};
use super::{Dag, Def, DefId, Signed};
use crate::graph::FastMap;

/// Two terms and whether their signs differ.
type Pair = (DefId, DefId, bool);

/// Takes common pairs of terms out of all sums.
pub fn share(dag: &mut Dag) {
    let uses = dag.uses();
    let mut candidates = Candidates::new();
    for id in 0..dag.defs.len() as DefId {
        if uses[id as usize] > 0 {
            register(dag, id, &mut candidates);
        }
    }
    candidates.rate(|pair, users| score(dag, pair, users));
    while let Some((pair, users)) = candidates.next(|pair, users| score(dag, pair, users)) {
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
            register(dag, id, &mut candidates);
        }
        candidates.rate(|pair, users| score(dag, pair, users));
    }
    alias(dag);
}

fn terms(dag: &Dag, id: DefId) -> &[Signed] {
    match &dag.defs[id as usize] {
        Def::Sum(terms) => terms,
        _ => &[],
    }
}

fn register(dag: &Dag, id: DefId, candidates: &mut Candidates<Pair>) {
    let list = terms(dag, id);
    for a in 0..list.len() {
        for b in a + 1..list.len() {
            candidates.hold((list[a].1, list[b].1, list[a].0 != list[b].0), id);
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

/// What a pair saves: one addition at each place but one, at every place where it depends on parameters
/// alone.
fn score(dag: &Dag, pair: Pair, users: &[DefId]) -> Option<Score> {
    let holds = |id: DefId| sign(terms(dag, id), pair).is_some();
    let places = users.iter().filter(|&&id| holds(id)).count();
    let whole = users
        .iter()
        .filter(|&&id| terms(dag, id).len() == 2 && holds(id))
        .count();
    let fixed = dag.facts[pair.0 as usize].fixed && dag.facts[pair.1 as usize].fixed;
    let saved = if fixed {
        places - whole
    } else {
        places.saturating_sub(1)
    };
    (saved > 0 && (whole < places || whole > 1)).then_some((saved, fixed))
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
