//! Values with their derivatives: edges, the values of fixed parameters put in, elimination.

use super::{Compiler, Effort, dense};
use crate::differentiate::{Edges, Jacobian, Linear, Order, Substituted};
use crate::graph::{Graph, NodeId, Symbol};
use crate::optimise::{Dag, import};
use crate::program::{Function, Section};

impl Compiler {
    /// A value and its sparse derivatives by groups of symbols.
    pub(super) fn jacobians(
        &self,
        linear: Linear,
        rows: usize,
        value: &'static str,
        by: &[(&'static str, &[Symbol])],
    ) -> Jacobians {
        let symbols: Vec<Symbol> = by
            .iter()
            .flat_map(|(_, part)| part.iter().copied())
            .collect();
        let names: Vec<String> = symbols.iter().map(|&s| self.symbol_name(s)).collect();
        let row_names: Vec<String> = (0..rows).map(|row| self.row_name(value, row)).collect();
        let Linear {
            mut graph,
            mut roots,
            ..
        } = linear;
        let mut edges = Edges::new(&mut graph, (&roots, &row_names), (&symbols, &names));
        if !self.fixed.is_empty() {
            let mut wanted = edges.partials();
            wanted.extend(&roots);
            let mut at = Substituted::new(&graph, &wanted, &self.fixed);
            let mut images: Vec<NodeId> = wanted.iter().map(|&node| at.image(node)).collect();
            roots = images.split_off(images.len() - roots.len());
            graph = at.graph;
            edges.replace(&graph, &images);
        }
        let by_order = |order: Order| {
            let mut graph = graph.clone();
            let all = edges.clone().accumulate(&mut graph, order);
            let mut wanted = roots.clone();
            let mut sections = vec![dense(value, rows)];
            let mut start = 0;
            for &(section, symbols) in by {
                let part = columns(&all, start, symbols.len() as u32);
                wanted.extend(&part.entries);
                sections.push(Section {
                    name: section,
                    len: part.entries.len(),
                    pattern: Some(part.pattern),
                });
                start += symbols.len() as u32;
            }
            let mut dag = import(&graph, &wanted);
            dag.optimise();
            Jacobians {
                dag,
                graph,
                sections,
            }
        };
        let edges_first = by_order(Order::FewestEdges);
        if self.effort == Effort::Quick {
            return edges_first;
        }
        let products_first = by_order(Order::FewestProducts);
        if products_first.dag.cost() < edges_first.dag.cost() {
            products_first
        } else {
            edges_first
        }
    }

    pub(super) fn finish_jacobians(&mut self, name: &'static str, of: Jacobians) -> Function {
        self.finish(name, &of.dag, &of.graph, of.sections)
    }
}

/// A value and its derivatives, ready to be put in order.
pub(super) struct Jacobians {
    dag: Dag,
    graph: Graph,
    sections: Vec<Section>,
}

impl Jacobians {
    /// Without what comes after the first sections.
    pub(super) fn first_sections(&self, sections: usize) -> Jacobians {
        let sections = self.sections[..sections].to_vec();
        let mut dag = self.dag.clone();
        dag.roots.truncate(sections.iter().map(|s| s.len).sum());
        Jacobians {
            dag,
            graph: self.graph.clone(),
            sections,
        }
    }
}

/// The columns `start .. start + width` of a Jacobian.
fn columns(all: &Jacobian, start: u32, width: u32) -> Jacobian {
    let mut part = Jacobian::default();
    for (&(row, column), &entry) in all.pattern.iter().zip(&all.entries) {
        if (start..start + width).contains(&column) {
            part.pattern.push((row, column - start));
            part.entries.push(entry);
        }
    }
    part
}
