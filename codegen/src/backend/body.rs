//! Language-independent function bodies: variables, loads, statements, stores and comments in order.

mod variables;

use crate::compile::Compiled;
use crate::program::{Function, Op, Operand};
use crate::schedule::pairs::sin_cos_pairs;
use std::collections::{HashMap, HashSet};
pub(crate) use variables::Variables;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Step {
    /// Comment that quotes a source line of the model, by index into `Lowered::provenance`.
    Source(usize),
    Load(Operand),
    Let(usize),
    SinCos {
        sin: usize,
        cos: usize,
        /// Operand whose value is the angle, rad.
        angle: Operand,
    },
    Store {
        output: usize,
        section: usize,
        element: usize,
    },
    /// Blank line between the computed statements and the stores of outputs that are constants or inputs.
    Gap,
}

/// Body of a generated function as a list of lines that use named local variables.
///
/// Inputs are loaded at their first use and results stored as soon as they are computed, which shortens the live ranges
/// of variables.
pub(crate) struct Body<'a> {
    pub compiled: &'a Compiled,
    pub function: &'a Function,
    pub variables: Variables,
    pub steps: Vec<Step>,
}

impl<'a> Body<'a> {
    /// Lists the lines of a function body; `is_reserved` excludes names of variables.
    pub fn new(
        compiled: &'a Compiled,
        function: &'a Function,
        is_reserved: impl Fn(&str) -> bool,
    ) -> Body<'a> {
        let variables = Variables::new(compiled, function, is_reserved);
        let steps = Planner::new(compiled, function, &variables).run();
        Body {
            compiled,
            function,
            variables,
            steps,
        }
    }

    pub fn op(&self, statement: usize) -> &'a Op {
        &self.function.program.statements[statement].op
    }

    /// `file:line  text` of an entry of `Lowered::provenance`, truncated to 94 characters.
    pub fn source_line(&self, origin: usize) -> String {
        const MAX_CHARS: usize = 94;
        let origin = &self.compiled.lowered.provenance[origin];
        let file = origin.source.rsplit('/').next().unwrap_or(&origin.source);
        let line = format!("{file}:{}  {}", origin.line, origin.text);
        let mut line: String = line
            .chars()
            .map(|c| if c.is_control() { ' ' } else { c })
            .collect();
        if line.chars().count() > MAX_CHARS {
            line = line.chars().take(MAX_CHARS - 2).collect::<String>() + " …";
        }
        line
    }

    pub fn reads(&self, input: Input) -> bool {
        self.function
            .program
            .operands()
            .any(|operand| Input::of(operand) == Some(input))
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Input {
    Time,
    State,
    Parameters,
    Prepared,
    Marker,
}

impl Input {
    /// Input argument to which an operand belongs; `None` for constants and statement results.
    pub fn of(operand: Operand) -> Option<Input> {
        match operand {
            Operand::Time => Some(Input::Time),
            Operand::State(_) => Some(Input::State),
            Operand::Parameter(_) => Some(Input::Parameters),
            Operand::Prepared(_) => Some(Input::Prepared),
            Operand::Marker(_) => Some(Input::Marker),
            Operand::Constant(_) | Operand::Temp(_) => None,
        }
    }

    pub fn name(self) -> &'static str {
        match self {
            Input::Time => "time",
            Input::State => "state",
            Input::Parameters => "parameters",
            Input::Prepared => "prepared",
            Input::Marker => "marker",
        }
    }
}

/// Input array and element index of an operand; `None` for time, constants and statement results.
pub(crate) fn input_element(operand: Operand) -> Option<(Input, u32)> {
    match operand {
        Operand::State(k) | Operand::Parameter(k) | Operand::Prepared(k) | Operand::Marker(k) => {
            Some((Input::of(operand)?, k))
        }
        Operand::Time | Operand::Constant(_) | Operand::Temp(_) => None,
    }
}

struct Planner<'a> {
    compiled: &'a Compiled,
    function: &'a Function,
    variables: &'a Variables,
    /// For each statement of the program, by index, the indices of the function outputs that it computes.
    outputs: Vec<Vec<usize>>,
    /// For each statement of such a pair, the sine and cosine of one angle.
    pairs: HashMap<usize, (usize, usize)>,
    loaded: HashSet<(Input, u32)>,
    /// Source lines of the model that have been emitted as comments, as (name of the source text, line number).
    quoted: HashSet<(&'a str, usize)>,
    steps: Vec<Step>,
}

impl<'a> Planner<'a> {
    fn new(compiled: &'a Compiled, function: &'a Function, variables: &'a Variables) -> Self {
        let program = &function.program;
        let mut outputs = vec![Vec::new(); program.statements.len()];
        for (at, output) in program.outputs.iter().enumerate() {
            if let Some(temp) = output.temp() {
                outputs[temp].push(at);
            }
        }
        Planner {
            compiled,
            function,
            variables,
            outputs,
            pairs: sin_cos_pairs(program),
            loaded: HashSet::new(),
            quoted: HashSet::new(),
            steps: Vec::new(),
        }
    }

    fn run(mut self) -> Vec<Step> {
        let mut computed = vec![false; self.function.program.statements.len()];
        for k in 0..computed.len() {
            self.statement(k, &mut computed);
        }
        let outputs = &self.function.program.outputs;
        let direct: Vec<usize> = (0..outputs.len())
            .filter(|&at| !matches!(outputs[at], Operand::Temp(_)))
            .collect();
        if !direct.is_empty() && !self.steps.is_empty() {
            self.steps.push(Step::Gap);
        }
        for at in direct {
            self.load(outputs[at]);
            self.store(at);
        }
        self.steps
    }

    fn statement(&mut self, k: usize, computed: &mut [bool]) {
        let statement = &self.function.program.statements[k];
        let stored = std::mem::take(&mut self.outputs[k]);
        if self.variables.of_statement(k).is_none() {
            if !stored.is_empty() {
                self.load_operands(k);
            }
        } else if !computed[k] {
            self.load_operands(k);
            if let Some(about) = statement.about {
                self.quote(about);
            }
            match (self.pairs.get(&k).copied(), statement.op) {
                (Some((sin, cos)), Op::Unary(_, angle))
                    if self.variables.of_statement(sin).is_some()
                        && self.variables.of_statement(cos).is_some() =>
                {
                    computed[sin] = true;
                    computed[cos] = true;
                    self.steps.push(Step::SinCos { sin, cos, angle });
                }
                _ => self.steps.push(Step::Let(k)),
            }
        }
        for at in stored {
            self.store(at);
        }
    }

    fn quote(&mut self, index: usize) {
        let origin = &self.compiled.lowered.provenance[index];
        if origin.line > 0 && self.quoted.insert((&origin.source, origin.line)) {
            self.steps.push(Step::Source(index));
        }
    }

    fn load(&mut self, operand: Operand) {
        if let Operand::Temp(t) = operand
            && self.variables.of_statement(t as usize).is_none()
        {
            self.load_operands(t as usize);
        } else if let Some(element) = input_element(operand)
            && self.loaded.insert(element)
        {
            self.steps.push(Step::Load(operand));
        }
    }

    fn load_operands(&mut self, k: usize) {
        for operand in self.function.program.statements[k].op.operands() {
            self.load(operand);
        }
    }

    fn store(&mut self, output: usize) {
        let mut start = 0;
        for (section, of) in self.function.sections.iter().enumerate() {
            if output < start + of.len {
                let element = output - start;
                self.steps.push(Step::Store {
                    output,
                    section,
                    element,
                });
                return;
            }
            start += of.len;
        }
    }
}
