//! The code of one quantity or derivative alone, by the stages that compile whole models.

use super::find::Found;
use crate::compile::Compiled;
use crate::count::{Count, count};
use crate::differentiate::{self, Edges, Linear, Order};
use crate::graph::{Graph, Symbol};
use crate::optimise::{Dag, import};
use crate::program::{Function, Program, Section};
use crate::rust;
use crate::schedule::prepare::Prepare;
use crate::schedule::{Namer, schedule_named};

/// Generated statements and what they cost.
pub(super) struct Made {
    pub once: String,
    pub code: String,
    pub cost_once: Count,
    pub cost: Count,
    /// The programs, for the tests: `quantities` computes what is explained.
    #[cfg_attr(not(test), allow(dead_code))]
    pub compiled: Compiled,
    /// Which components are not 0 throughout.
    #[cfg_attr(not(test), allow(dead_code))]
    pub rows: Vec<u32>,
}

/// Compiles what was found, or its derivative.
pub(super) fn generate(found: &Found, by: Option<(Symbol, &str)>) -> Made {
    let mut compiled = found.compiled.clone();
    let origins: Vec<String> = compiled
        .derived
        .origins
        .iter()
        .map(|origin| origin.name.clone())
        .collect();
    let layout = &mut compiled.layout;
    let mut fresh = Namer::new(&layout.states, &layout.parameters, &origins);
    fresh.reserve(&layout.marker);
    let graph = &found.compiled.derived.graph;
    let mut dag = import(graph, &found.nodes);
    dag.optimise();
    let (dag, graph, names, rows): (Dag, Graph, Vec<String>, Vec<u32>) = match by {
        None => {
            let rows = (0..found.nodes.len() as u32).collect();
            (dag, graph.clone(), found.names.clone(), rows)
        }
        Some((symbol, wrt)) => {
            let Linear {
                mut graph, roots, ..
            } = differentiate::linearise(&dag, graph, &mut fresh.clone());
            let edges = Edges::new(
                &mut graph,
                (&roots, &found.names),
                (&[symbol], &[wrt.to_string()]),
            );
            let jacobian = edges.accumulate(&mut graph, Order::FewestEdges);
            let mut dag = import(&graph, &jacobian.entries);
            dag.optimise();
            let rows: Vec<u32> = jacobian.pattern.iter().map(|&(row, _)| row).collect();
            let name = |&row: &u32| format!("d_{}_d_{wrt}", found.names[row as usize]);
            let names = rows.iter().map(name).collect();
            (dag, graph, names, rows)
        }
    };
    let mut prepare = Prepare::new(&layout.parameters);
    let program = schedule_named(&dag, &graph, &mut fresh, Some(&mut prepare), &names);
    compiled.prepared = prepare.names().to_vec();
    compiled.prepare = Function {
        name: "prepare",
        program: prepare.program(),
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
    // the others would refer to constants that are not prepared here
    for other in [
        &mut compiled.f,
        &mut compiled.f_jac,
        &mut compiled.f_jac_par,
        &mut compiled.observe,
        &mut compiled.observe_jac,
        &mut compiled.limits,
    ] {
        other.program = Program::default();
        other.sections.clear();
        other.results.clear();
    }
    let files = rust::emit(&compiled, &found.model);
    let body = |function: &str, array: &str, outputs: &[String]| {
        let file = format!("/{function}.rs");
        let found = files.iter().find(|found| found.path.ends_with(&file));
        found.map_or_else(String::new, |found| statements(&found.text, array, outputs))
    };
    Made {
        once: body("prepare", "prepared", &compiled.prepared),
        code: body("quantities", "values", &compiled.layout.quantities),
        cost_once: count(&compiled.prepare.program),
        cost: count(&compiled.quantities.program),
        compiled,
        rows,
    }
}

fn dense(name: &'static str, len: usize) -> Section {
    Section {
        name,
        len,
        pattern: None,
    }
}

/// The statements of a function's body; what is fetched from and put into arrays is called by its name.
fn statements(text: &str, array: &str, outputs: &[String]) -> String {
    let lines = text
        .lines()
        .skip_while(|line| !line.starts_with("pub fn"))
        .skip_while(|line| !line.ends_with('{'))
        .skip(1)
        .take_while(|line| *line != "}")
        .map(|line| line.strip_prefix("    ").unwrap_or(line));
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
            // it has its name already
            Some((name, right)) if right.trim() == format!("{name};") => {}
            Some((name, right)) => body.push(format!("let {name} ={right}")),
            None => body.push(line.to_string()),
        }
    }
    // blank lines stand between groups, not around them
    body.dedup_by(|a, b| a.is_empty() && b.is_empty());
    body.join("\n").trim_matches('\n').to_string()
}

/// `let u = state[3];`
fn is_load(line: &str) -> bool {
    ["state[", "parameters[", "prepared[", "marker["]
        .iter()
        .any(|array| {
            line.starts_with("let ")
                && line.contains(&format!(" = {array}"))
                && line.ends_with("];")
        })
}
