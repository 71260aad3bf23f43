//! Coefficients, and combinations of them, that the flights do not determine: named, and why, in words.

use std::collections::BTreeMap;

use model_spec::model::{Expr, ExprKind, Model};
use nalgebra::{DMatrix, SymmetricEigen};

use crate::problem::GlobalParameter;
use crate::report::NonIdentifiable;
use crate::wording::listed;

/// A direction whose standard error is more than this part of the usual size is not determined.
const LOOSE: f64 = 0.5;

/// A coefficient belongs to a direction where its part is at least this much of the greatest.
const PART: f64 = 0.3;

/// The least and the greatest that a named quantity was in the flights.
pub type ExcitationRange = BTreeMap<String, (f64, f64)>;

/// The directions that are not determined, the least determined first.
pub fn non_identifiable(
    model: &Model,
    global: &[GlobalParameter],
    covariance: &DMatrix<f64>,
    support: &ExcitationRange,
) -> Vec<NonIdentifiable> {
    let usual = |i: usize| global[i].x_scale;
    let size = global.len();
    // Where everything is held nothing is open.
    if size == 0 {
        return Vec::new();
    }
    let relative = DMatrix::from_fn(size, size, |i, j| {
        covariance[(i, j)] / (usual(i) * usual(j))
    });
    let eigen = SymmetricEigen::new(relative);
    let mut order: Vec<usize> = (0..size).collect();
    order.sort_by(|&a, &b| eigen.eigenvalues[b].total_cmp(&eigen.eigenvalues[a]));
    order
        .into_iter()
        .map(|k| {
            (
                eigen.eigenvalues[k].max(0.0).sqrt(),
                eigen.eigenvectors.column(k),
            )
        })
        .take_while(|(error, _)| *error > LOOSE)
        .map(|(error, direction)| {
            let greatest = direction.amax();
            let mut members: Vec<usize> = (0..size)
                .filter(|&i| direction[i].abs() >= PART * greatest)
                .collect();
            members.sort_by(|&a, &b| direction[b].abs().total_cmp(&direction[a].abs()));
            // Which way along the direction is nobody's choice: the first member goes up.
            let sign = direction[members[0]].signum();
            let weights = members
                .iter()
                .map(|&i| (global[i].name.clone(), sign * direction[i]))
                .collect();
            NonIdentifiable {
                combination: members.iter().map(|&i| global[i].name.clone()).collect(),
                weights,
                relative_error: error,
                why: why(model, global, &members, error, support),
            }
        })
        .collect()
}

fn why(
    model: &Model,
    global: &[GlobalParameter],
    members: &[usize],
    error: f64,
    support: &ExcitationRange,
) -> String {
    let names: Vec<&str> = members.iter().map(|&i| global[i].name.as_str()).collect();
    let much = if error > 1e3 {
        "any amount".to_owned()
    } else {
        format!("{:.0} % of what is usual", 100.0 * error)
    };
    let told = match names.as_slice() {
        [name] => format!(
            "{name} may change by {much} and these flights would look the same within their noise"
        ),
        _ => format!(
            "{} move together: along this combination they may change by {much} and these flights would look the same within their noise",
            listed(&names)
        ),
    };
    match seen_through(model, &names, support) {
        Some(because) => format!("{told}; {because}"),
        None => told,
    }
}

/// Ranges of the quantities that the coefficients are multiplied by where the model uses them.
fn seen_through(model: &Model, names: &[&str], support: &ExcitationRange) -> Option<String> {
    let mut met: Vec<&str> = Vec::new();
    let expressions = model.aux_variables.iter().map(|quantity| &quantity.value);
    let loads = model
        .forces
        .iter()
        .chain(&model.moments)
        .map(|load| &load.value);
    let stated = model.equations.iter().map(|equation| &equation.value);
    let clock = model.clock.iter().map(|clock| &clock.value);
    for expression in expressions.chain(loads).chain(stated).chain(clock) {
        let mut found = Found::default();
        found.walk(model, expression);
        let uses = found
            .coefficients
            .iter()
            .any(|&i| names.contains(&model.coefficients[i].name.as_str()));
        if uses {
            for quantity in found.quantities {
                if support.contains_key(quantity) && !met.contains(&quantity) {
                    met.push(quantity);
                }
            }
        }
    }
    let ranges: Vec<String> = met
        .iter()
        .take(3)
        .map(|name| {
            let (low, high) = support[*name];
            range(model, name, low, high)
        })
        .collect();
    (!ranges.is_empty()).then(|| format!("in them {}", ranges.join(", ")))
}

/// A range in its unit, angles in degrees.
fn range(model: &Model, name: &str, low: f64, high: f64) -> String {
    let angle = model_spec::unit::Unit::RADIAN;
    let quantity = model
        .aux_variables
        .iter()
        .find(|quantity| quantity.name == name);
    let is_angle = quantity.is_some_and(|quantity| quantity.value.unit == angle);
    if is_angle {
        let (low, high) = (low.to_degrees(), high.to_degrees());
        return format!("{name} lies between {low:.1}° and {high:.1}°");
    }
    let unit = quantity
        .map(|quantity| quantity.value.unit.to_string())
        .unwrap_or_default();
    format!("{name} lies between {low:.3} and {high:.3} {unit}")
        .trim_end()
        .to_owned()
}

#[derive(Default)]
struct Found<'m> {
    coefficients: Vec<usize>,
    quantities: Vec<&'m str>,
}

impl<'m> Found<'m> {
    fn walk(&mut self, model: &'m Model, expression: &'m Expr) {
        match expression.kind {
            ExprKind::Coefficient(i) => self.coefficients.push(i),
            ExprKind::AuxVariable(i) => self.quantities.push(&model.aux_variables[i].name),
            ExprKind::State(i) => self.quantities.push(&model.states[i].name),
            _ => expression.children(&mut |child| self.walk(model, child)),
        }
    }
}
