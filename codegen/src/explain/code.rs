//! Generated code of a single quantity or derivative, by the compiler stages that also compile whole models.

use super::find::FoundQuantity;
use crate::compile::{Compiled, Compiler, dense};
use crate::count::{Count, count};
use crate::differentiate::{EliminationOrder, LinearizedGraph, share_values};
use crate::graph::Symbol;
use crate::program::Function;
use crate::rust;
use crate::ssa::Ssa;

pub(super) struct GeneratedCode {
    pub once: String,
    pub code: String,
    pub cost_once: Count,
    pub cost: Count,
    /// Compiled model whose function `quantities` computes the explained quantity; read only by tests.
    #[cfg_attr(not(test), allow(dead_code))]
    pub compiled: Compiled,
    /// Indices of the components of the quantity or derivative that are not identically 0.
    #[cfg_attr(not(test), allow(dead_code))]
    pub rows: Vec<u32>,
}

pub(super) fn generate(found: &FoundQuantity, by: Option<(Symbol, &str)>) -> GeneratedCode {
    let mut compiler = found.compiler.clone();
    let mut ssa = compiler.optimised(&found.nodes);
    let mut names = found.names.clone();
    let mut rows: Vec<u32> = (0..found.nodes.len() as u32).collect();
    if let Some((symbol, wrt)) = by {
        (ssa, rows) = derivative(&mut compiler, &ssa, &names, symbol, wrt);
        let name = |&row: &u32| format!("d_{}_d_{wrt}", names[row as usize]);
        names = rows.iter().map(name).collect();
    }
    compiler.lowered.layout.quantities = names;
    let quantities = compiler.scheduled("quantities", &ssa, vec![dense("q", rows.len())]);
    let compiled = Compiled {
        quantities,
        ..compiler.prepared(&found.label)
    };
    let body = |function: &Function, array: &str, outputs: &[String]| {
        statements(&rust::function_file(&compiled, function), array, outputs)
    };
    GeneratedCode {
        once: body(&compiled.prepare, "prepared", &compiled.prepared),
        code: body(&compiled.quantities, "values", &compiled.layout.quantities),
        cost_once: count(&compiled.prepare.program),
        cost: count(&compiled.quantities.program),
        compiled,
        rows,
    }
}

/// Derivatives of the roots of `ssa`, named `names`, that are not 0, and the components to which they belong.
fn derivative(
    compiler: &mut Compiler,
    ssa: &Ssa,
    names: &[String],
    symbol: Symbol,
    wrt: &str,
) -> (Ssa, Vec<u32>) {
    let mut namer = compiler.namer();
    let graph = &mut compiler.lowered.graph;
    let first = graph.local_count();
    let jacobian = graph.scope(first..first, |graph| {
        let roots = share_values(ssa, graph, &mut namer);
        let linearized = LinearizedGraph::new(graph, &roots, names, &[symbol], &[wrt.to_string()]);
        linearized.eliminate_vertices(graph, EliminationOrder::FewestEdges)
    });
    let rows = jacobian.pattern.iter().map(|&(row, _)| row).collect();
    (compiler.optimised(&jacobian.entries), rows)
}

/// Statements of a generated function, without loads, with assignments for stores to `array`.
fn statements(text: &str, array: &str, outputs: &[String]) -> String {
    let lines = text.lines().skip_while(|line| !line.starts_with("pub fn"));
    let lines = lines.skip_while(|line| !line.ends_with('{')).skip(1);
    let lines = lines.take_while(|line| *line != "}");
    let lines = lines.map(|line| line.strip_prefix("    ").unwrap_or(line));
    let mut body: Vec<String> = Vec::new();
    for line in lines {
        if is_load(line) {
            continue;
        }
        let stored = outputs.iter().enumerate().find_map(|(k, name)| {
            let right = line.strip_prefix(&format!("{array}[{k}] ="))?;
            Some((name, right))
        });
        match stored {
            // The value already has that variable name.
            Some((name, right)) if right.trim() == format!("{name};") => {}
            Some((name, right)) => body.push(format!("let {name} ={right}")),
            None => body.push(line.to_string()),
        }
    }
    // No blank lines at the start or the end, and none doubled.
    body.dedup_by(|a, b| a.is_empty() && b.is_empty());
    body.join("\n").trim_matches('\n').to_string()
}

fn is_load(line: &str) -> bool {
    ["state[", "parameters[", "prepared[", "marker["]
        .iter()
        .any(|array| {
            line.starts_with("let ")
                && line.contains(&format!(" = {array}"))
                && line.ends_with("];")
        })
}
