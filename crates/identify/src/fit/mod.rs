//! One set of coefficients for all flights, and each flight's initial state.
//!
//! Output error: the differences between observed and predicted markers are made as small as their noise allows,
//! and the noise (its scale and its first-order correlation along each axis, its outliers) is estimated with them.

mod alone;
mod begin;
mod flown;
mod held_out;
mod look;
mod outcome;
mod problem;
mod recover;
mod rounds;
mod settle;
mod spin;

use std::borrow::Borrow;
use std::time::Instant;

use model_spec::model::Model;
use nalgebra::DVector;

use crate::dataset::{Dataset, Role};
use crate::levenberg::{Failure, Point, Solution};
use crate::noise::Noise;
use crate::options::Options;
use crate::predict;
use crate::report::{FlightEvidence, Report};
pub use crate::setting::FitError;
use crate::setting::Setting;
use crate::track::Track;
pub use held_out::FITTED;

/// A dataset that was fitted.
pub struct Fitted {
    /// What was found.
    pub report: Report,
    setting: Setting,
    names: Vec<String>,
    /// Tracks of the flights by index in the dataset; none for those that were left out.
    tracks: Vec<Option<(Track, DVector<f64>)>>,
    shared: DVector<f64>,
    noise: Noise,
}

/// What the stages of a fit work on.
#[derive(Clone)]
pub(crate) struct State {
    /// The flights that are fitted.
    pub tracks: Vec<Track>,
    /// The shared unknowns.
    pub shared: DVector<f64>,
    /// Each flight's initial state.
    pub own: Vec<DVector<f64>>,
    /// The usual time between samples, s.
    pub interval: f64,
    /// Steps tried so far.
    pub steps: usize,
    /// Estimates of the noise so far.
    pub rounds: usize,
}

/// Fits a model to a dataset's flights.
///
/// # Errors
/// See [`FitError`].
pub fn fit(model: &Model, dataset: &Dataset, options: &Options<'_>) -> Result<Fitted, FitError> {
    let clock = Instant::now();
    let mut setting = Setting::new(model, dataset, options)?;
    let of_role = |role: Role| move |flight: &usize| dataset.flights[*flight].role == role;
    let all = 0..dataset.flights.len();
    let fitted: Vec<usize> = all.clone().filter(of_role(Role::Fit)).collect();
    if fitted.is_empty() {
        let reason = "every flight is held out: none is left to fit".to_owned();
        return Err(FitError::Mismatch(reason));
    }
    let (tracks, floor) = begin::tracks(&setting, dataset, &fitted, options);
    setting.floor = floor;
    setting.tolerance = predict::tolerance(model, fitted.len());
    let mut begun = begin::begin(&setting, dataset, tracks, options)?;
    let (used, left_out) = (
        std::mem::take(&mut begun.flights),
        std::mem::take(&mut begun.left_out),
    );
    let started = clock.elapsed().as_secs_f64();

    let (mut state, flown) = spin::grow_all(&setting, begun, options)?;
    let flown = recover::recover(&setting, &mut state, flown, options)?;
    let (noise, solution, flown) = rounds::rounds(&setting, &mut state, flown, options)?;
    let solved = clock.elapsed().as_secs_f64();

    let outcome = outcome::Outcome::new(&setting, &state, flown, &noise, &solution, options)?;
    let mut report = outcome.report();
    let reports: Vec<_> = (0..used.len()).map(|index| outcome.flight(index)).collect();
    drop(outcome);
    let held_out: Vec<usize> = all.clone().filter(of_role(Role::HeldOut)).collect();
    let held = held_out::held_out(&setting, dataset, &held_out, &state, &noise, options)?;
    let mut tracks: Vec<Option<(Track, DVector<f64>)>> = vec![None; dataset.flights.len()];
    let mut flights = vec![None; dataset.flights.len()];
    for (flight, reason) in left_out {
        flights[flight] = Some(outcome::left_out(&dataset.flights[flight], reason));
    }
    let solved_tracks = state.tracks.into_iter().zip(solution.point.own);
    for ((flight, report), track) in used.into_iter().zip(reports).zip(solved_tracks) {
        flights[flight] = Some(report);
        tracks[flight] = Some(track);
    }
    for (flight, held) in held_out.into_iter().zip(held) {
        flights[flight] = Some(held.report);
        tracks[flight] = held.track;
    }
    report.flights = flights.into_iter().flatten().collect();
    report.seconds.insert("start".into(), started);
    report.seconds.insert("fit".into(), solved - started);
    report
        .seconds
        .insert("total".into(), clock.elapsed().as_secs_f64());
    Ok(Fitted {
        report,
        shared: solution.point.shared,
        setting,
        noise,
        names: dataset
            .markers
            .iter()
            .map(|marker| marker.name.clone())
            .collect(),
        tracks,
    })
}

impl Fitted {
    /// The model with what was estimated of it.
    pub fn setting(&self) -> &Setting {
        &self.setting
    }

    /// The shared unknowns, in the order of [`Setting::shared`].
    pub fn shared(&self) -> &DVector<f64> {
        &self.shared
    }

    /// The noise that residuals were weighed by.
    pub fn noise(&self) -> &Noise {
        &self.noise
    }

    /// Samples and initial state of a flight of the dataset, by index; none where it was left out.
    pub fn flight(&self, flight: usize) -> Option<(&Track, &DVector<f64>)> {
        let (track, own) = self.tracks.get(flight)?.as_ref()?;
        Some((track, own))
    }

    /// A flight of the dataset, by index, as measured and as predicted; none where it was left out.
    pub fn evidence(&self, flight: usize) -> Option<FlightEvidence> {
        let (track, own) = self.tracks.get(flight)?.as_ref()?;
        look::evidence(&self.setting, &self.names, track, (&self.shared, own))
    }
}

/// A failure of the least squares over these tracks, for the user.
fn told(failure: Failure, tracks: &[impl Borrow<Track>]) -> FitError {
    let file = |flight: usize| tracks[flight].borrow().file.clone();
    match failure {
        Failure::Start { flight, reason } => FitError::Flight {
            file: file(flight),
            reason,
        },
        Failure::Undetermined(crate::normal::Undetermined(flight)) => FitError::Flight {
            file: file(flight),
            reason: "its samples do not determine its initial state".into(),
        },
        Failure::Stopped => FitError::Interrupted,
    }
}

impl State {
    /// Where the unknowns are.
    fn point(&self) -> Point {
        Point {
            shared: self.shared.clone(),
            own: self.own.clone(),
        }
    }

    /// Takes over where an iteration ended.
    fn take(&mut self, solution: &Solution) {
        self.shared.clone_from(&solution.point.shared);
        self.own.clone_from(&solution.point.own);
        self.steps += solution.iterations;
    }
}

/// White noise of this size, where nothing better is known.
fn white(setting: &Setting, state: &State) -> Noise {
    Noise::white(setting.floor, state.interval)
}
