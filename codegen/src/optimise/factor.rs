//! Factoring: `a b + a c` becomes `a (b + c)` where that saves operations.

use super::{Dag, Def, DefId, Signed, cancel};
use crate::number::Number;

/// Factors every sum.
pub fn factor(dag: &mut Dag) {
    let mut uses = dag.uses();
    let mut k = 0;
    // sums that factoring makes are looked at in turn
    while k < dag.defs.len() {
        if uses.get(k).is_none_or(|&n| n > 0) && matches!(dag.defs[k], Def::Sum(_)) {
            while factor_once(dag, k as DefId, &mut uses) {}
        }
        k += 1;
    }
}

fn list(dag: &Dag, id: DefId) -> Vec<DefId> {
    match &dag.defs[id as usize] {
        Def::Product(factors) => factors.clone(),
        _ => vec![id],
    }
}

fn factor_once(dag: &mut Dag, id: DefId, uses: &mut Vec<u32>) -> bool {
    let Def::Sum(terms) = &dag.defs[id as usize] else {
        return false;
    };
    let terms = terms.clone();
    let lists: Vec<Vec<DefId>> = terms.iter().map(|&(_, term)| list(dag, term)).collect();
    // a 1 is a factor of everything, its own sum included
    let mut candidates: Vec<DefId> = lists.iter().flatten().copied().collect();
    candidates.retain(|&factor| dag.defs[factor as usize] != Def::Constant(Number::ONE));
    candidates.sort_unstable();
    candidates.dedup();
    let mut best: Option<(i64, DefId)> = None;
    for candidate in candidates {
        let with: Vec<usize> = (0..terms.len())
            .filter(|&t| lists[t].contains(&candidate))
            .collect();
        if with.len() < 2 {
            continue;
        }
        let common = common(&lists, &with);
        let private = |t: usize| uses.get(terms[t].1 as usize).is_none_or(|&n| n <= 1);
        let runtime = |factors: &[DefId]| {
            let moving = factors
                .iter()
                .filter(|&&f| !dag.facts[f as usize].fixed)
                .count();
            let fixed = usize::from(moving < factors.len());
            (moving + fixed).saturating_sub(1) as i64
        };
        let before: i64 = with
            .iter()
            .filter(|&&t| private(t))
            .map(|&t| runtime(&lists[t]))
            .sum();
        let inside: i64 = with
            .iter()
            .map(|&t| runtime(&without(&lists[t], &common)))
            .sum();
        let all_fixed = with.iter().all(|&t| {
            without(&lists[t], &common)
                .iter()
                .all(|&f| dag.facts[f as usize].fixed)
        });
        let mut outside = common.clone();
        outside.push(id);
        let after = inside + runtime(&outside) - if all_fixed { with.len() as i64 - 1 } else { 0 };
        let saved = before - after;
        if saved > 0 && best.is_none_or(|(most, _)| saved > most) {
            best = Some((saved, candidate));
        }
    }
    let Some((_, chosen)) = best else {
        return false;
    };
    let with: Vec<usize> = (0..terms.len())
        .filter(|&t| lists[t].contains(&chosen))
        .collect();
    let common = common(&lists, &with);
    let mut inner: Vec<Signed> = Vec::new();
    for &t in &with {
        let rest = without(&lists[t], &common);
        let rest = if rest.is_empty() {
            one(dag)
        } else {
            dag.product(rest)
        };
        inner.push((terms[t].0, rest));
    }
    cancel(&mut inner);
    let others = (0..terms.len()).filter(|t| !with.contains(t));
    let mut rest: Vec<Signed> = others.map(|t| terms[t]).collect();
    let number = number(dag, &inner);
    if number.is_some_and(Number::is_zero) {
        replace(dag, id, rest, uses);
        return true;
    }
    // a sum inside a product starts with plus
    let flip = number.map_or(inner[0].0, Number::is_negative);
    if flip {
        inner.iter_mut().for_each(|(minus, _)| *minus = !*minus);
    }
    let inner = match number {
        Some(number) => constant(dag, number.abs()),
        None => {
            let facts = dag.sum_facts(&inner);
            dag.define(Def::Sum(inner), facts, None)
        }
    };
    let mut outside = common;
    outside.extend(list(dag, inner));
    let product = dag.product(outside);
    rest.push((flip, product));
    replace(dag, id, rest, uses);
    true
}

/// Makes a definition the sum of these terms, and counts uses anew where they change.
fn replace(dag: &mut Dag, id: DefId, mut terms: Vec<Signed>, uses: &mut Vec<u32>) {
    cancel(&mut terms);
    let new = match terms.as_slice() {
        [] => Def::Constant(Number::ZERO),
        [(false, single)] => dag.defs[*single as usize].clone(),
        _ => Def::Sum(terms),
    };
    uses.resize(dag.defs.len(), 0);
    let old = std::mem::replace(&mut dag.defs[id as usize], new);
    for operand in dag.defs[id as usize].operands() {
        take(dag, operand, uses);
    }
    for operand in old.operands() {
        leave(dag, operand, uses);
    }
}

fn take(dag: &Dag, id: DefId, uses: &mut [u32]) {
    uses[id as usize] += 1;
    if uses[id as usize] == 1 {
        dag.defs[id as usize].for_operands(|operand| take(dag, operand, uses));
    }
}

fn leave(dag: &Dag, id: DefId, uses: &mut [u32]) {
    uses[id as usize] = uses[id as usize].saturating_sub(1);
    if uses[id as usize] == 0 {
        dag.defs[id as usize].for_operands(|operand| leave(dag, operand, uses));
    }
}

/// The sum of terms that are all constants.
fn number(dag: &Dag, terms: &[Signed]) -> Option<Number> {
    let mut sum = Number::ZERO;
    for &(minus, id) in terms {
        let Def::Constant(number) = dag.defs[id as usize] else {
            return None;
        };
        sum = sum.plus(if minus { number.opposite() } else { number });
    }
    Some(sum)
}

fn one(dag: &mut Dag) -> DefId {
    constant(dag, Number::ONE)
}

/// A constant above 0.
fn constant(dag: &mut Dag, number: Number) -> DefId {
    let facts = crate::graph::Facts {
        fixed: true,
        nonneg: true,
        nonzero: true,
    };
    dag.define(Def::Constant(number), facts, None)
}

fn common(lists: &[Vec<DefId>], with: &[usize]) -> Vec<DefId> {
    let mut common = lists[with[0]].clone();
    for &t in &with[1..] {
        let mut left = lists[t].clone();
        common.retain(|factor| match left.iter().position(|f| f == factor) {
            Some(at) => {
                left.remove(at);
                true
            }
            None => false,
        });
    }
    common
}

fn without(list: &[DefId], taken: &[DefId]) -> Vec<DefId> {
    let mut rest = list.to_vec();
    for factor in taken {
        if let Some(at) = rest.iter().position(|f| f == factor) {
            rest.remove(at);
        }
    }
    rest
}
