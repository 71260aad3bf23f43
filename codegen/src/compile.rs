//! The stages in order: lower, optimise, differentiate, specialize, optimise, schedule.

mod jacobians;

use crate::count;
use crate::graph::{NodeId, Symbol};
use crate::lower::{Lowered, lower};
use crate::number::Number;
use crate::program::{Function, Operand, Program, Section};
use crate::schedule::{Hoisted, Namer, schedule};
use crate::specialize::Values;
use crate::ssa::{Ssa, build};
use model_spec::layout::Layout;
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
    /// The model as expressions, with the names and source lines of its quantities.
    pub lowered: Lowered,
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
    let places = compiler.lowered.layout.parameters.len();
    for &(place, value) in fixed.iter().filter(|&&(place, _)| place < places) {
        let symbol = Symbol::Parameter(place as u32);
        compiler.fixed.insert(symbol, Number::literal(value, None));
    }
    compiler.effort = effort;
    compiler.run(&model.name)
}

/// Rates of the states, then the observation, without derivatives and with nothing hoisted: a program for models that are
/// compared by their values alone, in a tenth of the time of [`compile`].
pub fn compile_values(model: &Model) -> (Layout, Program) {
    let Lowered {
        mut graph,
        layout,
        dx,
        observation,
        ..
    } = lower(model);
    let wanted: Vec<NodeId> = dx
        .into_iter()
        .chain(observation.into_iter().flatten())
        .collect();
    let mut ssa = build(&graph, &wanted);
    ssa.optimise();
    let mut namer = Namer::new(&layout.states, &layout.parameters, &[]);
    let program = schedule(&ssa, &mut graph, &mut namer, None, &[]);
    (layout, program)
}

struct Compiler {
    lowered: Lowered,
    /// Constants in the place of parameters.
    fixed: Values,
    effort: Effort,
    columns: Vec<usize>,
    hoisted: Hoisted,
    quantity_names: Vec<String>,
}

impl Compiler {
    fn new(model: &Model, selection: &Selection) -> Compiler {
        let lowered = lower(model);
        let all = lowered.layout.parameters.len();
        let columns = match selection {
            Selection::All => (0..all).collect(),
            Selection::Only(places) => places
                .iter()
                .copied()
                .filter(|&place| place < all)
                .collect(),
        };
        let names = lowered.provenance.iter().map(|p| p.name.clone());
        Compiler {
            hoisted: Hoisted::new(&lowered.layout.parameters),
            quantity_names: names.collect(),
            lowered,
            fixed: Values::default(),
            effort: Effort::Full,
            columns,
        }
    }

    fn run(mut self, name: &str) -> Compiled {
        let (motion, observed) = self.differentiable();
        let [f, f_jac, f_jac_par] = self.motion(motion);
        let [observe, observe_jac] = self.observation(observed);
        let named: Vec<NodeId> = self.lowered.quantities.iter().map(|q| q.1).collect();
        let quantities = self.values("quantities", "q", &named);
        let limits = self.lowered.limits.clone();
        let limits = self.values("limits", "l", &limits);
        let prepared = self.hoisted.names().to_vec();
        let prepare = Function {
            name: "prepare",
            program: self.hoisted.program(&mut self.lowered.graph),
            sections: vec![dense("prepared", prepared.len())],
            results: prepared.clone(),
        };
        Compiled {
            name: name.to_string(),
            layout: self.lowered.layout.clone(),
            lowered: self.lowered,
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

    /// The observation as a list: empty where nothing is observed.
    fn observed(&self) -> Vec<NodeId> {
        self.lowered
            .observation
            .map_or_else(Vec::new, |y| y.to_vec())
    }

    /// Values without derivatives.
    fn values(&mut self, name: &'static str, section: &'static str, values: &[NodeId]) -> Function {
        let ssa = self.optimised(values);
        self.scheduled(name, &ssa, vec![dense(section, values.len())])
    }

    fn optimised(&self, roots: &[NodeId]) -> Ssa {
        let mut ssa = build(&self.lowered.graph, roots);
        ssa.optimise();
        ssa
    }

    fn namer(&self) -> Namer {
        let layout = &self.lowered.layout;
        let mut namer = Namer::new(&layout.states, &layout.parameters, &self.quantity_names);
        namer.reserve(&layout.marker);
        namer
    }

    fn scheduled(&mut self, name: &'static str, ssa: &Ssa, sections: Vec<Section>) -> Function {
        let mut namer = self.namer();
        let results = self.results(&sections);
        let hoisted = Some(&mut self.hoisted);
        let program = schedule(ssa, &mut self.lowered.graph, &mut namer, hoisted, &results);
        Function {
            name,
            program,
            sections,
            results,
        }
    }

    /// What each output is called: `u_dot`, `d_u_dot_d_w`, …
    fn results(&self, sections: &[Section]) -> Vec<String> {
        let layout = &self.lowered.layout;
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
        let layout = &self.lowered.layout;
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
            "dx" => format!("{}_dot", self.lowered.layout.states[row]),
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
