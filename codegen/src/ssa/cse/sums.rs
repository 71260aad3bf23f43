//! Common-subexpression elimination in sums: common pairs of terms are computed once, up to sign.

use super::candidates::{Candidates, Score};
use super::merge_equal;
use crate::ssa::{DefId, Signed, Ssa, SsaDef, sort_terms};

/// Two terms that occur in one sum, and whether their signs differ.
type Pair = (DefId, DefId, bool);

/// Extracts common pairs of terms from all sums into shared definitions.
pub fn share(ssa: &mut Ssa) {
    let uses = ssa.uses();
    let mut candidates = Candidates::new();
    for id in ssa.defs.indices() {
        if uses[id] > 0 {
            register(ssa, id, &mut candidates);
        }
    }
    candidates.rate(|pair, users| score(ssa, pair, users));
    while let Some((pair, users)) = candidates.next(|pair, users| score(ssa, pair, users)) {
        // share an existing sum equal to the pair
        let whole = users
            .iter()
            .copied()
            .find(|&id| terms(ssa, id).len() == 2 && sign(terms(ssa, id), pair).is_some());
        let (flipped, shared) = match whole {
            Some(id) => (sign(terms(ssa, id), pair) == Some(true), id),
            None => {
                let both = vec![(false, pair.0), (pair.2, pair.1)];
                let facts = ssa.sum_facts(&both);
                (false, ssa.define(SsaDef::Sum(both), facts, None))
            }
        };
        for id in users {
            if id == shared {
                continue;
            }
            let Some(minus) = sign(terms(ssa, id), pair) else {
                continue;
            };
            let SsaDef::Sum(list) = &mut ssa.defs[id] else {
                continue;
            };
            list.retain(|&(_, term)| term != pair.0 && term != pair.1);
            list.push((minus != flipped, shared));
            sort_terms(list);
            register(ssa, id, &mut candidates);
        }
        candidates.rate(|pair, users| score(ssa, pair, users));
    }
    merge_equal(ssa, terms, |terms| match terms {
        [(false, single)] => Some(*single),
        _ => None,
    });
}

fn terms(ssa: &Ssa, id: DefId) -> &[Signed] {
    match &ssa.defs[id] {
        SsaDef::Sum(terms) => terms,
        _ => &[],
    }
}

fn register(ssa: &Ssa, id: DefId, candidates: &mut Candidates<Pair>) {
    let list = terms(ssa, id);
    for a in 0..list.len() {
        for b in a + 1..list.len() {
            candidates.hold((list[a].1, list[b].1, list[a].0 != list[b].0), id);
        }
    }
}

/// Sign of the first term of a pair in a sum (`true` is minus); `None` if the sum does not contain the pair.
fn sign(list: &[Signed], pair: Pair) -> Option<bool> {
    let once = |wanted| {
        let mut found = list.iter().filter(|&&(_, id)| id == wanted);
        let first = found.next()?.0;
        found.next().is_none().then_some(first)
    };
    let (first, second) = (once(pair.0)?, once(pair.1)?);
    (pair.0 != pair.1 && (first != second) == pair.2).then_some(first)
}

/// Additions saved by a shared pair: occurrences less 1, or of a fixed pair those in longer sums.
fn score(ssa: &Ssa, pair: Pair, users: &[DefId]) -> Option<Score> {
    let holds = |id: DefId| sign(terms(ssa, id), pair).is_some();
    let places = users.iter().filter(|&&id| holds(id)).count();
    let whole = users
        .iter()
        .filter(|&&id| terms(ssa, id).len() == 2 && holds(id))
        .count();
    let fixed = ssa.facts[pair.0].fixed && ssa.facts[pair.1].fixed;
    let saved = if fixed {
        places - whole
    } else {
        places.saturating_sub(1)
    };
    (saved > 0 && (whole < places || whole > 1)).then_some((saved, fixed))
}
