//! Flights that are kept to judge predictions: their initial state is fitted on their first part with the
//! coefficients held, and the rest is predicted.

use flight::batch;
use nalgebra::DVector;

use super::begin::{fitted_starts, track};
use super::outcome::{initial, left_out};
use super::settle::{own_only, solve_own};
use super::{FitError, State};
use crate::dataset::Dataset;
use crate::noise::Noise;
use crate::normal::eliminate;
use crate::options::Options;
use crate::outlier;
use crate::predict::{Loss, residuals};
use crate::report::FlightReport;
use crate::setting::Setting;
use crate::track::Track;

/// The part of a held-out flight's samples that its initial state is fitted on.
pub const FITTED: f64 = 0.3;

/// A held-out flight.
pub struct HeldOut {
    /// What is reported of it.
    pub report: FlightReport,
    /// Its samples and its initial state; none where it was left out.
    pub track: Option<(Track, DVector<f64>)>,
}

/// Fits and predicts these flights.
///
/// # Errors
/// [`FitError::Interrupted`].
pub fn held_out(
    setting: &Setting,
    dataset: &Dataset,
    flights: &[usize],
    state: &State,
    noise: &Noise,
    options: &Options<'_>,
) -> Result<Vec<HeldOut>, FitError> {
    if !flights.is_empty() {
        options.begins("held-out flights", flights.len());
    }
    let found = batch::each_on(options.threads(), flights.len(), |index| {
        let flight = &dataset.flights[flights[index]];
        let found = one(setting, flight, state, noise, options);
        options.part_done();
        found.unwrap_or_else(|reason| HeldOut {
            report: left_out(flight, reason),
            track: None,
        })
    });
    if options.is_stopped() {
        return Err(FitError::Interrupted);
    }
    Ok(found)
}

fn one(
    setting: &Setting,
    flight: &crate::dataset::Flight,
    state: &State,
    noise: &Noise,
    options: &Options<'_>,
) -> Result<HeldOut, String> {
    let mut track = track(setting, flight)?;
    let all = track.times.len();
    let first = ((all as f64 * FITTED).ceil() as usize).clamp(1, all);
    if first == all {
        return Err("too short for a part of it to be predicted".into());
    }
    let head = track.head(first);
    let shared = &state.shared;
    let starts = fitted_starts(setting, &head, shared, options)?;
    let best = starts.into_iter().min_by(|a, b| a.0.total_cmp(&b.0));
    let (_, start) = best.ok_or("it has no start")?;
    let (_, own) = own_only(setting, &head, first, shared, start.state, options)?;
    mark(setting, &mut track, shared, &own)?;
    // Few samples, whose correlation may be the model's own error: as white, which misleads least.
    let white = Noise {
        ar1: [0.0; 3],
        ..*noise
    };
    let loss = Loss::Whitened(&white);
    let (own, solution) = solve_own(setting, &track, first, shared, own, loss, options)?;
    let system = eliminate(&solution.blocks, 0.0).map_err(|flight| flight.to_string())?;
    let covariance = system.own_covariance(0, &nalgebra::DMatrix::zeros(0, 0));
    let rest = residuals(setting, &track, (shared, &own), all)?;
    let (mut squares, mut count) = (0.0, 0_usize);
    for (marker, series) in rest.iter().enumerate() {
        for (sample, residual) in series.iter().enumerate().skip(first) {
            let Some(residual) = residual else { continue };
            if !track.outlier[sample * track.markers + marker] {
                squares += residual.iter().map(|r| r * r).sum::<f64>();
                count += 3;
            }
        }
    }
    if count == 0 {
        return Err("nothing was seen of the part that is to be predicted".into());
    }
    let initial = initial(setting, &track, &own, &covariance);
    let report = FlightReport {
        file: track.file.clone(),
        role: track.role,
        samples: track.samples,
        rms_m: (squares / count as f64).sqrt(),
        outliers: track.outlier.iter().filter(|outlier| **outlier).count(),
        initial,
        cut: track.cut.clone(),
        notes: track.notes.clone(),
    };
    Ok(HeldOut {
        report,
        track: Some((track, own)),
    })
}

/// Marks the outliers: by how they stand out from their neighbours, so that a wrong prediction is not taken for them.
fn mark(
    setting: &Setting,
    track: &mut Track,
    shared: &DVector<f64>,
    own: &DVector<f64>,
) -> Result<(), String> {
    let residuals = residuals(setting, track, (shared, own), track.times.len())?;
    let departures = outlier::departures(&track.times, &residuals);
    track.outlier = outlier::marks(&departures, outlier::scale(&departures));
    Ok(())
}
