//! Coefficient curves: the model's coefficients over the range of angle of attack or speed that the flights covered.

use dataset::statistics::median;
use identify::FlightEvidence;
use model_spec::model::{Model, Shape};
use model_spec::sort_by_number;
use serde::{Deserialize, Serialize};

/// Number of equal intervals of the abscissa of a curve (angle of attack or speed), and of samples in one for a point.
const GRID: (usize, usize) = (24, 4);

/// Quantiles of the abscissa (angle of attack or speed) over all samples; a curve is computed between these two.
const QUANTILES: (f64, f64) = (0.005, 0.995);

/// Names of abscissae: angle of attack, speed; the first that the model has is used.
const ABSCISSAE: [&str; 2] = ["alpha", "V"];

/// Prefix of the names of auxiliary variables that are aerodynamic coefficients, such as `C_D`.
const COEFFICIENT_PREFIX: &str = "C_";

/// A coefficient over angle of attack or speed, without and with the extension: medians within intervals.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CoefficientCurve {
    /// Name of the coefficient, such as `C_D`.
    pub quantity: String,
    /// Name of the abscissa, such as `alpha`.
    pub over: String,
    /// Unit of the abscissa, as text.
    pub unit: String,
    /// Centres of the intervals into which the abscissa is divided, in the unit of the abscissa.
    pub x: Vec<f64>,
    /// Medians of the coefficient in the model without the added effects, one for each interval of the abscissa.
    pub before: Vec<f64>,
    /// Medians of the coefficient in the extended model, one for each interval of the abscissa.
    pub after: Vec<f64>,
    /// Number of samples in each interval of the abscissa, counted for the model without the added effects.
    pub support: Vec<usize>,
}

/// Curves of every scalar auxiliary variable whose name begins with `C_`.
pub(crate) fn curves(
    model: &Model,
    before: &[FlightEvidence],
    after: &[FlightEvidence],
) -> Vec<CoefficientCurve> {
    let variable = |name: &str| model.aux_variables.iter().find(|l| l.name == name);
    let over = ABSCISSAE
        .into_iter()
        .find_map(|name| Some((name, variable(name)?)));
    let Some((over, abscissa)) = over else {
        return Vec::new();
    };
    let unit = abscissa.value.unit.to_string();
    let coefficients = model
        .aux_variables
        .iter()
        .filter(|l| l.name.starts_with(COEFFICIENT_PREFIX) && l.value.shape == Shape::Scalar);
    coefficients
        .filter_map(|coefficient| {
            let points = |flights| points(&coefficient.name, over, flights);
            let values = medians(points(before), points(after))?;
            Some(CoefficientCurve {
                quantity: coefficient.name.clone(),
                over: over.to_owned(),
                unit: unit.clone(),
                x: values.iter().map(|v| v.centre).collect(),
                before: values.iter().map(|v| v.before).collect(),
                after: values.iter().map(|v| v.after).collect(),
                support: values.iter().map(|v| v.support).collect(),
            })
        })
        .collect()
}

/// Medians in one interval without and with the added effects.
struct Interval {
    centre: f64,
    before: f64,
    after: f64,
    support: usize,
}

/// Intervals with enough samples (abscissa, value); `None` without samples or if all abscissae are equal.
fn medians(mut before: Vec<(f64, f64)>, mut after: Vec<(f64, f64)>) -> Option<Vec<Interval>> {
    if before.is_empty() || after.is_empty() {
        return None;
    }
    sort_by_number(&mut before, |point| point.0);
    sort_by_number(&mut after, |point| point.0);
    let all: Vec<f64> = before.iter().map(|point| point.0).collect();
    let mut intervals = intervals(&all, GRID.0).peekable();
    intervals.peek()?;
    let intervals = intervals.filter_map(|(from, step)| {
        let (mut was, mut is) = (within(&before, from, step), within(&after, from, step));
        let are_enough = was.len() >= GRID.1 && is.len() >= GRID.1;
        are_enough.then(|| Interval {
            centre: from + step / 2.0,
            support: was.len(),
            before: median(&mut was),
            after: median(&mut is),
        })
    });
    Some(intervals.collect())
}

/// Divides the range between the 0.5 % and the 99.5 % quantile of ascending values into equal intervals (start,
/// length).
#[doc(hidden)]
pub fn intervals(ascending: &[f64], number: usize) -> impl Iterator<Item = (f64, f64)> {
    let last = ascending.len().saturating_sub(1) as f64;
    let quantile = |part: f64| ascending.get((last * part) as usize).copied();
    let ends = quantile(QUANTILES.0).zip(quantile(QUANTILES.1));
    let ends = ends.filter(|(low, high)| low < high);
    ends.into_iter().flat_map(move |(low, high)| {
        let step = (high - low) / number as f64;
        (0..number).map(move |k| {
            let from = low + step * k as f64;
            (from, step)
        })
    })
}

/// Values whose abscissa is in [`from`, `from + width`); `points` are sorted.
fn within(points: &[(f64, f64)], from: f64, width: f64) -> Vec<f64> {
    let first = points.partition_point(|p| p.0 < from);
    let last = points.partition_point(|p| p.0 < from + width);
    points[first..last].iter().map(|p| p.1).collect()
}

/// Pairs (`over`, `quantity`) at all samples where both are finite.
fn points(quantity: &str, over: &str, flights: &[FlightEvidence]) -> Vec<(f64, f64)> {
    let mut points = Vec::new();
    for flight in flights {
        let position = |name: &str| flight.quantity_names.iter().position(|n| n == name);
        let (Some(x), Some(y)) = (position(over), position(quantity)) else {
            continue;
        };
        let each = flight.quantities.iter().map(|row| (row[x], row[y]));
        points.extend(each.filter(|(x, y)| x.is_finite() && y.is_finite()));
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_curve_is_the_median_within_each_interval() {
        let line = |slope: f64| -> Vec<(f64, f64)> {
            let points = (0..2400).map(|i| f64::from(i) / 2400.0);
            points.map(|x| (x, slope * x)).collect()
        };
        let mut before = line(1.0);
        before[1200].1 = 1e6;
        let values = medians(before, line(2.0)).unwrap();
        assert_eq!(values.len(), GRID.0);
        for value in &values {
            let x = value.centre;
            assert!((value.before - x).abs() < 1e-3 && (value.after - 2.0 * x).abs() < 2e-3);
            assert!(value.support > 90);
        }
        assert!(medians(vec![(1.0, 2.0); 50], line(1.0)).is_none());
        assert!(medians(Vec::new(), line(1.0)).is_none());
    }
}
