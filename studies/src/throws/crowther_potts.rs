//! Reproduces statements on launches by W. J. Crowther and J. R. Potts, "Simulation of a spin-stabilised sports disc",
//! Sports Engineering 10 (2007) 3, with the coefficients of the model `disc` and with those of their wind tunnel.

use analysis::design::{Path, ThrowFlights, ThrownBody};
use flight::throw::Throw;
use ode::IntegrationOptions;
use serde::Serialize;

use crate::error::StudyError;

/// Speed at release in the simulated disc launches, m/s.
const SPEED: f64 = 20.0;
/// Advance ratio r d/2V of the launches, with the spin r, the diameter d and the speed V.
const ADVANCE: f64 = 0.5;

/// Results of the simulated disc launches with one set of aerodynamic coefficients.
#[derive(Clone, Debug, Serialize)]
pub struct Launches {
    /// Description of the set of aerodynamic coefficients with which the disc was simulated.
    pub name: &'static str,
    /// Pitch at launch that gives the maximum range, and the one that gives the maximum time of flight, deg. Path and
    /// disc are pitched together (zero angle of attack).
    pub along: (f64, f64),
    /// Pitch of the disc at a horizontal launch (equal to the angle of attack) that gives the maximum range, and the
    /// one that gives the maximum time of flight, deg.
    pub level: (f64, f64),
    /// Results of horizontal launches as a function of the tilt of the disc (hyzer angle).
    pub tilts: Tilts,
    /// Pairs of an advance ratio and the mean curvature of the path's horizontal projection at this advance ratio
    /// (absolute value, whether the path turns to the left or to the right), rad/m.
    pub curvature: Vec<(f64, f64)>,
}

/// Results of horizontal disc launches with an angle of attack of 10°, as a function of the tilt (hyzer angle).
#[derive(Clone, Debug, Serialize)]
pub struct Tilts {
    /// Tilt (hyzer angle), deg, of the flight whose maximum lateral displacement is the smallest, and that
    /// displacement (absolute value), m. The tilt is positive if the left edge, seen from behind, is the lower one.
    pub straightest: (f64, f64),
    /// Tilt (hyzer angle), deg, with which the disc lands on the line of launch, interpolated between the simulated
    /// flights; positive if the left edge, seen from behind, is the lower one. `None` if no two successive flights land
    /// on opposite sides of the line.
    pub on_line: Option<f64>,
    /// Landing points: hyzer angle, deg (positive if the left edge, seen from behind, is the lower one), and horizontal
    /// position, m: x along the launch direction, y to the left of it.
    pub landings: Vec<(f64, f64, f64)>,
    /// Number of inflections of the curve through the landing points, ordered by hyzer angle; an S-shaped curve has 1.
    pub inflections: usize,
}

/// Names of the built-in effects by which the model `disc` must be extended to represent the coefficients that Potts
/// and Crowther measured in a wind tunnel.
const EFFECTS: [&str; 2] = ["constant_pitching_moment", "zero_lift_drag_angle"];

/// Values of the roll coefficient C_Rr, s, that are tried together with the coefficients that Potts and Crowther
/// measured in a wind tunnel.
const ROLLS: [f64; 7] = [-4e-4, -2e-4, 0.0, 2e-4, 4e-4, 6e-4, 8e-4];

/// Coefficients with round values near the table of Potts and Crowther (2002), "Frisbee aerodynamics": lift, drag (a
/// parabola with its minimum at -4 degrees), and pitching moment (C_M0 nose-up positive).
const TUNNEL: [(&str, f64); 9] = [
    ("C_L0", 0.20),
    ("C_La", 2.96),
    ("C_D0", 0.08),
    ("C_Da", 2.72),
    ("alpha_0", -0.0698),
    ("C_M0", 0.02),
    ("C_Ma", -0.13),
    ("C_Mq", -1e-4),
    ("C_Rr", 0.0),
];

/// Simulates launches over a range of tilts (hyzer angles) with coefficients close to those that Potts and Crowther
/// measured in a wind tunnel, for several values of the roll coefficient C_Rr. Returns pairs (C_Rr in s, results of the
/// launches).
///
/// # Errors
/// [`StudyError`] if the model cannot be loaded.
pub fn rolls() -> Result<Vec<(f64, Tilts)>, StudyError> {
    let each = ROLLS.map(|roll| {
        let mut values = TUNNEL.to_vec();
        values.push(("C_Rr", roll));
        let body = body("disc", &EFFECTS)?;
        let (flights, level) = flights(&body, &values);
        Ok((roll, tilts(&flights, &level(ADVANCE))))
    });
    each.into_iter().collect()
}

/// Simulates disc launches with each of four sets of aerodynamic coefficients, such as those of the model file and
/// those measured in a wind tunnel.
///
/// # Errors
/// [`StudyError`] if the model cannot be loaded.
pub fn launches() -> Result<Vec<Launches>, StudyError> {
    let disc = || body("disc", &EFFECTS);
    Ok(vec![
        of("the model's own", disc()?, &[])?,
        of("of the wind tunnel", disc()?, &TUNNEL)?,
        of(
            "of the wind tunnel, with the model's own pitching moment",
            disc()?,
            &own_pitch(&TUNNEL),
        )?,
        of("the wind tunnel's tables", body("ultimate_disc", &[])?, &[])?,
    ])
}

fn body(model: &str, effects: &[&str]) -> Result<ThrownBody, StudyError> {
    Ok(ThrownBody::new(model_spec::load::load(model, effects)?)?)
}

/// Returns the coefficients in `all` without those of the pitching moment, so that the pitching moment of the model
/// file remains in effect.
fn own_pitch(all: &[(&'static str, f64)]) -> Vec<(&'static str, f64)> {
    all.iter()
        .filter(|(name, _)| !["C_M0", "C_Ma"].contains(name))
        .copied()
        .collect()
}

/// Prepares simulations of flights of a disc with the coefficients `values`. Also returns a function that creates the
/// launch conditions of a horizontal launch at 20 m/s with a specified advance ratio.
fn flights<'b>(
    body: &'b ThrownBody,
    values: &[(&str, f64)],
) -> (ThrowFlights<'b>, impl Fn(f64) -> Throw + use<>) {
    let layout = body.compiled.layout();
    let mut parameters = layout.default_parameters();
    for (coefficient, value) in values {
        if let Some(place) = layout.parameter(coefficient) {
            parameters[place.index()] = *value;
        }
    }
    let diameter = layout
        .parameter("d")
        .map_or(0.269, |place| parameters[place.index()]);
    let level = move |advance: f64| Throw {
        spin: Some(advance * 2.0 * SPEED / diameter * 30.0 / std::f64::consts::PI),
        height: 1.0,
        ..Throw::at_speed(SPEED)
    };
    (body.with_parameters(parameters), level)
}

fn of(
    name: &'static str,
    body: ThrownBody,
    values: &[(&str, f64)],
) -> Result<Launches, StudyError> {
    let (flights, at_advance) = flights(&body, values);
    let level = at_advance(ADVANCE);
    let pitches: Vec<f64> = (-10..=50).map(f64::from).collect();
    let best = |throw: &dyn Fn(f64) -> Throw| -> Result<(f64, f64), StudyError> {
        let (mut range, mut time) = ((f64::MIN, 0.0), (f64::MIN, 0.0));
        for pitch in &pitches {
            let Some(path) = flown(&flights, &throw(*pitch)) else {
                continue;
            };
            let landing = path.landing();
            range = if landing.position.xy().norm() > range.0 {
                (landing.position.xy().norm(), *pitch)
            } else {
                range
            };
            time = if landing.time > time.0 {
                (landing.time, *pitch)
            } else {
                time
            };
        }
        Ok((range.1, time.1))
    };
    let mut curvature = Vec::new();
    for advance in [0.3, 0.4, 0.5, 0.7, 1.0, 1.4] {
        let throw = Throw {
            nose: Some(10.0),
            ..at_advance(advance)
        };
        if let Some(path) = flown(&flights, &throw) {
            curvature.push((advance, turned(&path)));
        }
    }
    Ok(Launches {
        name,
        along: best(&|pitch| Throw {
            launch: pitch,
            nose: Some(0.0),
            ..level
        })?,
        level: best(&|pitch| Throw {
            launch: 0.0,
            nose: Some(pitch),
            ..level
        })?,
        tilts: tilts(&flights, &level),
        curvature,
    })
}

/// Simulates horizontal launches with an angle of attack of 10° over a range of tilts (hyzer angles). `level` has the
/// other launch conditions, such as speed and spin.
fn tilts(flights: &ThrowFlights<'_>, level: &Throw) -> Tilts {
    let mut landings: Vec<(f64, f64, f64)> = Vec::new();
    let (mut straightest, mut on_line) = ((0.0, f64::INFINITY), None);
    for hyzer in (-60..=60).step_by(2).map(f64::from) {
        let throw = Throw {
            nose: Some(10.0),
            hyzer: Some(hyzer),
            ..*level
        };
        let Some(path) = flown(flights, &throw) else {
            continue;
        };
        let place = path.landing().position;
        if let Some((before, _, y)) = landings.last()
            && y * place.y < 0.0
        {
            on_line = Some(before - y * (hyzer - before) / (place.y - y));
        }
        landings.push((hyzer, place.x, place.y));
        let aside = (0..=100).map(|k| {
            let at = path.position(path.duration() * f64::from(k) / 100.0);
            at.y.abs()
        });
        let aside = aside.fold(0.0, f64::max);
        if aside < straightest.1 {
            straightest = (hyzer, aside);
        }
    }
    Tilts {
        straightest,
        on_line,
        inflections: inflections(&landings),
        landings,
    }
}

fn flown<'f>(flights: &'f ThrowFlights<'f>, throw: &Throw) -> Option<Path<'f>> {
    flights
        .fly(throw, None, &IntegrationOptions::with_tolerance(1e-8))
        .ok()
}

/// Absolute value of the mean curvature of the horizontal projection of the path in the first two seconds, rad/m: net
/// angle by which the horizontal direction of motion changes / length of the projection.
fn turned(path: &Path<'_>) -> f64 {
    let end = path.duration().min(2.0);
    let (steps, mut angle, mut length) = (200, 0.0, 0.0);
    let at = |k: i32| path.position(end * f64::from(k) / f64::from(steps)).xy();
    for k in 1..steps {
        let (before, after) = (at(k) - at(k - 1), at(k + 1) - at(k));
        angle += before.perp(&after).atan2(before.dot(&after));
        length += before.norm();
    }
    (angle / length).abs()
}

/// Number of inflections of a curve given by points (parameter, x, y): changes of the sign with which the curve turns.
/// Turns of less than one degree between neighbouring points are ignored.
fn inflections(points: &[(f64, f64, f64)]) -> usize {
    let mut last = 0.0;
    let mut count = 0;
    for three in points.windows(3) {
        let [(_, ax, ay), (_, bx, by), (_, cx, cy)] = three else {
            continue;
        };
        let (ux, uy, vx, vy) = (bx - ax, by - ay, cx - bx, cy - by);
        let turn = (ux * vy - uy * vx).atan2(ux * vx + uy * vy);
        if turn.abs() > 1f64.to_radians() {
            count += usize::from(last * turn < 0.0);
            last = turn.signum();
        }
    }
    count
}
