//! Traversal and modification of the expressions of a checked model.

use model_spec::model::{Expr, ExprKind, Model};

/// Direct subexpressions of an expression, in order.
pub fn children(e: &Expr) -> Vec<&Expr> {
    let mut out = Vec::new();
    e.children(&mut |child| out.push(child));
    out
}

/// Direct subexpressions of an expression, in order, by mutable reference.
pub fn children_mut(e: &mut Expr) -> Vec<&mut Expr> {
    let mut out = Vec::new();
    e.children_mut(&mut |child| out.push(child));
    out
}

/// Root of every expression of a model, by mutable reference.
pub fn roots_mut(model: &mut Model) -> Vec<&mut Expr> {
    let mut out: Vec<&mut Expr> = Vec::new();
    if let Some(body) = &mut model.body {
        out.push(&mut body.mass);
        out.extend(
            body.rotation
                .iter_mut()
                .flat_map(|r| r.inertia.iter_mut().flatten()),
        );
    }
    out.extend(model.aux_variables.iter_mut().map(|l| &mut l.value));
    out.extend(
        model
            .forces
            .iter_mut()
            .chain(&mut model.moments)
            .map(|l| &mut l.value),
    );
    out.extend(model.equations.iter_mut().map(|e| &mut e.value));
    out.extend(model.claim.iter_mut().flat_map(|c| c.expressions_mut()));
    out.extend(model.observation.iter_mut().map(|o| &mut o.value));
    out.extend(model.clock.iter_mut().map(|c| &mut c.value));
    out.extend(model.limits.iter_mut().map(|l| &mut l.value));
    out
}

/// Replaces every occurrence of the coefficient with the given index by the number `value`.
pub fn fix_coefficient(model: &mut Model, index: usize, value: f64) {
    fix(
        model,
        value,
        |kind| matches!(kind, ExprKind::Coefficient(i) if *i == index),
    );
}

/// Replaces every occurrence of the state with the given index by the number `value`.
pub fn fix_state(model: &mut Model, index: usize, value: f64) {
    fix(
        model,
        value,
        |kind| matches!(kind, ExprKind::State(i) if *i == index),
    );
}

fn fix(model: &mut Model, value: f64, is: impl Fn(&ExprKind) -> bool) {
    fn walk(e: &mut Expr, value: f64, is: &dyn Fn(&ExprKind) -> bool) {
        if is(&e.kind) {
            let exact = (value.fract() == 0.0 && value.abs() < 1e15).then_some((value as i64, 1));
            e.kind = ExprKind::Number { value, exact };
        }
        children_mut(e)
            .into_iter()
            .for_each(|child| walk(child, value, is));
    }
    roots_mut(model)
        .into_iter()
        .for_each(|root| walk(root, value, &is));
}
