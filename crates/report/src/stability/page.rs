//! The page and the text of a stability analysis.

use analysis::stability::{Criteria, Instant, Mode, ModeKind, Modes};

use super::Found;
use super::words::{INSTANT, lead, named, nutation, of_criteria, slowest, steady};
use crate::equation::{plain_sentence, sentence};
use crate::figures::{Layout, Look, Panel};
use crate::text::fitted;
use crate::{Figure, Html, Page, Table};

/// Maximum number of lines in a panel: the number of distinct colours.
const LINES: usize = 4;

/// The page of a stability analysis.
pub fn page(model: &str, found: &Found) -> Page {
    let mut words = Html::new();
    for text in lead(found) {
        words.paragraph(text);
    }
    let instant = (!found.release.modes.is_symmetric).then_some(INSTANT);
    words.alarms("Mind", instant);
    for text in of_criteria(&found.release) {
        words.paragraph(sentence(&text));
    }
    let mut picture = Html::new();
    picture.leading_figure(Some(fields(&found.map)));
    let mut body = Html::new();
    body.opening(words, picture, Html::new());
    let mut section = Html::new();
    section.table(&table(&found.release.modes));
    body.section("release", "Modes at release", section);
    if let Some(table) = controls(&found.release) {
        let mut section = Html::new();
        section.paragraph(sentence(CONTROLS));
        section.table(&table);
        body.section("controls", "Control derivatives at release", section);
    }
    if let Some((trim, modes)) = &found.trim {
        let mut section = Html::new();
        section.paragraph(steady(trim));
        section.table(&table(modes));
        body.section("trim", "Steady flight", section);
    }
    if !found.flight.is_empty() {
        let mut section = Html::new();
        section.paragraph(
            "Each instant is taken for itself: its modes are those of small departures that are over before the flight has changed. \
             The nutation is fast enough for that; the slow modes of a flight that is not steady are a guide only.",
        );
        section.figure(along(&found.flight), true);
        body.section("flight", "Along the flight", section);
    }
    let mut section = Html::new();
    section.paragraph("The throw of the release, at other speeds and spins.");
    section.figure(over(&found.map), true);
    body.section("speed-and-spin", "Over speed and spin", section);
    body.note(concat!("hyzer ", env!("CARGO_PKG_VERSION")));
    Page {
        kind: "hyzer stability",
        title: format!("Stability of {model}"),
        body,
        ..Page::default()
    }
}

fn table(modes: &Modes) -> Table {
    let period = |mode: &Mode| {
        let frequency = Some(mode.frequency()).filter(|f| *f > 1e-9);
        frequency.map_or_else(String::new, |f| format!("{:.4}", std::f64::consts::TAU / f))
    };
    let mut rows = Table::of(named(modes))
        .name("mode", |(_, name)| name.clone())
        .number("frequency, rad/s", |(mode, _)| {
            format!("{:.4}", mode.frequency())
        })
        .number("decay, 1/s", |(mode, _)| format!("{:.5}", mode.decay()))
        .number("damping ratio", |(mode, _)| {
            format!("{:.4}", mode.damping_ratio())
        })
        .number("period, s", |(mode, _)| period(mode));
    for (i, share) in ["axis", "path", "speed", "spin"].into_iter().enumerate() {
        rows = rows.number(share, |(mode, _)| {
            format!("{:.0} %", 100.0 * mode.shares[i])
        });
    }
    rows.table()
}

/// Meaning of the control derivatives.
const CONTROLS: &str = r"By how much the rate of a state grows with an input: the entries of $B$ in $\dot x = A x + B u$ that are not 0. stability.json has both matrices.";

/// Control derivatives; `None` where no input acts.
fn controls(instant: &Instant) -> Option<Table> {
    let entries: Vec<_> = instant.state_space.control_derivatives().collect();
    (!entries.is_empty()).then(|| {
        Table::of(entries)
            .name("rate of", |entry| entry.state)
            .plain("input", |entry| entry.input)
            .number("derivative", |entry| format!("{:.5}", entry.value))
            .plain("unit", |entry| entry.unit)
            .table()
    })
}

fn along(flight: &[Instant]) -> Figure {
    let nutation = |title: &str, of: fn(&Mode) -> f64, closed: fn(&Criteria) -> f64| {
        let modes = |i: &Instant| nutation(&i.modes).map_or(f64::NAN, of);
        let closed = flight.iter().map(|i| (i.time, closed(&i.criteria)));
        Panel::new(title, "time, s")
            .line("modes", flight.iter().map(|i| (i.time, modes(i))))
            .line("closed", closed)
    };
    let slow = |title: &str, of: fn(&Mode) -> f64| {
        let is_slow = |mode: &&Mode| !matches!(mode.kind, ModeKind::Nutation | ModeKind::Incidence);
        let points = flight.iter().flat_map(|i| {
            let modes = i.modes.modes.iter().filter(is_slow);
            modes.map(|mode| (i.time, of(mode)))
        });
        Panel::new(title, "time, s").dots(Look::Colour(0), points)
    };
    let [frequency, decay] = [
        "Frequency of the nutation, rad/s",
        "Decay of the nutation, 1/s",
    ];
    let panels = [
        nutation(frequency, Mode::frequency, |c| c.nutation),
        nutation(decay, Mode::decay, |c| c.nutation_decay),
        slow("Decay of the slow modes, 1/s", Mode::decay),
        slow("Their frequencies, rad/s", Mode::frequency),
    ];
    let caption =
        "Blue: eigenvalues of the whole body. Red, dashed: the closed forms of the criteria.";
    let title = "Modes along the flight";
    let layout = Layout::WIDE.with_columns(2);
    Figure::of_panels("modes", title, caption, layout, &panels)
}

fn over(map: &[Instant]) -> Figure {
    let mut speeds: Vec<f64> = map.iter().map(|i| i.throw.speed).collect();
    speeds.dedup();
    let step = speeds.len().div_ceil(LINES).max(1);
    let spin = |i: &Instant| i.throw.spin.unwrap_or(0.0);
    let panel = |title: &str, of: &dyn Fn(&Instant) -> f64| {
        let chosen = speeds.iter().skip(step / 2).step_by(step);
        chosen.fold(Panel::new(title, "spin, rpm"), |panel, speed| {
            let own = map.iter().filter(|i| i.throw.speed == *speed);
            panel.line(format!("{speed} m/s"), own.map(|i| (spin(i), of(i))))
        })
    };
    let fast = |i: &Instant| nutation(&i.modes).map_or(f64::NAN, Mode::frequency);
    let panels = [
        panel("Frequency of the fast mode, rad/s", &fast),
        Panel {
            levels: vec![0.0],
            ..panel("Least decay of the other modes, 1/s", &|i| {
                slowest(&i.modes)
            })
        },
    ];
    let caption = "A line for each speed. Below 0, dashed, a mode grows.";
    let title = "Modes over speed and spin";
    let layout = Layout::WIDE.with_columns(2);
    Figure::of_panels("map", title, caption, layout, &panels)
}

/// Where in the plane of spin and speed the criteria hold.
fn fields(map: &[Instant]) -> Figure {
    let points = |holds: bool| {
        let own = map.iter().filter(move |i| i.criteria.is_stable() == holds);
        own.map(|i| (i.throw.spin.unwrap_or(0.0), i.throw.speed))
    };
    let panel = Panel::new("Speed, m/s", "spin, rpm")
        .dots(Look::Colour(0), points(true))
        .dots(Look::Cross, points(false));
    let caption = "The throw of the release at other speeds and spins. Dots: all three criteria hold; crosses: one fails.";
    let title = "Where the axis is stable";
    Figure::of_panels("criteria", title, caption, Layout::COLUMN, &[panel])
}

const INSTANTS: usize = 8;

/// Text of a stability analysis.
pub fn text(model: &str, found: &Found) -> String {
    let mut text = fitted(&format!("{model}: {}", lead(found).join(" ")));
    text += &table(&found.release.modes).text(usize::MAX);
    if !found.release.modes.is_symmetric {
        text += &fitted(INSTANT);
    }
    let criteria = of_criteria(&found.release).into_iter();
    text.extend(criteria.map(|line| fitted(&plain_sentence(&line))));
    if let Some(table) = controls(&found.release) {
        text += &fitted(&plain_sentence(CONTROLS));
        text += &table.text(usize::MAX);
    }
    text.push('\n');
    text += &match &found.trim {
        Some((trim, modes)) => fitted(&steady(trim)) + &table(modes).text(usize::MAX),
        None => "No steady flight was found at this spin.\n".to_owned(),
    };
    if let Some(last) = found.flight.last() {
        let table = at_instants(&found.flight).text(usize::MAX);
        text += &format!(
            "\nAlong the flight, {:.2} s, the modes of each instant:\n{table}",
            last.time
        );
    }
    let stable = found.map.iter().filter(|i| i.criteria.is_stable()).count();
    let points = found.map.len();
    text + &format!("over speed and spin: all three criteria hold at {stable} of {points} points\n")
}

fn at_instants(flight: &[Instant]) -> Table {
    let step = (flight.len() / INSTANTS).max(1);
    // A body that hardly spins has no nutation.
    let number = |instant: &Instant, of: fn(&Mode) -> f64| {
        nutation(&instant.modes).map_or("–".to_owned(), |mode| format!("{:.3}", of(mode)))
    };
    Table::of(flight.iter().step_by(step).chain(flight.last()))
        .number("time, s", |instant| format!("{:.3}", instant.time))
        .number("speed, m/s", |instant| {
            format!("{:.2}", instant.throw.speed)
        })
        .number("nutation, rad/s", |instant| {
            number(instant, Mode::frequency)
        })
        .number("decay, 1/s", |instant| number(instant, Mode::decay))
        .table()
}
