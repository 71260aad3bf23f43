//! Functions: the arctangent's sine and cosine are algebraic, roots are half powers.

use super::{Function, Graph, Node, NodeId};
use crate::number::Number;

impl Graph {
    /// A function of one argument, simplified.
    pub fn call(&mut self, function: Function, x: NodeId) -> NodeId {
        if let Some(value) = self.as_number(x).and_then(|x| fold(function, x)) {
            return self.number(value);
        }
        match (function, self.node(x).clone()) {
            (Function::Sqrt, _) => return self.sqrt(x),
            (Function::Sin, Node::Atan2(y, x)) => {
                let radius = self.squares(y, x);
                return self.product(vec![(y, 2), (radius, -1)]);
            }
            (Function::Cos, Node::Atan2(y, x)) => {
                // cos 0 = 1 at the origin, where x / h is 0
                let radius = self.squares(y, x);
                let quotient = self.product(vec![(x, 2), (radius, -1)]);
                let mask = self.call(Function::NonZero, radius);
                return self.sum(
                    vec![(Number::ONE, quotient), (Number::MINUS_ONE, mask)],
                    Number::ONE,
                );
            }
            (Function::Sin, Node::Call(Function::Asin, y)) => {
                let (low, high) = (self.whole(-1), self.whole(1));
                let held = self.max(y, low);
                return self.min(held, high);
            }
            (Function::Cos, Node::Call(Function::Asin, y)) => {
                let square = self.power(y, 4);
                let one = self.whole(1);
                let rest = self.sub(one, square);
                return self.sqrt(rest);
            }
            (Function::Exp, Node::Call(Function::Log, y))
                if self.facts(y).nonneg && self.facts(y).nonzero =>
            {
                return y;
            }
            (Function::Log, Node::Call(Function::Exp, y)) => return y,
            (Function::Abs, _) if self.facts(x).nonneg => return x,
            (Function::NonZero, _) if self.facts(x).nonzero => return self.whole(1),
            (Function::NonZero, Node::Product(factors)) => {
                let masks = factors
                    .iter()
                    .map(|&(factor, _)| (self.call(Function::NonZero, factor), 2))
                    .collect();
                return self.product(masks);
            }
            (
                Function::NonZero,
                Node::Call(Function::NonZero | Function::Abs | Function::Sign, y),
            ) => {
                return self.call(Function::NonZero, y);
            }
            (
                Function::Step | Function::Sign,
                Node::Call(Function::NonZero | Function::Step, _),
            ) => return x,
            _ => {}
        }
        if self.leads_negative(x) && function != Function::Step {
            let opposite = self.neg(x);
            let value = match function {
                Function::Cos | Function::Abs | Function::NonZero => {
                    return self.call(function, opposite);
                }
                Function::Sin | Function::Asin | Function::Tanh | Function::Sign => {
                    self.call(function, opposite)
                }
                _ => return self.intern(Node::Call(function, x)),
            };
            return self.neg(value);
        }
        let positive = match (function, self.split_coefficient(x)) {
            (Function::Step | Function::Sign | Function::NonZero, (c, rest))
                if !c.is_negative() =>
            {
                rest
            }
            _ => x,
        };
        self.intern(Node::Call(function, positive))
    }

    /// Whether it is a single negated term.
    fn leads_negative(&self, x: NodeId) -> bool {
        self.split_coefficient(x).0.is_negative()
    }

    /// `a² + b²`.
    fn squares(&mut self, a: NodeId, b: NodeId) -> NodeId {
        let (a, b) = (self.power(a, 4), self.power(b, 4));
        self.add(a, b)
    }

    /// Square root; 0 where the argument is 0 or less.
    pub fn sqrt(&mut self, x: NodeId) -> NodeId {
        let (coefficient, rest) = self.split_coefficient(x);
        if !coefficient.is_one() && !coefficient.is_negative() {
            let root = self.sqrt(rest);
            let coefficient = self.number(coefficient.sqrt());
            return self.mul(coefficient, root);
        }
        match self.node(x).clone() {
            Node::Number(number) => self.number(number.sqrt()),
            _ if !self.facts(x).nonneg => self.intern(Node::Call(Function::Sqrt, x)),
            Node::Product(factors) => {
                let halved = factors
                    .iter()
                    .map(|&(factor, exponent)| {
                        if self.facts(factor).nonneg && exponent % 2 == 0 {
                            (factor, exponent / 2)
                        } else if exponent % 4 == 0 {
                            (self.call(Function::Abs, factor), exponent / 2)
                        } else {
                            (factor, 0)
                        }
                    })
                    .collect::<Vec<_>>();
                if halved.iter().any(|&(_, exponent)| exponent == 0) {
                    return self.intern(Node::Call(Function::Sqrt, x));
                }
                self.product(halved)
            }
            _ => self.product(vec![(x, 1)]),
        }
    }

    /// Angle of the point (`x`, `y`); 0 at the origin.
    pub fn atan2(&mut self, y: NodeId, x: NodeId) -> NodeId {
        if self.is_zero(y) && self.facts(x).nonneg {
            return y;
        }
        self.intern(Node::Atan2(y, x))
    }

    /// The smaller.
    pub fn min(&mut self, a: NodeId, b: NodeId) -> NodeId {
        if a == b {
            a
        } else {
            self.intern(Node::Min(a, b))
        }
    }

    /// The greater.
    pub fn max(&mut self, a: NodeId, b: NodeId) -> NodeId {
        if a == b {
            a
        } else {
            self.intern(Node::Max(a, b))
        }
    }

    /// `then` where `condition` is 0, else `otherwise`.
    pub fn if_zero(&mut self, condition: NodeId, then: NodeId, otherwise: NodeId) -> NodeId {
        if then == otherwise || self.facts(condition).nonzero {
            return otherwise;
        }
        if self.is_zero(condition) {
            return then;
        }
        self.intern(Node::IfZero(condition, then, otherwise))
    }

    /// Tangent.
    pub fn tan(&mut self, x: NodeId) -> NodeId {
        let (sin, cos) = (self.call(Function::Sin, x), self.call(Function::Cos, x));
        self.div(sin, cos)
    }
}

fn fold(function: Function, x: Number) -> Option<Number> {
    let zero = x.is_zero();
    match function {
        Function::Sin | Function::Asin | Function::Tanh | Function::Sqrt if zero => {
            Some(Number::ZERO)
        }
        Function::Cos | Function::Exp if zero => Some(Number::ONE),
        Function::Log if x.is_one() || zero || x.is_negative() => Some(Number::ZERO),
        Function::Abs => Some(x.abs()),
        Function::Sign if zero => Some(Number::ZERO),
        Function::Sign => Some(if x.is_negative() {
            Number::MINUS_ONE
        } else {
            Number::ONE
        }),
        Function::Step => Some(if zero || x.is_negative() {
            Number::ZERO
        } else {
            Number::ONE
        }),
        Function::NonZero => Some(if zero { Number::ZERO } else { Number::ONE }),
        _ => None,
    }
}
