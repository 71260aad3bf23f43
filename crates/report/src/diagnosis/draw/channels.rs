//! Figures of the unexplained loads over time: one small plot for each flight.

use diagnose::{LoadChannel, LoadHistory, Report};

use super::super::words;
use crate::figure::Figure;
use crate::figures::axis::{power_of_ten, range};
use crate::figures::csv::Table;
use crate::figures::{Layout, Panel, figure_of};
use crate::fit::draw::not_drawn;
use crate::thin::{MAX_FLIGHTS, stride};
use identify::numbers::{percent, raised};

const MAX_POINTS: usize = 120;

pub(in super::super) fn channels(report: &Report) -> Vec<Figure> {
    let all = report.unattributed.iter().flat_map(|o| &o.channels);
    let all = all.filter(|c| !c.histories.is_empty()).take(MAX_FLIGHTS);
    let figures = all.enumerate().map(|(i, channel)| figure(i, channel));
    figures.collect()
}

fn figure(index: usize, channel: &LoadChannel) -> Figure {
    let histories = channel.histories.iter().take(MAX_FLIGHTS);
    let histories: Vec<(&str, Vec<[f64; 3]>)> =
        histories.map(|h| (h.file.as_str(), points(h))).collect();
    let mut table = Table::new(&["flight", "t_s", "value", "std_error"]);
    for (file, points) in &histories {
        for [t, value, error] in points {
            table.text(file).number(*t).number(*value);
            table.number(*error).end();
        }
    }
    let (panels, power) = panels(&histories);
    let scale = match power {
        0 => String::new(),
        power => format!(", in 10{}", raised(power)),
    };
    let title = format!(
        "{}{scale}: {} explained",
        words::site(&channel.site),
        percent(channel.explained_fraction)
    );
    let left_out = channel.histories.len().saturating_sub(MAX_FLIGHTS);
    let left_out = not_drawn(left_out, "more flights");
    let caption = format!(
        "Estimated history of an additional coefficient in each flight; in the title the share of the misfit that it \
         explains; shaded: ±2 standard errors. All have one scale.{left_out}"
    );
    let name = format!("channel-{:02}", index + 1);
    let texts = [caption, table.finish()];
    Figure::in_layouts(name, &title, texts, Layout::WIDE, &|layout| {
        let columns = if layout.width > 600.0 { 4 } else { 2 };
        figure_of(layout.with_columns(columns), &title, &panels)
    })
}

/// Panels of load histories with one scale, and the power of ten of the values.
fn panels(histories: &[(&str, Vec<[f64; 3]>)]) -> (Vec<Panel>, i32) {
    let all = || histories.iter().flat_map(|(_, points)| points);
    // The vertical range follows the values; wider error bands are clipped.
    let (least, greatest) = range(all().map(|p| p[1]).chain([0.0]));
    let ends = all().flat_map(|[_, v, e]| [v - 2.0 * e, v + 2.0 * e]);
    let bands = range(ends.chain([0.0]));
    let size = (greatest - least).max(1e-300);
    let low = bands.0.max(least - size);
    let high = bands.1.min(greatest + size).max(low + 1e-300);
    let power = power_of_ten(low.abs().max(high.abs()));
    let scale = 10_f64.powi(-power);
    let along = range(all().map(|p| p[0]));
    let panel = |(file, points): &(&str, Vec<[f64; 3]>)| {
        let band = |[t, v, e]: &[f64; 3]| (*t, (v - 2.0 * e) * scale, (v + 2.0 * e) * scale);
        Panel {
            thin: true,
            ribbon: points.iter().map(band).collect(),
            up: Some((low * scale, high * scale)),
            along: Some(along),
            height: Some(84.0),
            ..Panel::new(*file, "time, s").line("", points.iter().map(|[t, v, _]| (*t, v * scale)))
        }
    };
    (histories.iter().map(panel).collect(), power)
}

/// Finite points (time in s, value, standard error) of a load history, thinned to [`MAX_POINTS`].
fn points(history: &LoadHistory) -> Vec<[f64; 3]> {
    let all = history.t.iter().zip(&history.value).zip(&history.std_error);
    let all = all.map(|((t, v), e)| [*t, *v, *e]);
    let all: Vec<[f64; 3]> = all.filter(|p| p.iter().all(|v| v.is_finite())).collect();
    stride(&all, MAX_POINTS)
}
