//! Values of nodes at points near a model's defaults, by which pivots are chosen.

use crate::functions::{BinaryFunction, MathFunction};
use crate::graph::{ExprGraph, Node, NodeId, Symbol};
use crate::layout::Layout;
use model_spec::model::Model;

/// Number of points near the defaults, and of further ones that are far from them.
pub(crate) const POINTS: usize = 5;
const FAR_POINTS: usize = 24;

/// States and parameters at which nodes are evaluated.
#[derive(Clone, Debug)]
pub(crate) struct Typical {
    states: Vec<f64>,
    parameters: Vec<f64>,
}

impl Typical {
    /// The defaults, and points around them at irregular distances, the far ones beyond half a turn; quaternions are of
    /// unit norm, since entries that vanish for these are no pivots.
    pub fn points(model: &Model, layout: &Layout) -> Vec<Typical> {
        let moved = |values: &[f64], point: usize, size: fn(f64) -> f64| -> Vec<f64> {
            let values = values.iter().enumerate();
            let irregular = |k: usize| (1.7 * k as f64 + 2.9 * point as f64).sin();
            { values.map(|(k, v)| v + point.min(1) as f64 * size(*v) * irregular(k)) }.collect()
        };
        let states = |point: usize| {
            let size = match point < POINTS {
                true => |v: f64| 0.5 * v.abs().max(1.0),
                false => |v: f64| 4.0 * v.abs().max(1.0),
            };
            let mut states = moved(&layout.initial, point, size);
            for quaternion in model.quaternions() {
                let norm = quaternion
                    .map(|k| states[k].powi(2))
                    .iter()
                    .sum::<f64>()
                    .sqrt();
                for k in quaternion.into_iter().filter(|_| norm > 0.0) {
                    states[k] /= norm;
                }
            }
            states
        };
        (0..POINTS + FAR_POINTS)
            .map(|point| Typical {
                states: states(point),
                parameters: moved(&layout.defaults, point, |v| 0.1 * v.abs()),
            })
            .collect()
    }

    /// Values of nodes at the point.
    pub fn values(&self, graph: &ExprGraph, nodes: &[NodeId]) -> Vec<f64> {
        let mut values = vec![0.0; graph.len()];
        for id in graph.reachable(nodes) {
            values[id.index()] = self.value(graph, id, &values);
        }
        nodes.iter().map(|id| values[id.index()]).collect()
    }

    fn value(&self, graph: &ExprGraph, id: NodeId, values: &[f64]) -> f64 {
        let of = |id: &NodeId| values[id.index()];
        match graph.node(id) {
            Node::Number(number) => number.value(),
            Node::Symbol(symbol) => match symbol {
                Symbol::Pi => std::f64::consts::PI,
                Symbol::State(k) => self.states[*k as usize],
                Symbol::Parameter(k) => self.parameters[*k as usize],
                Symbol::Time | Symbol::Marker(_) | Symbol::Local(_) => 0.0,
            },
            Node::Sum(terms, constant) => {
                let terms = terms.iter().map(|(factor, term)| factor.value() * of(term));
                constant.value() + terms.sum::<f64>()
            }
            Node::Product(factors) => { factors.iter() }
                .map(|(base, doubled)| match of(base) {
                    base if base == 0.0 || (base < 0.0 && doubled % 2 != 0) => 0.0,
                    base if doubled % 2 == 0 => base.powi(doubled / 2),
                    base => base.sqrt().powi(*doubled),
                })
                .product(),
            Node::Call(function, x) => MathFunction::eval(*function, of(x), graph.tables()),
            Node::Call2(BinaryFunction::Atan2, y, x) => of(y).atan2(of(x)),
            Node::Call2(BinaryFunction::Min, a, b) => of(a).min(of(b)),
            Node::Call2(BinaryFunction::Max, a, b) => of(a).max(of(b)),
            Node::Call2(BinaryFunction::Table(function), a, b) => {
                let table = graph.tables().table(function.table());
                table.bicubic().eval(of(a), of(b), function.orders())
            }
            Node::IfZero(condition, a, _) if of(condition) == 0.0 => of(a),
            Node::IfZero(_, _, b) => of(b),
        }
    }
}
