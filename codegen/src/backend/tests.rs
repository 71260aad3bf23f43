//! Test of the backend interface by a one-file C backend, whose compiled code is compared with the tape.

use super::body::{Body, Step, input_element};
use super::{Backend, SourceFile};
use crate::compile::{Compiled, compile};
use crate::functions::{BinaryFunction, MathFunction};
use crate::program::{Binary, Function, Fused, Op, Operand, Unary};
use crate::tape_model::{At, Scratch, TapeModel};
use model_spec::load;
use model_spec::model::Model;
use std::fmt::Write;
use std::process::Command;

struct C;

impl Backend for C {
    fn name(&self) -> &'static str {
        "c"
    }

    fn description(&self) -> &'static str {
        "C99 functions over double"
    }

    fn emit(&self, _: &Model, compiled: &Compiled) -> Vec<SourceFile> {
        let mut text = String::from(HELPERS);
        for function in [&compiled.prepare, &compiled.f_jac_par] {
            emit_function(&mut text, compiled, function);
        }
        vec![SourceFile {
            path: format!("{}.c", compiled.name),
            text,
        }]
    }
}

const HELPERS: &str = "\
#include <math.h>
#include <stdio.h>
static double root(double x) { return x <= 0 ? 0 : sqrt(x); }
static double logarithm(double x) { return x <= 0 ? 0 : log(x); }
static double recip_or_zero(double x) { return fabs(x) < 1e-75 ? 0 : 1 / x; }
static double if_zero(double x, double a, double b) { return fabs(x) < 1e-75 ? a : b; }
static double clamped_asin(double x) { return asin(x < -1 ? -1 : x > 1 ? 1 : x); }
static double sign(double x) { return (x > 0) - (x < 0); }
static double step(double x) { return x > 0; }
static double bicubic(double x, double y, int n, int m, const double *kx, const double *ky, const double (*c)[16]) {
  int i = 0, j = 0;
  while (i < n && kx[i] <= x) i++;
  while (j < m && ky[j] <= y) j++;
  double h = x - kx[i ? i - 1 : 0], k = y - ky[j ? j - 1 : 0], value = 0;
  const double *p = c[i * (m + 1) + j];
  for (int a = 3; a >= 0; a--)
    value = value * h + ((p[4*a+3] * k + p[4*a+2]) * k + p[4*a+1]) * k + p[4*a];
  return value;
}
static double cubic(double x, int n, const double *knots, const double (*c)[4]) {
  int i = 0;
  while (i < n && knots[i] <= x) i++;
  double h = x - knots[i ? i - 1 : 0];
  return ((c[i][3] * h + c[i][2]) * h + c[i][1]) * h + c[i][0];
}
";

fn emit_function(text: &mut String, compiled: &Compiled, function: &Function) {
    let body = Body::new(compiled, function, |name| {
        [
            "int",
            "double",
            "time",
            "state",
            "parameters",
            "prepared",
            "y0",
            "y1",
        ]
        .contains(&name)
    });
    let outputs: Vec<String> = function
        .sections
        .iter()
        .map(|section| format!("double *out_{}", section.name))
        .collect();
    let name = function.name;
    writeln!(
        text,
        "void {name}(double time, const double *state, const double *parameters, const double *prepared, {}) {{",
        outputs.join(", ")
    )
    .unwrap();
    let variable = |operand| body.variables.of(operand).unwrap_or("?").to_string();
    let temp = |k: usize| variable(Operand::Temp(k as u32));
    for &step in &body.steps {
        match step {
            Step::Gap => text.push('\n'),
            Step::Source(origin) => writeln!(text, "\n// {}", body.source_line(origin)).unwrap(),
            Step::Load(operand) => {
                let (input, k) = input_element(operand).unwrap();
                let name = variable(operand);
                writeln!(text, "const double {name} = {}[{k}];", input.name()).unwrap();
            }
            Step::Let(k) => {
                writeln!(
                    text,
                    "const double {} = {};",
                    temp(k),
                    op(&body, body.op(k))
                )
                .unwrap();
            }
            Step::SinCos { sin, cos, angle } => {
                let angle = value(&body, angle);
                writeln!(text, "const double {} = sin({angle});", temp(sin)).unwrap();
                writeln!(text, "const double {} = cos({angle});", temp(cos)).unwrap();
            }
            Step::Store {
                output,
                section,
                element,
            } => {
                let array = function.sections[section].name;
                let result = value(&body, function.program.outputs[output]);
                writeln!(text, "out_{array}[{element}] = {result};").unwrap();
            }
        }
    }
    text.push_str("}\n");
}

fn value(body: &Body<'_>, operand: Operand) -> String {
    match (body.variables.of(operand), operand) {
        (Some(name), _) => name.to_string(),
        (None, Operand::Constant(c)) => format!("({c:?})"),
        (None, Operand::Temp(t)) => op(body, body.op(t as usize)),
        (None, _) => "time".into(),
    }
}

fn op(body: &Body<'_>, op: &Op) -> String {
    let v = |operand| value(body, operand);
    match *op {
        Op::Unary(Unary::Neg, a) => format!("(-{})", v(a)),
        Op::Unary(Unary::Recip, a) => format!("(1 / {})", v(a)),
        Op::Unary(Unary::RecipOrZero, a) => format!("recip_or_zero({})", v(a)),
        Op::Unary(Unary::Call(MathFunction::NonZero), a) => format!("if_zero({}, 0, 1)", v(a)),
        Op::Unary(Unary::Call(MathFunction::Table(function)), a) => {
            let cubic = body.function.program.tables.of(function);
            let list = |values: &[f64]| {
                let values: Vec<String> = values.iter().map(|v| format!("{v:?}")).collect();
                format!("{{{}}}", values.join(", "))
            };
            let rows: Vec<String> = cubic.cubics().iter().map(|row| list(row)).collect();
            let (n, knots) = (cubic.knots().len(), list(cubic.knots()));
            let rows = rows.join(", ");
            format!(
                "cubic({}, {n}, (const double[]){knots}, (const double[][4]){{{rows}}})",
                v(a)
            )
        }
        Op::Unary(Unary::Call(function), a) => {
            let name = match function {
                MathFunction::Sqrt => "root",
                MathFunction::Log => "logarithm",
                MathFunction::Asin => "clamped_asin",
                MathFunction::Abs => "fabs",
                other => other.name(),
            };
            format!("{name}({})", v(a))
        }
        Op::Binary(Binary::Call(BinaryFunction::Atan2), a, b) => {
            format!("atan2({}, {})", v(a), v(b))
        }
        Op::Binary(Binary::Call(BinaryFunction::Table(function)), a, b) => {
            let bicubic = body
                .function
                .program
                .tables
                .table(function.table())
                .bicubic();
            let bicubic = bicubic.derivative(function.orders());
            let list = |values: &[f64]| {
                let values: Vec<String> = values.iter().map(|v| format!("{v:?}")).collect();
                format!("{{{}}}", values.join(", "))
            };
            let rows: Vec<String> = bicubic.cells().iter().map(|row| list(row)).collect();
            let [x, y] = bicubic.knots();
            format!(
                "bicubic({}, {}, {}, {}, (const double[]){}, (const double[]){}, (const double[][16]){{{}}})",
                v(a),
                v(b),
                x.len(),
                y.len(),
                list(x),
                list(y),
                rows.join(", ")
            )
        }
        Op::Binary(Binary::Call(BinaryFunction::Min), a, b) => format!("fmin({}, {})", v(a), v(b)),
        Op::Binary(Binary::Call(BinaryFunction::Max), a, b) => format!("fmax({}, {})", v(a), v(b)),
        Op::Binary(Binary::Add, a, b) => format!("({} + {})", v(a), v(b)),
        Op::Binary(Binary::Sub, a, b) => format!("({} - {})", v(a), v(b)),
        Op::Binary(Binary::Mul, a, b) => format!("({} * {})", v(a), v(b)),
        Op::Binary(Binary::Div, a, b) => format!("({} / {})", v(a), v(b)),
        Op::Fused(Fused::MulAdd, a, b, c) => format!("({} * {} + {})", v(a), v(b), v(c)),
        Op::Fused(Fused::MulSub, a, b, c) => format!("({} * {} - {})", v(a), v(b), v(c)),
        Op::Fused(Fused::NegMulAdd, a, b, c) => format!("({} - {} * {})", v(c), v(a), v(b)),
        Op::IfZero(a, b, c) => format!("if_zero({}, {}, {})", v(a), v(b), v(c)),
    }
}

#[test]
fn a_backend_of_one_file_agrees_with_the_tape() {
    if Command::new("cc").arg("--version").output().is_err() {
        eprintln!("no C compiler: skipped");
        return;
    }
    let zoo = include_str!("../../tests/integration/zoo/zoo.hyz");
    let model = load::from_text("zoo", zoo, &[]).unwrap();
    let compiled = compile(&model);
    let [file] = C.emit(&model, &compiled).try_into().unwrap();
    let (x, p) = (&compiled.layout.initial, &compiled.layout.defaults);

    let tape = TapeModel::new(&compiled);
    let lens = tape.f_jac_par.lens();
    let total: usize = lens.iter().sum();
    let list = |values: &[f64]| {
        values
            .iter()
            .map(|v| format!("{v:?}"))
            .collect::<Vec<_>>()
            .join(", ")
    };
    let main = format!(
        "int main(void) {{ double x[] = {{ {} }}, p[] = {{ {} }}, k[{}], y[{total}];
prepare(0, x, p, k, k); f_jac_par(0.2, x, p, k, y, y + {}, y + {});
for (int i = 0; i < {total}; i++) printf(\"%.17g\\n\", y[i]); return 0; }}\n",
        list(x),
        list(p),
        compiled.prepared.len().max(1),
        lens[0],
        lens[0] + lens[1],
    );
    let folder = std::env::temp_dir().join(format!("backend-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let (source, program) = (folder.join(&file.path), folder.join("program"));
    std::fs::write(&source, file.text + &main).unwrap();
    let done = Command::new("cc")
        .args(["-std=c99", "-ffp-contract=off"])
        .arg(&source)
        .arg("-o")
        .arg(&program)
        .arg("-lm")
        .output()
        .unwrap();
    assert!(
        done.status.success(),
        "{}",
        String::from_utf8_lossy(&done.stderr)
    );
    let printed = Command::new(&program).output().unwrap().stdout;
    std::fs::remove_dir_all(&folder).unwrap();
    let printed = String::from_utf8(printed).unwrap();
    let found: Vec<f64> = printed.lines().map(|line| line.parse().unwrap()).collect();

    let prepared = tape.prepare(p);
    let at = At {
        t: 0.2,
        x,
        p,
        prepared: &prepared,
    };
    let mut expected: Vec<Vec<f64>> = lens.iter().map(|&len| vec![0.0; len]).collect();
    let [dx, j, jp] = expected.as_mut_slice() else {
        panic!("three sections")
    };
    tape.f_jac_par
        .eval(at, &[], &mut Scratch::default(), &mut [dx, j, jp]);
    let expected = expected.concat();
    assert_eq!(expected.len(), found.len());
    for (a, b) in expected.iter().zip(&found) {
        assert!((a - b).abs() <= 1e-12 * a.abs().max(1.0), "{a} {b}");
    }
}
