//! Figures of profile likelihoods: deviance as a function of one fixed coefficient, with all other parameters
//! refitted.

use identify::numbers::{Digits, raised, unit};
use identify::{FitReport, Profile};
use model_spec::sort_by_number;

use crate::figure::Figure;
use crate::figures::axis::power_of_ten;
use crate::figures::{Layout, Look, Mark, Panel};
use crate::thin::MAX_FIGURES;

/// Deviance of the profile likelihood above which a value of the coefficient is rejected at the 5 % level: 95 %
/// quantile of χ²(1).
const LEVEL: f64 = 3.84;

/// Draws one figure for each profile likelihood in the report.
pub(in super::super) fn profiles(report: &FitReport) -> Vec<Figure> {
    let wanted = report.profiles.iter().take(MAX_FIGURES).enumerate();
    wanted
        .map(|(i, profile)| figure(i, profile, report))
        .collect()
}

fn figure(index: usize, profile: &Profile, report: &FitReport) -> Figure {
    let coefficient = report.coefficients.get(&profile.name);
    let unit = coefficient.map_or_else(String::new, |c| unit(&c.unit));
    let points = profile.points.iter().map(|[value, d]| (*value, *d));
    let mut points: Vec<(f64, f64)> = points
        .filter(|p| p.0.is_finite() && p.1.is_finite())
        .collect();
    sort_by_number(&mut points, |point| point.0);
    let highest = points.iter().map(|p| p.1).fold(2.0 * LEVEL, f64::max);
    let top = highest.min(4.0 * LEVEL);
    let power = power_of_ten(points.iter().map(|p| p.0.abs()).fold(0.0, f64::max));
    let scale = 10_f64.powi(-power);
    points.retain(|p| p.1 <= 1.02 * top);
    for point in &mut points {
        point.0 *= scale;
    }
    let ends = profile.interval.iter().flatten();
    let ends = ends.filter(|end| end.is_finite());
    let across = match (unit.as_str(), power) {
        ("", 0) => profile.name.clone(),
        (unit, 0) => format!("{}, {unit}", profile.name),
        (unit, p) => format!("{}, 10{} {unit}", profile.name, raised(p)),
    };
    let panel = Panel {
        thin: true,
        marks: ends.map(|end| Mark::vertical("", end * scale)).collect(),
        levels: vec![LEVEL],
        up: Some((-0.05 * top, 1.05 * top)),
        ..Panel::new("Deviance", across)
    };
    let panel = panel.line("", points.clone()).dots(Look::Colour(0), points);
    let width = coefficient.map_or(f64::NAN, |c| c.std_error);
    let end = |end: Option<f64>| match end {
        Some(value) => format!("at {} {unit}", Digits::of(value, width).one(value)),
        None => "nowhere in the profiled range".to_owned(),
    };
    let [low, high] = profile.interval.map(end).map(|end| end.trim().to_owned());
    let name = format!("profile-{:02}", index + 1);
    let title = format!("Profile likelihood of {}", profile.name);
    let caption = format!(
        "Broken line: 3.84, where a value is rejected at the 5\u{a0}% level. It is reached below {low}, above {high}."
    );
    Figure::of_panels(name, &title, caption, Layout::SMALL, &[panel])
}
