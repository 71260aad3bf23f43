//! One function of a model as a file of its own.

use super::WIDTH;
use super::expression::{Writer, local};
use crate::compile::Compiled;
use crate::count;
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
            while self.writer.statement(k).len() > LINE {
                let Some(part) = self.longest_part(k) else {
                    break;
                };
                name_part(&mut self.writer, part);
            }
            if self.writer.names[k].is_none() && self.writer.statement(k).len() > INLINE {
                name_part(&mut self.writer, k);
            }
        }
    }

    /// The longest operand of a statement that is written inside it.
    fn longest_part(&self, k: usize) -> Option<usize> {
        let operands = self.function.program.statements[k].op.operands();
        let parts = operands.into_iter().filter_map(|operand| match operand {
            Operand::Temp(t) if self.writer.names[t as usize].is_none() => Some(t as usize),
            _ => None,
        });
        parts.max_by_key(|&part| self.writer.statement(part).len())
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

    fn lines(&self) -> Vec<String> {
        let mut lines = self.loads();
        self.statements(&mut lines);
        self.stores(&mut lines);
        lines
    }

    fn loads(&self) -> Vec<String> {
        let layout = &self.compiled.layout;
        let mut used: Vec<(u8, u32)> = self
            .operands()
            .filter_map(|operand| match operand {
                Operand::State(k) => Some((0, k)),
                Operand::Parameter(k) => Some((1, k)),
                Operand::Prepared(k) => Some((2, k)),
                Operand::Marker(k) => Some((3, k)),
                _ => None,
            })
            .collect();
        used.sort_unstable();
        used.dedup();
        let line = |(kind, k): (u8, u32)| {
            let (array, names) = match kind {
                0 => ("state", &layout.states),
                1 => ("parameters", &layout.parameters),
                2 => ("prepared", &self.compiled.prepared),
                _ => ("marker", &layout.marker),
            };
            format!("let {} = {array}[{k}];", local(&names[k as usize]))
        };
        used.into_iter().map(line).collect()
    }

    fn statements(&self, lines: &mut Vec<String>) {
        let program = &self.function.program;
        let mut said: BTreeSet<(String, usize)> = BTreeSet::new();
        let mut done = vec![false; program.statements.len()];
        for (k, statement) in program.statements.iter().enumerate() {
            let Some(name) = &self.writer.names[k] else {
                continue;
            };
            if done[k] {
                continue;
            }
            if let Some(about) = &statement.about {
                let origin = &self.compiled.derived.origins[about.origin];
                if origin.line > 0 && said.insert((origin.source.clone(), origin.line)) {
                    lines.push(String::new());
                    lines.push(comment(&origin.source, origin.line, &origin.text));
                }
            }
            if let Op::Unary(Unary::Sin | Unary::Cos, angle) = statement.op
                && let Some((sin, cos)) = self.sin_cos(k, angle, &mut done)
            {
                lines.push(format!(
                    "let ({sin}, {cos}) = {}.sin_cos();",
                    self.writer.operand(angle)
                ));
                continue;
            }
            push_let(lines, &format!("let {name} ="), &self.writer.statement(k));
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
        let ((sin, sin_name), (cos, cos_name)) = (find(Unary::Sin)?, find(Unary::Cos)?);
        done[sin] = true;
        done[cos] = true;
        Some((sin_name, cos_name))
    }

    fn stores(&self, lines: &mut Vec<String>) {
        let names = &self.function.results;
        let mut at = 0;
        for section in &self.function.sections {
            if section.len > 0 {
                lines.push(String::new());
            }
            for k in 0..section.len {
                let value = self.writer.operand(self.function.program.outputs[at]);
                let place = format!("{}[{k}] =", output(section.name));
                let plain = format!("{place} {value};");
                let note = if section.pattern.is_some() && value != names[at] {
                    format!(" // {}", names[at])
                } else {
                    String::new()
                };
                if plain.len() + note.len() + 4 <= WIDTH {
                    lines.push(plain + &note);
                } else {
                    if !note.is_empty() {
                        lines.push(note.trim().to_string());
                    }
                    push_let(lines, &place, &value);
                }
                at += 1;
            }
        }
    }
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

/// `left right;`, on two lines where one is too short.
fn push_let(lines: &mut Vec<String>, left: &str, right: &str) {
    if 4 + left.len() + 1 + right.len() < WIDTH {
        lines.push(format!("{left} {right};"));
    } else {
        lines.push(left.to_string());
        lines.push(format!("    {right};"));
    }
}

fn comment(source: &str, line: usize, text: &str) -> String {
    let file = source.rsplit('/').next().unwrap_or(source);
    let mut comment = format!("// {file}:{line}  {text}");
    if comment.chars().count() > WIDTH - 6 {
        comment = comment.chars().take(WIDTH - 9).collect::<String>() + " …";
    }
    comment
}
