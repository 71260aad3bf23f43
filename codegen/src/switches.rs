//! Arguments of the functions that switch, such as `tanh`, `step` and tables: between two levels of such an argument the
//! equations of motion may differ from what they are on both sides.

use crate::compile::{dense, scheduled_values};
use crate::functions::{BinaryFunction, MathFunction};
use crate::graph::{ExprGraph, Node, NodeId, Symbol};
use crate::lower::{Lowered, lower};
use crate::program::Function;
use crate::tape_model::TapeFunction;
use lanes::{Level, Switch};
use model_spec::model::{Expr, ExprKind, Function as Named, Model};

/// Levels of the argument of an exponential or a hyperbolic tangent. Beyond the last, e^-32 = 1e-14 is a rounding error;
/// with fewer between them, some of the pulses of the tests are flown over.
const SMOOTH_LEVELS: [f64; 6] = [-32.0, -8.0, -2.0, 2.0, 8.0, 32.0];

/// Arguments of the functions of a model's equations of motion that switch.
#[derive(Clone, Debug)]
pub struct Switches {
    /// Computes the arguments from time, state and parameters, without invariants; one within another comes first.
    pub arguments: TapeFunction,
    /// Levels of each argument, which separate the pieces of its functions: knots, zeros.
    pub switches: Vec<Switch>,
}

impl Switches {
    /// Switches of `model` that depend on the state or the time; `None` if there are none. Kinks and jumps of functions
    /// of the time alone are left out unless `at_times`: where each is the end of a step, no step passes one.
    pub fn of(model: &Model, at_times: bool) -> Option<Switches> {
        if !model.expressions().into_iter().any(has_switch) {
            return None;
        }
        let Lowered {
            mut graph,
            layout,
            dx,
            ..
        } = lower(model);
        let (arguments, switches) = collected(&mut graph, &dx, at_times);
        if arguments.is_empty() {
            return None;
        }
        let function = Function {
            name: "switches",
            program: scheduled_values(&mut graph, &layout, &arguments),
            sections: vec![dense("switches", arguments.len())],
            results: Vec::new(),
        };
        Some(Switches {
            arguments: TapeFunction::new(&function),
            switches,
        })
    }
}

/// Whether an expression has a function that may switch: the graph of most models need not be built for an answer.
fn has_switch(expression: &Expr) -> bool {
    expression.nodes().any(|e| match &e.kind {
        ExprKind::Lookup(..) | ExprKind::Min(..) | ExprKind::Max(..) | ExprKind::RealPower(..) => {
            true
        }
        ExprKind::Call(function, _) => {
            !matches!(function, Named::Sin | Named::Cos | Named::Tan | Named::Atan)
        }
        _ => false,
    })
}

/// Nodes of the arguments on which `roots` depend, inner ones first, and their levels.
fn collected(
    graph: &mut ExprGraph,
    roots: &[NodeId],
    at_times: bool,
) -> (Vec<NodeId>, Vec<Switch>) {
    let (mut arguments, mut switches): (Vec<NodeId>, Vec<Switch>) = Default::default();
    let mut motion = Motion::default();
    for node in graph.reachable(roots) {
        for (argument, own, may_end_steps) in switched(graph, node) {
            let moves = motion.of(graph, argument);
            if !(moves.by_state || moves.by_time && (at_times || !may_end_steps)) {
                continue;
            }
            let known = arguments.iter().position(|known| *known == argument);
            let place = known.unwrap_or_else(|| {
                arguments.push(argument);
                switches.push(Switch::default());
                arguments.len() - 1
            });
            switches[place].levels.extend(own);
        }
    }
    for node in graph.reachable(&arguments) {
        if let Node::Call(MathFunction::Sin | MathFunction::Cos, phase) = *graph.node(node) {
            let moves = motion.of(graph, phase);
            if (moves.by_time || moves.by_state) && !arguments.contains(&phase) {
                arguments.push(phase);
                switches.push(Switch {
                    levels: Vec::new(),
                    is_phase: true,
                });
            }
        }
    }
    for Switch { levels, .. } in &mut switches {
        // Of equal ones the kink comes first, and is kept.
        levels.sort_by(|a, b| a.value.total_cmp(&b.value).then(b.is_kink.cmp(&a.is_kink)));
        levels.dedup_by_key(|level| level.value);
    }
    (arguments, switches)
}

/// Arguments of the function of a node with their levels, and whether these may be ends of steps if it is a function of
/// the time alone.
fn switched(graph: &mut ExprGraph, node: NodeId) -> Vec<(NodeId, Vec<Level>, bool)> {
    use MathFunction as F;
    if let Node::Product(factors) = graph.node(node) {
        // A power with a half in its exponent is 0 where its base is below 0.
        let odd = factors.iter().filter(|(_, doubled)| doubled % 2 != 0);
        let odd = odd.filter(|(base, _)| !graph.facts(*base).nonneg);
        return odd.map(|(base, _)| (*base, kinks(&[0.0]), false)).collect();
    }
    match *graph.node(node) {
        Node::Call(F::Exp | F::Tanh, x) => vec![(x, levels(&SMOOTH_LEVELS, |_| false), false)],
        Node::Call(F::Asin, x) => vec![(x, kinks(&[-1.0, 1.0]), false)],
        Node::Call(F::Log | F::Sqrt, x) if !graph.facts(x).nonneg => {
            vec![(x, kinks(&[0.0]), false)]
        }
        Node::Call(F::Abs | F::Sign | F::Heaviside, x) if !graph.facts(x).nonneg => {
            vec![(x, kinks(&[0.0]), true)]
        }
        Node::Call(F::Table(table), x) => {
            let is_linear = graph.tables().table(table.table()).is_linear;
            let own = levels(graph.tables().of(table).knots(), |_| is_linear);
            vec![(x, own, true)]
        }
        Node::Call2(BinaryFunction::Min | BinaryFunction::Max, a, b) => {
            vec![(graph.sub(a, b), kinks(&[0.0]), true)]
        }
        Node::Call2(BinaryFunction::Table(table), a, b) => {
            let table = graph.tables().table(table.table());
            let is_linear = table.is_linear;
            let knots = table
                .bicubic()
                .knots()
                .map(|knots| levels(knots, |_| is_linear));
            let both = [a, b].into_iter().zip(knots);
            both.map(|(x, own)| (x, own, true)).collect()
        }
        _ => Vec::new(),
    }
}

/// Levels at `values`; whether the one with an index is a kink.
fn levels(values: &[f64], is_kink: impl Fn(usize) -> bool) -> Vec<Level> {
    let level = |(k, &value)| Level {
        value,
        is_kink: is_kink(k),
    };
    values.iter().enumerate().map(level).collect()
}

fn kinks(values: &[f64]) -> Vec<Level> {
    levels(values, |_| true)
}

/// What a value changes with during a flight.
#[derive(Clone, Copy, Default)]
struct Moves {
    /// With the state, or with an input over time.
    by_state: bool,
    by_time: bool,
}

/// What each node of a graph so far changes with.
#[derive(Default)]
struct Motion(Vec<Moves>);

impl Motion {
    fn of(&mut self, graph: &ExprGraph, node: NodeId) -> Moves {
        // Operands are created before their users.
        for k in self.0.len()..graph.len() {
            let id = NodeId::new(k);
            let mut moves = Moves::default();
            match graph.node(id) {
                Node::Symbol(Symbol::State(_)) => moves.by_state = true,
                Node::Symbol(Symbol::Parameter(_)) => moves.by_state = !graph.facts(id).fixed,
                Node::Symbol(Symbol::Time) => moves.by_time = true,
                _ => {}
            }
            graph.for_operands(id, |operand| {
                let own = self.0[operand.index()];
                moves.by_state |= own.by_state;
                moves.by_time |= own.by_time;
            });
            self.0.push(moves);
        }
        self.0[node.index()]
    }
}
