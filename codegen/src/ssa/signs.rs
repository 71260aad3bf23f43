//! Sign placement: negates sums if that reduces the number of negations.
//!
//! Negating a sum is free if the sum is a term of another sum; a product passes the sign on to its users. Each of the
//! following costs one negation: a negative result, a negative function argument, and a sum of negative terms only.

use super::{DefId, Ssa, SsaDef};
use model_spec::index::IndexVec;

pub fn settle(ssa: &mut Ssa) {
    absorb_fixed(ssa);
    let mut users = users(ssa);
    let mut improved = true;
    let (mut touched, mut places) = (Vec::new(), Vec::new());
    while improved {
        improved = false;
        for id in ssa.defs.indices() {
            if !matches!(ssa.defs[id], SsaDef::Sum(_)) || users[id].is_empty() {
                continue;
            }
            touched.clear();
            if !turn(ssa, &users, id, &mut touched) {
                undo(ssa, &touched);
                continue;
            }
            places.clone_from(&touched);
            places.sort_unstable();
            places.dedup();
            let after = prices(ssa, &places);
            undo(ssa, &touched);
            if after < prices(ssa, &places) {
                turn(ssa, &users, id, &mut touched);
                improved = true;
            }
        }
        users = self::users(ssa);
    }
}

/// Location of a sign in the SSA program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum SignLocation {
    /// Signs of all terms of a sum.
    Terms(DefId),
    /// Sign of a product or reciprocal, which is stored at its users.
    Through(DefId),
    /// Sign of the operand with this index in a definition: a term of a sum or an argument of a function.
    Operand(DefId, usize),
    /// Sign of the requested result (root) with this index.
    Root(usize),
}

#[derive(Clone, Copy, Debug)]
enum User {
    SsaDef(DefId),
    Root(usize),
}

/// For each definition, the definitions and the requested results (roots) that use it.
type Users = IndexVec<DefId, Vec<User>>;

fn users(ssa: &Ssa) -> Users {
    let mut users: Users = ssa.side_table(Vec::new());
    let mut operands = Vec::new();
    for id in ssa.order() {
        operands.clear();
        ssa.defs[id].for_operands(|operand| operands.push(operand));
        operands.sort_unstable();
        operands.dedup();
        for &operand in &operands {
            users[operand].push(User::SsaDef(id));
        }
    }
    for (k, &(_, root)) in ssa.roots.iter().enumerate() {
        users[root].push(User::Root(k));
    }
    users
}

/// Negates a sum and the signs of its users; false if that is impossible, with `touched` to undo.
fn turn(ssa: &mut Ssa, users: &Users, id: DefId, touched: &mut Vec<SignLocation>) -> bool {
    if ssa.facts[id].nonneg {
        return false;
    }
    flip(ssa, SignLocation::Terms(id));
    touched.push(SignLocation::Terms(id));
    pass(ssa, users, id, touched)
}

fn pass(ssa: &mut Ssa, users: &Users, id: DefId, touched: &mut Vec<SignLocation>) -> bool {
    for &user in &users[id] {
        match user {
            User::Root(k) => {
                flip(ssa, SignLocation::Root(k));
                touched.push(SignLocation::Root(k));
            }
            User::SsaDef(user) => match &ssa.defs[user] {
                SsaDef::Product(factors) => {
                    let odd = factors.iter().filter(|&&f| f == id).count() % 2 == 1;
                    if odd && !through(ssa, users, user, touched) {
                        return false;
                    }
                }
                SsaDef::Recip(_) => {
                    if !through(ssa, users, user, touched) {
                        return false;
                    }
                }
                SsaDef::Root(_) => return false,
                def => {
                    let condition = matches!(def, SsaDef::IfZero(..));
                    for (k, operand) in def.operands().into_iter().enumerate() {
                        if operand == id && !(condition && k == 0) {
                            flip(ssa, SignLocation::Operand(user, k));
                            touched.push(SignLocation::Operand(user, k));
                        }
                    }
                }
            },
        }
    }
    true
}

/// Passes a sign on to the users of a product or reciprocal; false if that is impossible.
fn through(ssa: &mut Ssa, users: &Users, id: DefId, touched: &mut Vec<SignLocation>) -> bool {
    if ssa.facts[id].nonneg {
        return false;
    }
    flip(ssa, SignLocation::Through(id));
    touched.push(SignLocation::Through(id));
    pass(ssa, users, id, touched)
}

fn undo(ssa: &mut Ssa, touched: &[SignLocation]) {
    for &place in touched {
        flip(ssa, place);
    }
}

fn flip(ssa: &mut Ssa, place: SignLocation) {
    match place {
        SignLocation::Root(k) => ssa.roots[k].0 = !ssa.roots[k].0,
        SignLocation::Terms(id) => {
            if let SsaDef::Sum(terms) = &mut ssa.defs[id] {
                terms.iter_mut().for_each(|(minus, _)| *minus = !*minus);
            }
            flip(ssa, SignLocation::Through(id));
        }
        SignLocation::Through(id) => {
            if let Some((minus, _)) = &mut ssa.origin[id] {
                *minus = !*minus;
            }
        }
        SignLocation::Operand(id, k) => match &mut ssa.defs[id] {
            SsaDef::Sum(terms) => terms[k].0 = !terms[k].0,
            SsaDef::Call(_, (minus, _)) => *minus = !*minus,
            SsaDef::Call2(_, a, b) => {
                let part = if k == 0 { a } else { b };
                part.0 = !part.0;
            }
            SsaDef::IfZero(_, a, b) => {
                let part = if k == 1 { a } else { b };
                part.0 = !part.0;
            }
            _ => {}
        },
    }
}

fn prices(ssa: &Ssa, places: &[SignLocation]) -> i64 {
    places.iter().map(|&place| price(ssa, place)).sum()
}

/// Negations, 0 or 1, that the signs at a location require in each evaluation.
fn price(ssa: &Ssa, place: SignLocation) -> i64 {
    let sum = |terms: &[(bool, DefId)]| -> i64 {
        let plus = terms
            .iter()
            .any(|&(minus, id)| !minus || ssa.facts[id].fixed && is_leaf(ssa, id));
        i64::from(!plus)
    };
    match place {
        SignLocation::Through(_) => 0,
        SignLocation::Root(k) => i64::from(ssa.roots[k].0 && !ssa.facts[ssa.roots[k].1].fixed),
        SignLocation::Terms(id) => match &ssa.defs[id] {
            SsaDef::Sum(terms) => sum(terms),
            _ => 0,
        },
        SignLocation::Operand(id, k) => match &ssa.defs[id] {
            SsaDef::Sum(terms) => sum(terms),
            SsaDef::Call(_, (minus, _)) => i64::from(*minus),
            SsaDef::Call2(_, a, b) => i64::from(if k == 0 { a.0 } else { b.0 }),
            SsaDef::IfZero(_, a, b) => i64::from(if k == 1 { a.0 } else { b.0 }),
            _ => 0,
        },
    }
}

fn is_leaf(ssa: &Ssa, id: DefId) -> bool {
    matches!(ssa.defs[id], SsaDef::Constant(_))
}

/// Moves the sign of a negative result or sum into a factor of parameters only.
fn absorb_fixed(ssa: &mut Ssa) {
    let uses = ssa.uses();
    for k in 0..ssa.roots.len() {
        let (minus, id) = ssa.roots[k];
        if minus && uses[id] == 1 && absorb(ssa, id, &uses) {
            ssa.roots[k].0 = false;
        }
    }
    for id in uses.indices() {
        let SsaDef::Sum(terms) = &ssa.defs[id] else {
            continue;
        };
        if uses[id] == 0 || ssa.facts[id].fixed || terms.iter().any(|&(minus, _)| !minus) {
            continue;
        }
        let terms = terms.clone();
        for (at, &(_, term)) in terms.iter().enumerate() {
            if uses[term] == 1 && absorb(ssa, term, &uses) {
                if let SsaDef::Sum(terms) = &mut ssa.defs[id] {
                    terms[at].0 = false;
                }
                break;
            }
        }
    }
}

fn absorb(ssa: &mut Ssa, id: DefId, uses: &IndexVec<DefId, u32>) -> bool {
    let SsaDef::Product(factors) = ssa.defs[id].clone() else {
        return false;
    };
    for (at, &factor) in factors.iter().enumerate() {
        if ssa.facts[factor].fixed {
            let facts = super::ValueFacts {
                nonneg: false,
                ..ssa.facts[factor]
            };
            let opposite = ssa.define(SsaDef::Sum(vec![(true, factor)]), facts, None);
            if let SsaDef::Product(factors) = &mut ssa.defs[id] {
                factors[at] = opposite;
            }
            ssa.origin[id] = None;
            return true;
        }
        if uses.get(factor) == Some(&1) && absorb(ssa, factor, uses) {
            ssa.origin[id] = None;
            return true;
        }
    }
    false
}
