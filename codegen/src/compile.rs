//! Compilation of a model: lowering, optimisation, differentiation, specialization, optimisation, scheduling.

mod jacobians;

use crate::count;
use crate::graph::{ExprGraph, NodeId, Symbol};
use crate::lower::{Lowered, lower};
use crate::number::Number;
use crate::program::{Function, Operand, Program, Section};
use crate::schedule::{Hoisted, Namer, schedule};
use crate::specialize::Values;
use crate::ssa::{Ssa, build};
use model_spec::layout::Layout;
use model_spec::model::Model;

/// Parameters with respect to which derivatives are computed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Selection {
    /// Derivatives with respect to all parameters.
    All,
    /// Derivatives with respect to selected parameters, given by their index in [`Layout::parameters`].
    Only(Vec<usize>),
}

/// Trade-off between compile time and the operation count of the Jacobians.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effort {
    /// Tries several elimination orders for each Jacobian and uses the one with the lowest cost; for generated code.
    Full,
    /// One elimination order, and `f_jac` from `f_jac_par`; for bytecode at run time.
    Quick,
}

/// Compiled model: its functions, their order of arguments, and source locations.
#[derive(Clone, Debug, Default)]
pub struct Compiled {
    /// Name of the model.
    pub name: String,
    /// Names and order of the states, parameters and auxiliary variables.
    pub layout: Layout,
    /// Model lowered to scalar expressions, with names and source locations of its auxiliary variables.
    pub(crate) lowered: Lowered,
    /// Parameter of each column of `jp` and `dy_dp`.
    pub columns: Vec<usize>,
    /// Computes the invariants once per flight, for all other functions.
    pub prepare: Function,
    /// Names of the invariants that `prepare` computes.
    pub prepared: Vec<String>,
    /// Function that computes the time derivatives `dx` of the states.
    pub f: Function,
    /// Function that computes the time derivatives `dx` of the states and their state Jacobian `j`.
    pub f_jac: Function,
    /// Computes the state derivatives `dx` with the Jacobians `j` and `jp`.
    pub f_jac_par: Function,
    /// Computes the marker position `y`, m, if the model has a measurement equation.
    pub observe: Function,
    /// Computes `y` and its Jacobians `dy_dx`, `dy_dp` and `dy_dmarker`.
    pub observe_jac: Function,
    /// Function that computes the values of all auxiliary variables of the model.
    pub quantities: Function,
    /// Computes the left-hand sides of the limits of validity.
    pub limits: Function,
}

impl Compiled {
    /// All functions, in the order of the fields.
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

    /// Returns the model function with the name `name`, such as `f_jac`; `None` if there is no such function.
    pub fn function(&self, name: &str) -> Option<&Function> {
        self.functions()
            .into_iter()
            .find(|function| function.name == name)
    }

    /// Counts the operations that a function leaves to `prepare`; none for an unknown name.
    pub fn count_prepared(&self, name: &str) -> count::Count {
        let Some(function) = self.function(name) else {
            return count::Count::default();
        };
        let program = &function.program;
        let slots = program.operands().filter_map(|operand| match operand {
            Operand::Prepared(slot) => Some(slot as usize),
            _ => None,
        });
        count::count_for(&self.prepare.program, &slots.collect::<Vec<_>>())
    }

    /// Counts the operations of a function; none for an unknown name.
    pub fn count(&self, name: &str) -> count::Count {
        let function = self.function(name);
        function
            .map(|function| count::count(&function.program))
            .unwrap_or_default()
    }
}

/// Compiles a model, with derivatives with respect to all parameters.
pub fn compile(model: &Model) -> Compiled {
    compile_for(model, &Selection::All)
}

/// Compiles a model, with derivatives with respect to the selected parameters.
pub fn compile_for(model: &Model, selection: &Selection) -> Compiled {
    Compiler::new(model, selection).run(&model.name)
}

/// Compiles a model in which some parameters are replaced by constants. `fixed` contains pairs (index in
/// [`Layout::parameters`], value); if an index occurs twice, the last value applies.
///
/// Derivatives are taken with respect to all selected parameters, including fixed ones, before the values are
/// substituted. Entries of the Jacobians that vanish at these values are not in the sparsity patterns. The compiled
/// functions ignore the fixed elements of the parameter array.
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

/// Compiles state derivatives and observation, without Jacobians, in a tenth of the time of [`compile`].
pub fn compile_values(model: &Model) -> (Layout, Program) {
    let mut lowered = lower(model);
    let observation = lowered.observation.into_iter().flatten();
    let wanted: Vec<NodeId> = lowered.dx.into_iter().chain(observation).collect();
    let program = scheduled_values(&mut lowered.graph, &lowered.layout, &wanted);
    (lowered.layout, program)
}

/// Program of the nodes `wanted`, without `prepare`.
pub(crate) fn scheduled_values(
    graph: &mut ExprGraph,
    layout: &Layout,
    wanted: &[NodeId],
) -> Program {
    let mut ssa = build(graph, wanted);
    ssa.optimise();
    let mut namer = Namer::new(&layout.states, &layout.parameters, &[]);
    schedule(&ssa, graph, &mut namer, None, &[])
}

#[derive(Clone)]
pub(crate) struct Compiler {
    pub(crate) lowered: Lowered,
    /// Values of the parameters that are replaced by constants, with the parameters' symbols as keys.
    fixed: Values,
    effort: Effort,
    columns: Vec<usize>,
    hoisted: Hoisted,
    quantity_names: Vec<String>,
}

impl Compiler {
    pub(crate) fn new(model: &Model, selection: &Selection) -> Compiler {
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
        Compiled {
            f,
            f_jac,
            f_jac_par,
            observe,
            observe_jac,
            quantities,
            limits,
            ..self.prepared(name)
        }
    }

    /// Compiled model with `prepare` alone, for the functions that have been compiled.
    pub(crate) fn prepared(mut self, name: &str) -> Compiled {
        let prepared = self.hoisted.names().to_vec();
        Compiled {
            name: name.to_string(),
            layout: self.lowered.layout.clone(),
            prepare: Function {
                name: "prepare",
                program: self.hoisted.program(&mut self.lowered.graph),
                sections: vec![dense("prepared", prepared.len())],
                results: prepared.clone(),
            },
            lowered: self.lowered,
            columns: self.columns,
            prepared,
            ..Compiled::default()
        }
    }

    /// Components of the observed position, m; empty without a measurement equation.
    fn observed(&self) -> Vec<NodeId> {
        self.lowered
            .observation
            .map_or_else(Vec::new, |y| y.to_vec())
    }

    /// Compiles a function of `values` without derivatives, with one output vector.
    fn values(&mut self, name: &'static str, section: &'static str, values: &[NodeId]) -> Function {
        let ssa = self.optimised(values);
        self.scheduled(name, &ssa, vec![dense(section, values.len())])
    }

    pub(crate) fn optimised(&self, roots: &[NodeId]) -> Ssa {
        let mut ssa = build(&self.lowered.graph, roots);
        ssa.optimise();
        ssa
    }

    pub(crate) fn namer(&self) -> Namer {
        let layout = &self.lowered.layout;
        let mut namer = Namer::new(&layout.states, &layout.parameters, &self.quantity_names);
        namer.reserve(&layout.marker);
        namer
    }

    pub(crate) fn scheduled(
        &mut self,
        name: &'static str,
        ssa: &Ssa,
        sections: Vec<Section>,
    ) -> Function {
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

    /// Names of all outputs in `sections` (output vectors and matrices such as `dx` and `j`): `u_dot`, `d_u_dot_d_w`, …
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

pub(crate) fn dense(name: &'static str, len: usize) -> Section {
    Section {
        name,
        len,
        pattern: None,
    }
}

/// Program of all values of a model: state derivatives, observation, limits, auxiliary variables.
#[derive(Clone, Debug)]
pub struct EveryValue {
    /// Names and order of the states and parameters.
    pub layout: Layout,
    /// Program that computes all outputs, without `prepare`.
    pub program: Program,
    /// Number of components of the observation: 3, or 0 without one.
    pub observed: usize,
    /// Number of outputs that are left-hand sides `EXPR` of limits of validity (statements `limit EXPR > bound`).
    pub limits: usize,
    /// Number of components of each auxiliary variable, 1 or 3, in order.
    pub lets: Vec<usize>,
}

/// Compiles the values of a model, without Jacobians.
pub fn compile_every_value(model: &Model) -> EveryValue {
    let mut lowered = lower(model);
    let observation: Vec<_> = lowered.observation.into_iter().flatten().collect();
    let mut wanted = lowered.dx;
    wanted.extend(&observation);
    wanted.extend(&lowered.limits);
    wanted.extend(lowered.lets.iter().flatten());
    EveryValue {
        program: scheduled_values(&mut lowered.graph, &lowered.layout, &wanted),
        layout: lowered.layout,
        observed: observation.len(),
        limits: lowered.limits.len(),
        lets: lowered.lets.iter().map(Vec::len).collect(),
    }
}
