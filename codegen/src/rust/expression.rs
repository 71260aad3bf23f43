//! One statement as an infix expression, in exactly the order of the schedule.

use crate::program::{Binary, Fused, Op, Operand, Program, Unary};
use std::f64::consts::{FRAC_PI_2, PI};

/// How tightly an expression binds.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Bind {
    Sum,
    Product,
    Minus,
    Atom,
}

/// Writes expressions; statements without a name are written inside those that use them.
pub(super) struct Writer<'a> {
    pub program: &'a Program,
    /// Name of each statement that has one.
    pub names: Vec<Option<String>>,
    pub states: &'a [String],
    pub parameters: &'a [String],
    pub prepared: &'a [String],
    pub marker: &'a [String],
}

impl Writer<'_> {
    /// The right side of a statement.
    pub fn statement(&self, k: usize) -> String {
        self.op(&self.program.statements[k].op).0
    }

    /// An operand, as a value of its own.
    pub fn operand(&self, operand: Operand) -> String {
        self.value(operand).0
    }

    fn value(&self, operand: Operand) -> (String, Bind) {
        let name = match operand {
            Operand::Time => "time".to_string(),
            Operand::State(k) => local(&self.states[k as usize]),
            Operand::Parameter(k) => local(&self.parameters[k as usize]),
            Operand::Prepared(k) => local(&self.prepared[k as usize]),
            Operand::Marker(k) => local(&self.marker[k as usize]),
            Operand::Constant(c) => constant(c),
            Operand::Temp(k) => match &self.names[k as usize] {
                Some(name) => name.clone(),
                None => return self.op(&self.program.statements[k as usize].op),
            },
        };
        (name, Bind::Atom)
    }

    fn op(&self, op: &Op) -> (String, Bind) {
        match op {
            Op::IfZero(c, a, b) => {
                let (a, b) = (self.operand(*a), self.operand(*b));
                (
                    format!("{}.if_zero({a}, {b})", self.tight(*c, Bind::Atom)),
                    Bind::Atom,
                )
            }
            Op::Fused(fused, a, b, c) => {
                let method = match fused {
                    Fused::MulAdd => "mul_add",
                    Fused::MulSub => "mul_sub",
                    Fused::NegMulAdd => "neg_mul_add",
                };
                let (b, c) = (self.operand(*b), self.operand(*c));
                (
                    format!("{}.{method}({b}, {c})", self.tight(*a, Bind::Atom)),
                    Bind::Atom,
                )
            }
            Op::Binary(binary, a, b) => self.binary(*binary, *a, *b),
            Op::Unary(Unary::Neg, a) => (format!("-{}", self.tight(*a, Bind::Atom)), Bind::Minus),
            Op::Unary(Unary::Recip, a) => (
                format!("T::splat(1.0) / {}", self.tight(*a, Bind::Minus)),
                Bind::Product,
            ),
            Op::Unary(Unary::RecipOrZero, a) => self.method(*a, "recip_or_zero()"),
            Op::Unary(Unary::Call(function), a) => self.method(*a, function.rust_method()),
        }
    }

    fn method(&self, receiver: Operand, call: &str) -> (String, Bind) {
        let receiver = self.tight(receiver, Bind::Atom);
        (format!("{receiver}.{call}"), Bind::Atom)
    }

    fn binary(&self, binary: Binary, a: Operand, b: Operand) -> (String, Bind) {
        // operators group to the left: the right side needs parentheses where it binds no tighter
        let infix = |sign: &str, bind: Bind, above: Bind| {
            (
                format!("{} {sign} {}", self.tight(a, bind), self.tight(b, above)),
                bind,
            )
        };
        let method = |name: &str| {
            (
                format!("{}.{name}({})", self.tight(a, Bind::Atom), self.operand(b)),
                Bind::Atom,
            )
        };
        match binary {
            Binary::Add => infix("+", Bind::Sum, Bind::Product),
            Binary::Sub => infix("-", Bind::Sum, Bind::Product),
            Binary::Mul => infix("*", Bind::Product, Bind::Minus),
            Binary::Div => infix("/", Bind::Product, Bind::Minus),
            Binary::Atan2 => method("atan2"),
            Binary::Min => method("min"),
            Binary::Max => method("max"),
        }
    }

    fn tight(&self, operand: Operand, least: Bind) -> String {
        let (text, bind) = self.value(operand);
        if bind < least {
            format!("({text})")
        } else {
            text
        }
    }
}

/// A constant in every lane.
pub(super) fn constant(c: f64) -> String {
    if c == PI {
        "T::splat(PI)".into()
    } else if c == FRAC_PI_2 {
        "T::splat(FRAC_PI_2)".into()
    } else {
        format!("T::splat({c:?})")
    }
}

/// The local variable for a name of the model: arguments of the functions and words of Rust are avoided.
pub(super) fn local(name: &str) -> String {
    if crate::schedule::is_reserved(name) {
        format!("{name}_")
    } else {
        name.to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::functions::MathFunction;
    use crate::program::Statement;

    /// The text of `op` over a = temp 0 = `inner` of states b, c.
    fn nested(inner: Op, outer: impl Fn(Operand) -> Op) -> String {
        let unnamed = |op| Statement {
            op,
            name: None,
            about: None,
        };
        let program = Program {
            statements: vec![unnamed(inner), unnamed(outer(Operand::Temp(0)))],
            outputs: Vec::new(),
        };
        let states = ["a", "b", "c"].map(String::from);
        let writer = Writer {
            program: &program,
            names: vec![None; 2],
            states: &states,
            parameters: &[],
            prepared: &[],
            marker: &[],
        };
        writer.statement(1)
    }

    #[test]
    fn parentheses_stand_where_the_order_needs_them() {
        use Binary::{Add, Atan2, Div, Mul, Sub};
        let [a, b, c] = [0, 1, 2].map(Operand::State);
        let inner = |binary| Op::Binary(binary, b, c);
        let table = [
            (inner(Add), Sub, "a - (b + c)", "b + c - a"),
            (inner(Sub), Add, "a + (b - c)", "b - c + a"),
            (inner(Mul), Sub, "a - b * c", "b * c - a"),
            (inner(Add), Mul, "a * (b + c)", "(b + c) * a"),
            (inner(Mul), Div, "a / (b * c)", "b * c / a"),
            (inner(Div), Mul, "a * (b / c)", "b / c * a"),
            (inner(Add), Atan2, "a.atan2(b + c)", "(b + c).atan2(a)"),
            (Op::Unary(Unary::Neg, b), Mul, "a * -b", "-b * a"),
            (
                Op::Unary(Unary::Recip, b),
                Mul,
                "a * (T::splat(1.0) / b)",
                "T::splat(1.0) / b * a",
            ),
            (
                Op::Unary(Unary::Call(MathFunction::Sqrt), b),
                Div,
                "a / b.sqrt()",
                "b.sqrt() / a",
            ),
        ];
        for (inner, outer, right, left) in table {
            assert_eq!(nested(inner, |t| Op::Binary(outer, a, t)), right);
            assert_eq!(nested(inner, |t| Op::Binary(outer, t, a)), left);
        }
        let product = Op::Binary(Mul, b, c);
        assert_eq!(nested(product, |t| Op::Unary(Unary::Neg, t)), "-(b * c)");
        assert_eq!(
            nested(product, |t| Op::Unary(Unary::Call(MathFunction::Sqrt), t)),
            "(b * c).sqrt()"
        );
        let negative = Op::Unary(Unary::Neg, b);
        assert_eq!(
            nested(negative, |t| Op::Unary(Unary::Call(MathFunction::Abs), t)),
            "(-b).abs()"
        );
    }
}
