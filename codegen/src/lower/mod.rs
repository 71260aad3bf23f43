//! Lowering: translates the vector expressions of a model to scalar graph nodes.

mod expressions;
pub mod frames;
mod inertia;
mod linear;
mod motion;
mod solve;
mod systems;
mod typical;

use crate::graph::{ExprGraph, NodeId, Symbol};
use crate::layout::{Layout, needed};
use crate::table::Tables;
use frames::{Frames, Vector};
use model_spec::diagnostic::Span;
use model_spec::location::trimmed_line;
use model_spec::model::{Expr, ExprKind, Model};
use std::collections::HashSet;

/// Provenance of a named node: name and source location in the model text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Provenance {
    pub name: String,
    pub span: Span,
    pub source: String,
    pub line: usize,
    /// Text of the source line, without surrounding whitespace.
    pub text: String,
}

/// Lowered model: equations of motion and all outputs as nodes of one graph of scalar expressions.
#[derive(Clone, Debug, Default)]
pub struct Lowered {
    /// Expression graph that contains all nodes of the model.
    pub graph: ExprGraph,
    /// Names and order of the states, parameters, marker coordinates and auxiliary variables in arrays.
    pub layout: Layout,
    /// Time derivatives of the states, in the order of `Layout::states`.
    pub dx: Vec<NodeId>,
    /// Observed position, m, in the inertial frame.
    pub observation: Option<Vector>,
    /// Name and node of each of [`Layout::quantities`].
    pub quantities: Vec<(String, NodeId)>,
    /// Left-hand sides of the limits of validity, in order.
    pub limits: Vec<NodeId>,
    /// Names and source locations of the named nodes, in the order in which the names were first assigned.
    pub provenance: Vec<Provenance>,
    /// Values of all auxiliary variables, in order of declaration: one node for a scalar, three for a vector.
    pub lets: Vec<Vec<NodeId>>,
}

/// Value of a model expression: a scalar node or a vector of three nodes.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Value {
    Scalar(NodeId),
    Vector(Vector),
}

impl Value {
    pub(crate) fn map(self, mut change: impl FnMut(NodeId) -> NodeId) -> Value {
        match self {
            Value::Scalar(node) => Value::Scalar(change(node)),
            Value::Vector(vector) => Value::Vector(vector.map(change)),
        }
    }
}

pub(crate) struct Lowering<'a> {
    pub(crate) model: &'a Model,
    pub(crate) frames: Frames<'a>,
    pub(crate) graph: ExprGraph,
    pub(crate) layout: Layout,
    pub(crate) lets: Vec<Value>,
    /// In `Rotation::angular_velocity_frame`, once lowered: rates of the components of the angular velocity, rad/s²,
    /// and the angular velocity of the frame, rad/s.
    pub(crate) component_rates: Option<(Vector, Vector)>,
    /// Unknowns of each system: local symbols until it is solved.
    pub(crate) unknowns: Vec<Vec<NodeId>>,
    /// For each system, [`ExprKind::Determinacy`].
    pub(crate) determinacies: Vec<NodeId>,
    /// Whether values depend on unknowns that are not solved for yet, so that nodes are not named.
    pub(crate) is_provisional: bool,
    pub(crate) provenance: Vec<Provenance>,
    /// Names of the nodes whose source location is already in `provenance`.
    pub(crate) recorded: HashSet<String>,
}

pub fn lower(model: &Model) -> Lowered {
    let layout = Layout::new(model);
    let varying = layout.varying.iter().map(|id| id.index() as u32);
    let mut lowering = Lowering {
        model,
        frames: Frames {
            model,
            constant_angles: Vec::new(),
        },
        graph: ExprGraph::with_tables(Tables::of_model(model), varying.collect()),
        layout,
        lets: Vec::new(),
        component_rates: None,
        unknowns: Vec::new(),
        determinacies: Vec::new(),
        is_provisional: false,
        provenance: Vec::new(),
        recorded: HashSet::new(),
    };
    lowering.leaves();
    lowering.constant_angles();
    lowering.assumptions();
    lowering.systems();
    let of_motion = crate::layout::depends_on_accelerations(model);
    for (quantity, of_motion) in model.aux_variables.iter().zip(&of_motion) {
        let value = if *of_motion {
            // Overwritten once the equations of motion are lowered.
            Value::Scalar(lowering.graph.whole(0))
        } else {
            lowering.evaluate(&quantity.value)
        };
        lowering.lets.push(value);
    }
    let mut quantities = Vec::new();
    let names = lowering.layout.quantities.clone();
    let mut next = names.iter();
    let of_marker = crate::layout::is_unlisted(model);
    let values = model.aux_variables.iter().zip(lowering.lets.clone());
    // The compiled function `quantities` has no marker argument.
    for ((quantity, value), _) in values.zip(of_marker).filter(|(_, of_marker)| !of_marker) {
        for node in nodes(value) {
            if let Some(name) = next.next() {
                lowering.record(node, name, quantity.span);
                quantities.push((name.clone(), node));
            }
        }
    }
    let dx = lowering.motion();
    let later = model.aux_variables.iter().enumerate();
    for (index, quantity) in later.filter(|(index, _)| of_motion[*index]) {
        lowering.lets[index] = lowering.evaluate(&quantity.value);
    }
    let observation = model.observation.as_ref().map(|observation| {
        let vector = lowering.vector(&observation.value);
        for (k, &component) in vector.iter().enumerate() {
            let name = format!("{}_{}", observation.name, ["x", "y", "z"][k]);
            lowering.record(component, &name, observation.span);
        }
        vector
    });
    let limits = model.limits.iter();
    let limits = limits.map(|limit| lowering.scalar(&limit.value)).collect();
    let lets = lowering.lets.iter().map(|&value| nodes(value)).collect();
    let Lowering {
        graph,
        layout,
        provenance,
        ..
    } = lowering;
    Lowered {
        graph,
        layout,
        dx,
        observation,
        quantities,
        limits,
        provenance,
        lets,
    }
}

impl Lowered {
    /// Nodes of all outputs, some twice; changes nothing, but shares [`Lowered::replace_nodes`].
    pub(crate) fn nodes(&mut self) -> Vec<NodeId> {
        let mut nodes = Vec::new();
        self.replace_nodes(|node| {
            nodes.push(node);
            node
        });
        nodes
    }

    /// Replaces the node of each output by `replace(node)`.
    pub(crate) fn replace_nodes(&mut self, mut replace: impl FnMut(NodeId) -> NodeId) {
        let lets = self.lets.iter_mut().flatten();
        let quantities = self.quantities.iter_mut().map(|(_, node)| node);
        let observed = self.observation.iter_mut().flatten();
        let values = self.dx.iter_mut().chain(&mut self.limits);
        for node in values.chain(observed).chain(quantities).chain(lets) {
            *node = replace(*node);
        }
    }
}

fn nodes(value: Value) -> Vec<NodeId> {
    match value {
        Value::Scalar(node) => vec![node],
        Value::Vector(vector) => vector.to_vec(),
    }
}

impl Lowering<'_> {
    /// Creates the leaves first: sums are sorted by node index, and so follow [`Layout`].
    fn leaves(&mut self) {
        for k in 0..self.layout.states.len() {
            self.graph.symbol(Symbol::State(k as u32));
        }
        for k in 0..self.layout.parameters.len() {
            self.graph.symbol(Symbol::Parameter(k as u32));
        }
    }

    /// Lowers the angles by which frames are turned, which stand before all that depends on frames.
    fn constant_angles(&mut self) {
        let model = self.model;
        let angles: Vec<&Expr> = model.constant_angles.iter().collect();
        for (quantity, is_needed) in model.aux_variables.iter().zip(needed(model, &angles)) {
            let value = match is_needed {
                true => self.evaluate(&quantity.value),
                false => Value::Scalar(self.graph.whole(0)),
            };
            self.lets.push(value);
        }
        self.frames.constant_angles = angles.iter().map(|angle| self.scalar(angle)).collect();
        self.lets.clear();
    }

    /// Marks the mass, and what limits keep above 0, as nonzero, unless they use auxiliary variables.
    fn assumptions(&mut self) {
        let model = self.model;
        for limit in &model.limits {
            // skip limits that use auxiliary variables, which are not evaluated yet
            if limit.bound >= 0.0 && !mentions_let(&limit.value) {
                let node = self.scalar(&limit.value);
                self.graph.assume_nonzero(node);
            }
        }
        if let Some(body) = &model.body
            && !mentions_let(&body.mass)
        {
            let mass = self.scalar(&body.mass);
            self.graph.assume_nonzero(mass);
        }
    }

    /// Names a node and records its source location under that name; constants and leaves are skipped.
    pub(crate) fn record(&mut self, node: NodeId, name: &str, span: Span) {
        use crate::graph::Node;
        if self.is_provisional || matches!(self.graph.node(node), Node::Number(_) | Node::Symbol(_))
        {
            return;
        }
        self.graph.name(node, name);
        if !self.recorded.insert(name.to_string()) {
            return;
        }
        let source = self.model.sources.get(usize::from(span.source));
        let (line, text) = source.map_or((0, ""), |source| {
            trimmed_line(&source.text, span.start as usize)
        });
        let source = source.map_or_else(|| self.model.name.clone(), |source| source.name.clone());
        self.provenance.push(Provenance {
            name: name.to_string(),
            span,
            source,
            line,
            text: text.to_string(),
        });
    }
}

fn mentions_let(expr: &model_spec::model::Expr) -> bool {
    expr.nodes()
        .any(|e| matches!(e.kind, ExprKind::AuxVariable(_) | ExprKind::Determinacy(_)))
}
