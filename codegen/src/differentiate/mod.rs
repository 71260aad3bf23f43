//! Derivatives of the shared graph: exact, sparse, by elimination of its vertices.

mod edges;
mod eliminate;
pub mod partials;
mod substitute;

pub use edges::Edges;
pub use eliminate::{Jacobian, Order};
pub use substitute::{Substituted, Values};

use crate::graph::{FastMap, Graph, Node, NodeId, Symbol};
use crate::number::Number;
use crate::optimise::{Dag, Def, DefId};
use crate::schedule::Namer;

/// A graph in which what was shared is a leaf with a definition, ready to be differentiated.
#[derive(Clone, Debug)]
pub struct Linear {
    /// The new graph.
    pub graph: Graph,
    /// The node of each definition.
    pub images: Vec<NodeId>,
    /// The wanted results.
    pub roots: Vec<NodeId>,
}

/// Turns optimised definitions back into nodes: sums and shared products become locals, named as `namer`
/// would name them in the function of the values alone.
pub fn linearise(dag: &Dag, graph: &Graph, namer: &mut Namer) -> Linear {
    let uses = dag.uses();
    let mut new = Graph::new();
    let mut images: FastMap<DefId, NodeId> = FastMap::default();
    let order = dag.order();
    let mut rooted = vec![false; dag.defs.len()];
    for &id in &order {
        if let Def::Root(x) = dag.defs[id as usize] {
            rooted[x as usize] = true;
        }
    }
    for id in order {
        let image = |images: &FastMap<DefId, NodeId>, id: DefId| images[&id];
        let facts = dag.facts[id as usize];
        let shared = uses[id as usize] > 1;
        let node = match &dag.defs[id as usize] {
            Def::Leaf(symbol) => new.symbol(*symbol),
            Def::Constant(number) => new.number(*number),
            Def::Sum(terms) => {
                let terms = terms
                    .iter()
                    .map(|&(minus, term)| {
                        (
                            if minus {
                                Number::MINUS_ONE
                            } else {
                                Number::ONE
                            },
                            image(&images, term),
                        )
                    })
                    .collect();
                let sum = new.sum(terms, Number::ZERO);
                if rooted[id as usize] && matches!(new.node(sum), Node::Sum(..)) {
                    let root = new.local_root(facts, sum);
                    new.power(root, 4)
                } else {
                    new.local(facts, sum)
                }
            }
            Def::Product(factors) => {
                let factors = factors
                    .iter()
                    .map(|&factor| (image(&images, factor), 2))
                    .collect();
                let product = new.product(factors);
                if shared {
                    new.local(facts, product)
                } else {
                    product
                }
            }
            Def::Root(x) => new.sqrt(image(&images, *x)),
            Def::Recip(x) => {
                let x = image(&images, *x);
                if facts.nonzero {
                    new.assume_nonzero(x);
                }
                new.power(x, -2)
            }
            Def::Call(function, (minus, x)) => {
                let x = signed(&mut new, *minus, images[x]);
                new.call(*function, x)
            }
            Def::Atan2((a, y), (b, x)) => {
                let (y, x) = (
                    signed(&mut new, *a, images[y]),
                    signed(&mut new, *b, images[x]),
                );
                new.atan2(y, x)
            }
            Def::Min((a, x), (b, y)) => {
                let (x, y) = (
                    signed(&mut new, *a, images[x]),
                    signed(&mut new, *b, images[y]),
                );
                new.min(x, y)
            }
            Def::Max((a, x), (b, y)) => {
                let (x, y) = (
                    signed(&mut new, *a, images[x]),
                    signed(&mut new, *b, images[y]),
                );
                new.max(x, y)
            }
            Def::IfZero(c, (a, x), (b, y)) => {
                let c = images[c];
                let (x, y) = (
                    signed(&mut new, *a, images[x]),
                    signed(&mut new, *b, images[y]),
                );
                new.if_zero(c, x, y)
            }
        };
        // what keeps its identity keeps its name, so that derivatives can be called after it
        let keeps = match new.node(node) {
            Node::Symbol(Symbol::Local(_)) | Node::Call(..) | Node::Atan2(..) => true,
            Node::Product(_) => rooted[id as usize],
            _ => false,
        };
        if keeps || namer.has_own_name(dag, graph, id) {
            new.name(node, namer.name(dag, graph, id));
        }
        images.insert(id, node);
    }
    let roots = dag
        .roots
        .iter()
        .map(|&(minus, id)| signed(&mut new, minus, images[&id]))
        .collect();
    let zero = new.whole(0);
    let all = (0..dag.defs.len() as DefId)
        .map(|id| images.get(&id).copied().unwrap_or(zero))
        .collect();
    Linear {
        graph: new,
        images: all,
        roots,
    }
}

fn signed(graph: &mut Graph, minus: bool, id: NodeId) -> NodeId {
    if minus { graph.neg(id) } else { id }
}
