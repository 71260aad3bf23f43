//! Functions with Jacobians: linearization, substitution of fixed parameters, then vertex elimination.

use super::{Compiler, Effort, dense};
use crate::differentiate::{EliminationOrder, Jacobian, LinearizedGraph, share_values};
use crate::graph::{NodeId, Symbol};
use crate::program::{Function, Section};
use crate::specialize::Specialized;
use crate::ssa::{Ssa, build};
use std::ops::Range;

/// Model outputs to be differentiated, and their linearized computational graph.
pub(super) struct Differentiable {
    roots: Vec<NodeId>,
    edges: LinearizedGraph,
    locals: Range<usize>,
}

struct Jacobians {
    ssa: Ssa,
    sections: Vec<Section>,
}

/// Group of adjacent Jacobian columns that form one output matrix: (name of the matrix, number of columns).
type Columns = (&'static str, usize);

impl Compiler {
    /// Returns the linearized graphs of the state derivatives and of the observed marker position if some parameters
    /// are fixed to given values; `(None, None)` otherwise.
    ///
    /// Fixed values change which subexpressions are worth sharing. Partial derivatives are therefore taken of the
    /// unspecialized model, and then values and partial derivatives are specialized together.
    pub(super) fn differentiable(&mut self) -> (Option<Differentiable>, Option<Differentiable>) {
        if self.fixed.is_empty() {
            return (None, None);
        }
        let (dx, y) = (self.lowered.dx.clone(), self.observed());
        let graph = &self.lowered.graph;
        let (motion, observed) = (build(graph, &dx), build(graph, &y));
        let mut motion = self.linearized_motion(&motion);
        let mut observed = self.linearized_observation(&observed);
        self.specialize(&mut [&mut motion, &mut observed]);
        (Some(motion), Some(observed))
    }

    fn specialize(&mut self, all: &mut [&mut Differentiable]) {
        let mut wanted = self.lowered.nodes();
        for one in all.iter() {
            wanted.extend(&one.roots);
            wanted.extend(one.edges.partials());
        }
        let mut at = Specialized::new(&self.lowered.graph, &wanted, &self.fixed);
        self.lowered.replace_nodes(|node| at.image(node));
        for one in all {
            let partials: Vec<NodeId> = one.edges.partials();
            let partials: Vec<NodeId> = partials.into_iter().map(|p| at.image(p)).collect();
            one.edges.set_partials(&at.graph, &partials);
            one.roots
                .iter_mut()
                .for_each(|root| *root = at.image(*root));
            one.locals = 0..at.graph.local_count();
        }
        self.lowered.graph = at.graph;
    }

    /// Compiles `f`, `f_jac` and `f_jac_par`, from the linearized graph `known` if there is one.
    pub(super) fn motion(&mut self, known: Option<Differentiable>) -> [Function; 3] {
        let ssa = self.optimised(&self.lowered.dx);
        let (rows, states) = (ssa.roots.len(), self.lowered.layout.states.len());
        let f = self.scheduled("f", &ssa, vec![dense("dx", rows)]);
        let motion = match known {
            Some(known) => known,
            None => self.linearized_motion(&ssa),
        };
        let columns = [("j", states), ("jp", self.columns.len())];
        let both = match self.effort {
            Effort::Full => {
                let by_states = motion.towards_first(states);
                let f_jac = self.jacobians(&by_states, "dx", &columns[..1]);
                [f_jac, self.jacobians(&motion, "dx", &columns)]
            }
            Effort::Quick => {
                let f_jac_par = self.jacobians(&motion, "dx", &columns);
                [f_jac_par.first_sections(2), f_jac_par]
            }
        };
        let [f_jac, f_jac_par] = both;
        let f_jac = self.scheduled("f_jac", &f_jac.ssa, f_jac.sections);
        let f_jac_par = self.scheduled("f_jac_par", &f_jac_par.ssa, f_jac_par.sections);
        [f, f_jac, f_jac_par]
    }

    /// Compiles `observe` and `observe_jac`, from the linearized graph `known` if there is one.
    pub(super) fn observation(&mut self, known: Option<Differentiable>) -> [Function; 2] {
        let ssa = self.optimised(&self.observed());
        let layout = &self.lowered.layout;
        let (states, marker) = (layout.states.len(), layout.marker.len());
        let observe = self.scheduled("observe", &ssa, vec![dense("y", ssa.roots.len())]);
        let observed = match known {
            Some(known) => known,
            None => self.linearized_observation(&ssa),
        };
        let columns = [
            ("dy_dx", states),
            ("dy_dp", self.columns.len()),
            ("dy_dmarker", marker),
        ];
        let jacobians = self.jacobians(&observed, "y", &columns);
        let observe_jac = self.scheduled("observe_jac", &jacobians.ssa, jacobians.sections);
        [observe, observe_jac]
    }

    fn linearized_motion(&mut self, ssa: &Ssa) -> Differentiable {
        let symbols = self.states_and_parameters();
        self.linearized(ssa, "dx", &symbols)
    }

    fn linearized_observation(&mut self, ssa: &Ssa) -> Differentiable {
        let mut symbols = self.states_and_parameters();
        symbols.extend((0..self.lowered.layout.marker.len() as u32).map(Symbol::Marker));
        self.linearized(ssa, "y", &symbols)
    }

    fn states_and_parameters(&self) -> Vec<Symbol> {
        let states = (0..self.lowered.layout.states.len() as u32).map(Symbol::State);
        let parameters = self.columns.iter().map(|&k| Symbol::Parameter(k as u32));
        states.chain(parameters).collect()
    }

    /// Linearized graph of the roots of `ssa`, which form the output vector `value`.
    fn linearized(&mut self, ssa: &Ssa, value: &str, symbols: &[Symbol]) -> Differentiable {
        let columns: Vec<String> = symbols.iter().map(|&s| self.symbol_name(s)).collect();
        let rows = (0..ssa.roots.len()).map(|row| self.row_name(value, row));
        let rows: Vec<String> = rows.collect();
        let mut namer = self.namer();
        let graph = &mut self.lowered.graph;
        let first = graph.local_count();
        let (roots, edges) = graph.scope(first..first, |graph| {
            let roots = share_values(ssa, graph, &mut namer);
            let edges = LinearizedGraph::new(graph, &roots, &rows, symbols, &columns);
            (roots, edges)
        });
        Differentiable {
            roots,
            edges,
            locals: first..self.lowered.graph.local_count(),
        }
    }

    /// Compiles values and one Jacobian per group of columns, by the cheaper elimination order.
    fn jacobians(
        &mut self,
        of: &Differentiable,
        value: &'static str,
        columns: &[Columns],
    ) -> Jacobians {
        let edges_first = self.eliminated(of, value, columns, EliminationOrder::FewestEdges);
        if self.effort == Effort::Quick {
            return edges_first;
        }
        let products_first = self.eliminated(of, value, columns, EliminationOrder::FewestProducts);
        if products_first.ssa.cost() < edges_first.ssa.cost() {
            products_first
        } else {
            edges_first
        }
    }

    fn eliminated(
        &mut self,
        of: &Differentiable,
        value: &'static str,
        columns: &[Columns],
        order: EliminationOrder,
    ) -> Jacobians {
        let graph = &mut self.lowered.graph;
        let all = graph.scope(of.locals.clone(), |graph| {
            of.edges.clone().eliminate_vertices(graph, order)
        });
        let mut wanted = of.roots.clone();
        let mut sections = vec![dense(value, of.roots.len())];
        let mut start = 0;
        for &(name, width) in columns {
            let width = width as u32;
            let part = columns_of(&all, start, width);
            wanted.extend(&part.entries);
            sections.push(Section {
                name,
                len: part.entries.len(),
                pattern: Some(part.pattern),
            });
            start += width;
        }
        let mut ssa = build(graph, &wanted);
        ssa.optimise();
        Jacobians { ssa, sections }
    }
}

impl Differentiable {
    /// Returns a copy whose derivatives are restricted to the first `columns` independent symbols.
    fn towards_first(&self, columns: usize) -> Differentiable {
        Differentiable {
            roots: self.roots.clone(),
            edges: self.edges.clone().towards_first(columns),
            locals: self.locals.clone(),
        }
    }
}

impl Jacobians {
    fn first_sections(&self, sections: usize) -> Jacobians {
        let sections = self.sections[..sections].to_vec();
        let mut ssa = self.ssa.clone();
        ssa.roots.truncate(sections.iter().map(|s| s.len).sum());
        Jacobians { ssa, sections }
    }
}

/// Submatrix of the columns `start .. start + width` of a Jacobian, with the columns renumbered from 0.
fn columns_of(all: &Jacobian, start: u32, width: u32) -> Jacobian {
    let mut part = Jacobian::default();
    for (&(row, column), &entry) in all.pattern.iter().zip(&all.entries) {
        if (start..start + width).contains(&column) {
            part.pattern.push((row, column - start));
            part.entries.push(entry);
        }
    }
    part
}
