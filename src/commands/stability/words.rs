//! Output of a stability analysis as text, JSON and CSV.

use std::fmt::Write;

use analysis::stability::{Criteria, Instant, Mode, ModeKind, Modes};
use report::{Column, Table};
use serde_json::{Value, json};

use super::Found;
use super::page::{self, INSTANT, lead, steady};

/// Number of instants of the flight in the text for the terminal.
const INSTANTS: usize = 8;

/// Text of the modes and stability criteria in `found`, for the terminal.
pub fn table(model: &str, found: &Found) -> String {
    let mut text = format!("{model}: {}\n", lead(found).join(" "));
    text += &page::table(&found.release.modes).text(usize::MAX);
    if !found.release.modes.is_symmetric {
        text += &format!("{INSTANT}\n");
    }
    text += &(of_criteria(&found.release).join("\n") + "\n\n");
    text += &match &found.trim {
        Some((trim, modes)) => format!("{}\n{}", steady(trim), page::table(modes).text(usize::MAX)),
        None => "No steady flight was found at this spin.\n".to_owned(),
    };
    if let Some(last) = found.flight.last() {
        let table = along(&found.flight).text(usize::MAX);
        text += &format!(
            "\nAlong the flight, {:.2} s, the modes of each instant:\n{table}",
            last.time
        );
    }
    let stable = found.map.iter().filter(|i| i.criteria.is_stable()).count();
    let points = found.map.len();
    text + &format!("over speed and spin: all three criteria hold at {stable} of {points} points\n")
}

/// Table of the nutation at some instants of the flight, the last among them.
fn along(flight: &[Instant]) -> Table {
    let head = ["time, s", "speed, m/s", "nutation, rad/s", "decay, 1/s"];
    let mut table = Table::new().with(Column::Number, &head);
    let step = (flight.len() / INSTANTS).max(1);
    for instant in flight.iter().step_by(step).chain(flight.last()) {
        let nutation = nutation(&instant.modes);
        let number = |of: fn(&Mode) -> f64| format!("{:.3}", nutation.map_or(f64::NAN, of));
        table.row([
            format!("{:.3}", instant.time).into(),
            format!("{:.2}", instant.throw.speed).into(),
            number(Mode::frequency).into(),
            number(Mode::decay).into(),
        ]);
    }
    table
}

/// Sentences on the aerodynamic derivatives and the stability criteria at one instant of a flight.
pub fn of_criteria(instant: &Instant) -> Vec<String> {
    let (d, c) = (&instant.derivatives, &instant.criteria);
    let holds = |holds: bool| if holds { "holds" } else { "fails" };
    let mut lines = vec![
        format!(
            "a = {:.4} 1/s (lift), δ = {:.4} 1/s (damping), κ = {:.3} 1/s² (pitching moment), ν = I_a r/I_d = {:.3} rad/s",
            d.lift, d.damping, d.pitching, d.gyroscopic
        ),
        format!(
            "stiffness of the spin, ν² + δ² + 2aδ > κ: {}{}",
            holds(c.gyroscopic),
            factor(c)
        ),
        format!("incidence, a(ν² + δ²) > κδ: {}", holds(c.slow)),
        format!(
            "wobble, (2δ + a)(ν² + δ² + 2aδ − κ) > a(ν² + δ²) − κδ: {}",
            holds(c.wobble)
        ),
    ];
    if d.gyroscopic != 0.0 {
        lines.push(format!(
            "in closed form: nutation {:.3} rad/s, decay {:.4} 1/s; the plane rolls at {:+.4} rad/s (Crowther and Potts)",
            c.nutation, c.nutation_decay, c.roll_rate
        ));
    }
    if !instant.modes.is_symmetric {
        lines.push("the criteria are those of a body of revolution, which this is not".into());
    }
    lines
}

fn factor(criteria: &Criteria) -> String {
    match criteria.gyroscopic_factor {
        s if s.is_finite() && s > 0.0 => format!(", factor {s:.2}"),
        _ => ", whatever the spin".into(),
    }
}

/// The nutation mode (wobble) or, if there is none, the short-period mode; `None` if the motion has neither.
pub fn nutation(modes: &Modes) -> Option<&Mode> {
    let kinds = [ModeKind::Nutation, ModeKind::ShortPeriod];
    modes.modes.iter().find(|mode| kinds.contains(&mode.kind))
}

/// Minimum decay rate, 1/s, of all modes except those of the kinds nutation, heading and spin; negative if one of the
/// examined modes grows, infinite if there is none.
pub fn slowest(modes: &Modes) -> f64 {
    let others = modes.modes.iter().filter(|mode| {
        !matches!(
            mode.kind,
            ModeKind::Heading | ModeKind::Spin | ModeKind::Nutation
        )
    });
    others.map(Mode::decay).fold(f64::INFINITY, f64::min)
}

fn of_modes(modes: &Modes) -> Value {
    let all = modes.modes.iter().map(|mode| {
        json!({
            "kind": mode.kind.name(),
            "real_1_s": mode.value.re,
            "imaginary_rad_s": mode.value.im,
            "damping_ratio": mode.damping_ratio(),
            "shares": { "axis": mode.shares[0], "path": mode.shares[1], "speed": mode.shares[2], "spin": mode.shares[3] },
        })
    });
    json!({ "modes": all.collect::<Vec<_>>(), "ignorable": modes.ignorable, "symmetric": modes.is_symmetric })
}

fn of_instant(instant: &Instant) -> Value {
    let (d, c) = (&instant.derivatives, &instant.criteria);
    let mut value = of_modes(&instant.modes);
    value["seconds"] = json!(instant.time);
    value["speed_m_s"] = json!(instant.throw.speed);
    value["spin_rpm"] = json!(instant.throw.spin);
    value["derivatives"] = json!({
        "lift_1_s": d.lift, "damping_1_s": d.damping, "pitching_1_s2": d.pitching, "gyroscopic_rad_s": d.gyroscopic,
    });
    value["criteria"] = json!({
        "gyroscopic": c.gyroscopic, "incidence": c.slow, "wobble": c.wobble, "stable": c.is_stable(),
        "gyroscopic_factor": Some(c.gyroscopic_factor).filter(|v| v.is_finite()),
        "nutation_rad_s": Some(c.nutation).filter(|v| v.is_finite()),
        "nutation_decay_1_s": Some(c.nutation_decay).filter(|v| v.is_finite()),
        "roll_rad_s": Some(c.roll_rate).filter(|v| v.is_finite()),
    });
    value
}

/// The modes and stability criteria in `found` as JSON of the schema `hyzer.stability/1`.
pub fn json(model: &str, found: &Found) -> Value {
    json!({
        "schema": "hyzer.stability/1",
        "model": model,
        "release": of_instant(&found.release),
        "trim": found.trim.as_ref().map(|(trim, modes)| {
            let mut value = of_modes(modes);
            value["speed_m_s"] = json!(trim.throw.speed);
            value["launch_deg"] = json!(trim.throw.launch);
            value["nose_deg"] = json!(trim.throw.nose);
            value["hyzer_deg"] = json!(trim.throw.hyzer);
            value["turn_deg_s"] = json!(trim.turn.to_degrees());
            value
        }),
        "flight": found.flight.iter().map(of_instant).collect::<Vec<_>>(),
    })
}

/// CSV table of the modes at the given instants: one line per instant and mode, with the stability criteria at the
/// instant (1 if fulfilled, otherwise 0).
pub fn csv(instants: &[Instant]) -> String {
    let mut text = String::from(
        "t_s,speed_m_s,spin_rpm,mode,real_1_s,imaginary_rad_s,gyroscopic,incidence,wobble\n",
    );
    for instant in instants {
        let c = &instant.criteria;
        for mode in &instant.modes.modes {
            let _ = writeln!(
                text,
                "{},{},{},{},{},{},{},{},{}",
                instant.time,
                instant.throw.speed,
                instant.throw.spin.unwrap_or(0.0),
                mode.kind.name(),
                mode.value.re,
                mode.value.im,
                u8::from(c.gyroscopic),
                u8::from(c.slow),
                u8::from(c.wobble)
            );
        }
    }
    text
}
