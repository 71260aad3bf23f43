//! Whether the changes of quantities that a model claims determine its equations.

use crate::options::Options;
use crate::random::Random;
use crate::sample;
use model_spec::layout::needed;
use model_spec::model::{AuxVariable, Balance, Expr, ExprKind, Model};
use nalgebra::DMatrix;
use oracle::{Point, Tree, moving};

/// Random points at which the balances may determine the rates: at some they degenerate, such as the energy at rest.
const RANK_POINTS: usize = 4;

/// Least pivot, relative to the greatest, of balances that determine a rate; roundings leave about 1e-15.
const RANK_TOLERANCE: f64 = 1e-9;

/// Whether the claimed balances determine the rate of every state of the model itself. Balances that name what follows
/// from the equations, such as a reaction force or a `der(…)`, hold whatever these are, and do not count.
pub fn determine_all_rates(model: &Model) -> bool {
    let own = model.balances.iter();
    let own: Vec<&Expr> = own
        .filter(|own| !follows_from_equations(model, own))
        .map(|own| &own.quantity)
        .collect();
    let added = model.added_states();
    let states: Vec<usize> = (0..model.states.len())
        .filter(|state| !added.contains(state))
        .collect();
    let mut random = Random::new(Options::default().seed, "rank of balances");
    (0..RANK_POINTS).any(|_| {
        let point = sample::point(model, &mut random);
        let changes: Vec<f64> = { states.iter() }
            .flat_map(|&state| changes(model, &own, &point, state))
            .collect();
        rank(&changes, states.len()) == states.len()
    })
}

/// Derivatives of quantities, by component, at a point where one state alone changes, at the rate 1.
fn changes(model: &Model, quantities: &[&Expr], point: &Point<f64>, state: usize) -> Vec<f64> {
    let mut rates = vec![0.0; point.states.len()];
    rates[state] = 1.0;
    let moving = moving(point, &rates, 0.0);
    let tree = Tree::without_unknowns(model, &moving, quantities);
    let parts = { quantities.iter() }.flat_map(|own| tree.value(own).components());
    parts.map(|part| part.derivative).collect()
}

/// Rank of a matrix of so many columns, each scaled to the length 1, after each of its rows.
fn rank(values: &[f64], columns: usize) -> usize {
    let rows = values.len() / columns.max(1);
    if rows == 0 || values.iter().any(|value| !value.is_finite()) {
        return 0;
    }
    let mut matrix = DMatrix::from_column_slice(rows, columns, values);
    for mut row in matrix.row_iter_mut() {
        let _ = row.try_normalize_mut(0.0);
    }
    for mut column in matrix.column_iter_mut() {
        let _ = column.try_normalize_mut(0.0);
    }
    // With fewer rows than columns the triangle has no diagonal of its own.
    let triangle = matrix.col_piv_qr().r();
    let pivots: Vec<f64> = (0..rows.min(columns))
        .map(|k| triangle[(k, k)].abs())
        .collect();
    let least = RANK_TOLERANCE * pivots.iter().fold(0.0, |a: f64, b| a.max(*b));
    pivots.iter().filter(|own| **own > least).count()
}

/// Whether an auxiliary variable is the derivative of a state by its equation.
fn is_of_equation(model: &Model, variable: &AuxVariable) -> bool {
    let state = variable.name.strip_prefix("der_");
    state.is_some_and(|name| model.states.iter().any(|own| own.name == name))
}

fn follows_from_equations(model: &Model, balance: &Balance) -> bool {
    let is_of_equations = |part: &Expr| {
        matches!(
            part.kind,
            ExprKind::Rate(..)
                | ExprKind::BodyRate(..)
                | ExprKind::Unknown(..)
                | ExprKind::SpecificForce
                | ExprKind::AngularAcceleration
        )
    };
    let follows = |e: &Expr| e.nodes().any(is_of_equations);
    let parts = [&balance.quantity, &balance.change];
    let used = model.aux_variables.iter().zip(needed(model, &parts));
    let mut used = used.filter(|(_, is_needed)| *is_needed).map(|(own, _)| own);
    parts.into_iter().any(follows)
        || used.any(|own| is_of_equation(model, own) || follows(&own.value))
}
