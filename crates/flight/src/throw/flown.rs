//! Characteristics of a simulated flight in terms of a throw: range, height, time, speeds, spin and angles.

use model_spec::model::Model;
use ode::Trajectory;

use super::{Throw, ThrownModel};
use crate::initial_conditions::Release;
use crate::{BoundModel, CompiledModel};

/// Evenly spaced times of a flight at which maxima and minima are searched, in addition to its events.
const SAMPLES: u32 = 2000;

/// Characteristics of a simulated flight, such as duration, range and maximum height.
#[derive(Clone, Debug)]
pub struct FlownThrow {
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

impl FlownThrow {
    /// Characteristics of a flight; `None` for a model without a body, the meaning of whose states is unknown.
    pub fn of(
        model: &Model,
        body: &CompiledModel,
        release: &Release,
        flight: &Trajectory,
    ) -> Option<FlownThrow> {
        let thrown = ThrownModel::new(model).ok()?;
        let parameters = body.release_parameters(release);
        let bound = body.bind(parameters.clone());
        let at = |state: &[f64]| thrown.throw(state, &parameters.constants);
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
            thrown.ground(&first, &parameters.constants),
            thrown.ground(last, &parameters.constants),
        );
        let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
        let (sin, cos) = release.heading.to_radians().sin_cos();
        Some(FlownThrow {
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
}

/// Angle of attack, deg: the quantity `alpha`, or else that over the ground; `None` without attitude.
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
