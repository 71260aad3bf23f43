//! Renders docs/studies/bodies.md.

use model_spec::load::BODIES;
use model_spec::model::{Model, Parameter};
use report::figures::{Line, Panel, figure};
use serde::Serialize;

use super::{Curve, Filmed, TurnAndFade};
use crate::error::StudyError;
use crate::page::{Page, render};

#[derive(Serialize)]
struct Results<'r> {
    bodies: Vec<Body>,
    flights: &'r [TurnAndFade],
    filmed: &'r [Filmed],
}

/// Description, constants, and tables of coefficients of a body, as specified in its model file.
#[derive(Serialize)]
struct Body {
    name: String,
    /// Heading of the body: the first paragraph of the documentation in its model file.
    title: String,
    sources: Vec<String>,
    constants: Vec<[String; 3]>,
    tables: Vec<[String; 3]>,
}

impl Body {
    fn of(model: &Model) -> Self {
        let mut paragraphs = model.doc.split("\n\n").flat_map(|p| p.split("\n \n"));
        let one_line = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        let row = |p: &Parameter| {
            [
                p.name.clone(),
                model_spec::with_unit(p.value, &p.unit_text),
                one_line(&p.doc),
            ]
        };
        let constants = model.params.iter().chain(&model.coefficients);
        let tables = model.tables.iter().map(|table| {
            let argument = &table.arguments[0];
            let ends = [argument.knots.first(), argument.knots.last()];
            let [first, last] = ends.map(|knot| knot.copied().unwrap_or_default());
            let range = match argument.unit_text.as_str() {
                "rad" => format!("{:.0}° to {:.0}°", first.to_degrees(), last.to_degrees()),
                unit => format!("{first} to {}", model_spec::with_unit(last, unit)),
            };
            let knots = format!("{} knots, {range}", argument.knots.len());
            let name = format!("{}({})", table.name, argument.name);
            [name, knots, one_line(&table.doc)]
        });
        Body {
            name: model.name.clone(),
            title: one_line(paragraphs.next().unwrap_or_default()),
            sources: paragraphs.map(one_line).collect(),
            constants: constants.map(row).collect(),
            tables: tables.collect(),
        }
    }
}

/// Renders docs/studies/bodies.md and its figure of aerodynamic coefficients. `filmed` is empty if the measured throws are not
/// available.
///
/// # Errors
/// [`StudyError`] if a body does not load, or if a template cannot be rendered with the results.
pub fn bodies_page(
    curves: &[Curve],
    flights: &[TurnAndFade],
    filmed: &[Filmed],
) -> Result<Page, StudyError> {
    let models = BODIES.iter().map(|(name, _)| {
        let model = model_spec::load::load(name, &[])?;
        Ok(Body::of(&model))
    });
    let bodies: Result<Vec<Body>, StudyError> = models.collect();
    let titles = [
        "Lift C_L",
        "Drag C_D",
        "Pitching moment C_M, nose-up positive",
    ];
    let panels = titles.into_iter().enumerate().map(|(k, title)| {
        let lines = curves.iter().map(|curve| Line {
            name: { curve.name.trim_start_matches("golf_") }
                .trim_end_matches("_disc")
                .to_owned(),
            points: curve.points.iter().map(|(a, c)| (*a, c[k])).collect(),
        });
        Panel {
            title: title.into(),
            across: "angle of attack, deg".into(),
            lines: lines.collect(),
            ..Panel::default()
        }
    });
    let panels: Vec<Panel> = panels.collect();
    Ok(Page {
        text: render(
            include_str!("page.md"),
            Results {
                bodies: bodies?,
                flights,
                filmed,
            },
        )?,
        figures: vec![(
            "bodies-coefficients.svg".into(),
            figure("Coefficients of the discs", &panels),
        )],
    })
}
