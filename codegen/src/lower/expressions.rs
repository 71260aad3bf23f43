//! Lowering of model expressions to graph nodes, by expression kind.

use super::frames::{self, Vector};
use super::{Lowering, Value};
use crate::differentiate::partials;
use crate::functions::{BinaryFunction, FunctionLowering, MathFunction};
use crate::graph::{ExprGraph, NodeId, Symbol};
use crate::number::Number;
use crate::table::{TableFunction, TableId};
use model_spec::layout::ParamId;
use model_spec::model::{Body, Expr, ExprKind, Function as Named, Shape};

impl Lowering<'_> {
    pub(crate) fn scalar(&mut self, expr: &Expr) -> NodeId {
        match self.evaluate(expr) {
            Value::Scalar(node) => node,
            // unreachable after the shape check of the model
            Value::Vector(vector) => vector[0],
        }
    }

    pub(crate) fn vector(&mut self, expr: &Expr) -> Vector {
        match self.evaluate(expr) {
            Value::Vector(vector) => vector,
            Value::Scalar(node) => [node; 3],
        }
    }

    fn parameter(&mut self, at: ParamId) -> NodeId {
        self.graph.symbol(Symbol::Parameter(at.index() as u32))
    }

    fn symbol(&mut self, symbol: Symbol) -> Value {
        Value::Scalar(self.graph.symbol(symbol))
    }

    pub(crate) fn evaluate(&mut self, expr: &Expr) -> Value {
        use ExprKind as E;
        match &expr.kind {
            E::Number { value, exact } => {
                Value::Scalar(self.graph.number(Number::literal(*value, *exact)))
            }
            E::Pi => self.symbol(Symbol::Pi),
            E::Time => self.symbol(Symbol::Time),
            E::Param(k) => Value::Scalar(self.parameter(self.layout.param(*k))),
            E::Coefficient(k) => Value::Scalar(self.parameter(self.layout.coefficient(*k))),
            E::Input(k) => Value::Vector(self.layout.input(*k).map(|at| self.parameter(at))),
            E::State(k) => self.symbol(Symbol::State(*k as u32)),
            E::AuxVariable(k) => self.lets[*k],
            E::Unknown(system, k) => Value::Scalar(self.unknowns[*system][*k]),
            E::Determinacy(system) => Value::Scalar(self.determinacies[*system]),
            E::Rate(of, states, rates) => self.rate(of, states, rates),
            E::BodyRate(state, loads) => Value::Scalar(self.body_rate(*state, loads.is_empty())),
            E::Partial(of, state) => {
                let of = self.scalar(of);
                let state = Symbol::State(*state as u32);
                Value::Scalar(partials::total(&mut self.graph, of, state))
            }
            E::Axis(frame, axis) => {
                let unit = frames::axis(&mut self.graph, *axis);
                Value::Vector(self.in_frame(unit, *frame, expr.shape))
            }
            E::Position => Value::Vector(self.states(|body| body.position)),
            E::Velocity => Value::Vector(self.states(|body| body.velocity)),
            E::AngularVelocity => Value::Vector(self.spin()),
            E::SpecificForce => Value::Vector(self.specific_force()),
            E::AngularAcceleration => Value::Vector(self.angular_acceleration()),
            E::Marker => Value::Vector([0, 1, 2].map(|k| self.graph.symbol(Symbol::Marker(k)))),
            E::Components(parts) => {
                let components = [&parts[0], &parts[1], &parts[2]].map(|part| self.scalar(part));
                Value::Vector(components)
            }
            E::Neg(a) => self.evaluate(a).map(|component| self.graph.neg(component)),
            E::Add(a, b) => self.termwise(a, b, ExprGraph::add),
            E::Sub(a, b) => self.termwise(a, b, ExprGraph::sub),
            E::Mul(a, b) => match (self.evaluate(a), self.evaluate(b)) {
                (Value::Vector(v), Value::Scalar(s)) | (Value::Scalar(s), Value::Vector(v)) => {
                    let scaled = frames::scale(&mut self.graph, s, v);
                    Value::Vector(scaled.map(|part| self.graph.held_product(part)))
                }
                (a, b) => {
                    let product = self.graph.times(first(a), first(b));
                    Value::Scalar(self.graph.held_product(product))
                }
            },
            E::Div(a, b) => {
                let (a, b) = (self.evaluate(a), self.scalar(b));
                // the model checker has verified that the divisor is nonzero
                self.graph.assume_nonzero(b);
                a.map(|component| {
                    let quotient = self.graph.over(component, b);
                    self.graph.held_product(quotient)
                })
            }
            E::Ratio(parts) => {
                let [a, b, otherwise] =
                    [&parts[0], &parts[1], &parts[2]].map(|part| self.scalar(part));
                let quotient = self.graph.div(a, b);
                Value::Scalar(if self.graph.is_zero(otherwise) {
                    quotient
                } else {
                    self.graph.if_zero(b, otherwise, quotient)
                })
            }
            E::Pow(a, doubled) => {
                let a = self.scalar(a);
                Value::Scalar(self.graph.power(a, *doubled))
            }
            E::RealPower(a, b) => {
                let (a, b) = (self.scalar(a), self.scalar(b));
                Value::Scalar(self.graph.real_power(a, b))
            }
            E::Dot(a, b) => {
                let (a, b) = (self.vector(a), self.vector(b));
                Value::Scalar(frames::dot(&mut self.graph, a, b))
            }
            E::Cross(a, b) => {
                let (a, b) = (self.vector(a), self.vector(b));
                Value::Vector(frames::cross(&mut self.graph, a, b))
            }
            E::Norm(v) => {
                let v = self.vector(v);
                let square = frames::dot(&mut self.graph, v, v);
                Value::Scalar(self.graph.sqrt(square))
            }
            E::Direction(v, otherwise) => {
                let v = self.vector(v);
                let square = frames::dot(&mut self.graph, v, v);
                let length = self.graph.sqrt(square);
                let unit = v.map(|component| self.graph.div(component, length));
                match otherwise {
                    None => Value::Vector(unit),
                    Some(otherwise) => {
                        let other = self.vector(otherwise);
                        Value::Vector(
                            [0, 1, 2].map(|k| self.graph.if_zero(length, other[k], unit[k])),
                        )
                    }
                }
            }
            E::Component(v, k) => Value::Scalar(self.vector(v)[usize::from(*k) - 1]),
            E::Reexpress(v) => {
                let from = match v.shape {
                    Shape::Vector(frame) => frame,
                    Shape::Scalar => 0,
                };
                let vector = self.vector(v);
                Value::Vector(self.in_frame(vector, from, expr.shape))
            }
            E::Call(function, x) => {
                let x = self.scalar(x);
                Value::Scalar(match function {
                    Named::Log => self.graph.held_logarithm(x),
                    _ => self.named(*function, x),
                })
            }
            E::Lookup(index, a, b) => {
                let table = TableFunction::value_of(TableId::new(*index));
                self.call2(BinaryFunction::Table(table), a, b)
            }
            E::Atan2(y, x) => self.call2(BinaryFunction::Atan2, y, x),
            E::Min(a, b) => self.call2(BinaryFunction::Min, a, b),
            E::Max(a, b) => self.call2(BinaryFunction::Max, a, b),
        }
    }

    /// Derivative of a number, or of a vector in the inertial frame, by the time of the flight.
    fn rate(&mut self, of: &Expr, states: &[usize], rates: &[Expr]) -> Value {
        let value = match (self.evaluate(of), of.shape) {
            (Value::Vector(vector), Shape::Vector(from)) => {
                Value::Vector(self.reexpress(vector, from, 0))
            }
            (value, _) => value,
        };
        let mut moving: Vec<(Symbol, NodeId)> = Vec::new();
        for (&state, rate) in states.iter().zip(rates) {
            moving.push((Symbol::State(state as u32), self.scalar(rate)));
        }
        let one = self.graph.whole(1);
        let seconds = match &self.model.clock {
            Some(clock) => {
                let pace = self.scalar(&clock.value);
                self.graph.div(one, pace)
            }
            None => one,
        };
        moving.push((Symbol::Time, seconds));
        let changed = value.map(|component| partials::along(&mut self.graph, component, &moving));
        match (changed, of.shape) {
            (Value::Vector(vector), Shape::Vector(to)) => {
                Value::Vector(self.reexpress(vector, 0, to))
            }
            (changed, _) => changed,
        }
    }

    fn termwise(
        &mut self,
        a: &Expr,
        b: &Expr,
        operation: fn(&mut ExprGraph, NodeId, NodeId) -> NodeId,
    ) -> Value {
        match (self.evaluate(a), self.evaluate(b)) {
            (Value::Vector(a), Value::Vector(b)) => {
                Value::Vector([0, 1, 2].map(|k| operation(&mut self.graph, a[k], b[k])))
            }
            (a, b) => Value::Scalar(operation(&mut self.graph, first(a), first(b))),
        }
    }

    fn call2(&mut self, function: BinaryFunction, a: &Expr, b: &Expr) -> Value {
        let (a, b) = (self.scalar(a), self.scalar(b));
        Value::Scalar(self.graph.call2(function, a, b))
    }

    /// Components in frame `to` of a vector given in frame `from`.
    pub(super) fn reexpress(&mut self, vector: Vector, from: usize, to: usize) -> Vector {
        frames::reexpress(&mut self.graph, &self.frames, vector, from, to)
    }

    /// Angular velocity of frame `of`, rad/s, with components in frame `within`.
    pub(super) fn angular_velocity(&mut self, of: usize, within: usize) -> Vector {
        frames::angular_velocity(&mut self.graph, &self.frames, of, within)
    }

    fn in_frame(&mut self, vector: Vector, from: usize, shape: Shape) -> Vector {
        match shape {
            Shape::Vector(to) => self.reexpress(vector, from, to),
            Shape::Scalar => vector,
        }
    }

    fn states(&mut self, states: fn(&Body) -> [usize; 3]) -> Vector {
        match &self.model.body {
            Some(body) => states(body).map(|state| self.graph.symbol(Symbol::State(state as u32))),
            None => frames::zero(&mut self.graph),
        }
    }

    /// Angular velocity of the body, rad/s, in `Rotation::angular_velocity_frame`.
    pub(crate) fn spin(&mut self) -> Vector {
        match self.model.rotation() {
            Some(rotation) => {
                self.angular_velocity(rotation.body_frame, rotation.angular_velocity_frame)
            }
            None => frames::zero(&mut self.graph),
        }
    }

    fn named(&mut self, function: Named, x: NodeId) -> NodeId {
        let graph = &mut self.graph;
        match FunctionLowering::of(function) {
            FunctionLowering::Call(function) => graph.call(function, x),
            FunctionLowering::Tan => {
                let sin = graph.call(MathFunction::Sin, x);
                let cos = graph.call(MathFunction::Cos, x);
                graph.div(sin, cos)
            }
            FunctionLowering::Acos => {
                let asin = graph.call(MathFunction::Asin, x);
                let pi = graph.symbol(Symbol::Pi);
                let terms = vec![(Number::fraction(1, 2), pi), (Number::MINUS_ONE, asin)];
                graph.sum(terms, Number::ZERO)
            }
            FunctionLowering::Atan => {
                let one = graph.whole(1);
                graph.call2(BinaryFunction::Atan2, x, one)
            }
        }
    }
}

fn first(value: Value) -> NodeId {
    match value {
        Value::Scalar(node) => node,
        Value::Vector(vector) => vector[0],
    }
}
