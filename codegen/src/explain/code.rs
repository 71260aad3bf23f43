//! Generated code of a single quantity or derivative, by the compiler stages that also compile whole models.

use super::find::FoundQuantity;
use crate::compile::{Compiled, dense};
use crate::count::{Count, count};
use crate::differentiate::{EliminationOrder, LinearizedGraph, share_values};
use crate::graph::{ExprGraph, Symbol};
use crate::program::Function;
use crate::rust;
use crate::schedule::{Hoisted, Namer, schedule};
use crate::ssa::{Ssa, build};

/// Generated code of a quantity or derivative, with operation counts.
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

/// Generates the code of a quantity, or of its derivative with respect to `by`.
pub(super) fn generate(found: &FoundQuantity, by: Option<(Symbol, &str)>) -> GeneratedCode {
    let mut compiled = found.compiled.clone();
    let quantities = compiled.lowered.provenance.iter();
    let quantities: Vec<String> = quantities.map(|p| p.name.clone()).collect();
    let graph = &mut compiled.lowered.graph;
    let layout = &mut compiled.layout;
    let mut namer = Namer::new(&layout.states, &layout.parameters, &quantities);
    namer.reserve(&layout.marker);
    let mut ssa = build(graph, &found.nodes);
    ssa.optimise();
    let (ssa, names, rows) = match by {
        None => {
            let rows = (0..found.nodes.len() as u32).collect();
            (ssa, found.names.clone(), rows)
        }
        Some(by) => derivative(&ssa, graph, namer.clone(), &found.names, by),
    };
    let mut hoisted = Hoisted::new(&layout.parameters);
    let program = schedule(&ssa, graph, &mut namer, Some(&mut hoisted), &names);
    compiled.prepared = hoisted.names().to_vec();
    compiled.prepare = Function {
        name: "prepare",
        program: hoisted.program(graph),
        sections: vec![dense("prepared", compiled.prepared.len())],
        results: compiled.prepared.clone(),
    };
    layout.quantities = names.clone();
    compiled.quantities = Function {
        name: "quantities",
        program,
        sections: vec![dense("q", rows.len())],
        results: names,
    };
    // The programs of the other functions refer to invariants that this `prepare` does not compute.
    for other in [
        &mut compiled.f,
        &mut compiled.f_jac,
        &mut compiled.f_jac_par,
        &mut compiled.observe,
        &mut compiled.observe_jac,
        &mut compiled.limits,
    ] {
        *other = Function {
            name: other.name,
            ..Function::default()
        };
    }
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

/// Derivatives of a quantity's components that are not 0, with names and components.
fn derivative(
    ssa: &Ssa,
    graph: &mut ExprGraph,
    mut namer: Namer,
    rows: &[String],
    (symbol, wrt): (Symbol, &str),
) -> (Ssa, Vec<String>, Vec<u32>) {
    let first = graph.local_count();
    let jacobian = graph.scope(first..first, |graph| {
        let roots = share_values(ssa, graph, &mut namer);
        let linearized = LinearizedGraph::new(graph, &roots, rows, &[symbol], &[wrt.to_string()]);
        linearized.eliminate_vertices(graph, EliminationOrder::FewestEdges)
    });
    let mut ssa = build(graph, &jacobian.entries);
    ssa.optimise();
    let of: Vec<u32> = jacobian.pattern.iter().map(|&(row, _)| row).collect();
    let name = |&row: &u32| format!("d_{}_d_{wrt}", rows[row as usize]);
    let names = of.iter().map(name).collect();
    (ssa, names, of)
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

/// Whether a line loads an input element: `let u = state[3];`.
fn is_load(line: &str) -> bool {
    ["state[", "parameters[", "prepared[", "marker["]
        .iter()
        .any(|array| {
            line.starts_with("let ")
                && line.contains(&format!(" = {array}"))
                && line.ends_with("];")
        })
}
