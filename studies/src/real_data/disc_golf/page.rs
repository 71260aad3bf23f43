//! Section of docs/studies/real-data.md on the disc-golf throws.

use serde::Serialize;

use super::results::{DRAWS, DiscGolf, ThrowResult};
use super::throw::{LAUNCH_NAMES, TRACK_UNCERTAINTY};
use crate::error::StudyError;
use crate::page::render;

#[derive(Serialize)]
struct Section {
    track_uncertainty: f64,
    draws: usize,
    throws: Vec<ThrowRow>,
    launch_names: [&'static str; 7],
    launches: Vec<LaunchRow>,
    factors: Vec<FactorRow>,
    greatest_rms: f64,
    unknowns: usize,
    points: usize,
}

#[derive(Serialize)]
struct ThrowRow {
    number: u32,
    /// Horizontal position (x, y) of the last point of the measured track relative to the release, m.
    end: [f64; 2],
    stated_rms: Option<f64>,
    mean: [f64; 2],
    deviation: [f64; 2],
    within: f64,
}

#[derive(Serialize)]
struct LaunchRow {
    number: u32,
    rms: [f64; 2],
    changes: [f64; 7],
}

#[derive(Serialize)]
struct FactorRow {
    number: u32,
    rms: f64,
    /// Fitted factors by which the tabulated lift, drag and pitching moment are multiplied, each with its standard
    /// error.
    factors: [(f64, f64); 3],
    /// Maximum, over the launch quantities, of the absolute change by the fit, in units of the quantity's published
    /// uncertainty.
    greatest_change: f64,
}

/// Renders the section of docs/studies/real-data.md on the filmed disc-golf throws, as Markdown.
pub(in super::super) fn disc_golf_section(data: &DiscGolf) -> Result<String, StudyError> {
    let launches = || data.throws.iter().filter_map(launch_row);
    let section = Section {
        track_uncertainty: TRACK_UNCERTAINTY,
        draws: DRAWS,
        throws: data.throws.iter().map(throw_row).collect(),
        launch_names: LAUNCH_NAMES,
        launches: launches().collect(),
        factors: data.throws.iter().filter_map(factor_row).collect(),
        greatest_rms: launches().map(|row| row.rms[1]).fold(0.0, f64::max),
        unknowns: LAUNCH_NAMES.len(),
        points: data.throws.first().map_or(0, |r| r.throw.points().len()),
    };
    render(include_str!("page.md"), section)
}

fn throw_row(result: &ThrowResult) -> ThrowRow {
    let end = result.throw.track.last();
    ThrowRow {
        number: result.throw.number,
        end: end.map_or([f64::NAN; 2], |(_, position)| *position),
        stated_rms: result.fits[0].as_ref().map(|fit| fit.rms[0]),
        mean: result.band.mean,
        deviation: result.band.deviation,
        within: result.band.within,
    }
}

fn launch_row(result: &ThrowResult) -> Option<LaunchRow> {
    let fit = result.fits[0].as_ref()?;
    Some(LaunchRow {
        number: result.throw.number,
        rms: fit.rms,
        changes: fit.changes,
    })
}

fn factor_row(result: &ThrowResult) -> Option<FactorRow> {
    let fit = result.fits[1].as_ref()?;
    let changes = fit.changes.iter().map(|change| change.abs());
    Some(FactorRow {
        number: result.throw.number,
        rms: fit.rms[1],
        factors: [0, 1, 2].map(|k| (fit.factors[k], fit.factor_errors[k])),
        greatest_change: changes.fold(0.0, f64::max),
    })
}
