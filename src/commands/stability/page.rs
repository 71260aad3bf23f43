//! The report page of a stability analysis: modes at release, along the flight, in steady flight, and over speed and
//! spin.

use analysis::stability::{Instant, ModeKind, Modes};
use report::figures::{Dots, Line, Look, Panel};
use report::{Section, Sheet, SheetFigure, Table};

use super::Found;
use super::words::{nutation, of_criteria, slowest};

/// Maximum number of lines in one panel of a figure, equal to the number of distinct line colours.
const LINES: usize = 4;

/// The report page of a stability analysis.
pub fn sheet(model: &str, found: &Found) -> Sheet {
    let mut sections = vec![Section {
        title: "At release".into(),
        words: of_criteria(&found.release),
        table: table(&found.release.modes),
        ..Section::default()
    }];
    if let Some((trim, modes)) = &found.trim {
        sections.push(Section {
            title: "Steady flight".into(),
            words: vec![format!(
                "At the spin of release, held, the body can fly at {:.2} m/s, {:.2}° below the horizontal, nose {:.2}°, hyzer {:.2}°, \
                 its heading turning by {:+.2}°/s. Its modes there:",
                trim.throw.speed,
                -trim.throw.launch,
                trim.throw.nose.unwrap_or(0.0),
                trim.throw.hyzer.unwrap_or(0.0),
                trim.turn.to_degrees()
            )],
            table: table(modes),
            ..Section::default()
        });
    }
    if !found.flight.is_empty() {
        sections.push(Section {
            title: "Along the flight".into(),
            words: vec![
                "Each instant is taken for itself: its modes are those of small departures that are over before the flight has changed. \
                 The nutation is fast enough for that; the slow modes of a flight that is not steady are a guide only."
                    .into(),
            ],
            figures: vec![along(&found.flight)],
            ..Section::default()
        });
    }
    sections.push(Section {
        title: "Over speed and spin".into(),
        words: vec!["The throw of the release, at other speeds and spins.".into()],
        figures: vec![over(&found.map)],
        ..Section::default()
    });
    Sheet {
        kind: "hyzer stability".into(),
        title: format!("Stability of {model}"),
        lead: lead(found),
        warnings: match found.release.modes.is_symmetric {
            true => Vec::new(),
            false => vec![
                "The motion depends on the turn about the body's axis. For a spinning body the modes are those of an instant alone, and \
                 the criteria do not apply."
                    .into(),
            ],
        },
        sections,
    }
}

fn lead(found: &Found) -> Vec<String> {
    let mut lead = Vec::new();
    if let Some(mode) = nutation(&found.release.modes) {
        lead.push(format!(
            "At release the axis circles at {:.2} rad/s ({:.2} Hz) and its wobble {} at {:.3} 1/s.",
            mode.frequency(),
            mode.frequency() / std::f64::consts::TAU,
            if mode.decay() >= 0.0 {
                "decays"
            } else {
                "grows"
            },
            mode.decay().abs()
        ));
    }
    let growing = found
        .release
        .modes
        .modes
        .iter()
        .filter(|mode| mode.decay() < -1e-6);
    let names: Vec<String> = growing
        .map(|m| format!("{} ({:.3} 1/s)", m.kind.name(), -m.decay()))
        .collect();
    lead.push(match names.is_empty() {
        true => "None of its modes grows.".into(),
        false => format!("Growing: {}.", names.join(", ")),
    });
    lead
}

fn table(modes: &Modes) -> Table {
    let head = [
        "mode",
        "frequency, rad/s",
        "decay, 1/s",
        "damping ratio",
        "axis",
        "path",
        "speed",
        "spin",
    ];
    let rows = modes.modes.iter().map(|mode| {
        let mut row = vec![
            mode.kind.name().into(),
            format!("{:.4}", mode.frequency()),
            format!("{:.5}", mode.decay()),
            format!("{:.4}", mode.damping_ratio()),
        ];
        row.extend(mode.shares.map(|share| format!("{:.0} %", 100.0 * share)));
        row
    });
    Table {
        head: head.map(String::from).to_vec(),
        rows: rows.collect(),
    }
}

fn along(flight: &[Instant]) -> SheetFigure {
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
    let fast = |i: &Instant, of: &dyn Fn(&analysis::stability::Mode) -> f64| {
        nutation(&i.modes).map_or(f64::NAN, of)
    };
    let panel = |title: &str, lines| Panel {
        title: title.into(),
        across: "time, s".into(),
        lines,
        ..Panel::default()
    };
    let slow = |of: &dyn Fn(&analysis::stability::Mode) -> f64| {
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
    SheetFigure {
        name: "modes".into(),
        title: "Modes along the flight".into(),
        caption:
            "Blue: eigenvalues of the whole body. Red, dashed: the closed forms of the criteria."
                .into(),
        panels: vec![
            panel(
                "Frequency of the nutation, rad/s",
                vec![
                    line(
                        "modes",
                        of(&|i| fast(i, &analysis::stability::Mode::frequency)),
                    ),
                    line("closed", of(&|i| i.criteria.nutation)),
                ],
            ),
            panel(
                "Decay of the nutation, 1/s",
                vec![
                    line("modes", of(&|i| fast(i, &analysis::stability::Mode::decay))),
                    line("closed", of(&|i| i.criteria.nutation_decay)),
                ],
            ),
            dots(
                "Decay of the slow modes, 1/s",
                slow(&analysis::stability::Mode::decay),
            ),
            dots(
                "Their frequencies, rad/s",
                slow(&analysis::stability::Mode::frequency),
            ),
        ],
    }
}

fn over(map: &[Instant]) -> SheetFigure {
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
    SheetFigure {
        name: "map".into(),
        title: "Over speed and spin".into(),
        caption: "Last panel: dots where all three criteria hold, crosses where one fails.".into(),
        panels: vec![
            panel(
                "Frequency of the fast mode, rad/s",
                &|i| nutation(&i.modes).map_or(f64::NAN, analysis::stability::Mode::frequency),
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
        ],
    }
}
