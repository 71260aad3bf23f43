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

/// Factors of a term in order: those of a product, else the term itself.
fn list<'a>(ssa: &'a Ssa, id: &'a DefId) -> &'a [DefId] {
    match &ssa.defs[*id] {
        SsaDef::Product(factors) => factors,
        _ => std::slice::from_ref(id),
    }
}

/// What is extracted from a sum: the indices of terms, and the factors that they have in common.
type Extraction = (Vec<usize>, Vec<DefId>);

/// The extraction that saves most operations; `None` if none saves any.
fn best(ssa: &Ssa, id: DefId, terms: &[Signed], uses: &IndexVec<DefId, u32>) -> Option<Extraction> {
    let lists: Vec<&[DefId]> = terms.iter().map(|(_, term)| list(ssa, term)).collect();
    let factors = lists.iter().enumerate();
    let factors = factors.flat_map(|(t, list)| list.iter().map(move |&factor| (factor, t)));
    let mut places: Vec<(DefId, usize)> = factors.collect();
    places.sort_unstable();
    places.dedup();
    let mut best: Option<(i64, Extraction)> = None;
    for places in places.chunk_by(|a, b| a.0 == b.0) {
        // exclude the trivial factor 1
        if places.len() < 2 || ssa.defs[places[0].0] == SsaDef::Constant(Number::ONE) {
            continue;
        }
        let with: Vec<usize> = places.iter().map(|&(_, t)| t).collect();
        let common = common(&lists, &with);
        let saved = saved(ssa, id, terms, &lists, uses, (&with, &common));
        if saved > 0 && best.as_ref().is_none_or(|(most, _)| saved > *most) {
            best = Some((saved, (with, common)));
        }
    }
    best.map(|(_, extraction)| extraction)
}

/// Operations that an extraction saves in each evaluation.
fn saved(
    ssa: &Ssa,
    id: DefId,
    terms: &[Signed],
    lists: &[&[DefId]],
    uses: &IndexVec<DefId, u32>,
    (with, common): (&[usize], &[DefId]),
) -> i64 {
    let moving = |factors: &[DefId]| factors.iter().filter(|&&f| !ssa.facts[f].fixed).count();
    // operations of a product, of whose factors `moving` are not fixed
    let operations = |factors: usize, moving: usize| {
        (moving + usize::from(moving < factors)).saturating_sub(1) as i64
    };
    let (common_factors, common_moving) = (common.len(), moving(common));
    let (mut before, mut inside, mut all_fixed) = (0, 0, true);
    for &t in with {
        let (factors, moving) = (lists[t].len(), moving(lists[t]));
        if uses.get(terms[t].1).is_none_or(|&n| n <= 1) {
            before += operations(factors, moving);
        }
        inside += operations(factors - common_factors, moving - common_moving);
        all_fixed &= moving == common_moving;
    }
    // sums of what is left are computed once per flight if all of it is fixed
    let additions = if all_fixed { with.len() as i64 - 1 } else { 0 };
    let outside = operations(
        common_factors + 1,
        common_moving + usize::from(!ssa.facts[id].fixed),
    );
    before - inside - outside + additions
}

fn factor_once(ssa: &mut Ssa, id: DefId, uses: &mut IndexVec<DefId, u32>) -> bool {
    let SsaDef::Sum(terms) = &ssa.defs[id] else {
        return false;
    };
    let Some((with, common)) = best(ssa, id, terms, uses) else {
        return false;
    };
    let terms = terms.clone();
    let mut inner: Vec<Signed> = Vec::new();
    for &t in &with {
        let rest = without(list(ssa, &terms[t].1), &common);
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
    outside.extend(list(ssa, &inner));
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

/// Factors that some lists, each sorted, have in common.
fn common(lists: &[&[DefId]], with: &[usize]) -> Vec<DefId> {
    let mut common = lists[with[0]].to_vec();
    for &t in &with[1..] {
        let mut left = lists[t];
        common.retain(|factor| {
            left = &left[left.partition_point(|other| other < factor)..];
            let is_common = left.first() == Some(factor);
            left = &left[usize::from(is_common)..];
            is_common
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
