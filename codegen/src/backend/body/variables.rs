//! Names of the local variables of a generated function.

use super::input_element;
use crate::compile::Compiled;
use crate::program::{Binary, Function, Op, Operand, Program, Unary};
use std::collections::{HashMap, HashSet};

/// Maximum length, in characters, of the name that follows `part_of_` in the variable name of a subexpression.
const MAX_STEM: usize = 24;

pub(crate) struct Variables {
    inputs: HashMap<(super::Input, u32), String>,
    statements: Vec<Option<String>>,
}

impl Variables {
    pub(super) fn new(
        compiled: &Compiled,
        function: &Function,
        is_reserved: impl Fn(&str) -> bool,
    ) -> Variables {
        let mut names = UniqueNames {
            taken: HashSet::new(),
            numbers: HashMap::new(),
            is_reserved,
        };
        let mut inputs = HashMap::new();
        for operand in function.program.operands() {
            if let Some(element) = input_element(operand)
                && !inputs.contains_key(&element)
            {
                inputs.insert(element, names.take(&input_name(compiled, operand)));
            }
        }
        let statements = &function.program.statements;
        let mut variables = Variables {
            inputs,
            statements: statements
                .iter()
                .map(|statement| statement.name.as_deref().map(|name| names.take(name)))
                .collect(),
        };
        variables.split_long_expressions(function, &mut names);
        variables
    }

    /// Name of the variable of statement `k`; `None` if the statement is inlined into the expressions that use it.
    pub fn of_statement(&self, k: usize) -> Option<&str> {
        self.statements[k].as_deref()
    }

    /// Name of the variable of an operand; `None` for time, constants and inlined statements.
    pub fn of(&self, operand: Operand) -> Option<&str> {
        match operand {
            Operand::Temp(t) => self.of_statement(t as usize),
            other => self.inputs.get(&input_element(other)?).map(String::as_str),
        }
    }

    /// Assigns variables to inlined subexpressions that would make a line too long.
    fn split_long_expressions(
        &mut self,
        function: &Function,
        names: &mut UniqueNames<impl Fn(&str) -> bool>,
    ) {
        let program = &function.program;
        let owners = self.owners(function);
        for k in 0..program.statements.len() {
            while self.widths(program).statement(k) > MAX_STATEMENT {
                let Some(part) = self.widths(program).widest_part(k) else {
                    break;
                };
                self.statements[part] = Some(part_name(owners[part].as_deref(), names));
            }
            if self.statements[k].is_none() && self.widths(program).statement(k) > MAX_INLINE {
                self.statements[k] = Some(part_name(owners[k].as_deref(), names));
            }
        }
    }

    fn widths<'a>(
        &'a self,
        program: &'a Program,
    ) -> Widths<'a, impl Fn(Operand) -> Option<usize> + 'a> {
        Widths {
            program,
            variable: |operand| Some(self.of(operand)?.chars().count()),
        }
    }

    /// For each inlined statement, the variable or output whose expression contains it.
    fn owners(&self, function: &Function) -> Vec<Option<String>> {
        let program = &function.program;
        let mut owners: Vec<Option<String>> = vec![None; program.statements.len()];
        for (output, name) in program.outputs.iter().zip(&function.results) {
            if let Operand::Temp(t) = output {
                owners[*t as usize].get_or_insert_with(|| name.clone());
            }
        }
        for k in (0..program.statements.len()).rev() {
            let owner = self.statements[k].clone().or_else(|| owners[k].clone());
            for operand in program.statements[k].op.operands() {
                if let Operand::Temp(t) = operand
                    && self.statements[t as usize].is_none()
                {
                    owners[t as usize].clone_from(&owner);
                }
            }
        }
        owners
    }
}

fn input_name(compiled: &Compiled, operand: Operand) -> String {
    let layout = &compiled.layout;
    let (names, k) = match operand {
        Operand::State(k) => (&layout.states[..], k),
        Operand::Parameter(k) => (&layout.parameters[..], k),
        Operand::Prepared(k) => (&compiled.prepared[..], k),
        Operand::Marker(k) => (&layout.marker[..], k),
        Operand::Time | Operand::Constant(_) | Operand::Temp(_) => return "value".into(),
    };
    names[k as usize].clone()
}

/// New name `part_of_…` for a subexpression of the variable or output `owner`.
fn part_name(owner: Option<&str>, names: &mut UniqueNames<impl Fn(&str) -> bool>) -> String {
    let owner = owner.unwrap_or("result");
    let stem = match owner.char_indices().nth(MAX_STEM) {
        None => owner,
        Some((end, _)) => {
            let cut = owner[..end].rfind('_').unwrap_or(end);
            &owner[..cut]
        }
    };
    let base = format!("part_of_{stem}");
    names.take_numbered(&base)
}

/// Generator of unique identifiers that are not reserved in the output language.
struct UniqueNames<F> {
    taken: HashSet<String>,
    /// Last numeric suffix that `take_numbered` used for each name.
    numbers: HashMap<String, usize>,
    is_reserved: F,
}

impl<F: Fn(&str) -> bool> UniqueNames<F> {
    fn is_free(&self, name: &str) -> bool {
        !self.taken.contains(name) && !(self.is_reserved)(name)
    }

    /// Returns `base` if unused, else `base` with the smallest unused numeric suffix from 2.
    fn take_numbered(&mut self, base: &str) -> String {
        let mut n = self.numbers.get(base).copied().unwrap_or(0);
        loop {
            n += 1;
            let name = match n {
                1 => base.to_string(),
                n => format!("{base}_{n}"),
            };
            if self.is_free(&name) {
                self.numbers.insert(base.to_string(), n);
                self.taken.insert(name.clone());
                return name;
            }
        }
    }

    /// Returns `name`, with underscores appended until it is neither in use nor reserved.
    fn take(&mut self, name: &str) -> String {
        let mut name = name.to_string();
        while !self.is_free(&name) {
            name.push('_');
        }
        self.taken.insert(name.clone());
        name
    }
}

/// Maximum width, in characters, of an inlined expression.
pub(super) const MAX_INLINE: usize = 64;

pub(super) const MAX_STATEMENT: usize = 84;

/// Estimated width of a function or method call without its operands, characters.
const CALL: usize = 11;

/// Estimated width of a numeric constant, characters.
const CONSTANT: usize = 13;

/// Estimates printed widths; `variable` is the length of the name of an operand's variable.
pub(super) struct Widths<'a, V> {
    pub program: &'a Program,
    pub variable: V,
}

impl<V: Fn(Operand) -> Option<usize>> Widths<'_, V> {
    pub fn statement(&self, k: usize) -> usize {
        let op = &self.program.statements[k].op;
        let operands: usize = op
            .operands()
            .into_iter()
            .map(|operand| self.operand(operand))
            .sum();
        operands + own_width(op)
    }

    /// Index of the statement that is the widest inlined operand of statement `k`; `None` if no operand is inlined.
    pub fn widest_part(&self, k: usize) -> Option<usize> {
        let operands = self.program.statements[k].op.operands();
        let parts = operands.into_iter().filter_map(|operand| match operand {
            Operand::Temp(t) if (self.variable)(operand).is_none() => Some(t as usize),
            _ => None,
        });
        parts.max_by_key(|&part| self.statement(part))
    }

    fn operand(&self, operand: Operand) -> usize {
        match ((self.variable)(operand), operand) {
            (Some(width), _) => width,
            (None, Operand::Temp(t)) => self.statement(t as usize),
            (None, Operand::Constant(_)) => CONSTANT,
            (None, _) => "time".len(),
        }
    }
}

/// Estimated width of an operation without its operands, characters.
fn own_width(op: &Op) -> usize {
    match op {
        Op::Unary(Unary::Neg, _) => 1,
        Op::Unary(Unary::Recip, _) => CONSTANT + 3,
        Op::Binary(Binary::Add | Binary::Sub | Binary::Mul | Binary::Div, ..) => 3,
        _ => CALL,
    }
}
