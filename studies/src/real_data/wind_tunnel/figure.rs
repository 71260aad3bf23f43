//! Figure of the wind tunnel's table with the model's curves.

use model_spec::model::Model;
use report::figures::{Dots, Line, Look, Panel, figure};

use super::curves::Curve;
use super::page::{FIGURE_RANGE, NAMES, fitted_curve, model_curves};
use super::table::{Measured, between};

/// Range of angle of attack shown in the figure of lift, drag and pitching-moment curves, degrees.
const SHOWN: (f64, f64) = (-30.0, 45.0);

/// Draws the wind tunnel's coefficients and the model's curves as SVG: one panel each for lift, drag and pitching
/// moment.
pub(in super::super) fn tunnel_figure(disc: &Model, table: &[Measured]) -> String {
    let shown = between(table, SHOWN.0, SHOWN.1);
    let fitted_rows = between(table, FIGURE_RANGE.0, FIGURE_RANGE.1);
    let model = model_curves(disc);
    let line = |name: &str, curve: &Curve| Line {
        name: name.into(),
        points: (-60..=90)
            .map(|k| f64::from(k) * 0.5)
            .map(|a| (a, curve.at(a.to_radians())))
            .collect(),
    };
    let panels = (0..3).map(|coefficient| {
        let mut lines = vec![line("model's", &model[coefficient])];
        let fitted = fitted_curve(&fitted_rows, coefficient);
        lines.extend(fitted.map(|curve| line("fitted", &curve)));
        let points = shown.iter();
        let points = points.map(|row| (row.alpha.to_degrees(), row.coefficients[coefficient]));
        Panel {
            title: format!("{}, coefficient", NAMES[coefficient]),
            across: "angle of attack, degrees".into(),
            lines,
            thin: true,
            dots: vec![Dots {
                look: Look::Cross,
                points: points.collect(),
            }],
            ..Panel::default()
        }
    });
    let panels: Vec<Panel> = panels.collect();
    figure("A wind tunnel's table and the disc's curves", &panels)
}
