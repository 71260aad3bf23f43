//! The bench on which all candidates are tried: the fitted flights in the model that has every candidate switched on, and
//! off by its value.

use std::sync::Arc;

use flight::batch;
use identify::chart::Chart;
use identify::dataset::{Dataset, Role};
use identify::fit::{FitError, Fitted};
use identify::levenberg::{Known, Point, Problem, Solution, Until, solve};
use identify::noise::Noise;
use identify::normal::Block;
use identify::options::Options;
use identify::predict::{By, Loss, linearise};
use identify::setting::Setting;
use identify::track::Track;
use model_spec::model::Model;
use nalgebra::DVector;

use crate::catalogue::Candidate;

/// The flights, in the model with all candidates.
pub struct Bench {
    /// The model; its shared unknowns are those of the base and the candidates' coefficients.
    pub setting: Setting,
    /// The candidates.
    pub candidates: Vec<Columns>,
    /// The shared unknowns of the base, by index.
    pub base: Vec<usize>,
    /// The fitted flights; every state may be varied.
    pub tracks: Vec<Track>,
    /// Flights worked on at once.
    pub threads: usize,
}

/// A candidate, with where its unknowns are.
#[derive(Clone, Debug)]
pub struct Columns {
    /// What it is.
    pub candidate: Candidate,
    /// Its coefficients among the shared unknowns.
    pub shared: Vec<usize>,
    /// Its states.
    pub states: Vec<usize>,
}

impl Bench {
    /// Puts fitted flights on the bench; and the point that the fit found, with every candidate off.
    ///
    /// # Errors
    /// Where the flights do not go with the model.
    pub fn new(
        model: &Model,
        candidates: Vec<Candidate>,
        dataset: &Dataset,
        fitted: &Fitted,
        options: &Options<'_>,
    ) -> Result<(Self, Point), FitError> {
        let all = Options {
            // A candidate has its bounds; what is profiled is the fit's.
            profiles: &[],
            ..*options
        };
        let mut setting = Setting::new(model, dataset, &all)?;
        setting.floor = fitted.setting().floor;
        let layout = setting.body.layout();
        let columns: Vec<Columns> = candidates
            .into_iter()
            .map(|candidate| {
                let shared = candidate.coefficients.iter().filter_map(|part| {
                    let place = layout.params + part.index;
                    setting.shared.iter().position(|s| s.place == place)
                });
                Columns {
                    shared: shared.collect(),
                    states: candidate.states.iter().map(|part| part.index).collect(),
                    candidate,
                }
            })
            .collect();
        let of_candidates: Vec<usize> = columns.iter().flat_map(|c| c.shared.clone()).collect();
        let base = (0..setting.shared.len()).filter(|i| !of_candidates.contains(i));
        let base: Vec<usize> = base.collect();
        let before = fitted.setting();
        let shared = setting.shared.iter().map(|unknown| {
            let same = before.shared.iter().position(|s| s.name == unknown.name);
            same.map_or(unknown.model_value, |i| fitted.shared()[i])
        });
        let shared = DVector::from_iterator(setting.shared.len(), shared);
        let places: Vec<Option<usize>> = layout
            .states
            .iter()
            .map(|state| before.body.layout().state(state))
            .collect();
        let (mut tracks, mut own) = (Vec::new(), Vec::new());
        for (index, flight) in dataset.flights.iter().enumerate() {
            let Some((track, state)) = fitted.flight(index).filter(|_| flight.role == Role::Fit)
            else {
                continue;
            };
            let fresh = Track::new(&setting, flight).map_err(|reason| FitError::Flight {
                file: flight.file.clone(),
                reason,
            })?;
            tracks.push(Track {
                parameters: fresh.parameters,
                known: fresh.known,
                chart: fresh.chart,
                ..track.clone()
            });
            let full = places
                .iter()
                .zip(&layout.initial)
                .map(|(place, initial)| place.map_or(*initial, |place| state[place]));
            own.push(DVector::from_iterator(places.len(), full));
        }
        let threads = options
            .threads
            .unwrap_or_else(|| std::thread::available_parallelism().map_or(1, |count| count.get()));
        let bench = Self {
            setting,
            candidates: columns,
            base,
            tracks,
            threads,
        };
        Ok((bench, Point { shared, own }))
    }

    /// The normal equations of every flight, by every unknown.
    ///
    /// # Errors
    /// Where a flight is impossible.
    pub fn look(&self, point: &Point, noise: &Noise) -> Result<Vec<Block>, FitError> {
        let found = batch::each_on(self.threads, self.tracks.len(), |flight| {
            let track = &self.tracks[flight];
            let unknowns = (&point.shared, &point.own[flight]);
            let samples = track.times.len();
            let loss = Loss::Whitened(noise);
            linearise(&self.setting, track, unknowns, samples, By::All, loss)
                .map_err(|reason| self.impossible(flight, reason))
        });
        found.into_iter().collect()
    }

    pub(crate) fn impossible(&self, flight: usize, reason: String) -> FitError {
        FitError::Flight {
            file: self.tracks[flight].file.clone(),
            reason,
        }
    }

    /// The shared unknowns of the base and of some candidates, by index, in order.
    pub fn unknowns(&self, with: &[usize]) -> Vec<usize> {
        let mut unknowns = self.base.clone();
        unknowns.extend(with.iter().flat_map(|&c| &self.candidates[c].shared));
        unknowns.sort_unstable();
        unknowns
    }

    /// States of candidates that are not among these.
    pub fn states_but(&self, with: &[usize]) -> Vec<usize> {
        let each = self.candidates.iter().enumerate();
        each.filter(|(index, _)| !with.contains(index))
            .flat_map(|(_, columns)| columns.states.clone())
            .collect()
    }

    /// Fits the base and some candidates from a point on, all other candidates staying as they are there; the sum of squares
    /// that is left.
    ///
    /// # Errors
    /// In words, where that is impossible.
    pub fn refit(
        &self,
        with: &[usize],
        from: &Point,
        noise: &Noise,
    ) -> Result<(Point, f64), String> {
        let unknowns = self.unknowns(with);
        let setting = Setting {
            model: Arc::clone(&self.setting.model),
            body: Arc::clone(&self.setting.body),
            shared: unknowns
                .iter()
                .map(|&i| self.setting.shared[i].clone())
                .collect(),
            ..self.setting.clone()
        };
        let held = self.states_but(with);
        let tracks = self.tracks.iter().zip(&from.own).map(|(track, own)| {
            let mut known: Vec<usize> = track.known.iter().map(|(state, _)| *state).collect();
            known.extend(&held);
            let mut parameters = track.parameters.clone();
            for (unknown, value) in self.setting.shared.iter().zip(from.shared.iter()) {
                parameters[unknown.place] = *value;
            }
            let _ = own;
            Track {
                parameters,
                chart: Chart::new(&self.setting.model, &known),
                ..track.clone()
            }
        });
        let problem = Refit {
            known: setting.shared.iter().map(|shared| shared.known).collect(),
            setting,
            tracks: tracks.collect(),
            noise,
            threads: self.threads,
        };
        let start = Point {
            shared: DVector::from_iterator(
                unknowns.len(),
                unknowns.iter().map(|&i| from.shared[i]),
            ),
            own: from.own.clone(),
        };
        let Solution { point, squares, .. } =
            solve(&problem, start, Until::DONE).map_err(|failure| failure.to_string())?;
        let mut shared = from.shared.clone();
        for (&i, value) in unknowns.iter().zip(point.shared.iter()) {
            shared[i] = *value;
        }
        let point = Point {
            shared,
            own: point.own,
        };
        Ok((point, squares))
    }
}

/// The least squares of the base with some candidates.
struct Refit<'a> {
    setting: Setting,
    tracks: Vec<Track>,
    noise: &'a Noise,
    known: Vec<Known>,
    threads: usize,
}

impl Problem for Refit<'_> {
    fn flights(&self) -> usize {
        self.tracks.len()
    }

    fn linearise(
        &self,
        flight: usize,
        shared: &DVector<f64>,
        own: &DVector<f64>,
    ) -> Result<Block, String> {
        let track = &self.tracks[flight];
        let samples = track.times.len();
        let loss = Loss::Whitened(self.noise);
        linearise(&self.setting, track, (shared, own), samples, By::All, loss)
    }

    fn moved(&self, flight: usize, own: &DVector<f64>, step: &DVector<f64>) -> DVector<f64> {
        self.tracks[flight].chart.moved(own, step)
    }

    fn known(&self) -> &[Known] {
        &self.known
    }

    fn threads(&self) -> usize {
        self.threads
    }
}
