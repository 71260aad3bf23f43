//! Sites of mutations in a model file: its expressions, numbered in source order.

use model_spec::syntax::ast::{BinaryOp, BodyPartKind, Expr, ExprKind, Item, ItemKind};

/// Root expressions of a statement that are mutated; none where they do not describe physics.
pub fn roots(item: &mut Item) -> Vec<&mut Expr> {
    match &mut item.kind {
        ItemKind::Body(body) => {
            let of_part = body.parts.iter_mut().flat_map(|part| match &mut part.kind {
                BodyPartKind::Mass(e) => vec![e],
                BodyPartKind::Inertia(i) => i.rows.iter_mut().flatten().flatten().collect(),
                _ => Vec::new(),
            });
            of_part.collect()
        }
        other => other.value_mut().into_iter().collect(),
    }
}

/// Kind and name of a statement for messages, such as `frame B` or `der(u)`.
pub fn statement_name(item: &Item) -> String {
    match &item.kind {
        ItemKind::Parameter(c) => format!("declaration of {}", c.name.text),
        ItemKind::Input(i) => format!("input {}", i.name.text),
        ItemKind::Frame(f) => format!("frame {}", f.name.text),
        ItemKind::Body(b) => format!("body {}", b.name.text),
        ItemKind::Table(t) => format!("table {}", t.name.text),
        ItemKind::Let(l) => format!("let {}", l.name.text),
        ItemKind::Load(l) => format!("{:?} {}", l.class, l.name.text).to_lowercase(),
        ItemKind::Equation(e) => format!("der({})", e.state.text),
        ItemKind::Marker(m) => format!("marker {}", m.name.text),
        ItemKind::Observe(o) => format!("observe {}", o.name.text),
        ItemKind::Clock(_) => String::from("clock"),
        _ => String::from("statement"),
    }
}

/// Direct subexpressions that are mutated separately, not the exponent of a power.
pub fn children(e: &mut Expr) -> Vec<&mut Expr> {
    match &mut e.kind {
        ExprKind::Number(_) | ExprKind::Name(_) | ExprKind::Derivative(_) => Vec::new(),
        ExprKind::Part(a, _) | ExprKind::Neg(a) => vec![a],
        ExprKind::Components(parts, _) => parts.iter_mut().collect(),
        // An exponent is a literal and is mutated together with its power.
        ExprKind::Binary(BinaryOp::Pow, a, _) => vec![a],
        ExprKind::Binary(_, a, b) => vec![a, b],
        ExprKind::Call(_, arguments) => arguments.iter_mut().collect(),
    }
}

/// Number of expressions in the tree of `e`.
pub fn count(e: &mut Expr) -> usize {
    1 + children(e).into_iter().map(count).sum::<usize>()
}

/// Expression with index `n`, in preorder.
pub fn nth(e: &mut Expr, n: usize) -> Option<&mut Expr> {
    if n == 0 {
        return Some(e);
    }
    let mut left = n - 1;
    for child in children(e) {
        let size = count(child);
        if left < size {
            return nth(child, left);
        }
        left -= size;
    }
    None
}
