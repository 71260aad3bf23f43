//! A wind tunnel's table beside the curves of the disc.

use model_spec::model::Model;
use report::figures::{Dots, Line, Look, Panel, figure};

use crate::markdown::{Text, three};
use crate::real_data::wind_tunnel::{Curve, Measured, between, lowest};

/// Angles over which the disc's curves are fitted to the tunnel's table, degrees.
const RANGES: [(f64, f64); 3] = [(-5.0, 10.0), (-5.0, 15.0), (-10.0, 30.0)];

const NAMES: [&str; 3] = ["lift", "drag", "pitching moment"];

/// The section.
pub fn tunnel(text: &mut Text, disc: &Model, table: &[Measured]) {
    text.paragraph("## A frisbee in a wind tunnel (Potts & Crowther)");
    text.paragraph(
        "Lift, drag and pitching moment of a disc at rest in a stream, from -100° to 100°, against the curves that the model \
         `disc` has: lift linear in the angle of attack, drag quadratic about 0, moment linear and 0 at 0 (nose-up negative here, as \
         the model has it). For each range the curves of this form that are nearest to the table, and how far they stay from it (root mean \
         square, and the same of the model's own coefficients):",
    );
    let own = own(disc);
    let mut rows = Vec::new();
    for (low, high) in RANGES {
        let within = between(table, low, high);
        for which in 0..3 {
            let Some(curve) = form(&within, which) else {
                continue;
            };
            let size = within
                .iter()
                .map(|row| row.coefficients[which].powi(2))
                .sum::<f64>()
                / within.len() as f64;
            rows.push(vec![
                format!("{}, {low}° to {high}°", NAMES[which]),
                if which == 2 {
                    "0".into()
                } else {
                    three(curve.constant)
                },
                three(curve.multiple),
                three(curve.rms(&within, which)),
                three(own[which].rms(&within, which)),
                three(size.sqrt()),
            ]);
        }
    }
    text.table(
        &[
            "curve",
            "constant",
            "multiple",
            "fit stays off by",
            "the model's own",
            "size of the measured",
        ],
        rows,
    );
    text.paragraph(format!(
        "The model's own: {}.",
        disc.coefficients
            .iter()
            .take(5)
            .map(|c| format!("`{}` {}", c.name, three(c.value)))
            .collect::<Vec<_>>()
            .join(", ")
    ));
    let (low, high) = RANGES[1];
    text.paragraph(format!(
        "![Measured coefficients, the model's own curves, and those fitted from {low}° to {high}°](real-data-tunnel.svg)"
    ));
    missed(text, table);
}

/// Where the table leaves the curves' form, by numbers of its own.
fn missed(text: &mut Text, table: &[Measured]) {
    let slope = |which: usize, low: f64, high: f64| {
        let curve = Curve::fitted(&between(table, low, high), which, 1, false);
        three(curve.map_or(f64::NAN, |curve| curve.multiple))
    };
    text.paragraph(
        "What the forms miss, by slopes (per rad) of straight lines through parts of the table:",
    );
    if let Some(lowest) = lowest(&between(table, -10.0, 15.0), 1) {
        text.line(format!(
            "- drag: a parabola that may lie anywhere is lowest at {:.1}° over -10° to 15°; the model's lies at 0°;",
            lowest.to_degrees()
        ));
    }
    text.line(format!(
        "- lift: {} from 0° to 10°, {} from 10° to 20°, {} from 20° to 30°; the model has one slope;",
        slope(0, 0.0, 10.0),
        slope(0, 10.0, 20.0),
        slope(0, 20.0, 30.0)
    ));
    let at_zero = table.iter().find(|row| row.alpha.abs() < 1e-9);
    text.line(format!(
        "- pitching moment: {} at 0°, where the model has 0; slopes of {} from 0° to 10° and {} from 15° to 25°; the model has one.",
        at_zero.map_or(String::new(), |row| three(row.coefficients[2])),
        slope(2, 0.0, 10.0),
        slope(2, 15.0, 25.0)
    ));
    text.line("");
    text.paragraph(
        "The table is that of a disc that does not spin, and of another make than the model's.",
    );
}

/// The curve of the model's form that is nearest to the rows.
fn form(rows: &[Measured], which: usize) -> Option<Curve> {
    let (power, through_zero) = [(1, false), (2, false), (1, true)][which];
    Curve::fitted(rows, which, power, through_zero)
}

/// The model's own curves.
fn own(disc: &Model) -> [Curve; 3] {
    let value = |name: &str| {
        disc.coefficients
            .iter()
            .find(|c| c.name == name)
            .map_or(0.0, |c| c.value)
    };
    [
        Curve {
            constant: value("C_L0"),
            multiple: value("C_La"),
            power: 1,
        },
        Curve {
            constant: value("C_D0"),
            multiple: value("C_Da"),
            power: 2,
        },
        Curve {
            constant: 0.0,
            multiple: value("C_Ma"),
            power: 1,
        },
    ]
}

/// Angles that are drawn, degrees.
const DRAWN: (f64, f64) = (-30.0, 45.0);

/// The figure.
pub fn drawn(disc: &Model, table: &[Measured]) -> String {
    let rows = between(table, DRAWN.0, DRAWN.1);
    let (low, high) = RANGES[1];
    let within = between(table, low, high);
    let own = own(disc);
    let panels: Vec<Panel> = (0..3)
        .map(|which| {
            let line = |name: &str, curve: Curve| Line {
                name: name.into(),
                points: (-60..=90)
                    .map(|k| f64::from(k) * 0.5)
                    .map(|a| (a, curve.at(a.to_radians())))
                    .collect(),
            };
            let mut lines = vec![line("model's", own[which])];
            lines.extend(form(&within, which).map(|curve| line("fitted", curve)));
            Panel {
                title: format!("{}, coefficient", NAMES[which]),
                across: "angle of attack, degrees".into(),
                lines,
                thin: true,
                dots: vec![Dots {
                    look: Look::Cross,
                    points: rows
                        .iter()
                        .map(|row| (row.alpha.to_degrees(), row.coefficients[which]))
                        .collect(),
                }],
                ..Panel::default()
            }
        })
        .collect();
    figure("A wind tunnel's table and the disc's curves", &panels)
}
