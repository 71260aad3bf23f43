//! LaTeX of the expressions of a model, in the form in which its author wrote them.

use super::names::{Style, name};
use super::piece::{Bind, Piece};
use crate::functions::{BinaryFunction, FunctionLowering, Notation};
use model_spec::model::{Expr, ExprKind, Function, Model, Shape};

/// LaTeX of an expression. Changes of frame are not written, since they do not change the vector.
pub(super) fn piece(model: &Model, expr: &Expr) -> Piece {
    use ExprKind as E;
    let of = |e: &Expr| piece(model, e);
    let scalar = |n: &str| Piece::atom(name(n, Style::Scalar));
    match &expr.kind {
        E::Number { value, .. } => Piece::number(*value),
        E::Pi => Piece::atom(r"\pi"),
        E::Time => Piece::atom("t"),
        E::Param(k) => scalar(&model.params[*k].name),
        E::Coefficient(k) => scalar(&model.coefficients[*k].name),
        E::Input(k) => Piece::atom(name(&model.inputs[*k].name, Style::Vector)),
        E::State(k) => scalar(&model.states[*k].name),
        E::AuxVariable(k) => {
            let quantity = &model.aux_variables[*k];
            Piece::atom(name(&quantity.name, style(&quantity.value)))
        }
        E::Unknown(system, k) => {
            let unknown = &model.systems[*system].unknowns[*k];
            match unknown.state {
                Some(state) => {
                    let state = name(&model.states[state].name, Style::Scalar);
                    Piece::atom(format!(r"\dot{{{state}}}"))
                }
                None => scalar(&unknown.name.replace('.', "_")),
            }
        }
        E::Determinacy(system) => Piece::operator("det", &[scalar(&system.to_string())]),
        E::Rate(of_rate, ..) => Piece::atom(format!(
            r"\frac{{\mathrm{{d}}}}{{\mathrm{{d}}t}} {}",
            of(of_rate).at_least(Bind::Atom).text
        )),
        E::BodyRate(state, _) => Piece::atom(format!(
            r"\frac{{\mathrm{{d}}}}{{\mathrm{{d}}t}} {}",
            name(&model.states[*state].name, Style::Scalar)
        )),
        E::Partial(value, state) => Piece::atom(format!(
            r"\frac{{\partial {}}}{{\partial {}}}",
            of(value).at_least(Bind::Atom).text,
            name(&model.states[*state].name, Style::Scalar)
        )),
        E::Axis(frame, k) => axis(model, *frame, *k),
        E::Position => Piece::atom(r"\mathbf{r}"),
        E::Velocity => Piece::atom(r"\mathbf{v}"),
        E::AngularVelocity => Piece::atom(r"\boldsymbol{\omega}"),
        E::SpecificForce => Piece::atom(r"\mathbf{f}"),
        E::AngularAcceleration => Piece::atom(r"\dot{\boldsymbol{\omega}}"),
        E::Marker => {
            let marker = model.marker.as_ref().map_or("marker", |m| m.name.as_str());
            Piece::atom(name(marker, Style::Vector))
        }
        E::Components(parts) => {
            let parts = [&parts[0], &parts[1], &parts[2]].map(|part| of(part).text);
            let frame = match expr.shape {
                Shape::Vector(frame) => model.frames[frame].name.as_str(),
                Shape::Scalar => "",
            };
            Piece::atom(format!(r"\left({}\right)_{{{frame}}}", parts.join(r",\, ")))
        }
        E::Neg(a) => of(a).neg(),
        E::Add(a, b) => of(a).add(of(b)),
        E::Sub(a, b) => of(a).sub(of(b)),
        E::Mul(a, b) => of(a).mul(of(b)),
        E::Div(a, b) => of(a).div(of(b)),
        E::Ratio(parts) => {
            let [a, b, other] = [&parts[0], &parts[1], &parts[2]].map(of);
            let case = format!("{} = 0", b.text);
            let quotient = a.div(b);
            if other.text == "0" {
                quotient
            } else {
                Piece::cases(quotient, other, &case)
            }
        }
        E::Pow(a, doubled) => of(a).power(*doubled),
        E::RealPower(a, b) => of(a).raised(&of(b).text),
        E::Dot(a, b) => of(a).dotted(r"\cdot", of(b)),
        E::Cross(a, b) => of(a).dotted(r"\times", of(b)),
        E::Norm(v) => Piece::atom(format!(r"\left|{}\right|", of(v).text)),
        E::Direction(v, other) => {
            let v = of(v);
            let case = format!(r"{} = \mathbf{{0}}", v.text);
            let unit = Piece::operator("unit", &[v]);
            match other {
                None => unit,
                Some(other) => Piece::cases(unit, of(other), &case),
            }
        }
        E::Component(v, k) => match v.shape {
            Shape::Vector(frame) => of(v).dotted(r"\cdot", axis(model, frame, *k)),
            Shape::Scalar => of(v),
        },
        E::Reexpress(v) => of(v),
        E::Call(Function::Table(index), x) => {
            let of_table = name(&model.tables[*index].name, Style::Scalar);
            table(of_table, of(x))
        }
        E::Call(function, x) => call(FunctionLowering::of(*function).notation(), of(x)),
        E::Lookup(index, a, b) => {
            let of_table = name(&model.tables[*index].name, Style::Scalar);
            table_of_two(of_table, of(a), of(b))
        }
        E::Atan2(y, x) => call2(BinaryFunction::Atan2, of(y), of(x)),
        E::Min(a, b) => call2(BinaryFunction::Min, of(a), of(b)),
        E::Max(a, b) => call2(BinaryFunction::Max, of(a), of(b)),
    }
}

/// Typeface of an expression: vector for vector-valued expressions, else scalar.
pub(super) fn style(expr: &Expr) -> Style {
    match expr.shape {
        Shape::Scalar => Style::Scalar,
        Shape::Vector(_) => Style::Vector,
    }
}

fn axis(model: &Model, frame: usize, k: u8) -> Piece {
    let frame = model.frames[frame].name.to_lowercase();
    Piece::atom(format!("{}_{k}", name(&frame, Style::Vector)))
}

pub(super) fn call2(function: BinaryFunction, a: Piece, b: Piece) -> Piece {
    let command = match function {
        BinaryFunction::Atan2 | BinaryFunction::Table(_) => {
            return Piece::operator(function.name(), &[a, b]);
        }
        BinaryFunction::Min => r"\min",
        BinaryFunction::Max => r"\max",
    };
    Piece::function(
        command,
        Piece::new(format!(r"{},\, {}", a.text, b.text), Bind::Sum),
    )
}

/// LaTeX of the lookup of `x` in the table whose LaTeX name is `name`.
pub(super) fn table(name: String, x: Piece) -> Piece {
    Piece::atom(format!(r"{name}\left({}\right)", x.text))
}

/// LaTeX of the lookup of two arguments in the table whose LaTeX name is `name`.
pub(super) fn table_of_two(name: String, a: Piece, b: Piece) -> Piece {
    Piece::atom(format!(r"{name}\left({},\, {}\right)", a.text, b.text))
}

pub(super) fn call(notation: Notation, x: Piece) -> Piece {
    match notation {
        Notation::Command(command, _) => Piece::function(command, x),
        Notation::Operator(name) => Piece::operator(name, &[x]),
        Notation::Radical => x.power(1),
        Notation::PowerOfE => Piece::new(format!("e^{{{}}}", x.text), Bind::Product),
        Notation::Bars => Piece::atom(format!(r"\left|{}\right|", x.text)),
        Notation::Bracket(relation) => Piece::atom(format!(r"\left[{} {relation}\right]", x.text)),
    }
}
