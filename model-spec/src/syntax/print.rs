//! Printing of expressions and units in the notation of model files.

use std::fmt;

use super::ast::{BinaryOp, Expr, ExprKind, Quantity, UnitExpr};

impl BinaryOp {
    /// Text of the operator; sums and differences include surrounding spaces.
    pub fn symbol(self) -> &'static str {
        match self {
            BinaryOp::Add => " + ",
            BinaryOp::Sub => " - ",
            BinaryOp::Mul => "*",
            BinaryOp::Dot => "·",
            BinaryOp::Cross => "×",
            BinaryOp::Div => "/",
            BinaryOp::Pow => "^",
        }
    }

    fn strength(self) -> u8 {
        match self {
            BinaryOp::Add | BinaryOp::Sub => 10,
            BinaryOp::Mul | BinaryOp::Dot | BinaryOp::Cross | BinaryOp::Div => 20,
            BinaryOp::Pow => 30,
        }
    }
}

/// Texts with commas between them.
pub(super) fn listed(items: impl IntoIterator<Item = impl fmt::Display>) -> String {
    let texts: Vec<String> = items.into_iter().map(|item| item.to_string()).collect();
    texts.join(", ")
}

/// A unit behind `mark`; nothing if none is written.
pub(super) fn behind(mark: &str, unit: &Option<UnitExpr>) -> String {
    let unit = unit.as_ref();
    unit.map_or_else(String::new, |unit| format!("{mark}{unit}"))
}

impl fmt::Display for UnitExpr {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_inferred() {
            return f.write_str("[?]");
        }
        let mut any = false;
        for factor in self.factors.iter().filter(|u| u.doubled > 0) {
            write!(f, "{}{}", if any { "*" } else { "" }, factor.symbol)?;
            power(f, factor.doubled)?;
            any = true;
        }
        // A bare 1 after a number would be parsed as another number.
        if self.factors.iter().all(|u| u.doubled == 0) {
            return f.write_str("[1]");
        }
        if !any {
            f.write_str("1")?;
        }
        for factor in self.factors.iter().filter(|u| u.doubled < 0) {
            write!(f, "/{}", factor.symbol)?;
            power(f, -factor.doubled)?;
        }
        Ok(())
    }
}

fn power(f: &mut fmt::Formatter<'_>, doubled: i32) -> fmt::Result {
    match doubled {
        2 => Ok(()),
        even if even % 2 == 0 => write!(f, "^{}", even / 2),
        odd => write!(f, "^({odd}/2)"),
    }
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.number.text, behind(" ", &self.unit))
    }
}

impl fmt::Display for Expr {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write_expr(f, self, 0)
    }
}

fn write_expr(f: &mut fmt::Formatter<'_>, expr: &Expr, least: u8) -> fmt::Result {
    let strength = match &expr.kind {
        ExprKind::Binary(op, ..) => op.strength(),
        ExprKind::Neg(_) => 25,
        // A literal with a sign or unit binds less tightly than a name.
        ExprKind::Number(q) if q.number.text.starts_with('-') => 25,
        ExprKind::Number(q) if q.unit.is_some() => 35,
        ExprKind::Ascribed(..) => least,
        _ => 40,
    };
    if strength < least {
        f.write_str("(")?;
    }
    match &expr.kind {
        ExprKind::Number(q) => match &q.unit {
            Some(unit) => {
                let unit = unit.to_string();
                let bare = unit.trim_start_matches('[').trim_end_matches(']');
                write!(f, "{} [{bare}]", q.number.text)?;
            }
            None => f.write_str(&q.number.text)?,
        },
        ExprKind::Name(name) => f.write_str(name)?,
        ExprKind::Part(of, part) => {
            write_expr(f, of, 40)?;
            write!(f, ".{part}")?;
        }
        ExprKind::Derivative(state) => write!(f, "der({})", state.text)?,
        ExprKind::Components(parts, frame) => {
            write!(
                f,
                "({}, {}, {}) in {}",
                parts[0], parts[1], parts[2], frame.text
            )?;
        }
        ExprKind::Neg(of) => {
            f.write_str("-")?;
            write_expr(f, of, 25)?;
        }
        ExprKind::Binary(op, a, b) => {
            // `^` is right-associative, all other operators are left-associative.
            let (left, right) = match op {
                BinaryOp::Pow => (31, 30),
                _ => (op.strength(), op.strength() + 1),
            };
            write_expr(f, a, left)?;
            f.write_str(op.symbol())?;
            write_expr(f, b, right)?;
        }
        ExprKind::Element(name, subscripts) => {
            write!(f, "{name}[{}]", listed(subscripts))?;
        }
        ExprKind::Sum(index, of) => write!(f, "sum({index}, {of})")?,
        ExprKind::Ascribed(of, _) => write_expr(f, of, least)?,
        ExprKind::Call(name, arguments) => {
            write!(f, "{}({})", name.text, listed(arguments))?;
        }
    }
    if strength < least {
        f.write_str(")")?;
    }
    Ok(())
}
