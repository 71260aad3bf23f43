//! Signs: sums are turned around where that leaves fewer negations.
//!
//! Turning a sum costs nothing where it is a term of another sum; a product passes the sign on to its
//! users. What is left to pay for: negative results, negative arguments of functions, sums of nothing
//! but negative terms.

use super::{Dag, Def, DefId};

/// Turns sums as long as negations disappear.
pub fn settle(dag: &mut Dag) {
    absorb_fixed(dag);
    let mut users = users(dag);
    let mut improved = true;
    while improved {
        improved = false;
        for id in 0..dag.defs.len() as DefId {
            if !matches!(dag.defs[id as usize], Def::Sum(_)) || users[id as usize].is_empty() {
                continue;
            }
            let mut touched = Vec::new();
            if !turn(dag, &users, id, &mut touched) {
                undo(dag, touched);
                continue;
            }
            let after: i64 = distinct(&touched)
                .iter()
                .map(|&place| price(dag, place))
                .sum();
            let now = touched.clone();
            undo(dag, touched);
            let before: i64 = distinct(&now).iter().map(|&place| price(dag, place)).sum();
            if after < before {
                let mut again = Vec::new();
                turn(dag, &users, id, &mut again);
                improved = true;
            }
        }
        users = self::users(dag);
    }
}

/// A place where a sign stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Place {
    /// All terms of a sum.
    Terms(DefId),
    /// A product or reciprocal, which has none of its own.
    Through(DefId),
    /// One term of a sum, or an argument: the k-th operand.
    Operand(DefId, usize),
    /// A result.
    Root(usize),
}

#[derive(Clone, Copy, Debug)]
enum User {
    Def(DefId),
    Root(usize),
}

fn users(dag: &Dag) -> Vec<Vec<User>> {
    let mut users = vec![Vec::new(); dag.defs.len()];
    for id in dag.order() {
        let mut operands = dag.defs[id as usize].operands();
        operands.sort_unstable();
        operands.dedup();
        for operand in operands {
            users[operand as usize].push(User::Def(id));
        }
    }
    for (k, &(_, root)) in dag.roots.iter().enumerate() {
        users[root as usize].push(User::Root(k));
    }
    users
}

/// Turns a sum and whatever that passes through; false where it cannot be.
fn turn(dag: &mut Dag, users: &[Vec<User>], id: DefId, touched: &mut Vec<Place>) -> bool {
    if dag.facts[id as usize].nonneg {
        return false;
    }
    flip(dag, Place::Terms(id));
    touched.push(Place::Terms(id));
    pass(dag, users, id, touched)
}

fn pass(dag: &mut Dag, users: &[Vec<User>], id: DefId, touched: &mut Vec<Place>) -> bool {
    for &user in &users[id as usize] {
        match user {
            User::Root(k) => {
                flip(dag, Place::Root(k));
                touched.push(Place::Root(k));
            }
            User::Def(user) => match &dag.defs[user as usize] {
                Def::Product(factors) => {
                    let odd = factors.iter().filter(|&&f| f == id).count() % 2 == 1;
                    if odd && !through(dag, users, user, touched) {
                        return false;
                    }
                }
                Def::Recip(_) => {
                    if !through(dag, users, user, touched) {
                        return false;
                    }
                }
                Def::Root(_) => return false,
                def => {
                    let condition = matches!(def, Def::IfZero(..));
                    for (k, operand) in def.operands().into_iter().enumerate() {
                        if operand == id && !(condition && k == 0) {
                            flip(dag, Place::Operand(user, k));
                            touched.push(Place::Operand(user, k));
                        }
                    }
                }
            },
        }
    }
    true
}

/// A product or reciprocal takes the sign and hands it on.
fn through(dag: &mut Dag, users: &[Vec<User>], id: DefId, touched: &mut Vec<Place>) -> bool {
    if dag.facts[id as usize].nonneg {
        return false;
    }
    flip(dag, Place::Through(id));
    touched.push(Place::Through(id));
    pass(dag, users, id, touched)
}

fn undo(dag: &mut Dag, touched: Vec<Place>) {
    for place in touched {
        flip(dag, place);
    }
}

fn flip(dag: &mut Dag, place: Place) {
    match place {
        Place::Root(k) => dag.roots[k].0 = !dag.roots[k].0,
        Place::Terms(id) => {
            if let Def::Sum(terms) = &mut dag.defs[id as usize] {
                terms.iter_mut().for_each(|(minus, _)| *minus = !*minus);
            }
            flip(dag, Place::Through(id));
        }
        Place::Through(id) => {
            if let Some((minus, _)) = &mut dag.origin[id as usize] {
                *minus = !*minus;
            }
        }
        Place::Operand(id, k) => match &mut dag.defs[id as usize] {
            Def::Sum(terms) => terms[k].0 = !terms[k].0,
            Def::Call(_, (minus, _)) => *minus = !*minus,
            Def::Atan2(a, b) | Def::Min(a, b) | Def::Max(a, b) => {
                let part = if k == 0 { a } else { b };
                part.0 = !part.0;
            }
            Def::IfZero(_, a, b) => {
                let part = if k == 1 { a } else { b };
                part.0 = !part.0;
            }
            _ => {}
        },
    }
}

/// Places whose price may have changed, each once.
fn distinct(touched: &[Place]) -> Vec<Place> {
    let mut places: Vec<Place> = touched.to_vec();
    places.sort_unstable();
    places.dedup();
    places
}

/// Negations that a place costs.
fn price(dag: &Dag, place: Place) -> i64 {
    let sum = |terms: &[(bool, DefId)]| -> i64 {
        let plus = terms
            .iter()
            .any(|&(minus, id)| !minus || dag.facts[id as usize].fixed && is_leaf(dag, id));
        if plus { 0 } else { 1 }
    };
    match place {
        Place::Through(_) => 0,
        Place::Root(k) => i64::from(dag.roots[k].0 && !dag.facts[dag.roots[k].1 as usize].fixed),
        Place::Terms(id) => match &dag.defs[id as usize] {
            Def::Sum(terms) => sum(terms),
            _ => 0,
        },
        Place::Operand(id, k) => match &dag.defs[id as usize] {
            Def::Sum(terms) => sum(terms),
            Def::Call(_, (minus, _)) => i64::from(*minus),
            Def::Atan2(a, b) | Def::Min(a, b) | Def::Max(a, b) => {
                i64::from(if k == 0 { a.0 } else { b.0 })
            }
            Def::IfZero(_, a, b) => i64::from(if k == 1 { a.0 } else { b.0 }),
            _ => 0,
        },
    }
}

fn is_leaf(dag: &Dag, id: DefId) -> bool {
    matches!(dag.defs[id as usize], Def::Constant(_))
}

/// A negative result that is a product with a factor that is prepared anyway takes that factor's opposite.
fn absorb_fixed(dag: &mut Dag) {
    let uses = dag.uses();
    for k in 0..dag.roots.len() {
        let (minus, id) = dag.roots[k];
        if minus && uses[id as usize] == 1 && absorb(dag, id, &uses) {
            dag.roots[k].0 = false;
        }
    }
    for id in 0..uses.len() {
        let Def::Sum(terms) = &dag.defs[id] else {
            continue;
        };
        if uses[id] == 0 || dag.facts[id].fixed || terms.iter().any(|&(minus, _)| !minus) {
            continue;
        }
        let terms = terms.clone();
        for (at, &(_, term)) in terms.iter().enumerate() {
            if uses[term as usize] == 1 && absorb(dag, term, &uses) {
                if let Def::Sum(terms) = &mut dag.defs[id] {
                    terms[at].0 = false;
                }
                break;
            }
        }
    }
}

fn absorb(dag: &mut Dag, id: DefId, uses: &[u32]) -> bool {
    let Def::Product(factors) = dag.defs[id as usize].clone() else {
        return false;
    };
    for (at, &factor) in factors.iter().enumerate() {
        if dag.facts[factor as usize].fixed {
            let facts = super::Facts {
                nonneg: false,
                ..dag.facts[factor as usize]
            };
            let opposite = dag.define(Def::Sum(vec![(true, factor)]), facts, None);
            if let Def::Product(factors) = &mut dag.defs[id as usize] {
                factors[at] = opposite;
            }
            dag.origin[id as usize] = None;
            return true;
        }
        if uses.get(factor as usize) == Some(&1) && absorb(dag, factor, uses) {
            dag.origin[id as usize] = None;
            return true;
        }
    }
    false
}
