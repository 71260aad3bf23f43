//! Practical non-identifiability: combinations of coefficients that the flights do not determine.

use std::collections::BTreeMap;

use model_spec::model::{Expr, ExprKind, Model};
use model_spec::sort_by_number;
use nalgebra::{DMatrix, SymmetricEigen};

use crate::numbers::{is_angle, unit};
use crate::problem::GlobalParameter;
use crate::report::NonIdentifiable;
use crate::wording::listed;
use dataset::levels::CONFOUNDED;

/// Standard error of a direction, in typical magnitudes, above which it is not identifiable, and minimum component of a
/// coefficient that is named, relative to the largest.
const DIRECTION: (f64, f64) = (0.5, 0.3);

/// Minimum and maximum of each auxiliary variable and state over the flights.
type ExcitationRange = BTreeMap<String, (f64, f64)>;

/// Directions that are not identifiable, the largest standard error first.
pub fn non_identifiable(
    model: &Model,
    global: &[GlobalParameter],
    covariance: &DMatrix<f64>,
    ranges: &ExcitationRange,
) -> Vec<NonIdentifiable> {
    let usual = |i: usize| global[i].x_scale;
    let size = global.len();
    // The eigenvalue decomposition needs at least one parameter.
    if size == 0 {
        return Vec::new();
    }
    let relative = DMatrix::from_fn(size, size, |i, j| {
        covariance[(i, j)] / (usual(i) * usual(j))
    });
    let eigen = SymmetricEigen::new(relative);
    let mut order: Vec<usize> = (0..size).collect();
    sort_by_number(&mut order, |&index| -eigen.eigenvalues[index]);
    order
        .into_iter()
        .map(|k| {
            (
                eigen.eigenvalues[k].max(0.0).sqrt(),
                eigen.eigenvectors.column(k),
            )
        })
        .take_while(|(error, _)| *error > DIRECTION.0)
        .map(|(error, direction)| {
            let greatest = direction.amax();
            let mut members: Vec<usize> = (0..size)
                .filter(|&i| direction[i].abs() >= DIRECTION.1 * greatest)
                .collect();
            sort_by_number(&mut members, |&member| -direction[member].abs());
            // The sign of a direction is arbitrary: the first component is made positive.
            let sign = direction[members[0]].signum();
            let weights = members
                .iter()
                .map(|&i| (global[i].name.clone(), sign * direction[i]))
                .collect();
            NonIdentifiable {
                combination: members.iter().map(|&i| global[i].name.clone()).collect(),
                weights,
                relative_error: error,
                reason: reason(model, global, &members, error, ranges),
            }
        })
        .collect()
}

fn reason(
    model: &Model,
    global: &[GlobalParameter],
    members: &[usize],
    error: f64,
    ranges: &ExcitationRange,
) -> String {
    let names: Vec<&str> = members.iter().map(|&i| global[i].name.as_str()).collect();
    let much = if error > CONFOUNDED {
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
    match excitation(model, &names, ranges) {
        Some(because) => format!("{told}; {because}"),
        None => told,
    }
}

/// Ranges of up to three quantities that occur with the coefficients `names` in the model, in words.
fn excitation(model: &Model, names: &[&str], ranges: &ExcitationRange) -> Option<String> {
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
                if ranges.contains_key(quantity) && !met.contains(&quantity) {
                    met.push(quantity);
                }
            }
        }
    }
    let ranges: Vec<String> = met
        .iter()
        .take(3)
        .map(|name| {
            let (low, high) = ranges[*name];
            range(model, name, low, high)
        })
        .collect();
    (!ranges.is_empty()).then(|| format!("in them {}", ranges.join(", ")))
}

/// Range of an auxiliary variable or state in words; angles in degrees.
fn range(model: &Model, name: &str, low: f64, high: f64) -> String {
    let quantity = model
        .aux_variables
        .iter()
        .find(|quantity| quantity.name == name);
    if quantity.is_some_and(|quantity| is_angle(&quantity.value)) {
        let (low, high) = (low.to_degrees(), high.to_degrees());
        return format!("{name} lies between {low:.1}° and {high:.1}°");
    }
    let unit = quantity.map(|quantity| unit(&quantity.value.unit.to_string()));
    let unit = unit.unwrap_or_default();
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
            _ => {
                for child in expression.children() {
                    self.walk(model, child);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::options::FitOptions;
    use crate::problem::FitProblem;
    use dataset::synthesize::Plan;

    /// Two coefficients of which only the sum is determined, in units of their usual sizes.
    #[test]
    fn coefficients_that_move_together_are_named() {
        let disc = model_spec::load::load("disc", &[]).expect("the disc");
        let plan = Plan {
            flights: 1,
            duration: Some(0.1),
            ..Plan::default()
        };
        let dataset = crate::fit::tests::simulated(&disc, "backhand", &plan);
        let problem = FitProblem::new(&disc, &dataset, &FitOptions::default()).expect("a problem");
        let global = &problem.globals;
        let of = |apart: f64| {
            let covariance = DMatrix::from_fn(global.len(), global.len(), |i, j| {
                let relative = match (i, j) {
                    (0, 0) | (1, 1) => 1e-6 + apart * apart,
                    (0, 1) | (1, 0) => -apart * apart,
                    _ => 1e-6 * f64::from(u8::from(i == j)),
                };
                relative * global[i].x_scale * global[j].x_scale
            });
            non_identifiable(&disc, global, &covariance, &ExcitationRange::new())
        };
        assert_eq!(of(0.01), []);
        let [found] = &of(2.0)[..] else {
            panic!("one direction");
        };
        let names = [0, 1].map(|place| global[place].name.clone());
        assert!(
            names.iter().all(|name| found.combination.contains(name)),
            "{found:?}"
        );
        assert_eq!(found.combination.len(), 2);
        assert!(
            (found.relative_error - 8.0_f64.sqrt()).abs() < 1e-3,
            "{found:?}"
        );
        assert!(found.reason.contains("move together"), "{found:?}");
    }

    #[test]
    fn angles_are_in_degrees_and_ratios_are_not() {
        let disc = model_spec::load::load("disc", &[]).expect("the disc");
        let told = |name: &str| range(&disc, name, 0.1, 0.25);
        assert_eq!(told("alpha"), "alpha lies between 5.7° and 14.3°");
        assert_eq!(told("V"), "V lies between 0.100 and 0.250 m/s");
        assert_eq!(
            told("spin_ratio"),
            "spin_ratio lies between 0.100 and 0.250 rad"
        );
        let text = "model drop; param m = 1 kg; param nu = 1e-5 m^2/s; coefficient c = 1 N; frame N;\n\
             point drop { mass m; position (x, y, z) in N; velocity (vx, vy, vz) in N; }\n\
             let Re = vx*(1 m)/nu; force drag = (c*Re, 0, 0) in N;\n";
        let drop = model_spec::load::from_text("drop.hyz", text, &[]).expect("a model");
        let told = range(&drop, "Re", 9e4, 2e5);
        assert_eq!(told, "Re lies between 90000.000 and 200000.000");
    }
}
