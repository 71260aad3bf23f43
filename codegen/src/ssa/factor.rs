//! Factoring of sums: `a b + a c` becomes `a (b + c)` if that saves operations.

use super::{DefId, Signed, Ssa, SsaDef, cancel};
use crate::number::Number;
use model_spec::index::IndexVec;

/// Extracts common factors from all used sums, those that factoring creates included.
pub fn factor(ssa: &mut Ssa) {
    let mut uses = ssa.uses();
    let mut k = 0;
    // factoring appends sums, which are factored in turn
    while k < ssa.defs.len() {
        let id = DefId::new(k);
        if uses.get(id).is_none_or(|&n| n > 0) && matches!(ssa.defs[id], SsaDef::Sum(_)) {
            while factor_once(ssa, id, &mut uses) {}
        }
        k += 1;
    }
}

fn list(ssa: &Ssa, id: DefId) -> Vec<DefId> {
    match &ssa.defs[id] {
        SsaDef::Product(factors) => factors.clone(),
        _ => vec![id],
    }
}

fn factor_once(ssa: &mut Ssa, id: DefId, uses: &mut IndexVec<DefId, u32>) -> bool {
    let SsaDef::Sum(terms) = &ssa.defs[id] else {
        return false;
    };
    let terms = terms.clone();
    let lists: Vec<Vec<DefId>> = terms.iter().map(|&(_, term)| list(ssa, term)).collect();
    // exclude the trivial factor 1
    let mut candidates: Vec<DefId> = lists.iter().flatten().copied().collect();
    candidates.retain(|&factor| ssa.defs[factor] != SsaDef::Constant(Number::ONE));
    candidates.sort_unstable();
    candidates.dedup();
    let mut best: Option<(i64, Vec<usize>, Vec<DefId>)> = None;
    for candidate in candidates {
        let with: Vec<usize> = (0..terms.len())
            .filter(|&t| lists[t].contains(&candidate))
            .collect();
        if with.len() < 2 {
            continue;
        }
        let common = common(&lists, &with);
        let private = |t: usize| uses.get(terms[t].1).is_none_or(|&n| n <= 1);
        let runtime = |factors: &[DefId]| {
            let moving = factors.iter().filter(|&&f| !ssa.facts[f].fixed).count();
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
                .all(|&f| ssa.facts[f].fixed)
        });
        let mut outside = common.clone();
        outside.push(id);
        let after = inside + runtime(&outside) - if all_fixed { with.len() as i64 - 1 } else { 0 };
        let saved = before - after;
        if saved > 0 && best.as_ref().is_none_or(|(most, ..)| saved > *most) {
            best = Some((saved, with, common));
        }
    }
    let Some((_, with, common)) = best else {
        return false;
    };
    let mut inner: Vec<Signed> = Vec::new();
    for &t in &with {
        let rest = without(&lists[t], &common);
        let rest = if rest.is_empty() {
            constant(ssa, Number::ONE)
        } else {
            ssa.product(rest)
        };
        inner.push((terms[t].0, rest));
    }
    cancel(&mut inner);
    let others = (0..terms.len()).filter(|t| !with.contains(t));
    let mut rest: Vec<Signed> = others.map(|t| terms[t]).collect();
    let number = number(ssa, &inner);
    if number.is_some_and(Number::is_zero) {
        replace(ssa, id, rest, uses);
        return true;
    }
    // a sum inside a product starts with plus
    let flip = number.map_or(inner[0].0, Number::is_negative);
    if flip {
        inner.iter_mut().for_each(|(minus, _)| *minus = !*minus);
    }
    let inner = match number {
        Some(number) => constant(ssa, number.abs()),
        None => {
            let facts = ssa.sum_facts(&inner);
            ssa.define(SsaDef::Sum(inner), facts, None)
        }
    };
    let mut outside = common;
    outside.extend(list(ssa, inner));
    let product = ssa.product(outside);
    rest.push((flip, product));
    replace(ssa, id, rest, uses);
    true
}

/// Redefines `id` as the sum of `terms`, and updates the use counts.
fn replace(ssa: &mut Ssa, id: DefId, mut terms: Vec<Signed>, uses: &mut IndexVec<DefId, u32>) {
    cancel(&mut terms);
    let new = match terms.as_slice() {
        [] => SsaDef::Constant(Number::ZERO),
        [(false, single)] => ssa.defs[*single].clone(),
        _ => SsaDef::Sum(terms),
    };
    while uses.len() < ssa.defs.len() {
        uses.push(0);
    }
    let old = std::mem::replace(&mut ssa.defs[id], new);
    for operand in ssa.defs[id].operands() {
        take(ssa, operand, uses);
    }
    for operand in old.operands() {
        leave(ssa, operand, uses);
    }
}

fn take(ssa: &Ssa, id: DefId, uses: &mut IndexVec<DefId, u32>) {
    uses[id] += 1;
    if uses[id] == 1 {
        ssa.defs[id].for_operands(|operand| take(ssa, operand, uses));
    }
}

fn leave(ssa: &Ssa, id: DefId, uses: &mut IndexVec<DefId, u32>) {
    uses[id] = uses[id].saturating_sub(1);
    if uses[id] == 0 {
        ssa.defs[id].for_operands(|operand| leave(ssa, operand, uses));
    }
}

/// Value of a sum whose terms are all constants; `None` if a term is not constant.
fn number(ssa: &Ssa, terms: &[Signed]) -> Option<Number> {
    let mut sum = Number::ZERO;
    for &(minus, id) in terms {
        let SsaDef::Constant(number) = ssa.defs[id] else {
            return None;
        };
        sum = sum.plus(if minus { number.opposite() } else { number });
    }
    Some(sum)
}

/// Returns the definition of the positive constant `number`, which is added if missing.
fn constant(ssa: &mut Ssa, number: Number) -> DefId {
    let facts = crate::graph::ValueFacts {
        fixed: true,
        nonneg: true,
        nonzero: true,
    };
    ssa.define(SsaDef::Constant(number), facts, None)
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
