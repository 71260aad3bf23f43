//! Renders docs/studies/throws.md.

use report::figures::{Line, Panel, figure};
use serde::Serialize;

use super::{Launches, Tilts, Winds};
use crate::error::StudyError;
use crate::page::{Page, render};

#[derive(Serialize)]
struct Results<'r> {
    launches: &'r [Launches],
    rolls: &'r [(f64, Tilts)],
    winds: &'r [Winds],
    best: Winds,
    best_upright: Winds,
    /// Pairs of a wind speed, m/s, and the range of the longest throw against that wind minus that of the longest throw
    /// with it, m. All throws have zero hyzer angle.
    pairs: Vec<(f64, f64)>,
}

/// Renders docs/studies/throws.md from the simulated disc launches (`launches`), the launches for several roll coefficients
/// (`rolls`: C_Rr in s, results), and the longest discus throws in several winds (`winds`).
///
/// # Errors
/// [`StudyError`] if the template cannot be rendered with the results.
///
/// # Panics
/// If `winds` is empty.
pub fn throws_page(
    launches: &[Launches],
    rolls: &[(f64, Tilts)],
    winds: &[Winds],
) -> Result<Page, StudyError> {
    let best = winds
        .iter()
        .max_by(|a, b| a.range.total_cmp(&b.range))
        .expect("winds");
    let best_upright = winds
        .iter()
        .max_by(|a, b| a.upright.total_cmp(&b.upright))
        .expect("winds");
    let range = |wind: f64| winds.iter().find(|w| w.wind == wind).map(|w| w.upright);
    let pairs = winds.iter().filter(|w| w.wind > 0.0);
    let pairs = pairs
        .filter_map(|w| Some((w.wind, range(-w.wind)? - w.upright)))
        .collect();
    let lines = launches.iter().enumerate().map(|(k, launch)| Line {
        name: ["own", "tunnel", "mixed", "tables"]
            .get(k)
            .copied()
            .unwrap_or("")
            .to_owned(),
        points: launch
            .tilts
            .landings
            .iter()
            .map(|(_, x, y)| (*x, *y))
            .collect(),
    });
    let panel = Panel {
        title: "Landings over the hyzer at launch, -60° to 60°: y, m".into(),
        across: "x, m".into(),
        lines: lines.collect(),
        ..Panel::default()
    };
    Ok(Page {
        text: render(
            include_str!("page.md"),
            Results {
                launches,
                rolls,
                winds,
                best: *best,
                best_upright: *best_upright,
                pairs,
            },
        )?,
        figures: vec![(
            "throws-landings.svg".into(),
            figure("Landings over the tilt", &[panel]),
        )],
    })
}
