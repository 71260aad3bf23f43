//! Simulation of one synthetic flight: initial state, trajectory, marker positions and measurement noise.

use std::collections::BTreeMap;

use flight::release::{Release, Stop};
use flight::{CompiledModel, FlightParameters};
use model_spec::model::Model;
use ode::{Event, IntegrationOptions};
use rand::Rng;
use rand_chacha::ChaCha12Rng;
use rand_chacha::rand_core::SeedableRng;

use super::error::SimulationError;
use super::{MAX_POINTS, Plan, corrupt};
use crate::{Flight, KnownValue, Role};

/// Absolute (in the SI unit of each state) and relative integration tolerance.
const TOLERANCE: f64 = 1e-10;
/// Number of decimals to which sample times in seconds are rounded before the simulation, so that tables remain narrow.
const TIME_DECIMALS: i32 = 6;

/// Model, settings and marker positions that all flights of a synthetic dataset share.
pub(super) struct Maker<'a> {
    pub model: &'a Model,
    pub plan: &'a Plan,
    pub body: CompiledModel,
    pub positions: Vec<[f64; 3]>,
}

impl Maker<'_> {
    /// Simulates the flight `index` from `release` with a random initial state; returns it with noise, and that state.
    pub fn flight(
        &self,
        index: usize,
        release: &Release,
    ) -> Result<(Flight, Vec<f64>), SimulationError> {
        let plan = self.plan;
        // Each flight has its own random stream, so that an additional flight does not change the others.
        let mut random = ChaCha12Rng::seed_from_u64(plan.seed);
        random.set_stream(index as u64);
        let mut state = plan.spread.draw(self.model, &release.state(), &mut random);
        let parameters = self.body.release_parameters(release);
        if let Some(constraints) = self.body.constraints() {
            let constraints = constraints.bind(parameters.constants.clone());
            constraints.project(0.0, &mut state, None);
        }
        let times = self.times(release, &parameters, &state)?;
        let mut positions = self.observed(&parameters, &state, &times)?;
        corrupt(&mut positions, &plan.noise, random.next_u64());
        if let Some(decimals) = plan.decimals {
            for value in positions.iter_mut().flatten().flatten().flatten() {
                *value = rounded(*value, i32::from(decimals));
            }
        }
        let told = |(name, value): &(String, [f64; 3])| (name.clone(), KnownValue::Vector(*value));
        let mut known: BTreeMap<String, KnownValue> = release.known.iter().map(told).collect();
        if release.wind != [0.0; 3] {
            known.insert("wind".into(), KnownValue::Vector(release.wind));
        }
        let fitted = plan.flights - plan.held_out;
        let flight = Flight {
            file: format!("flight{:02}.csv", index + 1),
            role: if index < fitted {
                Role::Fit
            } else {
                Role::HeldOut
            },
            known,
            inputs: release.inputs.clone(),
            times,
            positions,
            ..Flight::default()
        };
        Ok((flight, state))
    }

    /// Sample times, s after launch, of the flight with the launch conditions `release` and the initial state `state`.
    fn times(
        &self,
        release: &Release,
        parameters: &FlightParameters,
        state: &[f64],
    ) -> Result<Vec<f64>, SimulationError> {
        let plan = self.plan;
        let end = match (plan.duration, release.stop) {
            (Some(duration), Stop::Duration(_)) | (None, Stop::Duration(duration)) => duration,
            (watched, Stop::Ground) => self.landing(parameters, state, watched)?,
        };
        let count = (end * plan.rate + 1e-9).floor() + 1.0;
        let points = count * self.positions.len() as f64 * plan.flights as f64;
        if points > MAX_POINTS {
            let samples = count;
            return Err(SimulationError::TooManyPoints { samples, points });
        }
        let time = |sample: usize| rounded(sample as f64 / plan.rate, TIME_DECIMALS);
        Ok((0..count as usize).map(time).collect())
    }

    /// Time at which the body reaches the ground, s, or `watched`, the end of the observed time, if that is earlier.
    fn landing(
        &self,
        parameters: &FlightParameters,
        state: &[f64],
        watched: Option<f64>,
    ) -> Result<f64, SimulationError> {
        let conditions = self.body.bind(parameters.clone());
        let height = self.body.place()[2].ok_or(SimulationError::NoHeight)?;
        let mut events = conditions.limits();
        events.push(Event::falls_to("ground", height, 0.0).terminal());
        let landed = conditions.integrate_to_end(
            (0.0, &state.into()),
            watched.unwrap_or(Release::MAX_DURATION),
            &IntegrationOptions::with_tolerance(TOLERANCE),
            &mut events,
        );
        let landed = landed?;
        if landed.event.is_some() || watched.is_some() {
            Ok(landed.time)
        } else {
            Err(SimulationError::NoLanding)
        }
    }

    /// Simulated marker positions without measurement errors at the sample times, as `[sample][marker]`, m.
    fn observed(
        &self,
        parameters: &FlightParameters,
        state: &[f64],
        times: &[f64],
    ) -> Result<Vec<Vec<Option<[f64; 3]>>>, SimulationError> {
        let conditions = self.body.bind(parameters.clone());
        let mut samples = vec![0.0; times.len() * state.len()];
        // A flight that leaves the model's domain of validity ends with an error.
        conditions.integrate_at(
            (0.0, &state.into()),
            times,
            &IntegrationOptions::with_tolerance(TOLERANCE),
            &mut conditions.limits(),
            &mut samples,
        )?;
        let mut observer = conditions.observer();
        let rows = times.iter().zip(samples.chunks(state.len()));
        let row = |(&t, x): (&f64, &[f64])| {
            let markers = self.positions.iter();
            markers
                .map(|marker| Some(observer.position(t, x, marker)))
                .collect()
        };
        Ok(rows.map(row).collect())
    }
}

fn rounded(value: f64, decimals: i32) -> f64 {
    let scale = 10.0_f64.powi(decimals);
    (value * scale).round() / scale
}
