//! Characteristics of a simulated flight in terms of a throw: range, height, time, speeds, spin and angles.

use std::fmt::Write;

use flight::release::Release;
use flight::throw::{Throw, ThrownModel};
use flight::{BoundModel, CompiledModel};
use model_spec::model::Model;
use ode::Trajectory;
use report::Table;
use serde_json::{Value, json};

use crate::commands::hundredths;

/// Number of evenly spaced times of a flight at which maxima and minima, such as the maximum height, are searched, in
/// addition to the events of the flight.
const SAMPLES: u32 = 2000;

/// Characteristics of a simulated flight, such as duration, range and maximum height.
#[derive(Clone, Debug)]
pub struct Flown {
    /// Duration of the flight, s.
    pub seconds: f64,
    /// Reason why the simulation ended: the name of an event such as the ground, or `time` for the specified duration.
    pub ended_by: String,
    /// Horizontal distance from the release to the end of the flight, m.
    pub range: f64,
    /// Lateral distance of the end of the flight from the line along the heading at release, left positive, m.
    pub sideways: f64,
    /// Maximum height of the mass centre, m, and the time at which it is reached, s.
    pub apex: (f64, f64),
    /// Maximum speed over the ground, m/s.
    pub top_speed: f64,
    /// Position of the mass centre at the end of the flight: x and y in the inertial frame, and height, m.
    pub landing: [f64; 3],
    /// Motion of the body at release, expressed in the quantities of a throw.
    pub release: Throw,
    /// Motion of the body at the end of the flight, expressed in the quantities of a throw.
    pub end: Throw,
    /// Minimum and maximum angle of attack, deg; `None` for a point mass.
    pub alpha: Option<(f64, f64)>,
}

impl Flown {
    /// Computes the characteristics of a flight; `None` for a model that declares no body, because the meaning of its
    /// states is unknown.
    pub fn of(
        model: &Model,
        body: &CompiledModel,
        release: &Release,
        flight: &Trajectory,
    ) -> Option<Flown> {
        let thrown = ThrownModel::new(model).ok()?;
        let parameters = body.release_parameters(release);
        let bound = body.bind(parameters.clone());
        let at = |state: &[f64]| thrown.throw(state, &parameters);
        let first = flight.sample(flight.start)?;
        let last = &flight.end_state;
        let step = (flight.end - flight.start) / f64::from(SAMPLES);
        let times = (0..SAMPLES).map(|k| flight.start + f64::from(k) * step);
        let mut all: Vec<(f64, Vec<f64>)> =
            times.filter_map(|t| Some((t, flight.sample(t)?))).collect();
        let events = flight.events.iter();
        all.extend(events.map(|event| (event.time, event.state.clone())));
        all.push((flight.end, last.clone()));
        let (mut apex, mut top_speed) = ((f64::MIN, 0.0), 0.0_f64);
        let mut alpha: Option<(f64, f64)> = None;
        for (t, state) in &all {
            let motion = at(state);
            if motion.height > apex.0 {
                apex = (motion.height, *t);
            }
            top_speed = top_speed.max(motion.speed);
            if let Some(now) = angle_of_attack(&bound, body, *t, state, &motion) {
                let (least, greatest) = alpha.unwrap_or((now, now));
                alpha = Some((least.min(now), greatest.max(now)));
            }
        }
        let (release, end) = (at(&first), at(last));
        let (from, to) = (
            thrown.ground(&first, &parameters),
            thrown.ground(last, &parameters),
        );
        let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
        let (sin, cos) = release.heading.to_radians().sin_cos();
        Some(Flown {
            seconds: flight.end - flight.start,
            ended_by: flight
                .terminal_event
                .clone()
                .unwrap_or_else(|| "time".into()),
            range: dx.hypot(dy),
            sideways: cos * dy - sin * dx,
            apex,
            top_speed,
            landing: [to[0], to[1], end.height],
            release,
            end,
            alpha,
        })
    }

    /// The characteristics of the flight as a short text table for the terminal.
    pub fn table(&self) -> String {
        let mut text = String::new();
        let side = if self.sideways < 0.0 { "right" } else { "left" };
        let _ = writeln!(
            text,
            "  range {:.2} m, {:.2} m to the {side} of the throw's line; lands at x {:.2}, y {:.2}, z {:.2} m",
            self.range,
            self.sideways.abs(),
            hundredths(self.landing[0]),
            hundredths(self.landing[1]),
            hundredths(self.landing[2])
        );
        let _ = writeln!(
            text,
            "  greatest height {:.2} m at {:.2} s; time {:.2} s; top speed {:.2} m/s",
            self.apex.0, self.apex.1, self.seconds, self.top_speed
        );
        if let Some((least, greatest)) = self.alpha {
            let _ = writeln!(text, "  angle of attack {least:.1} to {greatest:.1} deg");
        }
        let fields = flight::throw::FIELDS.into_iter();
        let rows = fields.filter_map(|(name, unit, ..)| {
            let ends = (self.release.field(name)?, self.end.field(name)?);
            Some((format!("{name}, {unit}"), ends))
        });
        let number = |value: f64| format!("{:.2}", hundredths(value));
        let table = Table::of(rows)
            .name("", |(name, _)| name.clone())
            .number("release", |(_, (release, _))| number(*release))
            .number("end", |(_, (_, end))| number(*end))
            .table();
        text + &table.text(usize::MAX)
    }

    /// The characteristics of the flight as JSON, with units in the keys.
    pub fn json(&self, model: &str) -> Value {
        let motion = |throw: &Throw| {
            json!({
                "speed_m_s": throw.speed, "heading_deg": throw.heading, "launch_deg": throw.launch,
                "nose_deg": throw.nose, "hyzer_deg": throw.hyzer, "spin_rpm": throw.spin,
                "height_m": throw.height, "wobble_deg": throw.wobble,
            })
        };
        json!({
            "schema": "hyzer.flight/1",
            "model": model,
            "seconds": self.seconds,
            "ended_by": self.ended_by,
            "range_m": self.range,
            "left_m": self.sideways,
            "apex_m": self.apex.0,
            "apex_s": self.apex.1,
            "top_speed_m_s": self.top_speed,
            "landing_m": self.landing,
            "release": motion(&self.release),
            "end": motion(&self.end),
            "alpha_deg": self.alpha.map(|(least, greatest)| json!({ "least": least, "greatest": greatest })),
        })
    }
}

/// Angle of attack, deg: the model's quantity `alpha` if it has one, otherwise the angle of attack relative to the
/// velocity over the ground, `motion.nose`; `None` for a body without attitude.
fn angle_of_attack(
    bound: &BoundModel<'_>,
    body: &CompiledModel,
    t: f64,
    state: &[f64],
    motion: &Throw,
) -> Option<f64> {
    let nose = motion.nose?;
    match body.layout().quantity("alpha") {
        Some(alpha) => {
            let all = bound.observer().quantities(t, state);
            Some(all[alpha.index()].to_degrees())
        }
        None => Some(nose),
    }
}
