//! LaTeX of expression graph nodes.

use super::names::{Style, name};
use super::piece::Piece;
use super::tree;
use crate::functions::{BinaryFunction, MathFunction};
use crate::graph::{ExprGraph, Node, NodeId, Symbol};
use crate::number::Number;

pub(crate) fn piece(
    graph: &ExprGraph,
    id: NodeId,
    leaf: &dyn Fn(NodeId, Symbol) -> Piece,
) -> Piece {
    let of = |id: NodeId| piece(graph, id, leaf);
    match graph.node(id) {
        Node::Number(value) => number(*value),
        Node::Symbol(symbol) => leaf(id, *symbol),
        Node::Sum(terms, constant) => sum(graph, terms, *constant, &of),
        Node::Product(factors) => product(graph, factors, &of),
        Node::Call(MathFunction::Table(function), x) => {
            let table = &graph.tables().table(function.table()).name;
            // A prime for each order of the derivative.
            let primes = "'".repeat(usize::from(function.orders()[0]));
            tree::table(name(table, Style::Scalar) + &primes, of(*x))
        }
        Node::Call(function, x) => tree::call(function.notation(), of(*x)),
        Node::Call2(BinaryFunction::Table(function), a, b) => {
            let table = &graph.tables().table(function.table()).name;
            let orders = match function.orders() {
                [0, 0] => String::new(),
                [by_first, by_second] => format!("^{{({by_first},{by_second})}}"),
            };
            let name = name(table, Style::Scalar) + &orders;
            tree::table_of_two(name, of(*a), of(*b))
        }
        Node::Call2(function, a, b) => tree::call2(*function, of(*a), of(*b)),
        Node::IfZero(c, a, b) => {
            let case = format!("{} = 0", of(*c).text);
            Piece::cases(of(*b), of(*a), &case)
        }
    }
}

fn number(value: Number) -> Piece {
    match value {
        // Only fractions with a denominator up to 64 are written as fractions.
        Number::Exact(n, d) if d > 1 && d <= 64 => {
            let above = Piece::number(n.unsigned_abs() as f64);
            let fraction = above.div(Piece::number(d as f64));
            if n < 0 { fraction.neg() } else { fraction }
        }
        other => Piece::number(other.value()),
    }
}

fn sum(
    graph: &ExprGraph,
    terms: &[(Number, NodeId)],
    constant: Number,
    of: &dyn Fn(NodeId) -> Piece,
) -> Piece {
    let mut parts: Vec<(bool, Piece)> = terms
        .iter()
        .map(|&(coefficient, term)| {
            (
                coefficient.is_negative(),
                scaled(graph, coefficient, term, of),
            )
        })
        .collect();
    if !constant.is_zero() {
        parts.push((constant.is_negative(), number(constant.abs())));
    }
    // A positive term, if any, comes first.
    if let Some(first) = parts.iter().position(|(minus, _)| !minus) {
        let part = parts.remove(first);
        parts.insert(0, part);
    }
    let mut parts = parts.into_iter();
    let Some((minus, first)) = parts.next() else {
        return Piece::number(0.0);
    };
    let first = if minus { first.neg() } else { first };
    parts.fold(
        first,
        |sum, (minus, part)| {
            if minus { sum.sub(part) } else { sum.add(part) }
        },
    )
}

/// LaTeX of a term multiplied by the absolute value of its coefficient.
fn scaled(
    graph: &ExprGraph,
    coefficient: Number,
    term: NodeId,
    of: &dyn Fn(NodeId) -> Piece,
) -> Piece {
    let coefficient = coefficient.abs();
    if coefficient.is_one() {
        return of(term);
    }
    match (graph.node(term), coefficient) {
        // Merges the coefficient and the product into one fraction.
        (Node::Product(factors), Number::Exact(n, d)) if d > 1 && d <= 64 => {
            fraction(graph, factors, Number::whole(n), Number::whole(d), of)
        }
        (Node::Product(factors), _) => fraction(graph, factors, coefficient, Number::ONE, of),
        _ => number(coefficient).mul(of(term)),
    }
}

fn product(graph: &ExprGraph, factors: &[(NodeId, i32)], of: &dyn Fn(NodeId) -> Piece) -> Piece {
    fraction(graph, factors, Number::ONE, Number::ONE, of)
}

fn fraction(
    graph: &ExprGraph,
    factors: &[(NodeId, i32)],
    above: Number,
    below: Number,
    of: &dyn Fn(NodeId) -> Piece,
) -> Piece {
    let mut factors = factors.to_vec();
    // Constant factors come first.
    factors.sort_by_key(|(base, _)| !graph.facts(*base).fixed);
    let side = |coefficient: Number, wanted: &dyn Fn(i32) -> bool| {
        let start = (!coefficient.is_one()).then(|| number(coefficient));
        factors
            .iter()
            .filter(|(_, exponent)| wanted(*exponent))
            .map(|&(base, exponent)| of(base).power(exponent.abs()))
            .fold(start, |product, factor| {
                Some(match product {
                    Some(product) => product.mul(factor),
                    None => factor,
                })
            })
    };
    let top = side(above, &|exponent| exponent > 0).unwrap_or_else(|| Piece::number(1.0));
    match side(below, &|exponent| exponent < 0) {
        Some(bottom) => top.div(bottom),
        None => top,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nodes_have_the_parentheses_they_need() {
        let mut g = ExprGraph::default();
        let [a, b, c] = [0, 1, 2].map(|k| g.symbol(Symbol::State(k)));
        let one = g.whole(1);
        let sum = g.add(a, b);
        let cases = [
            (g.mul(sum, c), "c (a + b)"),
            (g.div(a, sum), r"\frac{a}{a + b}"),
            (g.power(sum, -4), r"\frac{1}{(a + b)^2}"),
            (g.power(sum, 3), r"\sqrt{a + b}^3"),
            (g.sub(c, sum), "c - a - b"),
            (g.neg(a), "-a"),
            (g.sub(b, one), "b - 1"),
            (
                g.sum(vec![(Number::fraction(-3, 2), a)], Number::ONE),
                r"1 - \frac{3}{2} a",
            ),
            (g.call(MathFunction::Sin, sum), r"\sin(a + b)"),
            (g.call(MathFunction::Abs, a), r"\left|a\right|"),
            (
                g.call2(BinaryFunction::Atan2, a, sum),
                r"\operatorname{atan2}(a,\, a + b)",
            ),
            (
                g.if_zero(c, a, b),
                r"\begin{cases} a & c = 0 \\ b & \text{otherwise} \end{cases}",
            ),
        ];
        let leaf = |_: NodeId, symbol: Symbol| match symbol {
            Symbol::State(k) => Piece::atom(["a", "b", "c"][k as usize]),
            other => Piece::atom(format!("{other:?}")),
        };
        for (node, latex) in cases {
            assert_eq!(piece(&g, node, &leaf).text, latex);
        }
    }
}
