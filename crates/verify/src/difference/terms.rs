//! Names in the texts of statements, and terms in which two sums differ.

use model_spec::syntax::ast::{BinaryOp, Expr, ExprKind};

/// Words of a text that may be names; `in_F` also gives the frame `F`, `w_x` the input `w`.
pub fn words(text: &str) -> Vec<&str> {
    let mut out: Vec<&str> = Vec::new();
    for word in text.split(is_separator).filter(|word| !word.is_empty()) {
        out.push(word);
        out.extend(word.strip_prefix("in_"));
        // Components of an input are named after it.
        let mut axes = ["_x", "_y", "_z"].iter();
        out.extend(axes.find_map(|axis| word.strip_suffix(axis)));
    }
    out
}

/// Whether a character cannot be part of a name declared in a model.
fn is_separator(c: char) -> bool {
    !c.is_alphanumeric() && c != '_'
}

/// Terms in which two sums, or their only different inner sums, differ: those only in `old`, those only in `new`.
pub fn differing_terms(old: &Expr, new: &Expr) -> (Vec<String>, Vec<String>) {
    let (before, after) = (terms(old), terms(new));
    let olds: Vec<String> = before.iter().map(Term::to_string).collect();
    let news: Vec<String> = after.iter().map(Term::to_string).collect();
    let (gone, come) = (without(&olds, &news), without(&news, &olds));
    if let ([i], [j]) = (&gone[..], &come[..])
        && before[*i].negative == after[*j].negative
        && let Some((a, b)) = inner_sums(before[*i].value, after[*j].value)
    {
        return differing_terms(a, b);
    }
    let pick =
        |from: &[String], places: &[usize]| places.iter().map(|&k| from[k].clone()).collect();
    (pick(&olds, &gone), pick(&news, &come))
}

/// The outermost sum of each expression inside which alone they differ.
fn inner_sums<'a>(old: &'a Expr, new: &'a Expr) -> Option<(&'a Expr, &'a Expr)> {
    let (mut a, mut b) = (old, new);
    loop {
        (a, b) = one_part(a, b)?;
        if terms(a).len() > 1 || terms(b).len() > 1 {
            return Some((a, b));
        }
    }
}

/// The only pair of operands or arguments in which two expressions of the same kind differ.
fn one_part<'a>(old: &'a Expr, new: &'a Expr) -> Option<(&'a Expr, &'a Expr)> {
    match (&old.kind, &new.kind) {
        (ExprKind::Binary(a, ..), ExprKind::Binary(b, ..)) if a == b && *a != BinaryOp::Pow => {}
        (ExprKind::Call(a, _), ExprKind::Call(b, _)) if a.text == b.text => {}
        _ => return None,
    }
    let (olds, news) = (old.children(), new.children());
    let differ = |(a, b): &(&Expr, &Expr)| a.to_string() != b.to_string();
    let is_equal_count = olds.len() == news.len();
    let mut parts = olds.into_iter().zip(news).filter(differ);
    let first = parts.next()?;
    (parts.next().is_none() && is_equal_count).then_some(first)
}

/// Multiset difference: indices of the elements of `list` that `other` lacks.
fn without(list: &[String], other: &[String]) -> Vec<usize> {
    let mut left = other.to_vec();
    let mut missing = Vec::new();
    for (k, term) in list.iter().enumerate() {
        match left.iter().position(|o| o == term) {
            Some(at) => drop(left.swap_remove(at)),
            None => missing.push(k),
        }
    }
    missing
}

/// A term of a sum in an expression, with its sign.
struct Term<'a> {
    negative: bool,
    value: &'a Expr,
}

impl std::fmt::Display for Term<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let sign = if self.negative { "-" } else { "" };
        write!(f, "{sign}{}", self.value)
    }
}

fn terms(e: &Expr) -> Vec<Term<'_>> {
    fn walk<'a>(e: &'a Expr, negative: bool, out: &mut Vec<Term<'a>>) {
        match &e.kind {
            ExprKind::Binary(BinaryOp::Add, a, b) => {
                walk(a, negative, out);
                walk(b, negative, out);
            }
            ExprKind::Binary(BinaryOp::Sub, a, b) => {
                walk(a, negative, out);
                walk(b, !negative, out);
            }
            ExprKind::Neg(a) => walk(a, !negative, out),
            _ => out.push(Term { negative, value: e }),
        }
    }
    let mut out = Vec::new();
    walk(e, false, &mut out);
    out
}
