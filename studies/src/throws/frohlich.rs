//! Reproduces C. Frohlich, "Aerodynamic effects on discus flight", Am. J. Phys. 49 (1981) 1125: a discus flies farther
//! against a moderate wind than with it.

use analysis::design::{Bounds, Goal, SearchOptions, ThrownBody, design};
use serde::Serialize;

use crate::error::StudyError;

/// Launch conditions and range of the longest discus throw in a given wind along the throw.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Winds {
    /// Wind along the throw, m/s; positive for a tailwind.
    pub wind: f64,
    /// Range of the longest discus throw in this wind, m.
    pub range: f64,
    /// Launch angle of the longest discus throw in this wind, deg.
    pub launch: f64,
    /// Nose angle at release of the longest discus throw in this wind, deg: angle of attack with respect to the
    /// velocity relative to the ground, positive nose-up.
    pub nose: f64,
    /// Hyzer angle (tilt about the velocity) at release of the longest discus throw in this wind, deg; positive if the
    /// left edge, seen from behind, is the lower one.
    pub hyzer: f64,
    /// Maximum range, in this wind, of discus throws with zero hyzer angle at release, m.
    pub upright: f64,
}

/// Finds the longest discus throws with a release speed of 25 m/s and a spin of 420 rpm, in winds along the throw from
/// -20 m/s (headwind) to 20 m/s (tailwind).
///
/// # Errors
/// [`StudyError`] if the model cannot be loaded or a search finds no throw.
pub fn winds() -> Result<Vec<Winds>, StudyError> {
    let body = ThrownBody::new(model_spec::load::load("discus", &[])?)?;
    let layout = body.compiled.layout();
    let bounds = Bounds::standard(&body)
        .with("speed", 25.0, 25.0)
        .with("heading", 0.0, 0.0)
        .with("spin", 420.0, 420.0)
        .with("nose", -40.0, 30.0)
        .with("height", 1.8, 1.8);
    let all = (-10..=10).step_by(2).map(|k| {
        let wind = f64::from(2 * k);
        let mut parameters = layout.default_parameters();
        if let Some([x, ..]) = layout.components("wind") {
            parameters[x.index()] = wind;
        }
        let flights = body.with_parameters(parameters);
        let found = design(&flights, Goal::Range, &bounds, &SearchOptions::default())?;
        let held = bounds.clone().with("hyzer", 0.0, 0.0);
        let upright = design(&flights, Goal::Range, &held, &SearchOptions::default())?;
        Ok(Winds {
            upright: upright.figure,
            wind,
            range: found.figure,
            launch: found.throw.launch,
            nose: found.throw.nose.unwrap_or(0.0),
            hyzer: found.throw.hyzer.unwrap_or(0.0),
        })
    });
    all.collect()
}
