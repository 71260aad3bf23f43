//! Generates the mutations of one expression.

use super::names::Names;
use super::{Mutation, Operator};
use model_spec::diagnostic::Span;
use model_spec::syntax::ast::{BinaryOp, Expr, ExprKind, Name};

/// Mutations of an expression, in the statement `item`, and of its subexpressions, in preorder; `serial` counts the
/// expressions, and `text` returns the source text of a span.
pub fn everywhere<'s>(
    e: &Expr,
    names: &Names,
    item: usize,
    text: &dyn Fn(Span) -> &'s str,
    serial: &mut usize,
) -> Vec<Mutation<Expr>> {
    let mut out = rewrites(e, names, item, *serial);
    for own in &mut out {
        own.how = format!("`{}` {}", text(e.span), own.how);
    }
    *serial += 1;
    let mut children = e.children();
    if let ExprKind::Binary(BinaryOp::Pow, ..) = e.kind {
        // An exponent is a literal and is mutated together with its power.
        children.truncate(1);
    }
    for (k, child) in children.into_iter().enumerate() {
        for inner in everywhere(child, names, item, text, serial) {
            let mut to = e.clone();
            *to.children_mut().swap_remove(k) = inner.to;
            out.push(Mutation { to, ..inner });
        }
    }
    out
}

/// Mutations of the expression `e` in the statement `item`, not of its subexpressions. A whole right-hand side (`serial`
/// 0) is multiplied by 2, 0.5 and 1.1, a name or number by one of these, chosen by `serial`.
fn rewrites(e: &Expr, names: &Names, item: usize, serial: usize) -> Vec<Mutation<Expr>> {
    let root = serial == 0;
    let mut out = Vec::new();
    let mut push = |operator, how: String, to: Expr| out.push(Mutation { operator, how, to });
    let leaf = match &e.kind {
        ExprKind::Name(name) => !names.is_frame(name),
        ExprKind::Number(_) => true,
        _ => false,
    };
    if root || leaf {
        push(
            Operator::Sign,
            "negated".into(),
            with(e, ExprKind::Neg(Box::new(e.clone()))),
        );
        let factors = ["2", "0.5", "1.1"];
        for (k, factor) in factors.into_iter().enumerate() {
            if root || k == serial % 3 {
                push(
                    Operator::Factor,
                    format!("times {factor}"),
                    times(e, factor),
                );
            }
        }
    }
    match &e.kind {
        ExprKind::Number(_)
        | ExprKind::Derivative(_)
        | ExprKind::Element(..)
        | ExprKind::Sum(..)
        | ExprKind::Ascribed(..) => {}
        ExprKind::Name(name) => {
            for other in names.exchanges(name, item) {
                let how = format!("exchanged for `{other}`");
                push(Operator::Exchanged, how, with(e, ExprKind::Name(other)));
            }
        }
        ExprKind::Neg(a) => push(Operator::Sign, "minus left out".into(), (**a).clone()),
        ExprKind::Part(a, k) => {
            for axis in (1..=3).filter(|axis| axis != k) {
                let to = with(e, ExprKind::Part(a.clone(), axis));
                push(Operator::Axis, format!("axis {axis} for {k}"), to);
            }
            if let ExprKind::Name(frame) = &a.kind {
                for other in names.other_frames(frame) {
                    let of = Box::new(with(a, ExprKind::Name(other.clone())));
                    let to = with(e, ExprKind::Part(of, *k));
                    push(Operator::Frame, format!("of {other}"), to);
                }
            }
        }
        ExprKind::Components(parts, frame) => {
            for other in names.other_frames(&frame.text) {
                let name = Name::new(other, frame.span);
                let to = with(e, ExprKind::Components(parts.clone(), name));
                push(Operator::Frame, format!("in {other}"), to);
            }
            for (i, j) in [(0, 1), (1, 2), (0, 2)] {
                let mut swapped = parts.clone();
                swapped.swap(i, j);
                let how = format!("components {} and {} swapped", i + 1, j + 1);
                let to = with(e, ExprKind::Components(swapped, frame.clone()));
                push(Operator::Axis, how, to);
            }
        }
        ExprKind::Binary(op, a, b) => binary(e, *op, a, b, &mut push),
        ExprKind::Call(function, arguments) => call(e, function, arguments, names, &mut push),
    }
    out
}

fn binary(
    e: &Expr,
    op: BinaryOp,
    a: &Expr,
    b: &Expr,
    push: &mut impl FnMut(Operator, String, Expr),
) {
    let as_op = |op| {
        let (a, b) = (Box::new(a.clone()), Box::new(b.clone()));
        with(e, ExprKind::Binary(op, a, b))
    };
    match op {
        BinaryOp::Add | BinaryOp::Sub => {
            let (flipped, sign, second) = match op {
                BinaryOp::Add => (BinaryOp::Sub, "-", b.clone()),
                _ => {
                    let negated = with(b, ExprKind::Neg(Box::new(b.clone())));
                    (BinaryOp::Add, "+", negated)
                }
            };
            push(Operator::Sign, format!("`{sign}` instead"), as_op(flipped));
            push(Operator::Dropped, "second term dropped".into(), a.clone());
            push(Operator::Dropped, "first term dropped".into(), second);
        }
        BinaryOp::Mul | BinaryOp::Dot | BinaryOp::Cross => {
            push(Operator::Dropped, "second factor dropped".into(), a.clone());
            push(Operator::Dropped, "first factor dropped".into(), b.clone());
        }
        BinaryOp::Div => push(Operator::Dropped, "divisor dropped".into(), a.clone()),
        BinaryOp::Pow => {
            let ExprKind::Number(exponent) = &b.kind else {
                return;
            };
            let Ok(n) = exponent.number.text.parse::<i32>() else {
                return;
            };
            for other in [n - 1, n + 1] {
                let exponent = Box::new(Expr::number(other.to_string(), b.span));
                let to = with(e, ExprKind::Binary(op, Box::new(a.clone()), exponent));
                push(Operator::Exponent, format!("exponent {other} for {n}"), to);
            }
        }
    }
}

fn call(
    e: &Expr,
    function: &Name,
    arguments: &[Expr],
    names: &Names,
    push: &mut impl FnMut(Operator, String, Expr),
) {
    let renamed = |to: &str| {
        let name = Name::new(to, function.span);
        with(e, ExprKind::Call(name, arguments.to_vec()))
    };
    match (function.text.as_str(), arguments) {
        ("sin", _) => push(Operator::Function, "cos for sin".into(), renamed("cos")),
        ("cos", _) => push(Operator::Function, "sin for cos".into(), renamed("sin")),
        ("sqrt" | "unit" | "abs", [a, ..]) => {
            let how = format!("{} left out", function.text);
            push(Operator::Function, how, a.clone());
        }
        ("cross" | "atan2" | "dot", [a, b]) => {
            let swapped = vec![b.clone(), a.clone()];
            let to = with(e, ExprKind::Call(function.clone(), swapped));
            push(Operator::Order, "arguments swapped".into(), to);
        }
        (name, _) => {
            let Some(frame) = name.strip_prefix("in_") else {
                return;
            };
            for other in names.other_frames(frame) {
                let to = format!("in_{other}");
                push(Operator::Frame, to.clone(), renamed(&to));
            }
        }
    }
}

fn with(e: &Expr, kind: ExprKind) -> Expr {
    Expr { kind, span: e.span }
}

fn times(e: &Expr, factor: &str) -> Expr {
    let factor = Box::new(Expr::number(factor, e.span));
    with(
        e,
        ExprKind::Binary(BinaryOp::Mul, factor, Box::new(e.clone())),
    )
}
