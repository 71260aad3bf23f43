//! A compiled model as JSON: what other languages interpret, with the statements that the tape evaluates.
//!
//! The format is described in `docs/reference/ir.md`, and by the JSON Schema beside that page.

use crate::compile::{Compiled, compile};
use crate::functions::{BinaryFunction, MathFunction};
use crate::program::{Binary, Function, Fused, Op, Operand, Section, Unary};
use crate::table::{PiecewiseCubic, TableFunction, Tables};
use model_spec::layout::{Layout, is_unlisted};
use model_spec::model::{Input, Model, Parameter, Shape, State, ValidityLimit};
use std::fmt::Write;

/// Name and version of the format, the value of `schema`.
pub const SCHEMA: &str = "hyzer.ir/1";

/// Error of writing a model as JSON.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum IrError {
    /// A constant of the model has no JSON.
    #[error(
        "model `{model}`: {place} contains {value}, which JSON cannot hold; expected finite numbers: change the constants of the model that it follows from"
    )]
    NotFinite {
        /// Name of the model.
        model: String,
        /// Function, table or declaration with the constant.
        place: String,
        /// Value of the constant: infinite, or not a number.
        value: f64,
    },
}

/// Compiles a model and returns it as JSON: names, units and default values, then the statements of each function.
/// Equal models give equal text.
pub fn json(model: &Model) -> Result<String, IrError> {
    let compiled = compile(model);
    let written = || {
        let mut fields = declared(model, &compiled.layout)?;
        fields.extend(compiled_fields(&compiled)?);
        Ok(object(&fields, "\n") + "\n")
    };
    written().map_err(|NotFinite { place, value }| IrError::NotFinite {
        model: model.name.clone(),
        place,
        value,
    })
}

fn declared(model: &Model, layout: &Layout) -> Result<Vec<Field>, NotFinite> {
    let effects = model.effects.iter().map(|effect| string(&effect.name));
    Ok(vec![
        ("schema", string(SCHEMA)),
        ("version", string(env!("CARGO_PKG_VERSION"))),
        ("model", string(&model.name)),
        ("effects", row(effects)),
        ("states", each(&model.states, state)?),
        ("parameters", parameters(model)?),
        ("inputs", each(&model.inputs, |i| Ok(input(model, i)))?),
        ("marker", row(layout.marker.iter().map(|name| string(name)))),
        ("quantities", quantities(model, layout)),
        ("limits", each(&model.limits, limit)?),
    ])
}

fn each<T>(
    items: &[T],
    json: impl Fn(&T) -> Result<String, NotFinite>,
) -> Result<String, NotFinite> {
    Ok(lines(
        items.iter().map(json).collect::<Result<Vec<_>, _>>()?,
    ))
}

fn state(state: &State) -> Result<String, NotFinite> {
    value(&state.name, &state.unit_text, state.value, &[])
}

/// Object of a value with a name, a unit and a default; `more` are further fields.
fn value(name: &str, unit: &str, value: f64, more: &[Field]) -> Result<String, NotFinite> {
    let mut fields = vec![
        ("name", string(name)),
        ("unit", string(unit)),
        ("value", number(value, name)?),
    ];
    fields.extend_from_slice(more);
    Ok(object(&fields, ""))
}

fn parameters(model: &Model) -> Result<String, NotFinite> {
    let constants = model
        .params
        .iter()
        .map(|constant| parameter(constant, false));
    let coefficients = model.coefficients.iter().map(|c| parameter(c, true));
    let inputs = model.inputs.iter().flat_map(components);
    let all = constants.chain(coefficients).chain(inputs);
    Ok(lines(all.collect::<Result<Vec<_>, _>>()?))
}

fn parameter(parameter: &Parameter, coefficient: bool) -> Result<String, NotFinite> {
    let Parameter {
        name, unit_text, ..
    } = parameter;
    let bounds = match parameter.bounds {
        Some((low, high)) => numbers(&[low, high], name)?,
        None => "null".into(),
    };
    let more = [
        ("coefficient", coefficient.to_string()),
        ("varies", parameter.varies.to_string()),
        ("bounds", bounds),
        ("doc", string(&parameter.doc)),
    ];
    value(name, unit_text, parameter.value, &more)
}

fn components(input: &Input) -> [Result<String, NotFinite>; 3] {
    [0, 1, 2].map(|k| {
        let more = [
            ("coefficient", "false".into()),
            ("varies", "false".into()),
            ("bounds", "null".into()),
            ("doc", string(&input.doc)),
        ];
        let name = component(&input.name, k);
        value(&name, &input.unit_text, input.value[k], &more)
    })
}

fn component(vector: &str, k: usize) -> String {
    format!("{vector}_{}", ["x", "y", "z"][k])
}

fn input(model: &Model, input: &Input) -> String {
    let parameters = [0, 1, 2].map(|k| string(&component(&input.name, k)));
    let fields = [
        ("name", string(&input.name)),
        ("unit", string(&input.unit_text)),
        ("frame", string(&model.frames[input.frame].name)),
        ("parameters", row(parameters)),
    ];
    object(&fields, "")
}

fn quantities(model: &Model, layout: &Layout) -> String {
    let known = model.aux_variables.iter().zip(is_unlisted(model));
    let units = known.filter(|(_, observed)| !observed).flat_map(|(v, _)| {
        let components = match v.value.shape {
            Shape::Scalar => 1,
            Shape::Vector(_) => 3,
        };
        std::iter::repeat_n(v.value.unit.to_string(), components)
    });
    lines(
        layout
            .quantities
            .iter()
            .zip(units)
            .map(|(name, unit)| object(&[("name", string(name)), ("unit", string(&unit))], "")),
    )
}

fn limit(limit: &ValidityLimit) -> Result<String, NotFinite> {
    let fields = [
        ("bound", number(limit.bound, "a limit")?),
        ("reason", string(&limit.reason)),
    ];
    Ok(object(&fields, ""))
}

const INPUTS: [&str; 5] = ["t", "x", "p", "k", "m"];

fn compiled_fields(compiled: &Compiled) -> Result<Vec<Field>, NotFinite> {
    let named = [
        ("prepare", &compiled.prepare),
        ("rhs", &compiled.f),
        ("jacobian", &compiled.f_jac_par),
        ("observe", &compiled.observe),
        ("observe_jacobian", &compiled.observe_jac),
        ("quantities", &compiled.quantities),
        ("limits", &compiled.limits),
    ];
    let mut writer = Writer {
        compiled,
        tables: Vec::new(),
    };
    let mut functions = Vec::new();
    for (name, function) in named {
        functions.push((name, writer.function(name, function)?));
    }
    // The tables of all programs are those of the model.
    let tables = &compiled.f.program.tables;
    let tables = writer.tables.iter().map(|&used| table(tables, used));
    let tables = lines(tables.collect::<Result<Vec<_>, _>>()?);
    Ok(vec![
        ("tables", tables),
        ("functions", object(&functions, "\n")),
    ])
}

struct Writer<'a> {
    compiled: &'a Compiled,
    tables: Vec<Looked>,
}

/// A table that a function looks up, or a derivative of one.
#[derive(Clone, Copy, PartialEq)]
enum Looked {
    One(TableFunction),
    Two(TableFunction<2>),
}

impl Writer<'_> {
    fn function(&mut self, name: &str, function: &Function) -> Result<String, NotFinite> {
        let mut statements = Vec::new();
        for statement in &function.program.statements {
            statements.push(self.statement(&statement.op, name)?);
        }
        let fields = [
            ("inputs", inputs(function)),
            ("statements", lines(statements)),
            ("outputs", self.outputs(function, name)?),
        ];
        Ok(object(&fields, ""))
    }

    /// `["operation", operands…]`; a lookup has the index of its table before the operand.
    fn statement(&mut self, op: &Op, function: &str) -> Result<String, NotFinite> {
        let mut items = vec![string(operation(op))];
        if let Op::Unary(Unary::Call(MathFunction::Table(table)), _) = *op {
            items.push(self.table(Looked::One(table)).to_string());
        }
        if let Op::Binary(Binary::Call(BinaryFunction::Table(table)), ..) = *op {
            items.push(self.table(Looked::Two(table)).to_string());
        }
        for operand in op.operands() {
            items.push(written(operand, function)?);
        }
        Ok(row(items))
    }

    fn table(&mut self, table: Looked) -> usize {
        let known = self.tables.iter().position(|&known| known == table);
        known.unwrap_or_else(|| {
            self.tables.push(table);
            self.tables.len() - 1
        })
    }

    fn outputs(&self, function: &Function, name: &str) -> Result<String, NotFinite> {
        let mut outputs = Vec::new();
        for section in &function.sections {
            let values = &function.program.outputs[function.range(section.name)];
            let values = values.iter().map(|&operand| written(operand, name));
            let values = row(values.collect::<Result<Vec<_>, _>>()?);
            let mut fields = vec![
                ("name", string(section.name)),
                ("shape", self.shape(section)),
                ("values", values),
            ];
            if let Some(pattern) = &section.pattern {
                let entries = pattern
                    .iter()
                    .map(|(row, column)| format!("[{row},{column}]"));
                fields.push(("entries", row(entries)));
            }
            outputs.push(object(&fields, ""));
        }
        Ok(lines(outputs))
    }

    fn shape(&self, section: &Section) -> String {
        let layout = &self.compiled.layout;
        if section.pattern.is_none() {
            return format!("[{}]", section.len);
        }
        let rows = match section.name {
            "j" | "jp" => layout.states.len(),
            _ => self.compiled.observe.program.outputs.len(),
        };
        let columns = match section.name {
            "j" | "dy_dx" => layout.states.len(),
            "dy_dmarker" => layout.marker.len(),
            _ => self.compiled.columns.len(),
        };
        format!("[{rows},{columns}]")
    }
}

fn inputs(function: &Function) -> String {
    let read: Vec<&str> = function.program.operands().map(letter).collect();
    let inputs = INPUTS.into_iter().filter(|array| read.contains(array));
    row(inputs.map(string))
}

fn written(operand: Operand, function: &str) -> Result<String, NotFinite> {
    match operand {
        Operand::Constant(value) => number(value, &format!("the function `{function}`")),
        Operand::Time => Ok(string(letter(operand))),
        Operand::State(k)
        | Operand::Parameter(k)
        | Operand::Prepared(k)
        | Operand::Marker(k)
        | Operand::Temp(k) => Ok(format!("\"{}{k}\"", letter(operand))),
    }
}

fn letter(operand: Operand) -> &'static str {
    match operand {
        Operand::Time => "t",
        Operand::State(_) => "x",
        Operand::Parameter(_) => "p",
        Operand::Prepared(_) => "k",
        Operand::Marker(_) => "m",
        Operand::Temp(_) => "s",
        Operand::Constant(_) => "",
    }
}

fn operation(op: &Op) -> &'static str {
    match op {
        Op::Unary(Unary::Neg, _) => "neg",
        Op::Unary(Unary::Recip, _) => "recip",
        Op::Unary(Unary::RecipOrZero, _) => "recip_or_zero",
        Op::Unary(Unary::Call(function), _) => function.name(),
        Op::Binary(Binary::Add, ..) => "add",
        Op::Binary(Binary::Sub, ..) => "sub",
        Op::Binary(Binary::Mul, ..) => "mul",
        Op::Binary(Binary::Div, ..) => "div",
        Op::Binary(Binary::Call(function), ..) => function.name(),
        Op::Fused(Fused::MulAdd, ..) => "mul_add",
        Op::Fused(Fused::MulSub, ..) => "mul_sub",
        Op::Fused(Fused::NegMulAdd, ..) => "neg_mul_add",
        Op::IfZero(..) => "if_zero",
    }
}

fn table(tables: &Tables, used: Looked) -> Result<String, NotFinite> {
    let used = match used {
        Looked::One(used) => used,
        Looked::Two(used) => return surface(tables, used),
    };
    let cubic: &PiecewiseCubic = tables.of(used);
    let name = tables.name(used);
    let cubics = cubic.cubics().iter().map(|cubic| numbers(cubic, &name));
    let fields = [
        ("name", string(&name)),
        ("knots", numbers(cubic.knots(), &name)?),
        ("cubics", row(cubics.collect::<Result<Vec<_>, _>>()?)),
    ];
    Ok(object(&fields, ""))
}

fn surface(tables: &Tables, used: TableFunction<2>) -> Result<String, NotFinite> {
    let bicubic = tables.table(used.table()).bicubic();
    let bicubic = bicubic.derivative(used.orders());
    let name = tables.name(used);
    let [first, second] = bicubic.knots();
    let cells = bicubic.cells().iter().map(|cell| numbers(cell, &name));
    let fields = [
        ("name", string(&name)),
        ("knots", numbers(first, &name)?),
        ("second_knots", numbers(second, &name)?),
        ("bicubics", row(cells.collect::<Result<Vec<_>, _>>()?)),
    ];
    Ok(object(&fields, ""))
}

/// Value that JSON cannot hold, and the place where it was found.
struct NotFinite {
    place: String,
    value: f64,
}

type Field = (&'static str, String);

fn string(text: &str) -> String {
    let mut quoted = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            c if c < ' ' => {
                // Writing to a string cannot fail.
                let _ = write!(quoted, "\\u{:04x}", u32::from(c));
            }
            c => quoted.push(c),
        }
    }
    quoted + "\""
}

/// Number that is read back to the same bits.
fn number(value: f64, place: &str) -> Result<String, NotFinite> {
    if value.is_finite() {
        return Ok(format!("{value:?}"));
    }
    let place = place.to_owned();
    Err(NotFinite { place, value })
}

fn numbers(values: &[f64], place: &str) -> Result<String, NotFinite> {
    let values = values.iter().map(|&value| number(value, place));
    Ok(row(values.collect::<Result<Vec<_>, _>>()?))
}

fn row(items: impl IntoIterator<Item = String>) -> String {
    let items: Vec<String> = items.into_iter().collect();
    format!("[{}]", items.join(","))
}

/// List with an item per line.
fn lines(items: impl IntoIterator<Item = String>) -> String {
    let items: Vec<String> = items.into_iter().collect();
    match items.is_empty() {
        true => "[]".into(),
        false => format!("[\n{}\n]", items.join(",\n")),
    }
}

/// Object whose fields are separated by `gap`: a line break or nothing.
fn object(fields: &[Field], gap: &str) -> String {
    let fields = fields.iter();
    let fields: Vec<String> = fields
        .map(|(key, value)| format!("{}:{value}", string(key)))
        .collect();
    format!("{{{gap}{}{gap}}}", fields.join(&format!(",{gap}")))
}
