//! Constructors of nodes of the syntax tree.

use model_spec::diagnostic::Span;
use model_spec::syntax::ast::{
    BinaryOp, Continuation, EffectPart, Expr, ExprKind, Interpolation, Item, ItemKind, Let, Name,
    Number, Parameter, ParameterClass, Quantity, Table, UnitExpr, UnitFactor,
};

fn expr(kind: ExprKind) -> Expr {
    Expr {
        kind,
        span: Span::default(),
    }
}

/// Syntax-tree node of an identifier with the given text, without a location in a file.
pub(super) fn identifier(text: &str) -> Name {
    Name {
        text: text.to_owned(),
        span: Span::default(),
    }
}

/// Expression that refers to a quantity by its name.
pub(super) fn name(text: &str) -> Expr {
    expr(ExprKind::Name(text.to_owned()))
}

/// Literal of a finite number; `unit` lists powers of unit symbols and is empty for a pure number.
pub(super) fn number(value: f64, unit: &[(&str, i32)]) -> Expr {
    let magnitude = expr(ExprKind::Number(quantity(value.abs(), unit)));
    match value.is_sign_negative() {
        true => expr(ExprKind::Neg(Box::new(magnitude))),
        false => magnitude,
    }
}

fn quantity(value: f64, powers: &[(&str, i32)]) -> Quantity {
    let span = Span::default();
    Quantity {
        number: Number {
            text: format!("{value:?}"),
            span,
        },
        unit: (!powers.is_empty()).then(|| unit(powers)),
        span,
    }
}

fn unit(powers: &[(&str, i32)]) -> UnitExpr {
    let span = Span::default();
    let factors = powers.iter().map(|(symbol, power)| UnitFactor {
        symbol: (*symbol).to_owned(),
        doubled: 2 * power,
        span,
    });
    UnitExpr {
        factors: factors.collect(),
        span,
    }
}

/// Expression of a binary operation on two operands.
pub(super) fn binary(op: BinaryOp, a: Expr, b: Expr) -> Expr {
    expr(ExprKind::Binary(op, Box::new(a), Box::new(b)))
}

/// Expression of a call of a function with its arguments.
pub(super) fn call(function: &str, arguments: Vec<Expr>) -> Expr {
    expr(ExprKind::Call(identifier(function), arguments))
}

/// Expression of a vector from its components in the inertial frame.
pub(super) fn inertial_vector(components: [Expr; 3]) -> Expr {
    let frame = identifier("inertial");
    expr(ExprKind::Components(Box::new(components), frame))
}

/// Expression of the sum of the given terms; `None` if there are none.
pub(super) fn sum(terms: impl IntoIterator<Item = Expr>) -> Option<Expr> {
    let terms = terms.into_iter();
    terms.reduce(|a, b| binary(BinaryOp::Add, a, b))
}

/// Statement, for an effect of the model language, that defines the quantity named `text` by the expression `value`.
pub(super) fn add_let(text: &str, value: Expr) -> EffectPart {
    let binding = Let {
        name: identifier(text),
        unit: None,
        value,
    };
    added(ItemKind::Let(binding), String::new())
}

/// Statement, for an effect of the model language, that declares the dimensionless parameter named `text`, with the
/// default value 0 and the description `doc`.
pub(super) fn add_parameter(text: &str, doc: &str) -> EffectPart {
    let parameter = Parameter {
        class: ParameterClass::Param,
        name: identifier(text),
        value: quantity(0.0, &[]),
        bounds: None,
    };
    added(ItemKind::Parameter(parameter), doc.to_owned())
}

/// Statement, for an effect of the model language, that declares the table named `text` of speeds (m/s) over heights
/// (m), monotone between its knots and constant outside them.
pub(super) fn add_table(text: &str, knots: Vec<(f64, f64)>) -> EffectPart {
    let knots = knots.into_iter();
    let table = Table {
        name: identifier(text),
        argument: identifier("height"),
        argument_unit: Some(unit(&[("m", 1)])),
        unit: Some(unit(&[("m", 1), ("s", -1)])),
        knots: knots
            .map(|(height, speed)| (quantity(height, &[]), quantity(speed, &[])))
            .collect(),
        interpolation: Interpolation::Monotone,
        continuation: Continuation::Constant,
    };
    added(ItemKind::Table(table), String::new())
}

fn added(kind: ItemKind, doc: String) -> EffectPart {
    EffectPart::Add(Box::new(Item {
        kind,
        doc,
        span: Span::default(),
        effect: None,
    }))
}
