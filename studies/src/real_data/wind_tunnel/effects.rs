//! Section of docs/studies/real-data.md on the effects of the catalogue that improve the disc's aerodynamic curves.

use model_spec::sort_by_number;
use serde::Serialize;

use super::curves::{ALPHA, CUBE, Coefficient, Curve, ONE, SQUARE, STALL, Shape, minimum};
use super::table::{Measured, between};
use crate::error::StudyError;
use crate::page::render;

/// Half-widths of the ranges of angle of attack, centred at 0, over which curves are fitted to the wind tunnel's table,
/// degrees.
const HALF_WIDTHS: [f64; 3] = [10.0, 20.0, 30.0];

/// A functional form of a curve of lift, drag or pitching moment over the angle of attack: a linear combination of
/// basis functions.
struct Form {
    coefficient: Coefficient,
    /// Description of the curve's shape for the aerodynamic model without added effects; otherwise the name of the
    /// effect that gives the curve this shape.
    name: &'static str,
    shapes: &'static [Shape],
}

const fn form(coefficient: Coefficient, name: &'static str, shapes: &'static [Shape]) -> Form {
    Form {
        coefficient,
        name,
        shapes,
    }
}

const LIFT: Form = form(0, "lift: straight", &[ONE, ALPHA]);
const LIFT_STALL: Form = form(0, "`stall`", &[ONE, ALPHA, STALL]);
const DRAG: Form = form(1, "drag: parabola about 0", &[ONE, SQUARE]);
/// Form of the drag curve with the effect `zero_lift_drag_angle`: a parabola about a shifted angle, written as a
/// parabola with a linear term.
const DRAG_SHIFTED: Form = form(1, "`zero_lift_drag_angle`", &[ONE, SQUARE, ALPHA]);
const MOMENT: Form = form(2, "pitching moment: straight through 0", &[ALPHA]);
const MOMENT_CONSTANT: Form = form(2, "`constant_pitching_moment`", &[ALPHA, ONE]);
const MOMENT_CUBIC: Form = form(2, "`cubic_pitching_moment`", &[ALPHA, CUBE]);
const MOMENT_BOTH: Form = form(2, "both", &[ALPHA, ONE, CUBE]);
const MOMENT_EVEN: Form = form(
    2,
    "both, and a square (no effect has it)",
    &[ALPHA, ONE, CUBE, SQUARE],
);

/// Functional forms of the aerodynamic curves, in the order in which their residuals are tabulated.
const FORMS: [&Form; 9] = [
    &LIFT,
    &LIFT_STALL,
    &DRAG,
    &DRAG_SHIFTED,
    &MOMENT,
    &MOMENT_CONSTANT,
    &MOMENT_CUBIC,
    &MOMENT_BOTH,
    &MOMENT_EVEN,
];

/// For lift, drag and pitching moment: name, the model's form of the curve, and the absolute difference between the
/// curve and the tabulated coefficient above which the curve counts as deviating from the table.
const DEPARTURES: [(&str, &Form, f64); 3] = [
    ("Lift", &LIFT, 0.1),
    ("Drag", &DRAG, 0.05),
    ("The pitching moment", &MOMENT, 0.01),
];

#[derive(Serialize)]
struct Section {
    forms: Vec<FormRow>,
    departures: Vec<Departure>,
    /// Fraction by which the RMS residual of the drag parabola decreases if its minimum may shift along the angle of
    /// attack. The first entry is for the narrowest, the second for the widest range of angle of attack; `None` if
    /// there are too few rows.
    drag_shifted: [Option<f64>; 2],
    stall: [Option<f64>; 2],
    moment_constant: [Option<f64>; 2],
    moment_cubic: [Option<f64>; 2],
    /// Angle of attack of minimum drag, degrees, from a fit of a parabola with a free vertex to the tabulated drag. The
    /// first entry is from the fit over the narrowest, the second over the widest range of angle of attack; `None` if
    /// the parabola has no minimum or the range contains too few rows of the table.
    least_drag: [Option<f64>; 2],
}

#[derive(Serialize)]
struct FormRow {
    name: &'static str,
    /// RMS residuals of the curve with this functional form, one for each range of angle of attack to which it is
    /// fitted; `None` if the range has too few rows.
    rms: Vec<Option<f64>>,
}

/// Angles of attack at which a curve of the model's form first deviates from the table. The curve is fitted over the
/// narrowest range of angle of attack.
#[derive(Serialize)]
struct Departure {
    name: &'static str,
    limit: f64,
    /// Smallest angle of attack ≥ 0, degrees, at which the curve deviates from the table by more than the coefficient
    /// difference `limit`. `None` if there is no such angle.
    above: Option<f64>,
    /// Largest angle of attack ≤ 0, degrees, at which the curve deviates from the table by more than the coefficient
    /// difference `limit`. `None` if there is no such angle.
    below: Option<f64>,
}

/// Renders the section of docs/studies/real-data.md on the effects (optional model extensions) that improve the fit of the
/// model's curves to the wind tunnel's table of coefficients, as Markdown.
pub(in super::super) fn effects_section(table: &[Measured]) -> Result<String, StudyError> {
    let ranges = HALF_WIDTHS.map(|width| between(table, -width, width));
    let rms = |form: &Form, rows: &[Measured]| {
        let curve = Curve::fitted(rows, form.coefficient, form.shapes)?;
        Some(curve.rms(rows, form.coefficient))
    };
    let ends = [&ranges[0], &ranges[2]];
    let removed =
        |form: &Form, base: &Form| ends.map(|rows| Some(1.0 - rms(form, rows)? / rms(base, rows)?));
    let least_drag = |rows: &Vec<Measured>| {
        let curve = Curve::fitted(rows, DRAG_SHIFTED.coefficient, DRAG_SHIFTED.shapes)?;
        let [constant, square, linear] = curve.multiples.try_into().ok()?;
        minimum([constant, linear, square]).map(f64::to_degrees)
    };
    let forms = FORMS.iter().map(|form| FormRow {
        name: form.name,
        rms: ranges.iter().map(|rows| rms(form, rows)).collect(),
    });
    let departures = DEPARTURES.iter();
    let section = Section {
        forms: forms.collect(),
        departures: departures
            .filter_map(|(name, form, limit)| departure(table, &ranges[0], name, form, *limit))
            .collect(),
        drag_shifted: removed(&DRAG_SHIFTED, &DRAG),
        stall: removed(&LIFT_STALL, &LIFT),
        moment_constant: removed(&MOMENT_CONSTANT, &MOMENT),
        moment_cubic: removed(&MOMENT_CUBIC, &MOMENT),
        least_drag: ends.map(least_drag),
    };
    render(include_str!("effects.md"), section)
}

fn departure(
    table: &[Measured],
    fitted_rows: &[Measured],
    name: &'static str,
    form: &Form,
    limit: f64,
) -> Option<Departure> {
    let curve = Curve::fitted(fitted_rows, form.coefficient, form.shapes)?;
    let first = |sign: f64| {
        let side = table.iter().filter(|row| row.alpha * sign >= 0.0);
        let mut side: Vec<&Measured> = side.collect();
        sort_by_number(&mut side, |point| point.alpha.abs());
        let departs = |row: &&&Measured| {
            (row.coefficients[form.coefficient] - curve.at(row.alpha)).abs() > limit
        };
        side.iter().find(departs).map(|row| row.alpha.to_degrees())
    };
    Some(Departure {
        name,
        limit,
        above: first(1.0),
        below: first(-1.0),
    })
}
