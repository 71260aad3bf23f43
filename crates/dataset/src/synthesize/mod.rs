//! Synthetic datasets: simulated flights of a model whose marker positions are observed with measurement noise.
//!
//! The true values are returned as [`Truth`], for comparison with the estimates of a fit.

mod error;
mod maker;
mod noise;
mod spread;
mod truth;

use flight::CompiledModel;
use flight::release::Release;
use model_spec::model::Model;

pub use error::{OutOfRange, SimulationError, SynthesisError};
pub use noise::{Corruption, corrupt};
pub use spread::Spread;
pub use truth::Truth;

use self::maker::Maker;
use crate::{Dataset, Marker};

/// Maximum number of flights of a synthetic dataset.
const MAX_FLIGHTS: usize = 100_000;
/// Maximum product of the numbers of samples per flight, markers and flights of a synthetic dataset; it limits the
/// memory used.
const MAX_POINTS: f64 = 2e7;
/// Maximum sampling rate, Hz.
const MAX_RATE: f64 = 1e6;

/// Settings with which a synthetic dataset is generated.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// Number of flights. The given launch conditions ([`Release`]) are used in rotation.
    pub flights: usize,
    /// Number of held-out flights; they are the last ones of the dataset.
    pub held_out: usize,
    /// Time for which each flight is observed, s; `None` for the duration in the launch conditions ([`Release`]) of the
    /// flight. Flights whose launch conditions specify the ground as the end are observed until they reach the ground,
    /// but not longer than this time.
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
    /// Returns the settings for eight flights at 120 Hz, none held out, with positions rounded to 0.01 mm.
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
            let each = MARKERS.iter().enumerate();
            each.map(|(k, &position)| marker(&format!("m{}", k + 1), position))
                .collect()
        }
    }
}

/// Generates a synthetic dataset: simulates flights of a model and measures its markers with random errors. The launch
/// conditions in `releases` are used in rotation, and the initial state of each flight varies at random about the one
/// specified in its launch conditions.
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
        let (flight, state) =
            maker
                .flight(index, release)
                .map_err(|reason| SynthesisError::Flight {
                    number: index + 1,
                    reason,
                })?;
        let names = model.states.iter().map(|state| state.name.clone());
        initial.push((flight.file.clone(), names.zip(state).collect()));
        flights.push(flight);
    }
    let constants = releases[0].constants(
        model
            .params
            .iter()
            .chain(&model.coefficients)
            .map(|constant| (constant.name.as_str(), constant.value)),
    );
    let (parameters, coefficients) = constants.split_at(model.params.len());
    let named = |of: &[model_spec::model::Parameter], values: &[f64]| {
        let names = of.iter().map(|constant| constant.name.clone());
        names.zip(values.iter().copied()).collect()
    };
    Ok(SyntheticDataset {
        dataset: Dataset {
            model: model.name.clone(),
            parameters: named(&model.params, parameters),
            markers,
            flights,
            ..Dataset::default()
        },
        truth: Truth {
            model: model.name.clone(),
            effects: model.effects.iter().map(|on| on.name.clone()).collect(),
            coefficients: named(&model.coefficients, coefficients),
            noise: plan.noise,
            spread: plan.spread,
            seed: plan.seed,
            initial,
        },
    })
}

fn check(model: &Model, releases: &[Release], plan: &Plan) -> Result<(), SynthesisError> {
    let Some(first) = releases.first() else {
        return refuse("found no release, expected at least one");
    };
    let same = |release: &&Release| {
        release.parameters == first.parameters && release.coefficients == first.coefficients
    };
    if !releases.iter().all(|release| same(&release)) {
        return refuse(
            "found releases of different bodies, expected the same parameters and coefficients in all",
        );
    }
    if model.observation.is_none() {
        return refuse(format!("the model {} observes nothing", model.name));
    }
    OutOfRange::check("flights", plan.flights as f64, 1.0, MAX_FLIGHTS as f64)?;
    if plan.held_out > plan.flights {
        let (found, most) = (plan.held_out, plan.flights);
        return refuse(format!(
            "held-out: found {found}, expected at most the {most} flights"
        ));
    }
    if !(plan.rate > 0.0 && plan.rate <= MAX_RATE) {
        let found = plan.rate;
        return refuse(format!(
            "rate: found {found}, expected above 0 and up to {MAX_RATE} Hz"
        ));
    }
    if let Some(duration) = plan.duration
        && !(duration > 0.0 && duration <= Release::MAX_DURATION)
    {
        let most = Release::MAX_DURATION;
        return refuse(format!(
            "duration: found {duration}, expected above 0 and up to {most} s"
        ));
    }
    // The truth is written as TOML, which has no larger integers.
    if i64::try_from(plan.seed).is_err() {
        let (found, most) = (plan.seed, i64::MAX);
        return refuse(format!("seed: found {found}, expected at most {most}"));
    }
    plan.noise.check()?;
    plan.spread.check()?;
    Ok(())
}
