//! The report page of a stability analysis: modes at release, along the flight, in steady flight, and over speed and
//! spin.

use analysis::stability::{Instant, Mode, ModeKind, Modes};
use report::figures::{Dots, Layout, Line, Look, Panel};
use report::{Cell, Column, Figure, Html, Page, Table};

use super::Found;
use super::words::{INSTANT, lead, nutation, of_criteria, slowest, steady};

/// Maximum number of lines in one panel of a figure, equal to the number of distinct line colours.
const LINES: usize = 4;

/// The report page of a stability analysis, and its figures.
pub fn page(model: &str, found: &Found) -> (Page, Vec<Figure>) {
    let mut body = Html::new();
    for text in lead(found) {
        body.paragraph(text);
    }
    let instant = (!found.release.modes.is_symmetric).then_some(INSTANT);
    body.alarms("Mind", instant);
    let mut figures = Vec::new();
    let mut section = Html::new();
    for text in of_criteria(&found.release) {
        section.paragraph(text);
    }
    section.table(&table(&found.release.modes));
    body.section("release", "At release", section);
    if let Some((trim, modes)) = &found.trim {
        let mut section = Html::new();
        section.paragraph(steady(trim));
        section.table(&table(modes));
        body.section("trim", "Steady flight", section);
    }
    if !found.flight.is_empty() {
        let figure = along(&found.flight);
        let mut section = Html::new();
        section.paragraph(
            "Each instant is taken for itself: its modes are those of small departures that are over before the flight has changed. \
             The nutation is fast enough for that; the slow modes of a flight that is not steady are a guide only.",
        );
        section.figure(&figure, true);
        body.section("flight", "Along the flight", section);
        figures.push(figure);
    }
    let figure = over(&found.map);
    let mut section = Html::new();
    section.paragraph("The throw of the release, at other speeds and spins.");
    section.figure(&figure, true);
    body.section("speed-and-spin", "Over speed and spin", section);
    figures.push(figure);
    body.note(concat!("hyzer ", env!("CARGO_PKG_VERSION")));
    let page = Page {
        kind: "hyzer stability",
        title: format!("Stability of {model}"),
        body,
        ..Page::default()
    };
    (page, figures)
}

/// Table of the modes of the linearised motion.
pub fn table(modes: &Modes) -> Table {
    let head = [
        "frequency, rad/s",
        "decay, 1/s",
        "damping ratio",
        "period, s",
        "axis",
        "path",
        "speed",
        "spin",
    ];
    let mut table = Table::new()
        .with(Column::Name, &["mode"])
        .with(Column::Number, &head);
    for mode in &modes.modes {
        let frequency = Some(mode.frequency()).filter(|f| *f > 1e-9);
        let period = frequency.map(|f| format!("{:.4}", std::f64::consts::TAU / f));
        let mut row: Vec<Cell> = vec![
            mode.kind.name().into(),
            format!("{:.4}", mode.frequency()).into(),
            format!("{:.5}", mode.decay()).into(),
            format!("{:.4}", mode.damping_ratio()).into(),
            period.unwrap_or_default().into(),
        ];
        let shares = mode.shares.map(|share| format!("{:.0} %", 100.0 * share));
        row.extend(shares.map(Cell::from));
        table.row(row);
    }
    table
}

fn along(flight: &[Instant]) -> Figure {
    let of = |value: &dyn Fn(&Instant) -> f64| {
        flight
            .iter()
            .map(|i| (i.time, value(i)))
            .collect::<Vec<_>>()
    };
    let line = |name: &str, points| Line {
        name: name.into(),
        points,
    };
    let fast = |i: &Instant, of: &dyn Fn(&Mode) -> f64| nutation(&i.modes).map_or(f64::NAN, of);
    let panel = |title: &str, lines| Panel {
        title: title.into(),
        across: "time, s".into(),
        lines,
        ..Panel::default()
    };
    let slow = |of: &dyn Fn(&Mode) -> f64| {
        let points = flight.iter().flat_map(|i| {
            let modes = i
                .modes
                .modes
                .iter()
                .filter(|mode| !matches!(mode.kind, ModeKind::Nutation | ModeKind::Incidence));
            modes.map(|mode| (i.time, of(mode))).collect::<Vec<_>>()
        });
        points.collect::<Vec<_>>()
    };
    let dots = |title: &str, points| Panel {
        dots: vec![Dots {
            look: Look::Colour(0),
            points,
        }],
        ..panel(title, Vec::new())
    };
    let panels = [
        panel(
            "Frequency of the nutation, rad/s",
            vec![
                line("modes", of(&|i| fast(i, &Mode::frequency))),
                line("closed", of(&|i| i.criteria.nutation)),
            ],
        ),
        panel(
            "Decay of the nutation, 1/s",
            vec![
                line("modes", of(&|i| fast(i, &Mode::decay))),
                line("closed", of(&|i| i.criteria.nutation_decay)),
            ],
        ),
        dots("Decay of the slow modes, 1/s", slow(&Mode::decay)),
        dots("Their frequencies, rad/s", slow(&Mode::frequency)),
    ];
    let caption =
        "Blue: eigenvalues of the whole body. Red, dashed: the closed forms of the criteria.";
    Figure::of_panels(
        "modes",
        "Modes along the flight",
        caption,
        Layout::COLUMN,
        &panels,
    )
}

fn over(map: &[Instant]) -> Figure {
    let mut speeds: Vec<f64> = map.iter().map(|i| i.throw.speed).collect();
    speeds.dedup();
    let step = speeds.len().div_ceil(LINES).max(1);
    let chosen: Vec<f64> = speeds
        .iter()
        .copied()
        .skip(step / 2)
        .step_by(step)
        .collect();
    let panel = |title: &str, of: &dyn Fn(&Instant) -> f64, levels: Vec<f64>| Panel {
        title: title.into(),
        across: "spin, rpm".into(),
        lines: chosen
            .iter()
            .map(|speed| {
                let own = map.iter().filter(|i| i.throw.speed == *speed);
                Line {
                    name: format!("{speed} m/s"),
                    points: own.map(|i| (i.throw.spin.unwrap_or(0.0), of(i))).collect(),
                }
            })
            .collect(),
        levels,
        ..Panel::default()
    };
    let points = |holds: bool| {
        let own = map.iter().filter(move |i| i.criteria.is_stable() == holds);
        own.map(|i| (i.throw.spin.unwrap_or(0.0), i.throw.speed))
            .collect::<Vec<_>>()
    };
    let panels = [
        panel(
            "Frequency of the fast mode, rad/s",
            &|i| nutation(&i.modes).map_or(f64::NAN, Mode::frequency),
            Vec::new(),
        ),
        panel(
            "Least decay of the other modes, 1/s",
            &|i| slowest(&i.modes),
            vec![0.0],
        ),
        Panel {
            title: "Criteria: speed, m/s".into(),
            across: "spin, rpm".into(),
            dots: vec![
                Dots {
                    look: Look::Colour(0),
                    points: points(true),
                },
                Dots {
                    look: Look::Cross,
                    points: points(false),
                },
            ],
            ..Panel::default()
        },
    ];
    let caption = "Last panel: dots where all three criteria hold, crosses where one fails.";
    Figure::of_panels(
        "map",
        "Over speed and spin",
        caption,
        Layout::COLUMN,
        &panels,
    )
}
