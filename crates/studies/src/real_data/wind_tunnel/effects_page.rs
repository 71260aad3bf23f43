//! Which effects of the catalogue mend the disc's curves, and how far.

use crate::markdown::{Text, three};
use crate::real_data::wind_tunnel::{Measured, between, nearest};

/// Half-widths of the ranges of angles, degrees.
const WIDTHS: [f64; 3] = [10.0, 20.0, 30.0];

type Shape = fn(f64) -> f64;

/// A form of a curve: the coefficient, what its effects are called, its shapes.
type Row = (usize, &'static str, &'static [Shape]);

const ONE: Shape = |_| 1.0;
const ALPHA: Shape = |a| a;
const SQUARE: Shape = |a| a * a;
const CUBE: Shape = |a| a * a * a;
/// As the effect `stall` has it: above 8 degrees.
const STALL: Shape = |a| -(a - 8_f64.to_radians()).max(0.0).powi(2);

/// The model's forms, each followed by what effects make of it. A parabola with a linear part is one that lies elsewhere.
const FORMS: [Row; 9] = [
    (0, "lift: straight", &[ONE, ALPHA]),
    (0, "`stall`", &[ONE, ALPHA, STALL]),
    (1, "drag: parabola about 0", &[ONE, SQUARE]),
    (1, "`zero_lift_drag_angle`", &[ONE, SQUARE, ALPHA]),
    (2, "pitching moment: straight through 0", &[ALPHA]),
    (2, "`constant_pitching_moment`", &[ALPHA, ONE]),
    (2, "`cubic_pitching_moment`", &[ALPHA, CUBE]),
    (2, "both", &[ALPHA, ONE, CUBE]),
    (
        2,
        "both, and a square (no effect has it)",
        &[ALPHA, ONE, CUBE, SQUARE],
    ),
];

/// What differs by more than this is told of, of lift, drag and moment.
const APART: [f64; 3] = [0.1, 0.05, 0.01];

/// The section.
pub fn section(text: &mut Text, table: &[Measured]) {
    text.paragraph(
        "Which effects of the catalogue mend that, and how far? Forms fitted to the table within so many degrees of 0, and what they leave \
         (root mean square; rows stand 5° apart, so the first range has five of them):",
    );
    let within: Vec<Vec<Measured>> = WIDTHS.iter().map(|w| between(table, -w, *w)).collect();
    let rows = FORMS.iter().map(|(which, name, shapes)| {
        let mut row = vec![(*name).to_owned()];
        for rows in &within {
            let found = nearest(rows, *which, shapes);
            row.push(found.map_or(String::new(), |(_, left)| three(left)));
        }
        row
    });
    text.table(&["form", "within 10°", "20°", "30°"], rows);
    let near = |form: usize| {
        let (which, _, shapes) = FORMS[form];
        let (found, _) = nearest(&within[0], which, shapes)?;
        let value = move |alpha: f64| -> f64 {
            let each = found.iter().zip(shapes);
            each.map(|(multiple, shape)| multiple * shape(alpha)).sum()
        };
        Some((which, value))
    };
    for (name, form) in [("Lift", 0), ("Drag", 2), ("The pitching moment", 4)] {
        let Some((which, value)) = near(form) else {
            continue;
        };
        let first = |sign: f64| {
            let mut rows: Vec<&Measured> = table.iter().filter(|r| r.alpha * sign >= 0.0).collect();
            rows.sort_by(|a, b| a.alpha.abs().total_cmp(&b.alpha.abs()));
            let apart = |row: &&&Measured| {
                (row.coefficients[which] - value(row.alpha)).abs() > APART[which]
            };
            let row = rows.iter().find(apart);
            row.map_or("nowhere".to_owned(), |row| {
                format!("{:.0}°", row.alpha.to_degrees())
            })
        };
        text.line(format!(
            "- {name}: the model's form, fitted within 10°, is off by more than {} first at {} above and at {} below;",
            APART[which],
            first(1.0),
            first(-1.0)
        ));
    }
    text.line("");
    let share = |form: usize, base: usize, width: usize| {
        let left = |form: usize| {
            let (which, _, shapes) = FORMS[form];
            nearest(&within[width], which, shapes).map_or(f64::NAN, |found| found.1)
        };
        format!("{:.0} %", 100.0 * (1.0 - left(form) / left(base)))
    };
    let place = |width: usize| {
        let (which, _, shapes) = FORMS[3];
        nearest(&within[width], which, shapes).map_or(f64::NAN, |(found, _)| {
            (-found[2] / (2.0 * found[1])).to_degrees()
        })
    };
    text.paragraph(format!(
        "`zero_lift_drag_angle` takes {} of the drag's error away within 10° and {} within 30°, with the least drag at {:.1}° and {:.1}°; `stall` takes \
         {} and {} of the lift's. Of the moment `constant_pitching_moment` takes {} within 10° and {} within 30°, `cubic_pitching_moment` {} \
         and {}. A disc is not alike on both sides: where the range is wide, what is missing is a curve with an even part, which the cube is not.",
        share(3, 2, 0),
        share(3, 2, 2),
        place(0),
        place(2),
        share(1, 0, 0),
        share(1, 0, 2),
        share(5, 4, 0),
        share(5, 4, 2),
        share(6, 4, 0),
        share(6, 4, 2),
    ));
}
