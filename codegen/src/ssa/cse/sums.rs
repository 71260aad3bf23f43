//! Common-subexpression elimination in sums: common pairs of terms are computed once, up to sign.

use super::{Score, merge_equal};
use crate::ssa::{DefId, Signed, Ssa, SsaDef, sort_terms};

/// Two terms that occur in one sum, and whether their signs differ.
type Pair = (DefId, DefId, bool);

/// Extracts common pairs of terms from all sums into shared definitions.
pub fn share(ssa: &mut Ssa) {
    super::share(ssa, pairs, score, replace);
    merge_equal(ssa, terms, |terms| match terms {
        [(false, single)] => Some(*single),
        _ => None,
    });
}

fn replace(ssa: &mut Ssa, pair: Pair, mut users: Vec<DefId>) -> Vec<DefId> {
    // share an existing sum equal to the pair
    let mut all = users.iter().copied();
    let whole = all.find(|&id| terms(ssa, id).len() == 2 && sign(terms(ssa, id), pair).is_some());
    let (flipped, shared) = match whole {
        Some(id) => (sign(terms(ssa, id), pair) == Some(true), id),
        None => {
            let both = vec![(false, pair.0), (pair.2, pair.1)];
            let facts = ssa.sum_facts(&both);
            (false, ssa.define(SsaDef::Sum(both), facts, None))
        }
    };
    users.retain(|&id| id != shared && sign(terms(ssa, id), pair).is_some());
    for &id in &users {
        let minus = sign(terms(ssa, id), pair) == Some(true);
        if let SsaDef::Sum(list) = &mut ssa.defs[id] {
            list.retain(|&(_, term)| term != pair.0 && term != pair.1);
            list.push((minus != flipped, shared));
            sort_terms(list);
        }
    }
    users
}

fn terms(ssa: &Ssa, id: DefId) -> &[Signed] {
    match &ssa.defs[id] {
        SsaDef::Sum(terms) => terms,
        _ => &[],
    }
}

fn pairs(ssa: &Ssa, id: DefId) -> Vec<Pair> {
    let list = terms(ssa, id).iter().enumerate();
    let pairs = list.flat_map(|(k, &(minus, a))| {
        let rest = &terms(ssa, id)[k + 1..];
        rest.iter().map(move |&(other, b)| (a, b, minus != other))
    });
    pairs.collect()
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
