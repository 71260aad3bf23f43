//! Traversal and modification of the expressions of a checked model.

use model_spec::model::{Expr, ExprKind, Model};

/// Direct subexpressions of an expression, such as the two operands of a sum, from left to right.
pub fn children(e: &Expr) -> Vec<&Expr> {
    let mut out = Vec::new();
    e.children(&mut |child| out.push(child));
    out
}

/// Direct subexpressions of an expression, such as the two operands of a sum, from left to right, by mutable reference.
pub fn children_mut(e: &mut Expr) -> Vec<&mut Expr> {
    let mut out = Vec::new();
    e.children_mut(&mut |child| out.push(child));
    out
}

/// Replaces every occurrence of the coefficient with the given index by the number `value`.
pub fn fix_coefficient(model: &mut Model, index: usize, value: f64) {
    let is_coefficient = |kind: &ExprKind| matches!(kind, ExprKind::Coefficient(i) if *i == index);
    fix(model, value, &is_coefficient);
}

/// Replaces every occurrence of the state with the given index by the number `value`.
pub fn fix_state(model: &mut Model, index: usize, value: f64) {
    let is_state = |kind: &ExprKind| matches!(kind, ExprKind::State(i) if *i == index);
    fix(model, value, &is_state);
}

fn fix(model: &mut Model, value: f64, is: &dyn Fn(&ExprKind) -> bool) {
    fn walk(e: &mut Expr, value: f64, is: &dyn Fn(&ExprKind) -> bool) {
        if is(&e.kind) {
            let exact = (value.fract() == 0.0 && value.abs() < 1e15).then_some((value as i64, 1));
            e.kind = ExprKind::Number { value, exact };
        }
        e.children_mut(&mut |child| walk(child, value, is));
    }
    let roots = model.expressions_mut().into_iter();
    roots.for_each(|root| walk(root, value, is));
}
