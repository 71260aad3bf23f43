//! Datasets that are made, not measured: a model flies releases, and its markers are seen through noise.
//!
//! What was put in is the [`Truth`], so that what a fit finds can be held against it.

mod maker;
mod noise;
mod spread;
mod truth;

use flight::CompiledModel;
use flight::release::Release;
use model_spec::model::Model;

pub use noise::{Corruption, corrupt};
pub use spread::Spread;
pub use truth::Truth;

use self::maker::Maker;
use crate::dataset::{Dataset, Marker};

/// Most flights of a dataset.
const MOST_FLIGHTS: usize = 100_000;
/// Most marker points of a dataset: they bound the memory that it takes.
const MOST_POINTS: f64 = 2e7;
/// Highest rate, Hz.
const FASTEST: f64 = 1e6;

/// What is to be made.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// How many flights; they take the releases in turn.
    pub flights: usize,
    /// How many of them, the last, are held out.
    pub held_out: usize,
    /// How long each is watched, s; by default as its release says. A release until the ground ends there in any case.
    pub duration: Option<f64>,
    /// Samples per second.
    pub rate: f64,
    /// What is tracked; where none is given, see [`default_markers`].
    pub markers: Vec<Marker>,
    /// How the flights differ.
    pub spread: Spread,
    /// How they are seen.
    pub noise: Corruption,
    /// Decimals of a metre to which positions are rounded; none for all digits.
    pub decimals: Option<u8>,
    /// Seed of everything random.
    pub seed: u64,
}

impl Default for Plan {
    /// Eight flights at 120 Hz, none held out, to 0.01 mm.
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

/// Why a dataset cannot be made.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SynthesisError {
    /// Something that was asked for makes no sense.
    #[error("{0}")]
    Plan(String),
    /// A flight is impossible.
    #[error("flight {number}: {reason}")]
    Flight {
        /// Its number, from 1.
        number: usize,
        /// In words.
        reason: String,
    },
}

fn refuse<T>(why: impl Into<String>) -> Result<T, SynthesisError> {
    Err(SynthesisError::Plan(why.into()))
}

/// A dataset and what is behind it.
#[derive(Clone, Debug, PartialEq)]
pub struct Made {
    /// What would have been measured.
    pub dataset: Dataset,
    /// What was put in.
    pub truth: Truth,
}

/// Three points of a disc that are not in line, as the paper's markers were, m.
pub const MARKERS: [[f64; 3]; 3] = [
    [0.1, 0.0, 0.01],
    [-0.05, 0.0866, 0.01],
    [-0.04, -0.08, 0.01],
];

/// [`MARKERS`] of a rigid body; of a point mass its centre.
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

/// Flies releases of a model and observes its markers: as many flights as planned, each around its release.
///
/// # Errors
/// See [`SynthesisError`].
pub fn flights(model: &Model, releases: &[Release], plan: &Plan) -> Result<Made, SynthesisError> {
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
    Ok(Made {
        dataset: Dataset {
            model: model.name.clone(),
            parameters: named(&model.params, parameters),
            markers,
            sigma: None,
            flights,
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
    if !(1..=MOST_FLIGHTS).contains(&plan.flights) {
        let found = plan.flights;
        return refuse(format!(
            "flights: found {found}, expected 1 to {MOST_FLIGHTS}"
        ));
    }
    if plan.held_out > plan.flights {
        let (found, most) = (plan.held_out, plan.flights);
        return refuse(format!(
            "held-out: found {found}, expected at most the {most} flights"
        ));
    }
    if !(plan.rate > 0.0 && plan.rate <= FASTEST) {
        let found = plan.rate;
        return refuse(format!(
            "rate: found {found}, expected above 0 and up to {FASTEST} Hz"
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
    // TOML, where the truth is written, has no larger integers.
    if i64::try_from(plan.seed).is_err() {
        let (found, most) = (plan.seed, i64::MAX);
        return refuse(format!("seed: found {found}, expected at most {most}"));
    }
    let checks = plan.noise.check().and(plan.spread.check());
    checks.map_err(SynthesisError::Plan)
}
