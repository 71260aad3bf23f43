//! Figures of the estimates, and of the residual diagnostics.

use dataset::Role;
use identify::numbers::{Digits, displayed, percent, raised, unit, with_unit};
use identify::{AxisResiduals, Coefficient, FitReport, Profile};
use model_spec::sort_by_number;

use super::super::FitPage;
use super::not_drawn;
use crate::bands::std_error;
use crate::figure::Figure;
use crate::figures::axis::power_of_ten;
use crate::figures::chart::{Axis, Chart, Row, Shape};
use crate::figures::triangle::Triangle;
use crate::figures::{Bar, Layout, Look, Mark, Panel};
use crate::thin::{MAX_CURVE_POINTS, MAX_FIGURES, stride};

/// Minimum and maximum of the axis of relative standard errors, %.
const AXIS: (f64, f64) = (0.1, 1e3);

/// Relative standard error of each estimated coefficient, the smallest first.
pub(in super::super) fn precision(page: &FitPage<'_>) -> Option<Figure> {
    let size = |c: &Coefficient| std_error(c) / c.value.abs();
    let mut found = page.coefficients();
    found.retain(|(_, c)| !c.fixed && size(c).is_finite());
    sort_by_number(&mut found, |(_, c)| size(c));
    let left_out = found.len().saturating_sub(MAX_FIGURES);
    let rows = found.iter().take(MAX_FIGURES).map(|(name, c)| {
        let size = size(c);
        let class = if size < 1.0 { "bar" } else { "bar loose" };
        let bar = Shape::Bar((1e2 * size).clamp(AXIS.0, AXIS.1), class);
        Row::new(name, "tick", vec![bar]).words(percent(size))
    });
    let title = "Precision of each coefficient";
    let across = "standard error, % of the value";
    let chart = Chart {
        level: Some((100.0, "as large as the value".into())),
        ..Chart::new(title, rows.collect(), Axis::Log(AXIS.0), across)
    };
    let more = not_drawn(left_out, "less precise ones");
    let caption = format!(
        "Short bars: well determined. A bar up to the broken line: the standard error is {} of the value, so that not even the \
         sign is known. The larger of the two kinds of standard error is drawn.{more}",
        percent(1.0)
    );
    let draw = || Figure::of_chart("precision", &chart, &caption, Layout::COLUMN);
    (!chart.rows.is_empty()).then(draw)
}

/// 95 % quantile of χ²(1): deviance at which a value is rejected at the 5 % level.
const LEVEL: f64 = 3.84;

pub(in super::super) fn profiles(report: &FitReport) -> Vec<Figure> {
    let wanted = report.profiles.iter().take(MAX_FIGURES).enumerate();
    let figures = wanted.map(|(i, found)| profile(i, found, report));
    figures.collect()
}

fn profile(index: usize, profile: &Profile, report: &FitReport) -> Figure {
    let coefficient = report.coefficients.get(&profile.name);
    let unit = coefficient.map_or_else(String::new, |c| unit(&c.unit));
    let points = profile.points.iter().map(|[value, d]| (*value, *d));
    let finite = |p: &(f64, f64)| p.0.is_finite() && p.1.is_finite();
    let mut points: Vec<(f64, f64)> = points.filter(finite).collect();
    sort_by_number(&mut points, |point| point.0);
    let highest = points.iter().map(|p| p.1).fold(2.0 * LEVEL, f64::max);
    let top = highest.min(4.0 * LEVEL);
    let power = power_of_ten(points.iter().map(|p| p.0.abs()).fold(0.0, f64::max));
    let scale = 10_f64.powi(-power);
    points.retain(|p| p.1 <= 1.02 * top);
    for point in &mut points {
        point.0 *= scale;
    }
    let ends = profile
        .interval
        .iter()
        .flatten()
        .filter(|end| end.is_finite());
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

const MAX_COEFFICIENTS: usize = 40;

pub(in super::super) fn correlations(page: &FitPage<'_>) -> Option<Figure> {
    let report = page.report;
    let estimated = |name: &&str| report.coefficients.get(*name).is_none_or(|c| !c.fixed);
    let names = report.correlations.keys().map(String::as_str);
    let mut names: Vec<&str> = names.filter(estimated).collect();
    names.sort_by_key(|name| page.place(name));
    names.truncate(MAX_COEFFICIENTS);
    let order = names.clone();
    let value = |i: usize, j: usize| {
        let row = report.correlations.get(order[i]);
        let value = row.and_then(|row| row.get(order[j]));
        value.copied().unwrap_or(f64::NAN)
    };
    let triangle = Triangle {
        title: "Correlations of the coefficients",
        names,
        is_strong: &|_| false,
        value: &value,
        is_signed: true,
        ends: ["−1", "1"],
    };
    let caption = "Of the estimation errors of two coefficients: near ±1 only a combination of the two is identifiable. The row of \
                   a coefficient is left of its name, its column below it.";
    let draw = || Figure::of_triangle("correlations", &triangle, caption, Layout::SMALL);
    (order.len() > 1).then(draw)
}

const MIN_FLIGHTS: usize = 8;

pub(in super::super) fn histogram(report: &FitReport) -> Option<Figure> {
    let (scale, unit) = displayed(&report.leading_noise().unit);
    let flights = report.used(Role::Fit);
    let mut rms: Vec<f64> = flights.map(|flight| scale * flight.rms()).collect();
    rms.retain(|v| v.is_finite());
    if rms.len() < MIN_FLIGHTS {
        return None;
    }
    rms.sort_by(f64::total_cmp);
    let low = rms[0];
    // The upper limit is the 98 % quantile, so that a few flights with large residuals do not compress the others
    // into one bar.
    let quantile = rms[(rms.len() - 1) * 98 / 100];
    let high = if quantile > low {
        quantile
    } else {
        low + 1e-3_f64.max(0.01 * low.abs())
    };
    let number = ((rms.len() as f64).sqrt().ceil() as usize).clamp(5, 24);
    let step = (high - low) / number as f64;
    let mut counts = vec![0_usize; number];
    for value in rms.iter().filter(|v| **v <= high) {
        counts[(((value - low) / step) as usize).min(number - 1)] += 1;
    }
    let bars = counts.iter().enumerate().map(|(i, count)| Bar {
        from: low + step * i as f64,
        to: low + step * (i + 1) as f64,
        height: *count as f64,
    });
    let panel = Panel {
        bars: bars.collect(),
        ..Panel::new("Flights", with_unit("RMS residual of a flight", unit))
    };
    let beyond = rms.iter().filter(|v| **v > high).count();
    let more = not_drawn(beyond, "with larger residuals");
    let caption = format!("Number of fitted flights by RMS residual.{more}");
    let title = "Residuals by flight";
    Some(Figure::of_panels(
        "rms",
        title,
        caption,
        Layout::SMALL,
        &[panel],
    ))
}

pub(in super::super) fn whiteness(report: &FitReport) -> Vec<Figure> {
    let axes = report.residuals.iter().take(3).enumerate();
    let figures = axes.filter_map(|(i, (axis, found))| diagnostics(i, axis, found));
    figures.collect()
}

fn diagnostics(index: usize, axis: &str, found: &AxisResiduals) -> Option<Figure> {
    // The autocorrelation at lag 0 is 1 by definition and is omitted.
    let lags = |values: &[f64]| {
        let values = values.iter().enumerate().skip(1).take(MAX_CURVE_POINTS);
        values.map(|(lag, v)| (lag as f64, *v)).collect::<Vec<_>>()
    };
    let raw = lags(&found.autocorrelation);
    let white = lags(&found.whitened_autocorrelation);
    let mut panels = Vec::new();
    if !raw.is_empty() || !white.is_empty() {
        // The dashed line is drawn over the solid one, so that both are visible if they coincide.
        let panel = Panel::new("Autocorrelation", "lag, samples")
            .dots(Look::Colour(0), raw.clone())
            .dots(Look::Colour(1), white.clone())
            .line("raw", raw)
            .line("white", white);
        panels.push(Panel {
            band: Some((-found.band, found.band)).filter(|_| found.band.is_finite()),
            ..panel
        });
    }
    let quantiles: Vec<(f64, f64)> = found.quantiles.iter().map(|q| (q[0], q[1])).collect();
    if !quantiles.is_empty() {
        panels.push(Panel {
            map: true,
            diagonal: true,
            ..Panel::new("Normal Q–Q: sample quantiles", "theoretical quantiles")
                .dots(Look::Colour(0), stride(&quantiles, MAX_CURVE_POINTS))
        });
    }
    let name = format!("noise-{}", index + 1);
    let title = format!("Residuals along {axis}");
    let caption = "Above: autocorrelation of the residuals, as they are and whitened by the noise model; the whitened one should be \
                   within the shaded 95 % band. Below: normal Q–Q plot; the points should be on the line.";
    let draw = || Figure::of_panels(name, &title, caption, Layout::SMALL, &panels);
    (!panels.is_empty()).then(draw)
}
