//! The page, the text and the map of a sweep.

use flight::throw::FIELDS;
use nalgebra::{Matrix2, Vector2};
use serde_json::Value;

use crate::figures::{Layout, Look, Mark, Panel};
use crate::{Figure, Html, Page, Table, Units, hundredths};

/// Units of the results of a flight by the names of their columns; those of a throw have their own.
const RESULTS: [(&str, &str); 10] = [
    ("landing_t", "s"),
    ("landing_x", "m"),
    ("landing_y", "m"),
    ("landing_z", "m"),
    ("apex_t", "s"),
    ("apex_z", "m"),
    ("range", "m"),
    ("final_speed", "m/s"),
    ("final_spin", "rpm"),
    ("steps", "1"),
];

/// Maximum number of landings that a page and a map show.
pub const MAX_LANDINGS: usize = 2_000;

/// Fractions of the landings inside the ellipses, were they normal.
const FRACTIONS: [f64; 2] = [0.5, 0.95];

/// Points of an ellipse.
const POINTS: usize = 72;

/// Landings of a sweep: a sample of them, and the ellipses of their mean and covariance.
#[derive(Clone, Debug, PartialEq)]
pub struct Landings {
    /// Places on the ground, m.
    pub places: Vec<[f64; 2]>,
    /// Mean of all landings, m.
    pub mean: [f64; 2],
    /// Ellipses that contain half and 95 % of the landings, were they normal; empty if there is no scatter.
    pub ellipses: Vec<Vec<[f64; 2]>>,
}

impl Landings {
    /// Landings of a sweep with its `summary.json`; `None` if no flight has landed.
    pub fn of(summary: &Value, places: Vec<[f64; 2]>) -> Option<Landings> {
        let mean = |name: &str| summary["columns"][name]["mean"].as_f64();
        let mean = [mean("landing_x")?, mean("landing_y")?];
        let entry = |i: usize, j: usize| summary["landing_covariance"][i][j].as_f64();
        let covariance = Matrix2::new(entry(0, 0)?, entry(0, 1)?, entry(1, 0)?, entry(1, 1)?);
        let has_scatter = covariance.trace() > 0.0;
        let ellipses = FRACTIONS.iter().filter(|_| has_scatter);
        let ellipses = ellipses.map(|fraction| ellipse(mean, covariance, *fraction));
        (!places.is_empty()).then(|| Landings {
            places,
            mean,
            ellipses: ellipses.collect(),
        })
    }

    fn figure(&self) -> Figure {
        let points = |of: &[[f64; 2]]| of.iter().map(|p| (p[0], p[1])).collect::<Vec<_>>();
        let mut panel = Panel {
            map: true,
            marks: vec![Mark::new("mean", (self.mean[0], self.mean[1]))],
            ..Panel::new("y, m", "x, m")
        };
        for ellipse in &self.ellipses {
            panel = panel.line("", points(ellipse));
        }
        let panel = panel.dots(Look::Pale, points(&self.places));
        let caption = "Grey: landings. Blue and red, dashed: the ellipses that half and 95 % of them are inside of, were they normal.";
        Figure::of_panels("landings", "Landings", caption, Layout::COLUMN, &[panel])
    }
}

/// Ellipse that contains a fraction of a normal distribution; the first point is repeated at the end.
fn ellipse(mean: [f64; 2], covariance: Matrix2<f64>, fraction: f64) -> Vec<[f64; 2]> {
    let eigen = covariance.symmetric_eigen();
    let radius = (-2.0 * (1.0 - fraction).ln()).sqrt();
    let axes = eigen
        .eigenvalues
        .map(|value| radius * value.max(0.0).sqrt());
    let point = |k: usize| {
        let (s, c) = (std::f64::consts::TAU * k as f64 / POINTS as f64).sin_cos();
        let at = eigen.eigenvectors * Vector2::new(axes.x * c, axes.y * s);
        [mean[0] + at.x, mean[1] + at.y]
    };
    (0..=POINTS).map(point).collect()
}

/// The page of a sweep by its `summary.json`.
pub fn page(summary: &Value, landings: Option<&Landings>) -> Page {
    let mut words = Html::new();
    words.paragraph(format!("{}.", counts(summary)));
    let mut picture = Html::new();
    if let Some(landings) = landings {
        let sd = |axis: usize| summary["landing_covariance"][axis][axis].as_f64();
        let [x, y] = [0, 1].map(|axis| sd(axis).unwrap_or(0.0).sqrt());
        words.paragraph(format!(
            "They land at x {:.2} m, y {:.2} m in the mean, with standard deviations of {x:.2} m and {y:.2} m.",
            hundredths(landings.mean[0]),
            hundredths(landings.mean[1])
        ));
        picture.leading_figure(Some(landings.figure()));
    }
    let mut body = Html::new();
    body.opening(words, picture, Html::new());
    let mut section = Html::new();
    section.table(&table(summary, Units::Si));
    body.section("columns", "What varied, and what came of it", section);
    body.note(concat!(
        "Every flight is a row of flights.parquet. hyzer ",
        env!("CARGO_PKG_VERSION")
    ));
    Page {
        kind: "hyzer sweep",
        title: format!("Sweep of {}", summary["model"].as_str().unwrap_or_default()),
        body,
        ..Page::default()
    }
}

/// Text of a sweep by its `summary.json`, in `units`.
pub fn text(summary: &Value, units: Units) -> String {
    format!(
        "{}\n{}",
        counts(summary),
        table(summary, units).text(usize::MAX)
    )
}

/// Model, number of flights, and how they ended.
fn counts(summary: &Value) -> String {
    let (model, flights) = (summary["model"].as_str(), &summary["flights"]);
    let mut text = format!("{}: {flights} flights", model.unwrap_or_default());
    for (status, count) in summary["statuses"].as_object().into_iter().flatten() {
        text += &format!(", {count} {status}");
    }
    text
}

/// Rounds a value as it is shown; a negative zero becomes 0.
fn hundred_thousandths(value: f64) -> f64 {
    (1e5 * value).round() / 1e5 + 0.0
}

fn table(summary: &Value, units: Units) -> Table {
    let unit = |name: &str| {
        let thrown = FIELDS.iter().map(|(name, unit, ..)| (*name, *unit));
        let mut all = thrown.chain(RESULTS);
        all.find(|(known, _)| *known == name).map(|(_, unit)| unit)
    };
    let number = |name: &str, value: &Value| {
        let size = unit(name).map_or(1.0, |unit| units.instead_of(unit).1);
        let value = value.as_f64();
        value.map_or("–".to_owned(), |value| {
            format!("{:.5}", hundred_thousandths(value / size))
        })
    };
    let mut rows = Table::of(summary["columns"].as_object().into_iter().flatten())
        .name("", |(name, _)| match unit(name) {
            None | Some("1") => (*name).clone(),
            Some(unit) => format!("{name}, {}", units.instead_of(unit).0),
        })
        .number("mean", |(name, own)| number(name, &own["mean"]))
        .number("sd", |(name, own)| number(name, &own["sd"]));
    for (head, key) in [("5 %", "0.05"), ("median", "0.5"), ("95 %", "0.95")] {
        rows = rows.number(head, |(name, own)| number(name, &own["quantiles"][key]));
    }
    rows.table()
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn summary() -> Value {
        let column = |mean: f64| json!({ "mean": mean, "sd": 1.0, "quantiles": { "0.5": mean } });
        json!({
            "model": "disc", "flights": 3, "statuses": { "landed": 3 },
            "columns": { "speed": column(26.8224), "landing_x": column(30.48), "landing_y": column(0.0), "C_D0": column(0.1) },
            "landing_covariance": [[4.0, 0.0], [0.0, 1.0]],
        })
    }

    #[test]
    fn a_coach_reads_miles_per_hour_and_feet() {
        let text = text(&summary(), Units::Imperial);
        assert!(text.contains("speed, mph      60.00000"), "{text}");
        assert!(text.contains("landing_x, ft  100.00000"), "{text}");
        assert!(text.contains("C_D0             0.10000"), "{text}");
    }

    #[test]
    fn the_ellipse_of_half_the_landings_has_the_radius_of_the_median() {
        let landings = Landings::of(&summary(), vec![[30.0, 1.0]]).unwrap();
        let farthest = |axis: usize| {
            let own = landings.ellipses[0]
                .iter()
                .map(|p| p[axis] - landings.mean[axis]);
            own.fold(0.0, f64::max)
        };
        // The square of the radius has the median 2 ln 2.
        let radius = (2.0 * 2.0_f64.ln()).sqrt();
        assert!((farthest(0) - 2.0 * radius).abs() < 1e-3 && (farthest(1) - radius).abs() < 1e-3);
        assert_eq!(Landings::of(&summary(), Vec::new()), None);
        let html = page(&summary(), Some(&landings)).html();
        assert!(html.contains("id=\"landings\"") && html.contains("scope=\"row\""));
    }
}
