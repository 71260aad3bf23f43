//! Figures of the unexplained loads over time: one small plot for each flight.

use diagnose::{LoadChannel, LoadHistory, Report};

use super::super::words;
use crate::figure::Figure;
use crate::figures::Layout;
use crate::figures::axis::{number, range, ticks};
use crate::figures::csv::Table;
use crate::figures::svg::{Svg, cut};
use crate::fit::draw::not_drawn;
use crate::thin::stride;
use identify::numbers::{percent, raised};

/// Maximum number of load channels drawn, one figure each.
const MAX_CHANNELS: usize = 12;
/// Maximum number of time histories drawn for each load.
const MAX_HISTORIES: usize = 12;
/// Maximum number of points with which a load history is drawn.
const MAX_POINTS: usize = 120;
/// Height of the plot area for the load history of one flight, SVG units.
const TALL: f64 = 84.0;
/// Space above the plot area of a load history, SVG units.
const ABOVE: f64 = 24.0;
/// Space below the plot area of a load history, SVG units.
const BELOW: f64 = 24.0;

/// Draws the time histories of the loads that the model lacks, one figure for each load channel.
pub(super) fn channels(report: &Report) -> Vec<Figure> {
    let all = report.unattributed.iter().flat_map(|o| &o.channels);
    let all = all.filter(|c| !c.histories.is_empty()).take(MAX_CHANNELS);
    all.enumerate()
        .map(|(i, channel)| figure(i, channel))
        .collect()
}

fn figure(index: usize, channel: &LoadChannel) -> Figure {
    let title = format!(
        "{}: {} explained",
        words::site(&channel.site),
        percent(channel.explained_fraction)
    );
    let left_out = channel.histories.len().saturating_sub(MAX_HISTORIES);
    let left_out = not_drawn(left_out, "more flights");
    let caption = format!(
        "Estimated history of an additional coefficient in each flight; in the title the share of the misfit that it \
         explains; shaded: ±2 standard errors. All have one scale.{left_out}"
    );
    let name = format!("channel-{:02}", index + 1);
    let mut table = Table::new(&["flight", "t_s", "value", "std_error"]);
    for history in channel.histories.iter().take(MAX_HISTORIES) {
        for [t, value, error] in points(history) {
            table.text(&history.file).number(t).number(value);
            table.number(error).end();
        }
    }
    let texts = [caption, table.finish()];
    Figure::in_layouts(name, &title, texts, Layout::WIDE, &|layout| {
        draw(channel, &title, layout)
    })
}

/// Points (time in s, value, standard error) of the time history of a load; points that are not finite are dropped, and
/// the rest is thinned to at most [`MAX_POINTS`].
fn points(history: &LoadHistory) -> Vec<[f64; 3]> {
    let all = history.t.iter().zip(&history.value).zip(&history.std_error);
    let all: Vec<[f64; 3]> = all.map(|((t, v), e)| [*t, *v, *e]).collect();
    let all: Vec<[f64; 3]> = all
        .into_iter()
        .filter(|p| p.iter().all(|v| v.is_finite()))
        .collect();
    stride(&all, MAX_POINTS)
}

fn draw(channel: &LoadChannel, title: &str, layout: Layout) -> String {
    let (letters, letter) = (layout.letters, layout.letter());
    let histories: Vec<(&str, Vec<[f64; 3]>)> = channel
        .histories
        .iter()
        .take(MAX_HISTORIES)
        .map(|h| (h.file.as_str(), points(h)))
        .collect();
    let all = || histories.iter().flat_map(|(_, points)| points);
    // The vertical range follows the values; wider error bands are clipped.
    let values = range(all().map(|p| p[1]).chain([0.0]));
    let bands = range(
        all()
            .flat_map(|[_, v, e]| [v - 2.0 * e, v + 2.0 * e])
            .chain([0.0]),
    );
    let size = (values.1 - values.0).max(1e-300);
    let low = bands.0.max(values.0 - size);
    let high = bands.1.min(values.1 + size).max(low + 1e-300);
    let time = range(all().map(|p| p[0]));
    let length = if time.1 > time.0 {
        time.1 - time.0
    } else {
        1.0
    };
    // Axes of very small or large values are scaled by a power of ten, so that tick labels are readable.
    let largest = low.abs().max(high.abs());
    let power = match largest.log10().floor() as i32 {
        p if largest > 0.0 && !(-2..5).contains(&p) => p,
        _ => 0,
    };
    let scale = 10_f64.powi(-power);
    let ends = (low * scale, high * scale);
    let (mut at, mut decimals) = ticks(ends, 3);
    if at.len() < 2 {
        (at, decimals) = ticks(ends, 6);
    }
    let texts: Vec<(f64, String)> = at
        .into_iter()
        .map(|t| (t / scale, number(t, decimals)))
        .collect();
    let widest = texts.iter().map(|t| t.1.chars().count()).max().unwrap_or(1) as f64;
    let left = 12.0 + letter * widest;
    let columns = if layout.width > 600.0 { 4 } else { 2 };
    let columns = columns.min(histories.len().max(1));
    let gap = 14.0;
    let wide = (layout.width - left - 8.0 - gap * (columns - 1) as f64) / columns as f64;
    // A single plot does not fill the page width.
    let wide = wide.min(420.0);
    let mut svg = Svg::new();
    let shown = cut(title, layout.width - 12.0, 1.22 * letter);
    svg.text("title", (2.0, 2.0 * letters), "start", &shown);
    let mut first = 2.0 * letters + 10.0;
    if power != 0 {
        let words = format!("in 10{}", raised(power));
        svg.text("mark", (2.0, first + letters), "start", &words);
        first += letters + 4.0;
    }
    for (i, (file, points)) in histories.iter().enumerate() {
        let x0 = left + (wide + gap) * (i % columns) as f64;
        let top = first + (ABOVE + TALL + BELOW) * (i / columns) as f64 + ABOVE;
        let bottom = top + TALL;
        let x = |t: f64| x0 + wide * (t - time.0) / length;
        let y = |v: f64| bottom - TALL * ((v - low) / (high - low)).clamp(0.0, 1.0);
        svg.text("mark", (x0, top - 6.0), "start", &cut(file, wide, letter));
        ribbon(&mut svg, points, &x, &y);
        for (value, text) in &texts {
            let class = if *value == 0.0 { "zero" } else { "grid" };
            svg.line(class, (x0, y(*value)), (x0 + wide, y(*value)));
            if i % columns == 0 {
                svg.text("tick", (left - 6.0, y(*value) + 4.5), "end", text);
            }
        }
        svg.path("history", points.iter().map(|p| (x(p[0]), y(p[1]))));
        svg.line("axis", (x0, bottom), (x0 + wide, bottom));
        let ends = [(time.0, "start"), (time.0 + length, "end")];
        for (t, anchor) in ends {
            let mut text = identify::numbers::plain(t, 1);
            if anchor == "end" {
                text += " s";
            }
            svg.text("tick", (x(t), bottom + 3.0 + letters), anchor, &text);
        }
    }
    let lines = histories.len().div_ceil(columns) as f64;
    let tall = first + (ABOVE + TALL + BELOW) * lines + 4.0;
    svg.finish(title, (layout.width, tall), layout.most, letters)
}

/// Draws the error band of ±2 standard errors around a load history as a closed path. `points` are (time, value,
/// standard error); `x` and `y` map a time and a value to SVG units.
fn ribbon(svg: &mut Svg, points: &[[f64; 3]], x: &impl Fn(f64) -> f64, y: &impl Fn(f64) -> f64) {
    let upper = points.iter().map(|[t, v, e]| (x(*t), y(v + 2.0 * e)));
    let lower = points.iter().rev().map(|[t, v, e]| (x(*t), y(v - 2.0 * e)));
    if points.len() > 1 {
        svg.path("ribbon", upper.chain(lower));
    }
}
