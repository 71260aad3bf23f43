//! Figures of profile likelihoods: deviance as a function of one fixed coefficient, with all other parameters
//! refitted.

use identify::FitReport;
use model_spec::sort_by_number;

use crate::figure::Figure;
use crate::figures::{Dots, Layout, Line, Look, Mark, Panel};
use identify::numbers::{Digits, raised, unit};

/// Deviance of the profile likelihood above which a value of the coefficient is rejected at the 5 % level: 95 %
/// quantile of χ²(1).
const LEVEL: f64 = 3.84;
/// Maximum number of profile likelihoods drawn, one figure each.
const MAX_PROFILES: usize = 24;

/// Draws one figure for each profile likelihood in the report.
pub(in super::super) fn profiles(report: &FitReport) -> Vec<Figure> {
    let wanted = report.profiles.iter().take(MAX_PROFILES).enumerate();
    wanted
        .map(|(i, profile)| {
            let coefficient = report.coefficients.get(&profile.name);
            let unit = coefficient.map_or_else(String::new, |c| unit(&c.unit));
            let points = profile.points.iter().map(|[value, d]| (*value, *d));
            let mut points: Vec<(f64, f64)> =
                points.filter(|p| p.0.is_finite() && p.1.is_finite()).collect();
            sort_by_number(&mut points, |point| point.0);
            let highest = points.iter().map(|p| p.1).fold(2.0 * LEVEL, f64::max);
            let top = highest.min(4.0 * LEVEL);
            // Axes of very small or large values are scaled by a power of ten, so that tick labels are readable.
            let largest = points.iter().map(|p| p.0.abs()).fold(0.0, f64::max);
            let power = match largest.log10().floor() as i32 {
                p if largest > 0.0 && !(-3..5).contains(&p) => p,
                _ => 0,
            };
            let scale = 10_f64.powi(-power);
            for point in &mut points {
                point.0 *= scale;
            }
            let inside = points.iter().copied().filter(|p| p.1 <= 1.02 * top);
            let dots: Vec<(f64, f64)> = inside.collect();
            let ends = profile.interval.iter().flatten();
            let ends = ends.filter(|end| end.is_finite()).map(|end| Mark {
                name: String::new(),
                at: (end * scale, f64::NAN),
            });
            let across = match (unit.as_str(), power) {
                ("", 0) => profile.name.clone(),
                (unit, 0) => format!("{}, {unit}", profile.name),
                (unit, p) => format!("{}, 10{} {unit}", profile.name, raised(p)),
            };
            let width = coefficient.map_or(f64::NAN, |c| c.std_error);
            let end = |end: Option<f64>| match end {
                Some(value) => format!("at {} {unit}", Digits::of(value, width).one(value)),
                None => "nowhere in the profiled range".to_owned(),
            };
            let [low, high] = profile.interval.map(end).map(|end| end.trim().to_owned());
            let panel = Panel {
                title: "Deviance".into(),
                across,
                lines: vec![Line {
                    name: String::new(),
                    points: dots.clone(),
                }],
                thin: true,
                dots: vec![Dots {
                    look: Look::Colour(0),
                    points: dots,
                }],
                marks: ends.collect(),
                levels: vec![LEVEL],
                up: Some((-0.05 * top, 1.05 * top)),
                ..Panel::default()
            };
            Figure::of_panels(
                format!("profile-{:02}", i + 1),
                &format!("Profile likelihood of {}", profile.name),
                format!(
                    "Broken line: 3.84, where a value is rejected at the 5\u{a0}% level. It is reached below {low}, above {high}."
                ),
                Layout::SMALL,
                &[panel],
            )
        })
        .collect()
}
