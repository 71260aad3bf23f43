//! Plain text of expression nodes.

use codegen::graph::{ExprGraph, Node, NodeId, Symbol};
use codegen::number::Number;

/// Returns the expression of a node as plain text; `symbol` returns the name of a leaf.
pub fn show(graph: &ExprGraph, id: NodeId, symbol: &dyn Fn(Symbol) -> String) -> String {
    shown(graph, id, symbol, 0)
}

/// Returns the expression of a node as text, in parentheses if the context `level` requires them: 0 in a sum, 1 in
/// a product, 2 as the base of a power.
fn shown(graph: &ExprGraph, id: NodeId, symbol: &dyn Fn(Symbol) -> String, level: u8) -> String {
    let inner = |id: NodeId, level: u8| shown(graph, id, symbol, level);
    let parenthesise = |text: String, needed: bool| if needed { format!("({text})") } else { text };
    match graph.node(id) {
        Node::Number(number) => {
            parenthesise(number_text(*number), level > 0 && number.is_negative())
        }
        Node::Symbol(leaf) => symbol(*leaf),
        Node::Sum(terms, constant) => {
            let mut text = String::new();
            for &(coefficient, term) in terms {
                let sign = match (coefficient.is_negative(), text.is_empty()) {
                    (false, true) => "",
                    (true, true) => "-",
                    (false, false) => " + ",
                    (true, false) => " - ",
                };
                text.push_str(sign);
                if !coefficient.abs().is_one() {
                    text.push_str(&format!("{}*", number_text(coefficient.abs())));
                }
                text.push_str(&inner(term, 1));
            }
            if !constant.is_zero() {
                text.push_str(if constant.is_negative() { " - " } else { " + " });
                text.push_str(&number_text(constant.abs()));
            }
            parenthesise(text, level > 0)
        }
        Node::Product(factors) => {
            let parts: Vec<String> = factors
                .iter()
                .map(|&(base, exponent)| {
                    let power = Number::fraction(exponent.into(), 2);
                    if power.is_one() {
                        inner(base, 1)
                    } else {
                        format!("{}^{}", inner(base, 2), power_text(power))
                    }
                })
                .collect();
            parenthesise(parts.join("*"), level > 1)
        }
        Node::Call(function, x) => {
            format!("{}({})", graph.function_name(*function), inner(*x, 0))
        }
        Node::Call2(function, a, b) => {
            let name = format!("{function:?}").to_lowercase();
            format!("{name}({}, {})", inner(*a, 0), inner(*b, 0))
        }
        Node::IfZero(c, a, b) => format!(
            "if_zero({}, {}, {})",
            inner(*c, 0),
            inner(*a, 0),
            inner(*b, 0)
        ),
    }
}

fn number_text(number: Number) -> String {
    match number {
        Number::Exact(n, 1) => n.to_string(),
        Number::Exact(n, d) => format!("{n}/{d}"),
        Number::Float(x) => format!("{x}"),
    }
}

fn power_text(power: Number) -> String {
    match power {
        Number::Exact(n, 1) if n > 0 => n.to_string(),
        other => format!("({})", number_text(other)),
    }
}
