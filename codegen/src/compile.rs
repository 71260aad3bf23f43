//! The stages in order: derive, simplify, differentiate, simplify, schedule.

mod jacobians;

use crate::count;
use crate::derive::{Derived, derive};
use crate::differentiate::{self, Linear, Values};
use crate::graph::{Graph, NodeId, Symbol};
use crate::layout::Layout;
use crate::number::Number;
use crate::optimise::{Dag, import};
use crate::program::{Function, Operand, Program, Section};
use crate::schedule::prepare::Prepare;
use crate::schedule::{Namer, schedule_named};
use model_spec::model::Model;

/// Which parameters derivatives are taken for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Selection {
    /// All of them.
    All,
    /// These, by their place in [`Layout::parameters`].
    Only(Vec<usize>),
}

/// How much work goes into few operations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effort {
    /// Each Jacobian in the best of several orders, for code that is kept.
    Full,
    /// One order, and `f_jac` as what `f_jac_par` computes of it, for a tape that is made for one question.
    Quick,
}

/// A model as programs.
#[derive(Clone, Debug)]
pub struct Compiled {
    /// The model's name.
    pub name: String,
    /// The order of states and parameters.
    pub layout: Layout,
    /// The model as nodes, with the names and places of its quantities.
    pub derived: Derived,
    /// Places of the parameters that columns of `jp` and `dy_dp` stand for; all unless a selection was made.
    pub columns: Vec<usize>,
    /// Computes the constants of a flight from the parameters; they are an input of every other function.
    pub prepare: Function,
    /// Names of those constants.
    pub prepared: Vec<String>,
    /// `dx`.
    pub f: Function,
    /// `dx`, `j`.
    pub f_jac: Function,
    /// `dx`, `j`, `jp`.
    pub f_jac_par: Function,
    /// `y`: the marker in the inertial frame. Empty where nothing is observed.
    pub observe: Function,
    /// `y`, `dy_dx`, `dy_dp`, `dy_dmarker`.
    pub observe_jac: Function,
    /// Every named quantity.
    pub quantities: Function,
    /// Left sides of the limits.
    pub limits: Function,
}

impl Compiled {
    /// All functions, `prepare` first.
    pub fn functions(&self) -> [&Function; 8] {
        [
            &self.prepare,
            &self.f,
            &self.f_jac,
            &self.f_jac_par,
            &self.observe,
            &self.observe_jac,
            &self.quantities,
            &self.limits,
        ]
    }

    /// A function by its name.
    pub fn function(&self, name: &str) -> Option<&Function> {
        self.functions()
            .into_iter()
            .find(|function| function.name == name)
    }

    /// Operations of `prepare` that a function relies on: what they would cost it if nothing were prepared.
    pub fn count_prepared(&self, name: &str) -> count::Count {
        let Some(function) = self.function(name) else {
            return count::Count::default();
        };
        let program = &function.program;
        let inside = program.statements.iter().flat_map(|s| s.op.operands());
        let slots: Vec<usize> = inside
            .chain(program.outputs.iter().copied())
            .filter_map(|operand| match operand {
                Operand::Prepared(slot) => Some(slot as usize),
                _ => None,
            })
            .collect();
        count::count_for(&self.prepare.program, &slots)
    }

    /// Operations of a function.
    pub fn count(&self, name: &str) -> count::Count {
        self.function(name)
            .map_or_else(count::Count::default, |function| {
                count::count(&function.program)
            })
    }
}

/// Compiles a model, with derivatives for all parameters.
pub fn compile(model: &Model) -> Compiled {
    compile_for(model, &Selection::All)
}

/// Compiles a model, with derivatives for selected parameters.
pub fn compile_for(model: &Model, selection: &Selection) -> Compiled {
    Compiler::new(model, selection).run(&model.name)
}

/// Compiles a model at given values of some parameters, by their place in [`Layout::parameters`], of two values for one
/// the last.
///
/// Derivatives are taken for all selected parameters, these among them, and then the values are put in, so that nothing is
/// left of what vanishes there: entries of the Jacobians that are 0 at these values are not in their patterns. All
/// functions are for these values; what they are handed in those places is not read.
pub fn compile_at(
    model: &Model,
    selection: &Selection,
    fixed: &[(usize, f64)],
    effort: Effort,
) -> Compiled {
    let mut compiler = Compiler::new(model, selection);
    let places = compiler.derived.layout.parameters.len();
    for &(place, value) in fixed.iter().filter(|&&(place, _)| place < places) {
        let symbol = Symbol::Parameter(place as u32);
        compiler.fixed.insert(symbol, Number::literal(value, None));
    }
    compiler.effort = effort;
    compiler.run(&model.name)
}

struct Compiler {
    derived: Derived,
    /// Parameters that are numbers.
    fixed: Values,
    effort: Effort,
    columns: Vec<usize>,
    prepare: Prepare,
    origins: Vec<String>,
}

impl Compiler {
    fn new(model: &Model, selection: &Selection) -> Compiler {
        let derived = derive(model);
        let all = derived.layout.parameters.len();
        let columns = match selection {
            Selection::All => (0..all).collect(),
            Selection::Only(places) => places
                .iter()
                .copied()
                .filter(|&place| place < all)
                .collect(),
        };
        let origins = derived
            .origins
            .iter()
            .map(|origin| origin.name.clone())
            .collect();
        Compiler {
            prepare: Prepare::new(&derived.layout.parameters),
            derived,
            fixed: Values::default(),
            effort: Effort::Full,
            columns,
            origins,
        }
    }

    fn run(mut self, name: &str) -> Compiled {
        let states: Vec<Symbol> = (0..self.derived.layout.states.len() as u32)
            .map(Symbol::State)
            .collect();
        let parameters: Vec<Symbol> = self
            .columns
            .iter()
            .map(|&k| Symbol::Parameter(k as u32))
            .collect();
        let marker: Vec<Symbol> = (0..self.derived.layout.marker.len() as u32)
            .map(Symbol::Marker)
            .collect();

        let dx = self.derived.dx.clone();
        let y: Vec<NodeId> = self
            .derived
            .observation
            .map_or_else(Vec::new, |y| y.to_vec());
        let (motion, seen, linear, linear_seen) = if self.fixed.is_empty() {
            let (motion, seen) = (self.optimised(&dx), self.optimised(&y));
            let (linear, linear_seen) = (self.linear(&motion), self.linear(&seen));
            (motion, seen, linear, linear_seen)
        } else {
            // What operations are shared now need not be once the values are in.
            let graph = &self.derived.graph;
            let linear = self.linear(&import(graph, &dx));
            let linear_seen = self.linear(&import(graph, &y));
            self.derived.put_in(&self.fixed);
            let y = self.derived.observation;
            let y = y.map_or_else(Vec::new, |y| y.to_vec());
            let (motion, seen) = (self.optimised(&self.derived.dx), self.optimised(&y));
            (motion, seen, linear, linear_seen)
        };
        let f = self.finish(
            "f",
            &motion,
            &self.derived.graph.clone(),
            vec![dense("dx", dx.len())],
        );

        let n = dx.len();
        let by = [("j", states.as_slice()), ("jp", parameters.as_slice())];
        let (f_jac, f_jac_par) = match self.effort {
            Effort::Full => {
                let f_jac = self.jacobians(linear.clone(), n, "dx", &by[..1]);
                let f_jac = self.finish_jacobians("f_jac", f_jac);
                let f_jac_par = self.jacobians(linear, n, "dx", &by);
                (f_jac, self.finish_jacobians("f_jac_par", f_jac_par))
            }
            Effort::Quick => {
                let f_jac_par = self.jacobians(linear, n, "dx", &by);
                let f_jac = f_jac_par.first_sections(2);
                let f_jac = self.finish_jacobians("f_jac", f_jac);
                (f_jac, self.finish_jacobians("f_jac_par", f_jac_par))
            }
        };

        let observe = self.finish(
            "observe",
            &seen,
            &self.derived.graph.clone(),
            vec![dense("y", y.len())],
        );
        let by = [
            ("dy_dx", states.as_slice()),
            ("dy_dp", parameters.as_slice()),
            ("dy_dmarker", marker.as_slice()),
        ];
        let observe_jac = self.jacobians(linear_seen, y.len(), "y", &by);
        let observe_jac = self.finish_jacobians("observe_jac", observe_jac);

        let named: Vec<NodeId> = self
            .derived
            .quantities
            .iter()
            .map(|&(_, node)| node)
            .collect();
        let value = self.optimised(&named);
        let quantities = self.finish(
            "quantities",
            &value,
            &self.derived.graph.clone(),
            vec![dense("q", named.len())],
        );

        let limits = self.derived.limits.clone();
        let value = self.optimised(&limits);
        let limits = self.finish(
            "limits",
            &value,
            &self.derived.graph.clone(),
            vec![dense("l", limits.len())],
        );

        let program = self.prepare.program();
        let prepared = self.prepare.names().to_vec();
        let prepare = Function {
            name: "prepare",
            program,
            sections: vec![dense("prepared", prepared.len())],
            results: prepared.clone(),
        };
        Compiled {
            name: name.to_string(),
            layout: self.derived.layout.clone(),
            derived: self.derived,
            columns: self.columns,
            prepare,
            prepared,
            f,
            f_jac,
            f_jac_par,
            observe,
            observe_jac,
            quantities,
            limits,
        }
    }

    fn optimised(&self, roots: &[NodeId]) -> Dag {
        let mut dag = import(&self.derived.graph, roots);
        dag.optimise();
        dag
    }

    fn linear(&self, dag: &Dag) -> Linear {
        differentiate::linearise(dag, &self.derived.graph, &mut self.namer())
    }

    fn namer(&self) -> Namer {
        let layout = &self.derived.layout;
        let mut namer = Namer::new(&layout.states, &layout.parameters, &self.origins);
        namer.reserve(&layout.marker);
        namer
    }

    fn finish(
        &mut self,
        name: &'static str,
        dag: &Dag,
        graph: &Graph,
        sections: Vec<Section>,
    ) -> Function {
        let mut namer = self.namer();
        let results = self.results(&sections);
        let program: Program =
            schedule_named(dag, graph, &mut namer, Some(&mut self.prepare), &results);
        Function {
            name,
            program,
            sections,
            results,
        }
    }

    /// What each output is called: `u_dot`, `d_u_dot_d_w`, …
    fn results(&self, sections: &[Section]) -> Vec<String> {
        let layout = &self.derived.layout;
        let names = sections.iter().flat_map(|section| {
            (0..section.len).map(|k| {
                let Some(pattern) = &section.pattern else {
                    return match section.name {
                        "q" => layout.quantities[k].clone(),
                        "l" => format!("margin_{}", k + 1),
                        name => self.row_name(name, k),
                    };
                };
                let (row, column) = pattern[k];
                let column = match section.name {
                    "j" | "dy_dx" => &layout.states[column as usize],
                    "dy_dmarker" => &layout.marker[column as usize],
                    _ => &layout.parameters[self.columns[column as usize]],
                };
                let value = if section.name.starts_with('j') {
                    "dx"
                } else {
                    "y"
                };
                format!("d_{}_d_{column}", self.row_name(value, row as usize))
            })
        });
        names.collect()
    }

    fn symbol_name(&self, symbol: Symbol) -> String {
        let layout = &self.derived.layout;
        match symbol {
            Symbol::State(k) => layout.states[k as usize].clone(),
            Symbol::Parameter(k) => layout.parameters[k as usize].clone(),
            Symbol::Marker(k) => layout.marker[k as usize].clone(),
            Symbol::Time => "time".into(),
            Symbol::Pi => "pi".into(),
            Symbol::Local(k) => format!("local_{k}"),
        }
    }

    fn row_name(&self, value: &str, row: usize) -> String {
        match value {
            "dx" => format!("{}_dot", self.derived.layout.states[row]),
            _ => format!("seen_{}", ["x", "y", "z"][row % 3]),
        }
    }
}

fn dense(name: &'static str, len: usize) -> Section {
    Section {
        name,
        len,
        pattern: None,
    }
}
