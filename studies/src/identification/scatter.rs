//! Scatter plot of the estimates of each scenario, one dot per seed.

use report::figures::{Dots, Line, Look, Panel, figure};

use super::paper_fits::{PaperFits, Scenario};

/// Maximum number of dots (estimates) drawn for one coefficient and one scenario of the scatter plot.
const MAX_DOTS: usize = 100;

/// Draws the estimates of all scenarios (sets of fitted flights) as a scatter plot in SVG: one panel per coefficient,
/// one column of dots per scenario.
pub(super) fn scatter(fits: &PaperFits) -> String {
    let panels = fits.truth.iter().enumerate().map(|(k, (name, truth))| {
        let ends = [0.5, fits.scenarios.len() as f64 + 0.5];
        let columns = fits.scenarios.iter().enumerate();
        Panel {
            title: name.clone(),
            across: "scenario, in the order of the table".into(),
            lines: vec![Line {
                name: "true".into(),
                points: ends.map(|x| (x, *truth)).to_vec(),
            }],
            thin: true,
            dots: columns.map(|(column, s)| dots(column, s, k)).collect(),
            ..Panel::default()
        }
    });
    let panels: Vec<Panel> = panels.collect();
    figure("Estimates of single seeds", &panels)
}

/// Dots of a scatter plot for the estimates of one coefficient (given by its index) in one scenario, at most
/// [`MAX_DOTS`]. `column` is the index of their plot column. Horizontal offsets by multiples of the golden ratio keep
/// the dots apart.
fn dots(column: usize, scenario: &Scenario, coefficient: usize) -> Dots {
    let offset = |index: usize| 0.6 * ((index as f64 * 0.618_034).fract() - 0.5);
    let estimates = scenario.estimates[coefficient].iter().take(MAX_DOTS);
    Dots {
        look: Look::Pale,
        points: estimates
            .enumerate()
            .map(|(index, value)| (column as f64 + 1.0 + offset(index), *value))
            .collect(),
    }
}
