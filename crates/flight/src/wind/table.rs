//! A wind table in height as tables of the model language: monotone cubics between the heights, constant outside them.

use model_spec::diagnostic::Span;
use model_spec::syntax::ast::{EffectPart, Expr, ExprKind};

use super::nodes::{add_let, add_table, call, inertial_vector, name};

/// Names of the three tables that give the components of the wind velocity as functions of the height, in the effect by
/// which the wind is added to a model.
const COMPONENTS: [&str; 3] = ["wind_table_1", "wind_table_2", "wind_table_3"];

/// Statements of the model language that define the height `wind_height` and, from a table over this height, the wind
/// velocity `wind_of_profile`. Each of `rows` contains a height (m, increasing) and the three components of the wind
/// velocity in the inertial frame (m/s).
pub(super) fn statements(rows: &[[f64; 4]]) -> Vec<EffectPart> {
    let height = Expr {
        kind: ExprKind::Part(Box::new(name("position")), 3),
        span: Span::default(),
    };
    let tables = (1..).zip(COMPONENTS).map(|(axis, table)| {
        let knots = rows.iter().map(|row| (row[0], row[axis]));
        add_table(table, knots_of(knots.collect()))
    });
    let mut parts: Vec<EffectPart> = tables.collect();
    parts.push(add_let("wind_height", height));
    let components = COMPONENTS.map(|table| call(table, vec![name("wind_height")]));
    parts.push(add_let("wind_of_profile", inertial_vector(components)));
    parts
}

/// Knots (height in m, component of the wind velocity in m/s) for a table of the model language, which requires at
/// least three: if there are two, their mean is inserted between them.
fn knots_of(mut knots: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    if let [(low, first), (high, last)] = knots[..] {
        knots.insert(1, (0.5 * (low + high), 0.5 * (first + last)));
    }
    knots
}
