//! Section of docs/studies/real-data.md on the wind tunnel's table and the model's curves.

use model_spec::model::Model;
use serde::Serialize;

use super::curves::{ALPHA, Curve, ONE, SQUARE, Shape, minimum};
use super::table::{Measured, between};
use crate::error::StudyError;
use crate::page::render;

/// Ranges of angle of attack over which the model's curves are fitted, degrees.
const RANGES: [(f64, f64); 3] = [(-5.0, 10.0), (-5.0, 15.0), (-10.0, 30.0)];

/// Range of angle of attack over which the curves in the figure are fitted, degrees.
pub(super) const FIGURE_RANGE: (f64, f64) = RANGES[1];

/// Names of the coefficients, in the order of the columns of the wind tunnel's table.
pub(super) const NAMES: [&str; 3] = ["lift", "drag", "pitching moment"];

/// Basis functions of the model's curves: linear lift, parabolic drag about 0, moment proportional to the angle.
const MODEL_SHAPES: [&[Shape]; 3] = [&[ONE, ALPHA], &[ONE, SQUARE], &[ALPHA]];

#[derive(Serialize)]
struct Section {
    curves: Vec<CurveRow>,
    coefficients: Vec<(String, f64)>,
    figure_range: (f64, f64),
    /// Angle of attack at the minimum of the fitted drag parabola, degrees; `None` if the parabola has no minimum.
    least_drag: Option<f64>,
    lift_slopes: [Option<f64>; 3],
    moment_at_zero: Option<f64>,
    moment_slopes: [Option<f64>; 2],
}

/// A curve with the model's functional form, fitted to the wind tunnel's table over a range of angle of attack.
#[derive(Serialize)]
struct CurveRow {
    name: &'static str,
    low: f64,
    high: f64,
    constant: f64,
    multiple: f64,
    rms: f64,
    /// RMS difference, over the range of the fit, between the table and the curve with the coefficients of the model
    /// file.
    model_rms: f64,
    /// RMS, over the range of the fit, of the values of this aerodynamic coefficient in the table.
    magnitude: f64,
}

/// Renders the section of docs/studies/real-data.md that compares the wind tunnel's table of coefficients with the model's
/// curves, as Markdown.
pub(in super::super) fn tunnel_section(
    disc: &Model,
    table: &[Measured],
) -> Result<String, StudyError> {
    let model = model_curves(disc);
    let slope = |coefficient: usize, low: f64, high: f64| {
        let line = Curve::fitted(&between(table, low, high), coefficient, &[ONE, ALPHA])?;
        Some(line.multiples[1])
    };
    let zero = table.iter().find(|row| row.alpha.abs() < 1e-9);
    let parabola = Curve::fitted(&between(table, -10.0, 15.0), 1, &[ONE, ALPHA, SQUARE]);
    let coefficients = disc.coefficients.iter().take(5);
    let section = Section {
        curves: RANGES
            .iter()
            .flat_map(|range| curve_rows(table, &model, *range))
            .collect(),
        coefficients: coefficients.map(|c| (c.name.clone(), c.value)).collect(),
        figure_range: FIGURE_RANGE,
        least_drag: parabola
            .and_then(|curve| minimum(curve.multiples.try_into().ok()?))
            .map(f64::to_degrees),
        lift_slopes: [
            slope(0, 0.0, 10.0),
            slope(0, 10.0, 20.0),
            slope(0, 20.0, 30.0),
        ],
        moment_at_zero: zero.map(|row| row.coefficients[2]),
        moment_slopes: [slope(2, 0.0, 10.0), slope(2, 15.0, 25.0)],
    };
    render(include_str!("page.md"), section)
}

fn curve_rows(table: &[Measured], model: &[Curve; 3], (low, high): (f64, f64)) -> Vec<CurveRow> {
    let rows = between(table, low, high);
    let curves = (0..3).filter_map(|coefficient| {
        let curve = fitted_curve(&rows, coefficient)?;
        let squares = rows.iter().map(|row| row.coefficients[coefficient].powi(2));
        let mean_square = squares.sum::<f64>() / rows.len() as f64;
        let (multiple, constant) = curve.multiples.split_last()?;
        Some(CurveRow {
            name: NAMES[coefficient],
            low,
            high,
            constant: constant.first().copied().unwrap_or(0.0),
            multiple: *multiple,
            rms: curve.rms(&rows, coefficient),
            model_rms: model[coefficient].rms(&rows, coefficient),
            magnitude: mean_square.sqrt(),
        })
    });
    curves.collect()
}

/// Least-squares fit of a curve with the model's basis functions to one coefficient in the rows of an aerodynamic table
/// (`coefficient`: 0 lift, 1 drag, 2 pitching moment); `None` if there are too few rows.
pub(super) fn fitted_curve(rows: &[Measured], coefficient: usize) -> Option<Curve> {
    Curve::fitted(rows, coefficient, MODEL_SHAPES[coefficient])
}

/// Curves of lift, drag and pitching moment over the angle of attack, with the coefficients of the model file of
/// `disc`.
pub(super) fn model_curves(disc: &Model) -> [Curve; 3] {
    let value = |name: &str| {
        let mut coefficients = disc.coefficients.iter();
        let found = coefficients.find(|c| c.name == name);
        found.map_or(0.0, |c| c.value)
    };
    [
        Curve::new(MODEL_SHAPES[0], vec![value("C_L0"), value("C_La")]),
        Curve::new(MODEL_SHAPES[1], vec![value("C_D0"), value("C_Da")]),
        Curve::new(MODEL_SHAPES[2], vec![value("C_Ma")]),
    ]
}
