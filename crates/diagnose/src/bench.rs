//! The bench on which all candidates are tried: the fitted flights in the model that has every candidate switched on, and
//! off by its value.

use std::sync::Arc;

use codegen::Layout;
use flight::batch;
use flight::body::{Body, Conditions};
use flight::sensitivity::Linearised;
use identify::chart::Chart;
use identify::dataset::{Dataset, Role};
use identify::fit::{FitError, Fitted};
use identify::levenberg::{Known, Point, Problem, Solution, Until, shared_step, solve};
use identify::noise::Noise;
use identify::normal::{Block, eliminate};
use identify::options::Options;
use identify::predict::{By, Loss, Residual, each_residual, linearise, linearise_by};
use identify::setting::Setting;
use identify::track::Track;
use model_spec::layout::StateId;
use nalgebra::DVector;

use crate::catalogue::{Candidate, Catalogue};
use crate::kept::{Kept, Vantage};
use crate::scores::own_block;
use crate::terms::Grammar;

/// A refit that takes more steps leads nowhere.
const STEPS: Until = Until {
    steps: 25,
    ..Until::DONE
};

/// The flights, in the model with all candidates.
pub struct Bench {
    /// The model, with every candidate off; its shared unknowns are those of the base and the candidates' coefficients.
    pub setting: Setting,
    catalogue: Catalogue,
    /// The candidates.
    pub candidates: Vec<Columns>,
    /// The shared unknowns of the base, by index.
    pub base: Vec<usize>,
    /// Terms outside the catalogue, where the model has channels for them; their unknowns come behind the shared ones.
    pub grammar: Option<Grammar>,
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
        catalogue: &Catalogue,
        dataset: &Dataset,
        fitted: &Fitted,
        options: &Options<'_>,
    ) -> Result<(Self, Point), FitError> {
        let mut hold = options.hold.to_vec();
        let loads = catalogue.channels.iter().flat_map(|c| c.loads);
        hold.extend(loads.map(|(name, ..)| ((*name).to_owned(), None)));
        let all = Options {
            hold: &hold,
            // What is profiled is the fit's.
            profiles: &[],
            ..*options
        };
        let fixed = off(catalogue, &[]);
        let body = Body::on_tape_at(&catalogue.model, &fixed);
        let mut setting = Setting::with_body(&catalogue.model, body, dataset, &all)?;
        setting.floor = fitted.setting().floor;
        let layout = setting.body.layout();
        let columns: Vec<Columns> = catalogue
            .candidates
            .iter()
            .cloned()
            .map(|candidate| {
                let shared = candidate.coefficients.iter().filter_map(|part| {
                    let place = layout.coefficient(part.index).index();
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
        let places: Vec<Option<StateId>> = layout
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
                .map(|(place, initial)| place.map_or(*initial, |place| state[place.index()]));
            own.push(DVector::from_iterator(places.len(), full));
        }
        let grammar = catalogue
            .channels
            .and_then(|channels| Grammar::new(channels, layout));
        let bench = Self {
            catalogue: catalogue.clone(),
            grammar,
            setting,
            candidates: columns,
            base,
            tracks,
            threads: options.threads(),
        };
        Ok((bench, Point { shared, own }))
    }

    /// The normal equations of every flight, by every unknown of the base and the catalogue.
    ///
    /// # Errors
    /// Where a flight is impossible.
    pub fn look(
        &self,
        setting: &Setting,
        point: &Point,
        noise: &Noise,
    ) -> Result<Vec<Block>, FitError> {
        let nothing = Kept::default();
        let from = Vantage {
            setting,
            point,
            kept: &nothing,
        };
        self.look_by(from, noise, None)
    }

    /// The same by the terms outside the catalogue too, whose unknowns come behind the shared ones.
    ///
    /// # Errors
    /// Where a flight is impossible.
    pub fn look_further(&self, from: Vantage<'_>, noise: &Noise) -> Result<Vec<Block>, FitError> {
        self.look_by(from, noise, self.grammar.as_ref())
    }

    fn look_by(
        &self,
        from: Vantage<'_>,
        noise: &Noise,
        grammar: Option<&Grammar>,
    ) -> Result<Vec<Block>, FitError> {
        let Vantage { setting, point, .. } = from;
        let found = batch::each_on(self.threads, self.tracks.len(), |flight| {
            let track = &self.tracks[flight];
            let unknowns = (&point.shared, &point.own[flight]);
            let samples = track.times.len();
            let loss = Loss::Whitened(noise);
            let found = match grammar {
                None => linearise(setting, track, unknowns, samples, By::All, loss),
                Some(grammar) => {
                    let conditions = conditions(setting, track, &point.shared);
                    let (motion, places) = self.further(&conditions, grammar);
                    let by = (motion, places.as_slice());
                    from.kept.with(flight, |kept| {
                        linearise_by(setting, track, unknowns, samples, loss, by, Some(kept))
                    })
                }
            };
            found.map_err(|reason| self.impossible(flight, reason))
        });
        found.into_iter().collect()
    }

    /// Equations of motion with the terms of a grammar, and the places of all constants.
    fn further<'c>(
        &self,
        conditions: &'c Conditions<'c>,
        grammar: &'c Grammar,
    ) -> (impl Linearised + use<'c>, Vec<usize>) {
        let first = self.setting.body.layout().parameters.len();
        let mut places: Vec<usize> = self.setting.shared.iter().map(|s| s.place).collect();
        places.extend(first..first + grammar.terms.len());
        (grammar.motion(conditions, first), places)
    }

    /// Hands out a track's residuals with their derivatives by everything there is.
    ///
    /// # Errors
    /// In words, where the flight is impossible.
    pub(crate) fn each_residual_further(
        &self,
        setting: &Setting,
        track: &Track,
        unknowns: (&DVector<f64>, &DVector<f64>),
        each: impl FnMut(Residual<'_>),
    ) -> Result<(), String> {
        let conditions = conditions(setting, track, unknowns.0);
        match &self.grammar {
            Some(grammar) => {
                let (motion, places) = self.further(&conditions, grammar);
                each_residual(setting, track, unknowns, motion, &places, each)
            }
            None => {
                let places: Vec<usize> = self.setting.shared.iter().map(|s| s.place).collect();
                let motion = conditions.linear_motion();
                each_residual(setting, track, unknowns, motion, &places, each)
            }
        }
    }

    pub(crate) fn impossible(&self, flight: usize, reason: String) -> FitError {
        FitError::Flight {
            file: self.tracks[flight].file.clone(),
            reason,
        }
    }

    /// The model in which these candidates may be on, the others being off: for their derivatives it is quicker than one in which
    /// all may be.
    pub fn setting_with(&self, effects: &[usize]) -> Setting {
        let fixed = off(&self.catalogue, effects);
        Setting {
            body: Arc::new(Body::on_tape_at(&self.catalogue.model, &fixed)),
            ..self.setting.clone()
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

    /// The directions of a flight's chart that move the states of candidates which are not among `with`, and all others.
    pub(crate) fn directions(&self, flight: usize, with: &[usize]) -> (Vec<usize>, Vec<usize>) {
        let off = self.states_but(with);
        let chart = &self.tracks[flight].chart;
        let is_off = |direction: &usize| chart.plain(*direction).is_some_and(|s| off.contains(&s));
        (0..chart.dimension()).partition(is_off)
    }

    /// A flight's normal equations by its own unknowns without the states of candidates that are not among `with`; and which
    /// directions of its chart are left.
    pub(crate) fn own_of(
        &self,
        flight: usize,
        block: &Block,
        with: &[usize],
    ) -> (Block, Vec<usize>) {
        let (_, own) = self.directions(flight, with);
        (own_block(block, &own, &[]), own)
    }

    /// Fits the base and some candidates from a point on, all other candidates staying as they are there; the sum of squares
    /// that is left.
    ///
    /// # Errors
    /// In words, where that is impossible.
    pub fn refit(
        &self,
        setting: &Setting,
        with: &[usize],
        from: &Point,
        noise: &Noise,
    ) -> Result<(Point, f64), String> {
        let unknowns = self.unknowns(with);
        let setting = Setting {
            shared: unknowns
                .iter()
                .map(|&i| setting.shared[i].clone())
                .collect(),
            ..setting.clone()
        };
        let held = self.states_but(with);
        let tracks = self.tracks.iter().map(|track| {
            let mut known: Vec<usize> = track.known.iter().map(|(state, _)| *state).collect();
            known.extend(&held);
            let mut parameters = track.parameters.clone();
            for (unknown, value) in self.setting.shared.iter().zip(from.shared.iter()) {
                parameters[unknown.place] = *value;
            }
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
        let leapt = problem.stepped(&start);
        let found = leapt.and_then(|leapt| solve(&problem, leapt, STEPS).ok());
        let found = match found {
            Some(found) => found,
            None => solve(&problem, start, STEPS).map_err(|failure| failure.to_string())?,
        };
        let Solution { point, squares, .. } = found;
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

fn conditions<'a>(setting: &'a Setting, track: &Track, shared: &DVector<f64>) -> Conditions<'a> {
    setting.body.with(track.parameters(setting, shared))
}

/// Places and values of everything that is off where only these candidates are on.
fn off(catalogue: &Catalogue, on: &[usize]) -> Vec<(usize, f64)> {
    let layout = Layout::new(&catalogue.model);
    let each = catalogue.candidates.iter().enumerate();
    let parts = each
        .filter(|(index, _)| !on.contains(index))
        .flat_map(|(_, candidate)| &candidate.coefficients);
    let mut fixed: Vec<(usize, f64)> = parts
        .map(|part| (layout.coefficient(part.index).index(), part.null_value))
        .collect();
    let loads = catalogue.channels.iter().flat_map(|c| c.loads);
    fixed.extend(loads.filter_map(|(name, ..)| Some((layout.parameter(name)?.index(), 0.0))));
    fixed
}

/// The least squares of the base with some candidates.
struct Refit<'a> {
    setting: Setting,
    tracks: Vec<Track>,
    noise: &'a Noise,
    known: Vec<Known>,
    threads: usize,
}

impl Refit<'_> {
    /// The point after one whole step, even where the squares are greater there: a new effect bends the valley in which the
    /// solution lies, and to follow it in small steps takes long.
    fn stepped(&self, from: &Point) -> Option<Point> {
        let blocks = batch::each_on(self.threads, self.tracks.len(), |flight| {
            self.linearise(flight, &from.shared, &from.own[flight])
        });
        let blocks: Vec<Block> = blocks.into_iter().collect::<Result<_, _>>().ok()?;
        let system = eliminate(&blocks, 0.0).ok()?;
        let (matrix, gradient) = (&system.reduced, &system.gradient);
        let (step, _) = shared_step(matrix, gradient, &from.shared, &self.known, 0.0)?;
        let own = system.own_steps(&step);
        let own = own.iter().zip(&from.own).enumerate();
        let own = own.map(|(flight, (step, own))| self.moved(flight, own, step));
        Some(Point {
            own: own.collect(),
            shared: &from.shared + step,
        })
    }
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
