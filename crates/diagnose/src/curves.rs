//! Curves of the model's coefficients, before and after, over what the flights showed.

use identify::{FlightEvidence, median};
use model_spec::model::{Model, Shape};

use crate::report::Curve;

/// Intervals along a curve.
const INTERVALS: usize = 24;

/// Samples that an interval must hold to be drawn.
const LEAST: usize = 4;

/// The quantities over which curves are drawn, the first that a model has.
const OVER: [&str; 2] = ["alpha", "V"];

/// Every named number of the model whose name begins with `C_`, over the angle of attack or the speed.
pub fn curves(model: &Model, before: &[FlightEvidence], after: &[FlightEvidence]) -> Vec<Curve> {
    let has = |name: &&str| model.aux_variables.iter().any(|l| l.name == **name);
    let Some(over) = OVER.into_iter().find(|name| has(name)) else {
        return Vec::new();
    };
    let unit = model.aux_variables.iter().find(|l| l.name == over);
    let unit = unit.map(|l| l.value.unit.to_string()).unwrap_or_default();
    let wanted = model
        .aux_variables
        .iter()
        .filter(|l| l.name.starts_with("C_") && l.value.shape == Shape::Scalar);
    wanted
        .filter_map(|l| curve(&l.name, over, &unit, before, after))
        .collect()
}

fn curve(
    quantity: &str,
    over: &str,
    unit: &str,
    before: &[FlightEvidence],
    after: &[FlightEvidence],
) -> Option<Curve> {
    let (mut old, mut new) = (
        points(quantity, over, before),
        points(quantity, over, after),
    );
    if old.is_empty() || new.is_empty() {
        return None;
    }
    old.sort_by(|a, b| a.0.total_cmp(&b.0));
    new.sort_by(|a, b| a.0.total_cmp(&b.0));
    // The ends of the range hold few samples that say little.
    let at = |part: f64| old[((old.len() - 1) as f64 * part) as usize].0;
    let (low, high) = (at(0.005), at(0.995));
    let step = (high - low) / INTERVALS as f64;
    if step.is_nan() || step <= 0.0 {
        return None;
    }
    let mut curve = Curve {
        quantity: quantity.to_owned(),
        over: over.to_owned(),
        unit: unit.to_owned(),
        x: Vec::new(),
        before: Vec::new(),
        after: Vec::new(),
        support: Vec::new(),
    };
    for k in 0..INTERVALS {
        let from = low + step * k as f64;
        let within = |points: &[(f64, f64)]| -> Vec<f64> {
            let first = points.partition_point(|p| p.0 < from);
            let last = points.partition_point(|p| p.0 < from + step);
            points[first..last].iter().map(|p| p.1).collect()
        };
        let (mut was, mut is) = (within(&old), within(&new));
        if was.len() >= LEAST && is.len() >= LEAST {
            curve.x.push(from + step / 2.0);
            curve.support.push(was.len());
            curve.before.push(median(&mut was));
            curve.after.push(median(&mut is));
        }
    }
    Some(curve)
}

fn points(quantity: &str, over: &str, flights: &[FlightEvidence]) -> Vec<(f64, f64)> {
    let mut points = Vec::new();
    for flight in flights {
        let place = |name: &str| flight.quantity_names.iter().position(|n| n == name);
        let (Some(x), Some(y)) = (place(over), place(quantity)) else {
            continue;
        };
        let each = flight.quantities.iter().map(|row| (row[x], row[y]));
        points.extend(each.filter(|(x, y)| x.is_finite() && y.is_finite()));
    }
    points
}
