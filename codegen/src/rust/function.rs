//! One function of a model as a file of its own.

use super::WIDTH;
use super::expression::{Writer, local};
use super::width::two_lines;
use crate::compile::Compiled;
use crate::count;
use crate::functions::MathFunction;
use crate::program::{Function, Op, Operand, Unary};
use std::collections::BTreeSet;
use std::fmt::Write;

/// Longest expression that is written inside another.
const INLINE: usize = 64;

/// Longest right side of a statement: what fits a line of its own.
const LINE: usize = WIDTH - 9;

/// The text of a function's file.
pub(super) fn emit(compiled: &Compiled, function: &Function) -> String {
    let mut text = head(compiled, function);
    let body = Body::new(compiled, function);
    let used = body.used_inputs();
    let _ = writeln!(text, "use lanes::Real;");
    let lines = body.lines();
    for constant in ["FRAC_PI_2", "PI"] {
        if lines
            .iter()
            .any(|line| line.contains(&format!("T::splat({constant})")))
        {
            let _ = writeln!(text, "use std::f64::consts::{constant};");
        }
    }
    text.push('\n');
    let _ = writeln!(text, "/// {}", sentence(function.name));
    let _ = writeln!(text, "///\n/// {}.", count::count(&function.program));
    let prepared = compiled.count_prepared(function.name).total();
    if prepared > 0 {
        let _ = writeln!(text, "/// `prepare` takes {prepared} operations for it.");
    }
    let inputs = inputs(compiled, function.name);
    text.push_str("#[inline(always)]\n");
    text.push_str(&signature(compiled, function, &inputs, &used));
    if lines.is_empty() {
        // as rustfmt has it
        if !text.ends_with("\n) {\n") {
            text.truncate(text.trim_end().len());
        }
        text.push_str("}\n");
        return text;
    }
    for line in lines {
        if line.is_empty() {
            text.push('\n');
        } else {
            let _ = writeln!(text, "    {line}");
        }
    }
    text.push_str("}\n");
    text
}

fn head(compiled: &Compiled, function: &Function) -> String {
    let mut text = String::from("// Written by `hyzer generate`; changes belong in the model.\n");
    let title = match function.name {
        "prepare" => "the constants of a flight",
        "f" => "derivatives of the states",
        "f_jac" => "derivatives of the states, and theirs by the states",
        "f_jac_par" => "derivatives of the states, and theirs by states and parameters",
        "observe" => "what is observed",
        "observe_jac" => "what is observed, and its derivatives",
        "quantities" => "the named quantities",
        _ => "the limits of the model",
    };
    let _ = writeln!(text, "//! `{}`: {title}.", compiled.name);
    text.push('\n');
    text
}

fn sentence(name: &str) -> &'static str {
    match name {
        "prepare" => "What depends on the parameters alone, once per flight.",
        "f" => "Derivatives `dx` of the states.",
        "f_jac" => {
            "Derivatives `dx` of the states and the entries `j` of their Jacobian, see `J_PATTERN`."
        }
        "f_jac_par" => {
            "`dx`, `j`, and the entries `jp` of the Jacobian by the parameters, see `JP_PATTERN`."
        }
        "observe" => "The marker, `seen`, in the inertial frame.",
        "observe_jac" => {
            "The marker, `seen`, and its derivatives by states, parameters and its own coordinates."
        }
        "quantities" => "Every named quantity, see `QUANTITIES`.",
        _ => "What must stay above `LIMITS`.",
    }
}

/// Inputs of a function: name, type.
pub(super) fn inputs(compiled: &Compiled, name: &str) -> Vec<(&'static str, String)> {
    let layout = &compiled.layout;
    let parameters = ("parameters", format!("&[T; {}]", layout.parameters.len()));
    if name == "prepare" {
        return vec![parameters];
    }
    let mut inputs = vec![
        ("time", "T".to_string()),
        ("state", format!("&[T; {}]", layout.states.len())),
        parameters,
        ("prepared", format!("&[T; {}]", compiled.prepared.len())),
    ];
    if name.starts_with("observe") {
        inputs.push(("marker", format!("&[T; {}]", layout.marker.len())));
    }
    inputs
}

fn signature(
    compiled: &Compiled,
    function: &Function,
    inputs: &[(&'static str, String)],
    used: &BTreeSet<&'static str>,
) -> String {
    let mut arguments: Vec<String> = inputs
        .iter()
        .map(|(name, kind)| {
            if used.contains(name) {
                format!("{name}: {kind}")
            } else {
                format!("_{name}: {kind}")
            }
        })
        .collect();
    for section in &function.sections {
        let name = output(section.name);
        let name = if section.len == 0 {
            format!("_{name}")
        } else {
            name.to_string()
        };
        arguments.push(format!("{name}: &mut [T; {}]", section.len));
    }
    let name = function.name;
    let short = format!("pub fn {name}<T: Real>({}) {{", arguments.join(", "));
    let _ = compiled;
    if short.len() <= WIDTH {
        return short + "\n";
    }
    let mut text = format!("pub fn {name}<T: Real>(\n");
    for argument in arguments {
        let _ = writeln!(text, "    {argument},");
    }
    text.push_str(") {\n");
    text
}

/// Name of an output argument.
pub(super) fn output(section: &'static str) -> &'static str {
    match section {
        // a state may well be called y
        "y" => "seen",
        "q" => "values",
        "l" => "margins",
        other => other,
    }
}

struct Body<'a> {
    compiled: &'a Compiled,
    function: &'a Function,
    writer: Writer<'a>,
}

impl<'a> Body<'a> {
    fn new(compiled: &'a Compiled, function: &'a Function) -> Body<'a> {
        let program = &function.program;
        let names = program
            .statements
            .iter()
            .map(|statement| statement.name.clone())
            .collect();
        let layout = &compiled.layout;
        let writer = Writer {
            program,
            names,
            states: &layout.states,
            parameters: &layout.parameters,
            prepared: &compiled.prepared,
            marker: &layout.marker,
        };
        let mut body = Body {
            compiled,
            function,
            writer,
        };
        body.break_up();
        body
    }

    /// Names the parts of expressions that would not fit a line.
    fn break_up(&mut self) {
        let program = &self.function.program;
        let layout = &self.compiled.layout;
        let mut taken: BTreeSet<String> = self.writer.names.iter().flatten().cloned().collect();
        taken.extend(
            layout
                .states
                .iter()
                .chain(&layout.parameters)
                .chain(&self.compiled.prepared)
                .cloned(),
        );
        // the name of the statement that each unnamed part ends up in
        let mut owner: Vec<Option<String>> = vec![None; program.statements.len()];
        for (output, name) in program.outputs.iter().zip(&self.function.results) {
            if let Operand::Temp(t) = output {
                owner[*t as usize].get_or_insert_with(|| name.clone());
            }
        }
        for k in (0..program.statements.len()).rev() {
            let mine = self.writer.names[k].clone().or_else(|| owner[k].clone());
            for operand in program.statements[k].op.operands() {
                if let Operand::Temp(t) = operand
                    && self.writer.names[t as usize].is_none()
                {
                    owner[t as usize] = mine.clone();
                }
            }
        }
        let mut name_part = |writer: &mut Writer<'_>, k: usize| {
            let base = owner[k].clone().unwrap_or_else(|| "rest".into());
            let base = format!("part_of_{}", short(&base));
            let mut name = base.clone();
            let mut n = 2;
            while !taken.insert(name.clone()) {
                name = format!("{base}_{n}");
                n += 1;
            }
            writer.names[k] = Some(name);
        };
        for k in 0..program.statements.len() {
            while let Some(part) = self.writer.part_of_wide_call(k) {
                name_part(&mut self.writer, part);
            }
            while self.writer.statement(k).len() > LINE {
                let operands = program.statements[k].op.operands();
                let Some(part) = self.writer.longest_part(&operands) else {
                    break;
                };
                name_part(&mut self.writer, part);
            }
            if self.writer.names[k].is_none() && self.writer.statement(k).len() > INLINE {
                name_part(&mut self.writer, k);
            }
        }
    }

    fn operands(&self) -> impl Iterator<Item = Operand> + '_ {
        let program = &self.function.program;
        let inside = program
            .statements
            .iter()
            .flat_map(|statement| statement.op.operands());
        inside.chain(program.outputs.iter().copied())
    }

    fn used_inputs(&self) -> BTreeSet<&'static str> {
        self.operands()
            .filter_map(|operand| match operand {
                Operand::Time => Some("time"),
                Operand::State(_) => Some("state"),
                Operand::Parameter(_) => Some("parameters"),
                Operand::Prepared(_) => Some("prepared"),
                Operand::Marker(_) => Some("marker"),
                Operand::Constant(_) | Operand::Temp(_) => None,
            })
            .collect()
    }

    /// Inputs stand where they are first needed, and results are stored where they are known: what is not needed yet or
    /// any more holds no register.
    fn lines(&self) -> Vec<String> {
        let mut lines = Lines::default();
        self.statements(&mut lines);
        let outputs = &self.function.program.outputs;
        let rest: Vec<usize> = (0..outputs.len())
            .filter(|&at| !matches!(outputs[at], Operand::Temp(_)))
            .collect();
        if !rest.is_empty() {
            lines.text.push(String::new());
        }
        for at in rest {
            self.load(outputs[at], &mut lines);
            self.store(at, &mut lines);
        }
        lines.text
    }

    /// Loads what an operand needs of the inputs and is not there yet.
    fn load(&self, operand: Operand, lines: &mut Lines) {
        let layout = &self.compiled.layout;
        let (array, names, k) = match operand {
            Operand::State(k) => ("state", &layout.states, k),
            Operand::Parameter(k) => ("parameters", &layout.parameters, k),
            Operand::Prepared(k) => ("prepared", &self.compiled.prepared, k),
            Operand::Marker(k) => ("marker", &layout.marker, k),
            Operand::Temp(t) if self.writer.names[t as usize].is_none() => {
                return self.load_all(t as usize, lines);
            }
            Operand::Time | Operand::Constant(_) | Operand::Temp(_) => return,
        };
        if lines.loaded.insert((array, k)) {
            let name = local(&names[k as usize]);
            lines.text.push(format!("let {name} = {array}[{k}];"));
        }
    }

    fn load_all(&self, k: usize, lines: &mut Lines) {
        for operand in self.function.program.statements[k].op.operands() {
            self.load(operand, lines);
        }
    }

    fn statements(&self, lines: &mut Lines) {
        let program = &self.function.program;
        let mut said: BTreeSet<(String, usize)> = BTreeSet::new();
        let mut done = vec![false; program.statements.len()];
        let mut results: Vec<Vec<usize>> = vec![Vec::new(); program.statements.len()];
        for (at, output) in program.outputs.iter().enumerate() {
            if let Operand::Temp(t) = output {
                results[*t as usize].push(at);
            }
        }
        for (k, statement) in program.statements.iter().enumerate() {
            let stored = std::mem::take(&mut results[k]);
            let Some(name) = &self.writer.names[k] else {
                for at in stored {
                    self.load_all(k, lines);
                    self.store(at, lines);
                }
                continue;
            };
            if !done[k] {
                self.load_all(k, lines);
                if let Some(about) = &statement.about {
                    let origin = &self.compiled.derived.origins[about.origin];
                    if origin.line > 0 && said.insert((origin.source.clone(), origin.line)) {
                        lines.text.push(String::new());
                        let comment = comment(&origin.source, origin.line, &origin.text);
                        lines.text.push(comment);
                    }
                }
                if let Op::Unary(
                    Unary::Call(MathFunction::Sin) | Unary::Call(MathFunction::Cos),
                    angle,
                ) = statement.op
                    && let Some((sin, cos)) = self.sin_cos(k, angle, &mut done)
                {
                    lines.text.push(format!(
                        "let ({sin}, {cos}) = {}.sin_cos();",
                        self.writer.operand(angle)
                    ));
                } else {
                    let left = format!("let {name} =");
                    lines.text.extend(self.writer.statement_lines(&left, k));
                }
            }
            for at in stored {
                self.store(at, lines);
            }
        }
    }

    /// Names of sine and cosine where both are needed.
    fn sin_cos(&self, k: usize, angle: Operand, done: &mut [bool]) -> Option<(String, String)> {
        let statements = &self.function.program.statements;
        let find = |unary: Unary| {
            let at =
                (k..statements.len()).find(|&at| statements[at].op == Op::Unary(unary, angle))?;
            Some((at, self.writer.names[at].clone()?))
        };
        let ((sin, sin_name), (cos, cos_name)) = (
            find(Unary::Call(MathFunction::Sin))?,
            find(Unary::Call(MathFunction::Cos))?,
        );
        done[sin] = true;
        done[cos] = true;
        Some((sin_name, cos_name))
    }

    /// Writes a result to its place.
    fn store(&self, at: usize, lines: &mut Lines) {
        let mut start = 0;
        let section = self.function.sections.iter().find(|section| {
            start += section.len;
            at < start
        });
        let Some(section) = section else { return };
        let k = at + section.len - start;
        let name = &self.function.results[at];
        let value = self.writer.operand(self.function.program.outputs[at]);
        let place = format!("{}[{k}] =", output(section.name));
        let plain = format!("{place} {value};");
        let note = if section.pattern.is_some() && value != *name {
            format!(" // {name}")
        } else {
            String::new()
        };
        if plain.len() + note.len() + 4 <= WIDTH {
            lines.text.push(plain + &note);
        } else {
            if !note.is_empty() {
                lines.text.push(note.trim().to_string());
            }
            let part = self.writer.part(self.function.program.outputs[at]);
            lines.text.extend(match part {
                Some(k) => self.writer.statement_lines(&place, k),
                None => two_lines(&place, &value),
            });
        }
    }
}

/// Lines of a body, and the inputs that are loaded.
#[derive(Default)]
struct Lines {
    text: Vec<String>,
    loaded: BTreeSet<(&'static str, u32)>,
}

/// A name cut at a word, so that two of them fit a line.
fn short(name: &str) -> &str {
    const MOST: usize = 24;
    if name.len() <= MOST {
        return name;
    }
    name[..MOST]
        .rfind('_')
        .map_or(&name[..MOST], |at| &name[..at])
}

fn comment(source: &str, line: usize, text: &str) -> String {
    let file = source.rsplit('/').next().unwrap_or(source);
    let mut comment = format!("// {file}:{line}  {text}");
    if comment.chars().count() > WIDTH - 6 {
        comment = comment.chars().take(WIDTH - 9).collect::<String>() + " …";
    }
    comment
}
