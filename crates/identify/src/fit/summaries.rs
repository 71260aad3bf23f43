//! Flights that are summaries in a fit: their initial states by their releases, before noise is estimated.

use super::FitError;
use super::residual_cache::ResidualCache;
use super::state::State;
use crate::channel::{Channel, ChannelKind};
use crate::error::{ExcludedFlight, FlightError};
use crate::ids::FlightId;
use crate::numbers::significant;
use crate::observations::Observations;
use crate::problem::FitProblem;
use crate::summary::SummaryModel;
use crate::summary_value::{ASSUMED, SummaryValue, of_unit};
use dataset::{Dataset, Sensor, SummaryQuantity};
use flight::throw::Throw;
use nalgebra::DVector;
use std::fmt::{self, Display};

/// Flights of summaries with their initial states, and those that cannot be used.
#[derive(Default)]
pub struct Summaries {
    found: Vec<(FlightId, Observations, DVector<f64>)>,
    excluded: Vec<ExcludedFlight>,
}

impl Summaries {
    /// Takes the flights that are summaries out of `flights`.
    pub fn take(problem: &FitProblem, dataset: &Dataset, flights: &mut Vec<FlightId>) -> Self {
        let mut own = Self::default();
        if problem.summary.is_none() {
            return own;
        }
        flights.retain(|&flight| {
            let data = &dataset.flights[flight.index()];
            if !dataset.is_summary(data) {
                return true;
            }
            let found = Observations::new(problem, data).and_then(|observations| {
                let state = initial_state(problem, &observations)?;
                Ok((flight, observations, state))
            });
            match found {
                Ok(found) => own.found.push(found),
                Err(reason) => own.excluded.push(ExcludedFlight {
                    flight,
                    file: data.file.clone(),
                    reason,
                }),
            }
            false
        });
        own
    }

    pub fn is_empty(&self) -> bool {
        self.found.is_empty() && self.excluded.is_empty()
    }

    pub fn observations(&self) -> impl Iterator<Item = &Observations> + Clone {
        self.found.iter().map(|(_, observations, _)| observations)
    }

    /// Adds the flights to a fit in progress, and returns the residuals of all its flights.
    pub fn join(self, state: &mut State<'_>) -> Result<ResidualCache, FitError> {
        state.excluded.extend(self.excluded);
        for (flight, observations, local) in self.found {
            state.push(flight, observations, local);
        }
        state.exclude(Vec::new())?;
        state.flown_residuals()
    }
}

/// Initial state of a summary by its release.
pub fn initial_state(
    problem: &FitProblem,
    observations: &Observations,
) -> Result<DVector<f64>, FlightError> {
    let summary = problem.summary.as_ref().ok_or(FlightError::NoMeasurement)?;
    let state = summary.initial_state(problem, observations)?;
    Ok(observations.with_known_states(DVector::from_vec(state)))
}

/// What a row is assumed to have where it does not tell it: the quantity, value and standard deviation, and which rows.
/// `None` for a channel that is no such assumption, or one that a standard deviation takes as exact.
pub fn assumed<'o>(
    channel: &Channel,
    index: usize,
    rows: impl Iterator<Item = &'o Observations>,
) -> Option<Assumed> {
    let (Some(value), ChannelKind::Summary(SummaryValue::Column(quantity))) =
        (channel.assumed, channel.kind)
    else {
        return None;
    };
    let unit = quantity.si_unit();
    let sigma = channel
        .sigma
        .filter(|sigma| *sigma > of_unit(&ASSUMED, unit))?;
    let (mut lacking, mut all) = (0, 0);
    for row in rows {
        all += 1;
        lacking += usize::from(row.value(0, index).is_some());
    }
    let (value, sigma) = (significant(value, 3), significant(sigma, 3));
    Some(Assumed {
        quantity: quantity.name(),
        value: format!("{value} ± {sigma} {unit}"),
        more: format!("{sigma} {unit}"),
        lacking,
        all,
    })
}

/// An assumption of the releases of rows, in words.
pub struct Assumed {
    quantity: &'static str,
    value: String,
    /// Its standard deviation, with unit.
    pub more: String,
    lacking: usize,
    all: usize,
}

impl Display for Assumed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Assumed {
            quantity,
            value,
            lacking,
            all,
            ..
        } = self;
        match lacking == all {
            true => write!(
                f,
                "no column tells the {quantity}, which each row is assumed to have as {value}"
            ),
            false => write!(
                f,
                "{lacking} of {all} rows have no {quantity}, and are assumed to have {value}"
            ),
        }
    }
}

/// What rows are assumed to have, one sentence for each quantity.
pub fn assumptions<'o>(
    problem: &FitProblem,
    rows: impl Iterator<Item = &'o Observations> + Clone,
) -> Vec<String> {
    let channels = problem.channels.iter().enumerate();
    let found = channels.filter_map(|(index, own)| assumed(own, index, rows.clone()));
    found
        .filter(|own| own.lacking > 0)
        .map(|own| own.to_string())
        .collect()
}

/// What the dataset says of its recordings, and which columns are taken as exact.
pub fn notes(problem: &FitProblem, dataset: &Dataset) -> Vec<String> {
    let exact = problem.channels.iter();
    let exact = exact.filter(|own| own.is_exact && own.assumed.is_none());
    let names: Vec<&str> = exact.map(|own| own.name.as_str()).collect();
    let note = format!(
        "{}: taken as exact, as their standard deviations are not stated",
        names.join(", ")
    );
    let notes = dataset.notes.iter().cloned();
    let notes = notes.chain((!names.is_empty()).then_some(note));
    notes.chain(spin_of_model(problem, dataset)).collect()
}

/// Which spin a point mass has by its model, where neither a column nor what is known of a flight tells one.
fn spin_of_model(problem: &FitProblem, dataset: &Dataset) -> Option<String> {
    problem.summary.as_ref()?;
    let spin = ChannelKind::Summary(SummaryValue::Column(SummaryQuantity::Spin));
    if problem.channels.iter().any(|own| own.kind == spin) {
        return None;
    }
    let input = { problem.model.inputs.iter() }.find(|own| own.name == Sensor::SPIN)?;
    let rows = dataset.flights.iter().filter(|own| dataset.is_summary(own));
    let lacking = rows
        .filter(|own| !own.known.contains_key(Sensor::SPIN))
        .count();
    let size = significant(nalgebra::Vector3::from(input.value).norm(), 3);
    (lacking > 0).then(|| {
        format!("no column tells the spin, which {lacking} rows have as in the model: {size} rad/s")
    })
}

impl SummaryModel {
    /// Initial state by the measured release, with assumptions where no column measures it.
    ///
    /// # Errors
    /// [`FlightError::NoRelease`] if the model has no such release.
    fn initial_state(
        &self,
        problem: &FitProblem,
        observations: &Observations,
    ) -> Result<Vec<f64>, FlightError> {
        let measured = |quantity: SummaryQuantity| {
            let mut channels = problem.channels.iter().enumerate();
            channels.find_map(|(index, own)| {
                let is_own = own.kind == ChannelKind::Summary(SummaryValue::Column(quantity));
                let value = observations.value(0, index).filter(|_| is_own)?;
                Some(value[0] * own.to_si)
            })
        };
        let angle = |quantity| measured(quantity).map(f64::to_degrees);
        let mut throw = Throw {
            heading: angle(SummaryQuantity::Heading).unwrap_or(0.0),
            launch: angle(SummaryQuantity::Launch).unwrap_or(0.0),
            height: measured(SummaryQuantity::Height).unwrap_or(0.0),
            ..Throw::at_speed(measured(SummaryQuantity::Speed).unwrap_or(0.0))
        };
        if self.thrown.has_attitude() {
            throw.nose = angle(SummaryQuantity::Nose);
            throw.hyzer = angle(SummaryQuantity::Hyzer);
            throw.spin = measured(SummaryQuantity::Spin).map(|spin| spin / flight::throw::RPM);
            throw.wobble = angle(SummaryQuantity::Wobble).filter(|_| throw.spin != Some(0.0));
        }
        let found = self
            .thrown
            .state(&throw, [0.0; 2], &observations.parameters);
        let mut state = found.map_err(|error| FlightError::NoRelease(error.to_string()))?;
        if let Some(places) = self.spin_states() {
            let (size, tilt) = (
                measured(SummaryQuantity::Spin).unwrap_or(0.0),
                measured(SummaryQuantity::SpinAxis).unwrap_or(0.0),
            );
            let motion = self.thrown.motion(&state, &observations.parameters);
            let along = motion.velocity.normalize();
            let left = nalgebra::Vector3::z().cross(&along).normalize();
            let spin = -size * (left * tilt.cos() + along.cross(&left) * tilt.sin());
            for (place, value) in places.into_iter().zip(spin.iter()) {
                state[place] = *value;
            }
        }
        Ok(state)
    }
}
