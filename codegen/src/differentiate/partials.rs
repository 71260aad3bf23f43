//! Exact partial derivatives of single nodes, with defined values at singular points.

use crate::functions::{BinaryFunction, Derivative, MathFunction};
use crate::graph::{ExprGraph, FastMap, Node, NodeId, Symbol};
use crate::number::Number;

fn of_call(graph: &mut ExprGraph, function: MathFunction, x: NodeId, value: NodeId) -> NodeId {
    match function.derivative() {
        Derivative::Zero => graph.whole(0),
        Derivative::Value => value,
        Derivative::Call(other) => graph.call(other, x),
        Derivative::Opposite(other) => {
            let other = graph.call(other, x);
            graph.neg(other)
        }
        Derivative::OneMinusValueSquared => one_minus_square(graph, value),
        Derivative::InverseRootOfOneMinusSquare => {
            let complement = one_minus_square(graph, x);
            let root = graph.sqrt(complement);
            graph.power(root, -2)
        }
        Derivative::ReciprocalAboveZero => {
            let above = graph.call(MathFunction::Heaviside, x);
            graph.div(above, x)
        }
        Derivative::HalfOverValue => {
            let half = graph.number(Number::fraction(1, 2));
            graph.div(half, value)
        }
    }
}

fn one_minus_square(graph: &mut ExprGraph, x: NodeId) -> NodeId {
    let square = graph.power(x, 4);
    graph.sum(vec![(Number::MINUS_ONE, square)], Number::ONE)
}

/// Operands of a node that is neither sum nor product, each with the partial derivative with respect to that operand.
pub(crate) fn of_node(graph: &mut ExprGraph, id: NodeId) -> Vec<(NodeId, NodeId)> {
    match graph.node(id).clone() {
        Node::Number(_) | Node::Symbol(_) | Node::Sum(..) | Node::Product(_) => Vec::new(),
        Node::Call(function, x) => vec![(x, of_call(graph, function, x, id))],
        Node::Call2(BinaryFunction::Atan2, y, x) => {
            let (yy, xx) = (graph.power(y, 4), graph.power(x, 4));
            let square = graph.add(yy, xx);
            let by_y = graph.div(x, square);
            let by_x = graph.div(y, square);
            let by_x = graph.neg(by_x);
            vec![(y, by_y), (x, by_x)]
        }
        Node::Call2(BinaryFunction::Table(function), a, b) => {
            let partials = [a, b].into_iter().enumerate().map(|(k, argument)| {
                let partial = match function.derivative(k) {
                    Some(slope) => graph.call2(BinaryFunction::Table(slope), a, b),
                    None => graph.whole(0),
                };
                (argument, partial)
            });
            partials.collect()
        }
        Node::Call2(function, a, b) => {
            let difference = match function {
                BinaryFunction::Min => graph.sub(b, a),
                _ => graph.sub(a, b),
            };
            let first = graph.call(MathFunction::Heaviside, difference);
            let second = graph.sum(vec![(Number::MINUS_ONE, first)], Number::ONE);
            vec![(a, first), (b, second)]
        }
        Node::IfZero(condition, a, b) => {
            let other = graph.call(MathFunction::NonZero, condition);
            let here = graph.sum(vec![(Number::MINUS_ONE, other)], Number::ONE);
            vec![(a, here), (b, other)]
        }
    }
}

/// Leaves of a sum of products, each with the partial derivative with respect to it.
pub(crate) fn of_expression(graph: &mut ExprGraph, id: NodeId) -> Vec<(NodeId, NodeId)> {
    let mut found = PartialSums::default();
    let one = graph.whole(1);
    collect(graph, id, Number::ONE, one, &mut found);
    found
        .sums
        .into_iter()
        .map(|(vertex, terms)| (vertex, graph.sum(terms, Number::ZERO)))
        .collect()
}

/// Terms of partial derivatives by node, in order of first occurrence.
#[derive(Default)]
struct PartialSums {
    sums: Vec<(NodeId, Vec<(Number, NodeId)>)>,
    place_of: FastMap<NodeId, usize>,
}

impl PartialSums {
    fn add(&mut self, vertex: NodeId, term: (Number, NodeId)) {
        let next = self.sums.len();
        let place = *self.place_of.entry(vertex).or_insert(next);
        if place == next {
            self.sums.push((vertex, Vec::new()));
        }
        self.sums[place].1.push(term);
    }
}

fn collect(
    graph: &mut ExprGraph,
    id: NodeId,
    coefficient: Number,
    cofactor: NodeId,
    found: &mut PartialSums,
) {
    match graph.node(id).clone() {
        Node::Number(_) | Node::Symbol(Symbol::Pi) => {}
        Node::Sum(terms, _) => {
            for &(c, term) in &terms {
                collect(graph, term, coefficient.times(c), cofactor, found);
            }
        }
        Node::Product(factors) => {
            for k in 0..factors.len() {
                let (base, exponent) = factors[k];
                let mut others = factors.to_vec();
                // d/dx of x^(e/2) is e/2 x^(e/2 - 1); at x = 0 the guarded reciprocal makes the derivative 0.
                others[k].1 = exponent - 2;
                others.push((cofactor, 2));
                let lowered = graph.product(others);
                let c = coefficient.times(Number::fraction(exponent.into(), 2));
                collect(graph, base, c, lowered, found);
            }
        }
        _ => found.add(id, (coefficient, cofactor)),
    }
}

pub(crate) fn total(graph: &mut ExprGraph, id: NodeId, by: Symbol) -> NodeId {
    let mut known = FastMap::default();
    total_of(graph, id, by, &mut known)
}

fn total_of(
    graph: &mut ExprGraph,
    id: NodeId,
    by: Symbol,
    known: &mut FastMap<NodeId, NodeId>,
) -> NodeId {
    if let Some(&derivative) = known.get(&id) {
        return derivative;
    }
    let derivative = match graph.node(id).clone() {
        Node::Number(_) => graph.whole(0),
        Node::Symbol(symbol) if symbol == by => graph.whole(1),
        Node::Symbol(Symbol::Local(k)) => {
            let definition = graph.definition(k);
            total_of(graph, definition, by, known)
        }
        Node::Symbol(_) => graph.whole(0),
        _ => {
            let partials = of_operation(graph, id).into_iter();
            let terms = partials.map(|(operand, partial)| {
                let inner = total_of(graph, operand, by, known);
                (Number::ONE, graph.mul(partial, inner))
            });
            let terms = terms.collect();
            graph.sum(terms, Number::ZERO)
        }
    };
    known.insert(id, derivative);
    derivative
}

/// Partial derivatives of any operation with respect to its operands, those of nested sums and products included.
pub(crate) fn of_operation(graph: &mut ExprGraph, id: NodeId) -> Vec<(NodeId, NodeId)> {
    match graph.node(id) {
        Node::Sum(..) | Node::Product(_) => of_expression(graph, id),
        _ => of_node(graph, id),
    }
}
