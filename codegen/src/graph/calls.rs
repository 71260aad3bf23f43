//! Construction and simplification of function nodes.

use super::{ExprGraph, Node, NodeId};
use crate::functions::{BinaryFunction, MathFunction, Parity};
use crate::number::Number;

impl ExprGraph {
    /// Node of `function(x)`, simplified.
    pub fn call(&mut self, function: MathFunction, x: NodeId) -> NodeId {
        if let Some(value) = self.as_number(x).and_then(|x| function.constant_value(x)) {
            return self.number(value);
        }
        match (function, self.node(x).clone()) {
            (MathFunction::Sqrt, _) => return self.sqrt(x),
            (MathFunction::Sin, Node::Call2(BinaryFunction::Atan2, y, x)) => {
                let radius = self.squares(y, x);
                return self.product(vec![(y, 2), (radius, -1)]);
            }
            (MathFunction::Cos, Node::Call2(BinaryFunction::Atan2, y, x)) => {
                // cos 0 = 1 at the origin, where x / radius is defined as 0
                let radius = self.squares(y, x);
                let quotient = self.product(vec![(x, 2), (radius, -1)]);
                let mask = self.call(MathFunction::NonZero, radius);
                return self.sum(
                    vec![(Number::ONE, quotient), (Number::MINUS_ONE, mask)],
                    Number::ONE,
                );
            }
            (MathFunction::Sin, Node::Call(MathFunction::Asin, y)) => {
                let (low, high) = (self.whole(-1), self.whole(1));
                let held = self.call2(BinaryFunction::Max, y, low);
                return self.call2(BinaryFunction::Min, held, high);
            }
            (MathFunction::Cos, Node::Call(MathFunction::Asin, y)) => {
                let square = self.power(y, 4);
                let one = self.whole(1);
                let rest = self.sub(one, square);
                return self.sqrt(rest);
            }
            (MathFunction::Exp, Node::Call(MathFunction::Log, y))
                if self.facts(y).nonneg && self.facts(y).nonzero =>
            {
                return y;
            }
            (MathFunction::Log, Node::Call(MathFunction::Exp, y)) => return y,
            (MathFunction::Abs, _) if self.facts(x).nonneg => return x,
            (MathFunction::NonZero, _) if self.facts(x).nonzero => return self.whole(1),
            (MathFunction::NonZero, Node::Product(factors)) => {
                let masks = factors
                    .iter()
                    .map(|&(factor, _)| (self.call(MathFunction::NonZero, factor), 2))
                    .collect();
                return self.product(masks);
            }
            (
                MathFunction::NonZero,
                Node::Call(MathFunction::NonZero | MathFunction::Abs | MathFunction::Sign, y),
            ) => {
                return self.call(MathFunction::NonZero, y);
            }
            (
                MathFunction::Heaviside | MathFunction::Sign,
                Node::Call(MathFunction::NonZero | MathFunction::Heaviside, _),
            ) => return x,
            _ => {}
        }
        let (coefficient, rest) = self.split_coefficient(x);
        if coefficient.is_negative() {
            match function.parity() {
                Parity::Even => {
                    let opposite = self.neg(x);
                    return self.call(function, opposite);
                }
                Parity::Odd => {
                    let opposite = self.neg(x);
                    let value = self.call(function, opposite);
                    return self.neg(value);
                }
                Parity::None => {}
            }
        }
        let scaled = function.ignores_scale() && !coefficient.is_negative();
        self.intern(Node::Call(function, if scaled { rest } else { x }))
    }

    fn squares(&mut self, a: NodeId, b: NodeId) -> NodeId {
        let (a, b) = (self.power(a, 4), self.power(b, 4));
        self.add(a, b)
    }

    /// Node of the square root of `x`; 0 where `x` ≤ 0.
    pub fn sqrt(&mut self, x: NodeId) -> NodeId {
        let (coefficient, rest) = self.split_coefficient(x);
        if !coefficient.is_one() && !coefficient.is_negative() {
            let root = self.sqrt(rest);
            let coefficient = self.number(coefficient.sqrt());
            return self.mul(coefficient, root);
        }
        match self.node(x).clone() {
            Node::Number(number) => self.number(number.sqrt()),
            _ if !self.facts(x).nonneg => self.intern(Node::Call(MathFunction::Sqrt, x)),
            Node::Product(factors) => {
                let halved = factors
                    .iter()
                    .map(|&(factor, exponent)| {
                        if self.facts(factor).nonneg && exponent % 2 == 0 {
                            (factor, exponent / 2)
                        } else if exponent % 4 == 0 {
                            (self.call(MathFunction::Abs, factor), exponent / 2)
                        } else {
                            (factor, 0)
                        }
                    })
                    .collect::<Vec<_>>();
                if halved.iter().any(|&(_, exponent)| exponent == 0) {
                    return self.intern(Node::Call(MathFunction::Sqrt, x));
                }
                self.product(halved)
            }
            _ => self.product(vec![(x, 1)]),
        }
    }

    /// A function of two arguments.
    pub fn call2(&mut self, function: BinaryFunction, a: NodeId, b: NodeId) -> NodeId {
        match function {
            BinaryFunction::Atan2 if self.is_zero(a) && self.facts(b).nonneg => a,
            BinaryFunction::Min | BinaryFunction::Max if a == b => a,
            _ => self.intern(Node::Call2(function, a, b)),
        }
    }

    /// Node of a selection: `then` where `condition` is 0, else `otherwise`.
    pub fn if_zero(&mut self, condition: NodeId, then: NodeId, otherwise: NodeId) -> NodeId {
        if then == otherwise || self.facts(condition).nonzero {
            return otherwise;
        }
        if self.is_zero(condition) {
            return then;
        }
        self.intern(Node::IfZero(condition, then, otherwise))
    }
}
