//! Synthetic datasets: simulated flights of a model whose marker positions are observed with measurement noise.
//!
//! The true values are returned as [`Truth`], for comparison with the estimates of a fit.

mod error;
mod maker;
mod noise;
mod spread;
mod truth;

use flight::release::Release;
use flight::{CompiledModel, InputInterpolation};
use model_spec::model::Model;

pub use error::{OutOfRange, SimulationError, SynthesisError};
pub use noise::{Corruption, corrupt};
pub use spread::Spread;
pub use truth::Truth;

use self::maker::Maker;
use crate::{Dataset, Marker};

const MAX_FLIGHTS: usize = 100_000;
/// Maximum product of samples per flight, markers and flights of a synthetic dataset; it limits the memory used.
const MAX_POINTS: f64 = 2e7;
const MAX_RATE: f64 = 1e6;

/// Settings with which a synthetic dataset is generated.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// Number of flights. The given launch conditions ([`Release`]) are used in rotation.
    pub flights: usize,
    /// Number of held-out flights; they are the last ones of the dataset.
    pub held_out: usize,
    /// Time for which each flight is observed, s; `None` for the duration in its [`Release`]. Flights that end at the
    /// ground are observed until then, but not longer than this time.
    pub duration: Option<f64>,
    /// Sampling rate, Hz.
    pub rate: f64,
    /// Tracked markers; if empty, those of [`default_markers`] are used.
    pub markers: Vec<Marker>,
    /// Random variation of the initial states between flights.
    pub spread: Spread,
    /// Measurement noise, outliers and dropouts (missing positions).
    pub noise: Corruption,
    /// Number of decimals to which positions in metres are rounded; `None` for no rounding.
    pub decimals: Option<u8>,
    /// Seed of the random number generators.
    pub seed: u64,
}

impl Default for Plan {
    fn default() -> Self {
        Self {
            flights: 8,
            held_out: 0,
            duration: None,
            rate: 120.0,
            markers: Vec::new(),
            spread: Spread::default(),
            noise: Corruption::default(),
            decimals: Some(5),
            seed: 1,
        }
    }
}

fn refuse<T>(why: impl Into<String>) -> Result<T, SynthesisError> {
    Err(SynthesisError::Plan(why.into()))
}

/// A synthetic dataset with its true values.
#[derive(Clone, Debug, PartialEq)]
pub struct SyntheticDataset {
    /// The simulated flights, as a dataset of the same form as a measured one.
    pub dataset: Dataset,
    /// True values from which the dataset was generated.
    pub truth: Truth,
}

/// Default marker positions on a disc, in body axes, m: three points that are not collinear, about 0.1 m from the axis.
pub const MARKERS: [[f64; 3]; 3] = [
    [0.1, 0.0, 0.01],
    [-0.05, 0.0866, 0.01],
    [-0.04, -0.08, 0.01],
];

/// Default markers of a model: [`MARKERS`] for a rigid body, and one marker at the centre for a point mass.
pub fn default_markers(model: &Model) -> Vec<Marker> {
    let marker = |name: &str, position| Marker {
        name: name.into(),
        position,
    };
    match &model.body {
        Some(body) if body.rotation.is_none() => vec![marker("centre", [0.0; 3])],
        _ => {
            let each = MARKERS.into_iter().zip(1..);
            each.map(|(position, k)| marker(&format!("m{k}"), position))
                .collect()
        }
    }
}

/// Simulates flights of a model and measures its markers with errors. The launch conditions in `releases` are used in
/// turn, and the initial state of each flight varies at random about that of its launch conditions.
///
/// # Errors
/// [`SynthesisError::Plan`] or [`SynthesisError::OutOfRange`] if the plan is invalid; [`SynthesisError::Flight`] if a
/// flight cannot be simulated.
pub fn flights(
    model: &Model,
    releases: &[Release],
    plan: &Plan,
) -> Result<SyntheticDataset, SynthesisError> {
    check(model, releases, plan)?;
    let markers = if plan.markers.is_empty() {
        default_markers(model)
    } else {
        plan.markers.clone()
    };
    let maker = Maker {
        model,
        plan,
        body: CompiledModel::new(model),
        positions: markers.iter().map(|marker| marker.position).collect(),
    };
    let mut flights = Vec::with_capacity(plan.flights);
    let mut initial = Vec::with_capacity(plan.flights);
    for index in 0..plan.flights {
        let release = &releases[index % releases.len()];
        let made = maker.flight(index, release);
        let (flight, state) = made.map_err(|reason| SynthesisError::Flight {
            number: index + 1,
            reason,
        })?;
        let names = model.states.iter().map(|state| state.name.clone());
        initial.push((flight.file.clone(), names.zip(state).collect()));
        flights.push(flight);
    }
    let constants = model.params.iter().chain(&model.coefficients);
    let defaults = constants
        .clone()
        .map(|constant| (constant.name.as_str(), constant.value));
    let values = releases[0].constants(defaults);
    let mut named = constants.zip(values);
    // An input at its default may be that of an effect, which the model that is fitted need not have.
    let parameters = named.by_ref().take(model.params.len());
    let stated = parameters.filter(|(own, value)| !own.varies || *value != own.value);
    let parameters = stated.map(|(own, value)| (own.name.clone(), value));
    let parameters = parameters.collect();
    let coefficients = named.map(|(own, value)| (own.name.clone(), value));
    Ok(SyntheticDataset {
        dataset: Dataset {
            model: model.name.clone(),
            parameters,
            markers,
            flights,
            input_interpolation: interpolations(releases).next().unwrap_or_default(),
            ..Dataset::default()
        },
        truth: Truth {
            model: model.name.clone(),
            effects: model.effects.iter().map(|on| on.name.clone()).collect(),
            coefficients: coefficients.collect(),
            noise: plan.noise,
            spread: plan.spread,
            seed: plan.seed,
            initial,
        },
    })
}

/// Interpolation of each input over time of each release.
fn interpolations(releases: &[Release]) -> impl Iterator<Item = InputInterpolation> {
    let inputs = releases.iter().flat_map(|release| &release.inputs);
    inputs.map(|(_, series)| series.interpolation())
}

fn check(model: &Model, releases: &[Release], plan: &Plan) -> Result<(), SynthesisError> {
    let Some(first) = releases.first() else {
        return refuse("found no release, expected at least one");
    };
    let is_same = |release: &Release| {
        release.parameters == first.parameters && release.coefficients == first.coefficients
    };
    OutOfRange::check("flights", plan.flights as f64, 1.0, MAX_FLIGHTS as f64)?;
    let (rate, most) = (plan.rate, Release::MAX_DURATION);
    let duration = plan.duration.unwrap_or(most);
    let checks = [
        (
            releases.iter().all(is_same),
            "found releases of different bodies, expected the same parameters and coefficients in all".into(),
        ),
        (
            interpolations(releases).is_sorted_by(|one, other| one == other),
            "found inputs over time of different interpolations, expected one for all of a dataset".into(),
        ),
        (
            model.observation.is_some(),
            format!("the model {} observes nothing", model.name),
        ),
        (
            plan.held_out <= plan.flights,
            format!("held-out: found {}, expected at most the {} flights", plan.held_out, plan.flights),
        ),
        (
            rate > 0.0 && rate <= MAX_RATE,
            format!("rate: found {rate}, expected above 0 and up to {MAX_RATE} Hz"),
        ),
        (
            duration > 0.0 && duration <= most,
            format!("duration: found {duration}, expected above 0 and up to {most} s"),
        ),
        (
            // The truth is written as TOML, which has no larger integers.
            i64::try_from(plan.seed).is_ok(),
            format!("seed: found {}, expected at most {}", plan.seed, i64::MAX),
        ),
    ];
    if let Some((_, why)) = checks.into_iter().find(|(is_met, _)| !is_met) {
        return refuse(why);
    }
    plan.noise.check()?;
    plan.spread.check()?;
    Ok(())
}
