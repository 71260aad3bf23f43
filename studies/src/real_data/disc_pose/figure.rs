//! Figure of the ratio of the moments of inertia, by throw.

use report::figures::{Dots, Line, Look, Panel, figure};

use super::fit::DiscPose;

/// Half width of a 95 % interval of a normal variable, in standard deviations.
const NORMAL_95: f64 = 1.96;

/// Draws the ratio of the moments of inertia I_a/I_d estimated from each single throw with its 95 % interval, and the
/// jackknife interval of the estimate from all throws together, as SVG.
pub(in super::super) fn ratio_figure(data: &DiscPose) -> String {
    let alone = || {
        let each = data.throws.iter().enumerate();
        each.filter_map(|(index, throw)| Some((index as f64 + 1.0, throw.alone?)))
    };
    // A NaN after each interval ends its line, so that all intervals are drawn as one series.
    let bars = alone().flat_map(|(at, own)| {
        let ends = [-NORMAL_95, NORMAL_95].map(|z| (at, own.value + z * own.std_error));
        ends.into_iter().chain([(f64::NAN, f64::NAN)])
    });
    let value = data.ratio().value;
    let panel = Panel {
        title: "I_a/I_d by throw, each alone; band: all together".into(),
        across: "throw, in the order of the table".into(),
        lines: vec![Line {
            name: "95 %".into(),
            points: bars.collect(),
        }],
        thin: true,
        dots: vec![Dots {
            look: Look::Cross,
            points: alone().map(|(at, own)| (at, own.value)).collect(),
        }],
        levels: vec![value],
        band: Some((
            value - NORMAL_95 * data.jackknife,
            value + NORMAL_95 * data.jackknife,
        )),
        ..Panel::default()
    };
    figure("Ratio of the moments of inertia of a golf disc", &[panel])
}
