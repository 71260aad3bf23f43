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
                let (c, lowered) = by_factor(graph, &factors, k, cofactor);
                collect(graph, factors[k].0, coefficient.times(c), lowered, found);
            }
        }
        _ => found.add(id, (coefficient, cofactor)),
    }
}

/// Derivative of a product by the base of its factor number `k`, times `cofactor`: a coefficient and a product.
fn by_factor(
    graph: &mut ExprGraph,
    factors: &[(NodeId, i32)],
    k: usize,
    cofactor: NodeId,
) -> (Number, NodeId) {
    let exponent = factors[k].1;
    let mut others = factors.to_vec();
    // d/dx of x^(e/2) is e/2 x^(e/2 - 1); at x = 0 the guarded reciprocal makes the derivative 0.
    others[k].1 = exponent - 2;
    others.push((cofactor, 2));
    (Number::fraction(exponent.into(), 2), graph.product(others))
}

/// Derivative of an expression by a symbol.
pub(crate) fn total(graph: &mut ExprGraph, id: NodeId, by: Symbol) -> NodeId {
    let one = graph.whole(1);
    along(graph, id, &[(by, one)])
}

/// Derivative of an expression in the direction in which some symbols change, each at its rate.
pub(crate) fn along(graph: &mut ExprGraph, id: NodeId, moving: &[(Symbol, NodeId)]) -> NodeId {
    let mut sweep = Sweep {
        moving,
        known: FastMap::default(),
        leaves: FastMap::default(),
    };
    sweep.derivative(graph, id)
}

/// Maximum number of places of leaves in a sum of products that is differentiated as a whole. Where sums share parts, the
/// number doubles with each level.
const MAX_LEAVES: u64 = 4096;

/// One forward sweep.
struct Sweep<'m> {
    moving: &'m [(Symbol, NodeId)],
    known: FastMap<NodeId, NodeId>,
    leaves: FastMap<NodeId, u64>,
}

impl Sweep<'_> {
    fn derivative(&mut self, graph: &mut ExprGraph, id: NodeId) -> NodeId {
        if let Some(&derivative) = self.known.get(&id) {
            return derivative;
        }
        let derivative = match *graph.node(id) {
            Node::Number(_) => graph.whole(0),
            Node::Symbol(symbol) => {
                match (self.moving.iter().find(|own| own.0 == symbol), symbol) {
                    (Some(&(_, rate)), _) => rate,
                    (None, Symbol::Local(k)) => {
                        let definition = graph.definition(k);
                        self.derivative(graph, definition)
                    }
                    (None, _) => graph.whole(0),
                }
            }
            _ => {
                let partials = match self.count_leaves(graph, id) <= MAX_LEAVES {
                    true => of_operation(graph, id),
                    false => of_operands(graph, id),
                };
                let terms = partials.into_iter().map(|(operand, partial)| {
                    let inner = self.derivative(graph, operand);
                    (Number::ONE, graph.mul(partial, inner))
                });
                let terms = terms.collect();
                graph.sum(terms, Number::ZERO)
            }
        };
        self.known.insert(id, derivative);
        derivative
    }

    /// Number of places of leaves in a sum of products, at most `u64::MAX`.
    fn count_leaves(&mut self, graph: &ExprGraph, id: NodeId) -> u64 {
        if let Some(&count) = self.leaves.get(&id) {
            return count;
        }
        let inner: Vec<NodeId> = match graph.node(id) {
            Node::Sum(terms, _) => terms.iter().map(|own| own.1).collect(),
            Node::Product(factors) => factors.iter().map(|own| own.0).collect(),
            _ => return 1,
        };
        let count = inner.into_iter().fold(0_u64, |sum, part| {
            sum.saturating_add(self.count_leaves(graph, part))
        });
        self.leaves.insert(id, count);
        count
    }
}

/// Terms of a sum or factors of a product, each with the partial derivative with respect to it.
fn of_operands(graph: &mut ExprGraph, id: NodeId) -> Vec<(NodeId, NodeId)> {
    match graph.node(id).clone() {
        Node::Sum(terms, _) => {
            let partials = terms.into_iter();
            let partials = partials.map(|(factor, term)| (term, graph.number(factor)));
            partials.collect()
        }
        Node::Product(factors) => {
            let one = graph.whole(1);
            let partials = (0..factors.len()).map(|k| {
                let (coefficient, lowered) = by_factor(graph, &factors, k, one);
                let coefficient = graph.number(coefficient);
                (factors[k].0, graph.mul(coefficient, lowered))
            });
            partials.collect()
        }
        _ => of_node(graph, id),
    }
}

/// Partial derivatives of any operation with respect to its operands, those of nested sums and products included.
pub(crate) fn of_operation(graph: &mut ExprGraph, id: NodeId) -> Vec<(NodeId, NodeId)> {
    match graph.node(id) {
        Node::Sum(..) | Node::Product(_) => of_expression(graph, id),
        _ => of_node(graph, id),
    }
}

#[cfg(test)]
mod tests {
    use crate::tape_model::{At, Scratch};
    use crate::{TapeModel, compile};
    use model_spec::load::from_text;

    /// Each level has the one below twice, so that the terms of the last one, written out, are more than a sweep
    /// differentiates as a whole.
    #[test]
    fn sums_that_share_parts_are_differentiated_in_one_sweep() {
        let levels = 16;
        let level = |k: i32| format!("let b_{k} = c*b_{} + d*(b_{} + 1);\n", k - 1, k - 1);
        let text = format!(
            "model probe; frame N; param c = 0.25; param d = 0.5; state x = 2; state v = 0;
             let b_0 = x;\n{}der(x) = 3 [/s]; der(v) = der(b_{levels});",
            (1..=levels).map(level).collect::<String>()
        );
        let model = from_text("probe.hyz", &text, &[]).unwrap_or_else(|error| panic!("{error}"));
        let tape = TapeModel::new(&compile(&model));
        let parameters = [0.25, 0.5];
        let at = At {
            t: 0.0,
            x: &[2.0, 0.0],
            p: &parameters,
            prepared: &tape.prepare(&parameters),
        };
        let mut rates = [0.0; 2];
        tape.f
            .eval(at, &[], &mut Scratch::default(), &mut [&mut rates]);
        let expected = 3.0 * 0.75_f64.powi(levels);
        assert!((rates[1] / expected - 1.0).abs() < 1e-12, "{rates:?}");
    }
}
