//! Command `hyzer stability`: computes the modes of the linearised motion at release, along the flight and in steady
//! flight, stability criteria, and maps over speed and spin.

use analysis::stability::{Body, StabilityError, along, at, map, modes, trim};
use anyhow::ensure;
use flight::files::ResultFile;
use flight::release::Release;
use flight::simulate;
use flight::throw::Throw;
use model_spec::model::Model;
use ode::{IntegrationError, IntegrationOptions};
use report::stability::{self, Found};

use super::simulate::{apply_all, released, throws};
use super::vector;
use crate::cli::Stability as Options;
use crate::{Answer, output};

/// Speeds of the grid, m/s.
const SPEEDS: [f64; 12] = [
    6.0, 8.0, 10.0, 12.0, 14.0, 16.0, 18.0, 20.0, 22.0, 25.0, 28.0, 31.0,
];
/// Spins of the grid, from 0: number of intervals, and maximum, rpm.
const SPINS: (u32, f64) = (24, 1200.0);
/// Speed (m/s) and spin (rpm) of the throw by default.
const THROW: (f64, f64) = (16.0, 700.0);

/// Runs `hyzer stability`: computes modes and criteria, prints them, and writes the result files.
pub(super) fn run(options: &Options) -> anyhow::Result<Answer> {
    let out = output::results(options.out.as_deref(), &options.figures, &[])?;
    ensure!(
        options.throw.techdisc.is_none(),
        "--techdisc: expected a throw by --speed and others; `hyzer simulate` flies a launch monitor's table"
    );
    let (model, mut release, throw) = match &options.release {
        Some(name) => {
            let (model, release) = released(name, false, Some(&options.model), &options.with)?;
            (model, release, None)
        }
        None => {
            let model = model_spec::load::load(&options.model, &super::names(&options.with))?;
            let release = throws::at_defaults(&options.model, &model);
            let throw = Throw {
                spin: Some(THROW.1),
                ..Throw::at_speed(THROW.0)
            };
            (model, release, Some(throw))
        }
    };
    apply_all(&options.set, &model, &mut release)?;
    if throw.is_some() {
        throws::check_sets(&options.set, &model)?;
    }
    if let Some(wind) = &options.wind {
        release.wind = vector("--wind", wind, "m/s")?;
    }
    let body = Body::new(model)?;
    throws::apply(
        &options.throw,
        report::Units::Si,
        throw,
        &body.model,
        &mut release,
    )?;
    let (found, missing) = found(&body, &release, options.times as usize)?;
    if let Some(error) = missing {
        eprintln!("no modes along the flight: {error}");
    }
    output::print(if options.json {
        json(&body.model, &found)
    } else {
        stability::text(&body.model.name, &found)
    })?;
    if let Some(out) = &out {
        let what = match found.release.state_space.inputs.is_empty() {
            true => "stability.json, report.html, modes.csv and map.csv",
            false => "stability.json, report.html, modes.csv, map.csv and controls.csv",
        };
        out.write(files(&body.model, &found), what)?;
    }
    Ok(Answer::Yes)
}

/// Modes and criteria at a release, along its flight and in steady flight; and why there are none along the flight.
///
/// # Errors
/// If the motion cannot be linearised.
pub fn found(
    body: &Body,
    release: &Release,
    times: usize,
) -> Result<(Found, Option<IntegrationError>), StabilityError> {
    let bound = body.with_parameters(body.compiled.release_parameters(release));
    let first = at(&bound, 0.0, &release.state())?;
    let settings = IntegrationOptions::with_tolerance(1e-9);
    let (flight, missing) = match simulate(&body.compiled, release, &settings) {
        Ok(flight) => (along(&bound, &flight, times)?, None),
        Err(error) => (Vec::new(), Some(error)),
    };
    let spin = first.throw.rotation_rate();
    let spins = (0..=SPINS.0).map(|k| SPINS.1 * f64::from(k) / f64::from(SPINS.0));
    let spins: Vec<f64> = spins.collect();
    let found = Found {
        map: map(&bound, &first.throw, &SPEEDS, &spins),
        trim: trim(&bound, spin).map(|trim| {
            let modes = modes(&trim.linearised, trim.turn);
            (trim, modes)
        }),
        release: first,
        flight,
    };
    Ok((found, missing))
}

/// The modes and criteria as JSON.
pub fn json(model: &Model, found: &Found) -> String {
    format!("{:#}\n", stability::json(&model.name, found))
}

/// Result files of `hyzer stability`.
pub fn files(model: &Model, found: &Found) -> Vec<ResultFile> {
    let mut files = vec![
        ResultFile::new("stability.json", json(model, found)),
        ResultFile::new("modes.csv", stability::csv(&found.flight)),
        ResultFile::new("map.csv", stability::csv(&found.map)),
    ];
    let controls = stability::controls(found);
    files.extend(controls.map(|table| ResultFile::new("controls.csv", table)));
    files.extend(stability::page(&model.name, found).files());
    files
}
