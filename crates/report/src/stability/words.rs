//! Sentences of a stability analysis, and its JSON and CSV.

use analysis::stability::{
    Criteria, FlightDirection, Instant, Mode, ModeKind, Modes, NEUTRAL, StateSpace, Trim,
};
use nalgebra::DMatrix;
use serde_json::{Value, json};

use super::Found;
use crate::CsvTable;

/// Warning on a body that is no body of revolution.
pub(super) const INSTANT: &str = "The motion depends on the turn about the body's axis. The modes are those in axes that turn with the body; where the air \
     acts on it from one side, they are those of an instant alone, and the criteria do not apply.";

/// The modes with their names, those of one kind numbered from the fastest.
pub(super) fn named(modes: &Modes) -> Vec<(&Mode, String)> {
    let all = &modes.modes;
    let named = all.iter().enumerate().map(|(i, mode)| {
        let alike = |of: &[Mode]| of.iter().filter(|other| other.kind == mode.kind).count();
        let name = mode.kind.name();
        match alike(all) {
            1 => (mode, name.to_owned()),
            _ => (mode, format!("{name} {}", alike(&all[..=i]))),
        }
    });
    named.collect()
}

pub(super) fn steady(trim: &Trim) -> String {
    format!(
        "At the spin of release, held, the body can fly through the air at {:.2} m/s, {:.2}° below the horizontal, nose {:.2}°, hyzer {:.2}°, \
         its heading turning by {:+.2}°/s. Its modes there:",
        trim.throw.speed,
        -trim.throw.launch,
        trim.throw.nose.unwrap_or(0.0),
        trim.throw.hyzer.unwrap_or(0.0),
        trim.turn.to_degrees()
    )
}

/// Sentences on the nutation at release and on the modes that grow.
pub(super) fn lead(found: &Found) -> Vec<String> {
    let mut lead = Vec::new();
    if let Some(mode) = nutation(&found.release.modes) {
        let (frequency, decay) = (mode.frequency(), mode.decay());
        lead.push(format!(
            "At release the axis circles at {frequency:.2} rad/s ({:.2} Hz) and its wobble {}{}.",
            frequency / std::f64::consts::TAU,
            course(-decay),
            match decay.abs() < NEUTRAL {
                true => String::new(),
                false => format!(" at {:.3} 1/s", decay.abs()),
            }
        ));
    }
    let growing = named(&found.release.modes).into_iter();
    let growing = growing.filter(|(mode, _)| mode.decay() < -NEUTRAL);
    let names = growing.map(|(mode, name)| format!("{name} ({:.3} 1/s)", -mode.decay()));
    let names: Vec<String> = names.collect();
    lead.push(if names.is_empty() {
        "At release none of its modes grows.".into()
    } else {
        format!("Growing at release: {}.", names.join(", "))
    });
    let failing = found.flight.iter().find(|i| !i.criteria.is_stable());
    lead.extend(found.flight.last().map(|last| match failing {
        Some(first) => format!(
            "Along the flight of {:.2} s a criterion of the axis fails, first at {:.2} s.",
            last.time, first.time
        ),
        None => format!(
            "Along the flight of {:.2} s the criteria of the axis hold.",
            last.time
        ),
    }));
    lead
}

/// Sentences on the criteria of an instant, with formulas as LaTeX between dollar signs.
pub(super) fn of_criteria(instant: &Instant) -> Vec<String> {
    let (d, c) = (&instant.derivatives, &instant.criteria);
    let holds = |holds: bool| if holds { "holds" } else { "fails" };
    let derivatives = format!(
        r"$a$ = {:.4} 1/s (lift), $\delta$ = {:.4} 1/s (damping), $\kappa$ = {:.3} 1/s² (pitching moment), $\nu = I_a r/I_d$ = {:.3} rad/s",
        d.lift, d.damping, d.pitching, d.gyroscopic
    );
    let (spin, factor) = (holds(c.gyroscopic), factor(c));
    let mut lines = match d.flight {
        FlightDirection::AcrossAxis => vec![
            derivatives,
            format!(
                r"stiffness of the spin, $\nu^2 + \delta^2 + 2a\delta > \kappa$: {spin}{factor}"
            ),
            format!(
                r"incidence, $a(\nu^2 + \delta^2) > \kappa\delta$: {}",
                holds(c.slow)
            ),
            format!(
                r"wobble, $(2\delta + a)(\nu^2 + \delta^2 + 2a\delta - \kappa) > a(\nu^2 + \delta^2) - \kappa\delta$: {}",
                holds(c.wobble)
            ),
        ],
        FlightDirection::AlongAxis => {
            let motions: Vec<f64> = d.eigenvalues().iter().map(|value| value.re).collect();
            let (fast, slow) = (course(motions[0]), course(motions[1]));
            let dynamic = c.dynamic_factor;
            let dynamic = dynamic.map_or_else(String::new, |s_d| format!(", $S_d$ = {s_d:.2}"));
            vec![
                format!(
                    r"{derivatives}, $\mu$ = {:.3} 1/s² (Magnus moment)",
                    d.magnus
                ),
                format!(
                    r"gyroscopic stability, $S_g = \nu^2/(4(\kappa - a\delta)) > 1$: {spin}{factor}"
                ),
                format!(
                    r"dynamic stability, $1/S_g < S_d(2 - S_d)$: the slow motion of the axis {slow}, the fast one {fast}{dynamic}"
                ),
            ]
        }
    };
    // The closed form is an expansion for a spin that is fast beside the stiffness and the damping.
    let is_fast = d.gyroscopic.powi(2) > d.pitching.abs() + d.damping.powi(2);
    if is_fast && d.flight == FlightDirection::AcrossAxis {
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

/// What a motion does that grows at a rate, 1/s.
fn course(growth: f64) -> &'static str {
    match growth {
        _ if growth.abs() < NEUTRAL => "neither decays nor grows",
        _ if growth < 0.0 => "decays",
        _ => "grows",
    }
}

fn factor(criteria: &Criteria) -> String {
    match criteria.gyroscopic_factor {
        s if s.is_finite() && s > 0.0 => format!(", factor {s:.2}"),
        _ => ", whatever the spin".into(),
    }
}

/// The nutation or, if there is none, the short period.
pub(super) fn nutation(modes: &Modes) -> Option<&Mode> {
    let kinds = [ModeKind::Nutation, ModeKind::ShortPeriod];
    modes.modes.iter().find(|mode| kinds.contains(&mode.kind))
}

/// Smallest decay rate of all modes except nutation, heading and spin, 1/s; infinite if there is none.
pub(super) fn slowest(modes: &Modes) -> f64 {
    let apart = [ModeKind::Heading, ModeKind::Spin, ModeKind::Nutation];
    let others = modes
        .modes
        .iter()
        .filter(|mode| !apart.contains(&mode.kind));
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
        "magnus_1_s2": d.magnus,
    });
    value["criteria"] = json!({
        "gyroscopic": c.gyroscopic, "incidence": c.slow, "wobble": c.wobble, "stable": c.is_stable(),
        "dynamic_factor": c.dynamic_factor,
        "gyroscopic_factor": Some(c.gyroscopic_factor).filter(|v| v.is_finite()),
        "nutation_rad_s": Some(c.nutation).filter(|v| v.is_finite()),
        "nutation_decay_1_s": Some(c.nutation_decay).filter(|v| v.is_finite()),
        "roll_rad_s": Some(c.roll_rate).filter(|v| v.is_finite()),
    });
    value
}

/// The analysis as JSON of the schema `hyzer.stability/1`.
pub fn json(model: &str, found: &Found) -> Value {
    json!({
        "schema": "hyzer.stability/1",
        "model": model,
        "linearised": of_equations(&found.release.state_space),
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

fn of_equations(equations: &StateSpace) -> Value {
    let rows = |matrix: &DMatrix<f64>| -> Vec<Vec<f64>> {
        let rows = matrix.row_iter();
        rows.map(|row| row.iter().copied().collect()).collect()
    };
    json!({
        "states": equations.states, "inputs": equations.inputs, "a": rows(&equations.a), "b": rows(&equations.b),
    })
}

/// CSV table of the control derivatives at release and along the flight; `None` for a model without scalar inputs.
pub fn controls(found: &Found) -> Option<String> {
    let instants = match found.flight.is_empty() {
        true => std::slice::from_ref(&found.release),
        false => &found.flight,
    };
    let entries = instants.iter().flat_map(|instant| {
        let entries = instant.state_space.control_derivatives();
        entries.map(move |entry| (instant.time, entry))
    });
    let has_inputs = !found.release.state_space.inputs.is_empty();
    has_inputs.then(|| {
        CsvTable::of(entries)
            .column("t_s", |(time, _)| *time)
            .column("state", |(_, entry)| entry.state)
            .column("input", |(_, entry)| entry.input)
            .column("derivative", |(_, entry)| entry.value)
            .column("unit", |(_, entry)| entry.unit)
            .text()
    })
}

/// CSV table of the modes: one line per instant and mode, with the criteria (1 or 0).
pub fn csv(instants: &[Instant]) -> String {
    let all = instants.iter().flat_map(|instant| {
        let modes = instant.modes.modes.iter();
        modes.map(move |mode| (instant, mode))
    });
    CsvTable::of(all)
        .column("t_s", |(instant, _)| instant.time)
        .column("speed_m_s", |(instant, _)| instant.throw.speed)
        .column("spin_rpm", |(instant, _)| instant.throw.spin.unwrap_or(0.0))
        .column("mode", |(_, mode)| mode.kind.name())
        .column("real_1_s", |(_, mode)| mode.value.re)
        .column("imaginary_rad_s", |(_, mode)| mode.value.im)
        .column("gyroscopic", |(i, _)| u8::from(i.criteria.gyroscopic))
        .column("incidence", |(instant, _)| u8::from(instant.criteria.slow))
        .column("wobble", |(instant, _)| u8::from(instant.criteria.wobble))
        .text()
}
