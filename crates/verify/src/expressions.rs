//! Traversal and modification of the expressions of a checked model.

use model_spec::model::{EffectUnknown, Expr, ExprKind, Model};

/// Replaces every coefficient and state that the effects of a model add by its null value.
pub fn fix_effects(model: &mut Model) {
    let effects = model.effects.clone();
    let null_value = |kind: &ExprKind| {
        let find =
            |own: &[EffectUnknown], index| own.iter().find(|own| own.index == index).copied();
        let own = match *kind {
            ExprKind::Coefficient(i) => effects.iter().find_map(|e| find(&e.coefficients, i)),
            ExprKind::State(i) => effects.iter().find_map(|e| find(&e.states, i)),
            _ => None,
        };
        own.map(|own| own.null_value)
    };
    fn walk(e: &mut Expr, null_value: &dyn Fn(&ExprKind) -> Option<f64>) {
        if let Some(value) = null_value(&e.kind) {
            let exact = (value.fract() == 0.0 && value.abs() < 1e15).then_some((value as i64, 1));
            e.kind = ExprKind::Number { value, exact };
        }
        for child in e.children_mut() {
            walk(child, null_value);
        }
    }
    let roots = model.expressions_mut().into_iter();
    roots.for_each(|root| walk(root, &null_value));
}
