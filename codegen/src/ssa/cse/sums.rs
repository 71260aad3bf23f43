//! Common-subexpression elimination in sums: common pairs of terms are computed once, up to sign.

use super::{Replaced, Score, merge_equal, pairs_of};
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

fn replace(ssa: &mut Ssa, pair: Pair, mut users: Vec<DefId>) -> Replaced {
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
    (shared, users)
}

fn terms(ssa: &Ssa, id: DefId) -> &[Signed] {
    match &ssa.defs[id] {
        SsaDef::Sum(terms) => terms,
        _ => &[],
    }
}

fn pairs(ssa: &Ssa, id: DefId, with: Option<DefId>) -> Vec<Pair> {
    let pairs = pairs_of(terms(ssa, id), with, |(_, term)| term);
    pairs
        .map(|((minus, a), (other, b))| (a, b, minus != other))
        .collect()
}

/// Sign of the first term of a pair in a sum (`true` is minus); `None` if the sum does not contain the pair.
fn sign(list: &[Signed], pair: Pair) -> Option<bool> {
    // terms are sorted by definition
    let once = |wanted| {
        let mut found = list[list.partition_point(|&(_, id)| id < wanted)..].iter();
        let first = found.next().filter(|&&(_, id)| id == wanted)?.0;
        found
            .next()
            .is_none_or(|&(_, id)| id != wanted)
            .then_some(first)
    };
    let (first, second) = (once(pair.0)?, once(pair.1)?);
    (pair.0 != pair.1 && (first != second) == pair.2).then_some(first)
}

/// Additions saved by a shared pair: occurrences less 1, or of a fixed pair those in longer sums.
fn score(ssa: &Ssa, pair: Pair, users: &[DefId]) -> Option<Score> {
    let lists = users.iter().map(|&id| terms(ssa, id));
    let (mut places, mut whole) = (0, 0);
    for list in lists.filter(|list| sign(list, pair).is_some()) {
        places += 1;
        whole += usize::from(list.len() == 2);
    }
    let fixed = ssa.facts[pair.0].fixed && ssa.facts[pair.1].fixed;
    let saved = if fixed {
        places - whole
    } else {
        places.saturating_sub(1)
    };
    (saved > 0 && (whole < places || whole > 1)).then_some((saved, fixed))
}
