//! Functions as lists of statements, and the tables that they look up.

use super::text::{Field, NotFinite, lines, number, numbers, object, row, string};
use crate::compile::Compiled;
use crate::functions::MathFunction;
use crate::program::{Binary, Function, Fused, Op, Operand, Section, Unary};
use crate::table::{PiecewiseCubic, TableFunction, Tables};

/// Arrays that a function may read, by the letter of their operands, in the order in which `inputs` lists them.
const INPUTS: [&str; 5] = ["t", "x", "p", "k", "m"];

/// The fields `tables` and `functions`.
pub(super) fn fields(compiled: &Compiled) -> Result<Vec<Field>, NotFinite> {
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
    /// Tables and derivatives of tables that statements look up, in the order of their first use.
    tables: Vec<TableFunction>,
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
            items.push(self.table(table).to_string());
        }
        for operand in op.operands() {
            items.push(written(operand, function)?);
        }
        Ok(row(items))
    }

    /// Index of a table in the list of those that are used.
    fn table(&mut self, table: TableFunction) -> usize {
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

    /// Length of a vector, or rows and columns of a matrix.
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

/// Letters of the arrays that a function reads.
fn inputs(function: &Function) -> String {
    let read: Vec<&str> = function.program.operands().map(letter).collect();
    let inputs = INPUTS.into_iter().filter(|array| read.contains(array));
    row(inputs.map(string))
}

/// JSON of an operand: a number, or a letter and an index, as in `x3`.
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

/// Letter of the array that an operand is read from; empty for a constant.
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

/// Name of an operation in the format.
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
        Op::Binary(Binary::Atan2, ..) => "atan2",
        Op::Binary(Binary::Min, ..) => "min",
        Op::Binary(Binary::Max, ..) => "max",
        Op::Fused(Fused::MulAdd, ..) => "mul_add",
        Op::Fused(Fused::MulSub, ..) => "mul_sub",
        Op::Fused(Fused::NegMulAdd, ..) => "neg_mul_add",
        Op::IfZero(..) => "if_zero",
    }
}

fn table(tables: &Tables, used: TableFunction) -> Result<String, NotFinite> {
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
