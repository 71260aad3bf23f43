//! What a fit found, put in order.

use std::collections::BTreeMap;

use nalgebra::{DMatrix, DVector};

use super::flown::Flown;
use super::look::{Looked, NOTHING, joined, look};
use super::problem::Squares;
use super::{FitError, State, told};
use crate::dataset::Flight;
use crate::levenberg::Solution;
use crate::noise::{Noise, median};
use crate::normal::eliminate;
use crate::options::Options;
use crate::predict::Loss;
use crate::report::{
    AxisNoise, Coefficient, Estimate, FlightReport, Iterations, Profile, Report, residuals::Pool,
};
use crate::setting::Setting;
use crate::track::Track;
use crate::uncertainty::{Covariance, Support, interval, profile, undetermined};

const AXES: [&str; 3] = ["x", "y", "z"];

/// A solution with what it is worth.
pub struct Outcome<'a> {
    setting: &'a Setting,
    state: &'a State,
    noise: &'a Noise,
    solution: &'a Solution,
    covariance: Covariance,
    flights: Vec<One>,
    /// The median of those root mean squares, m.
    usual: f64,
    pool: Pool,
    support: Support,
    profiles: Vec<Profile>,
}

/// One flight.
struct One {
    /// Root mean square of its residuals, m.
    rms: f64,
    /// Points that were left out of it.
    outliers: usize,
    initial: BTreeMap<String, Estimate>,
}

impl<'a> Outcome<'a> {
    /// Works out what a solution is worth, from the flights as it flies them.
    ///
    /// # Errors
    /// [`FitError`] where a flight does not determine its initial state, or is impossible.
    pub fn new(
        setting: &'a Setting,
        state: &'a State,
        flown: Flown,
        noise: &'a Noise,
        solution: &'a Solution,
        options: &Options<'_>,
    ) -> Result<Self, FitError> {
        let system = eliminate(&solution.blocks, 0.0)
            .map_err(|flight| told(flight.into(), &state.tracks))?;
        let covariance = Covariance::new(&system, state.tracks.len(), &setting.shared);
        let mut profiles = Vec::new();
        let errors = covariance.errors();
        for name in options.profiles {
            let index = setting
                .shared
                .iter()
                .position(|shared| shared.name == *name);
            let Some(index) = index else { continue };
            options.begins(&format!("profile of {name}"), state.tracks.len());
            let loss = Loss::Whitened(noise);
            let problem = Squares::of_all(setting, &state.tracks, loss, options);
            let found = profile(&problem, solution, &setting.shared, index, errors[index]);
            profiles.push(found.map_err(|failure| told(failure, &state.tracks))?);
        }
        let looked = flight::batch::each_on(options.threads(), state.tracks.len(), |index| {
            let (track, path) = (&state.tracks[index], flown.path(&state.tracks, index)?);
            let looked = look(setting, track, noise, &state.shared, path);
            let covariance = system.own_covariance(index, &covariance.model);
            let initial = initial(setting, track, &solution.point.own[index], &covariance);
            Ok((looked, initial))
        });
        let mut pool = Pool::default();
        let layout = setting.body.layout();
        let names = layout.quantities.iter().chain(&layout.states);
        let mut support = vec![NOTHING; layout.quantities.len() + layout.states.len()];
        let mut flights = Vec::with_capacity(looked.len());
        for looked in looked {
            let (looked, initial): (Looked, _) = looked?;
            pool.join(looked.pool);
            for (range, seen) in support.iter_mut().zip(looked.support) {
                *range = joined(*range, seen);
            }
            flights.push(One {
                rms: looked.rms,
                outliers: looked.outliers,
                initial,
            });
        }
        let mut sizes: Vec<f64> = flights.iter().map(|flight| flight.rms).collect();
        Ok(Self {
            setting,
            state,
            noise,
            solution,
            covariance,
            flights,
            usual: median(&mut sizes),
            pool,
            support: names
                .cloned()
                .zip(support)
                .filter(|(_, seen)| *seen != NOTHING)
                .collect(),
            profiles,
        })
    }

    /// The report, without its flights.
    pub fn report(&self) -> Report {
        let setting = self.setting;
        let names: Vec<&str> = setting
            .shared
            .iter()
            .map(|shared| shared.name.as_str())
            .collect();
        let matrix = self.covariance.correlations();
        let correlations = (0..names.len()).map(|i| {
            let row = names
                .iter()
                .enumerate()
                .map(|(j, name)| ((*name).to_owned(), matrix[(i, j)]));
            (names[i].to_owned(), row.collect())
        });
        let points: usize = self
            .state
            .tracks
            .iter()
            .map(|track| track.seen.iter().flatten().count())
            .sum();
        let all: usize = self.state.tracks.iter().map(|track| track.seen.len()).sum();
        let outliers = self.flights.iter().map(|flight| flight.outliers).sum();
        Report {
            schema: "hyzer.fit/1".into(),
            model: setting.model.name.clone(),
            effects: setting
                .model
                .effects
                .iter()
                .map(|effect| effect.name.clone())
                .collect(),
            rms_m: self.pool.rms(),
            noise: self.noise_report(points, outliers, all - points),
            coefficients: self.coefficients(),
            correlations: correlations.collect(),
            flights: Vec::new(),
            undetermined: undetermined(
                &setting.model,
                &setting.shared,
                &self.covariance.model,
                &self.support,
            ),
            profiles: self.profiles.clone(),
            residuals: self.pool.axes(),
            iterations: Iterations {
                steps: self.state.steps,
                rounds: self.state.rounds,
                converged: self.solution.converged,
            },
            seconds: BTreeMap::new(),
        }
    }

    fn noise_report(
        &self,
        points: usize,
        outliers: usize,
        dropouts: usize,
    ) -> crate::report::Noise {
        let noise = self.noise;
        let axis = |(k, name): (usize, &&str)| {
            let (sigma_m, ar1) = (noise.sigma[k], noise.ar1[k]);
            ((*name).to_owned(), AxisNoise { sigma_m, ar1 })
        };
        crate::report::Noise {
            sigma_m: noise.overall(),
            ar1: noise.ar1.iter().sum::<f64>() / 3.0,
            estimated: self.setting.sigma.is_none(),
            axes: AXES.iter().enumerate().map(axis).collect(),
            interval_s: noise.interval,
            points,
            outliers,
            outlier_fraction: outliers as f64 / points.max(1) as f64,
            dropouts,
        }
    }

    fn coefficients(&self) -> BTreeMap<String, Coefficient> {
        let errors = self.covariance.errors();
        let clustered = self.covariance.clustered_errors();
        let estimated = self.setting.shared.iter().enumerate().map(|(i, shared)| {
            let value = self.solution.point.shared[i];
            let (low, high) = shared.known.bounds;
            let coefficient = Coefficient {
                value,
                std_error: errors[i],
                std_error_clustered: clustered.as_ref().map(|errors| errors[i]),
                interval: interval(value, errors[i]),
                unit: shared.unit.clone(),
                at_bound: value <= low || value >= high,
                held: false,
                model_value: shared.model_value,
                prior: shared.known.prior.map(|(value, sigma)| [value, sigma]),
            };
            (shared.name.clone(), coefficient)
        });
        let constants = &self.setting.model.coefficients;
        let held = self.setting.held.iter().map(|(name, value)| {
            let constant = constants.iter().find(|constant| constant.name == *name);
            let coefficient = Coefficient {
                value: *value,
                std_error: 0.0,
                std_error_clustered: None,
                interval: [*value; 2],
                unit: constant.map(|c| c.unit_text.clone()).unwrap_or_default(),
                at_bound: false,
                held: true,
                model_value: constant.map_or(*value, |constant| constant.value),
                prior: None,
            };
            (name.clone(), coefficient)
        });
        estimated.chain(held).collect()
    }

    /// One of the fitted flights.
    pub fn flight(&self, index: usize) -> FlightReport {
        let track = &self.state.tracks[index];
        let flight = &self.flights[index];
        let mut notes = track.notes.clone();
        if let Some(note) = self.stands_out(flight.rms) {
            notes.push(note);
        }
        FlightReport {
            file: track.file.clone(),
            role: track.role,
            samples: track.samples,
            rms_m: flight.rms,
            outliers: flight.outliers,
            initial: flight.initial.clone(),
            cut: track.cut.clone(),
            notes,
        }
    }

    /// What is said of a flight that is fitted far worse than the others.
    fn stands_out(&self, rms: f64) -> Option<String> {
        (rms > 4.0 * self.usual).then(|| {
            format!(
                "its residuals are {:.0} times the usual: look at it before you rely on this fit",
                rms / self.usual
            )
        })
    }
}

/// The initial state of a flight with the standard errors by its chart's directions.
pub fn initial(
    setting: &Setting,
    track: &Track,
    own: &DVector<f64>,
    covariance: &DMatrix<f64>,
) -> BTreeMap<String, Estimate> {
    let names = &setting.body.layout().states;
    let mut along = DMatrix::zeros(names.len(), track.chart.dimension());
    for (state, direction, value) in track.chart.tangent(own.as_slice()) {
        along[(state, direction)] = value;
    }
    let covariance = &along * covariance * along.transpose();
    let estimate = |(i, name): (usize, &String)| {
        let std_error = covariance[(i, i)].max(0.0).sqrt();
        let value = own[i];
        (name.clone(), Estimate { value, std_error })
    };
    names.iter().enumerate().map(estimate).collect()
}

/// A flight that was left out.
pub fn left_out(flight: &Flight, reason: String) -> FlightReport {
    FlightReport {
        file: flight.file.clone(),
        role: flight.role,
        samples: flight.times.len(),
        rms_m: 0.0,
        outliers: 0,
        initial: BTreeMap::new(),
        cut: None,
        notes: vec![format!("left out: {reason}")],
    }
}
