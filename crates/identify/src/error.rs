//! Why a dataset cannot be fitted, and why one flight cannot be used.

use crate::ids::FlightId;
use crate::wording::count;

/// Why one flight cannot be fitted or predicted.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FlightError {
    /// No sample has a measured marker.
    #[error("no marker is measured in any of its samples")]
    NoMeasurement,
    /// Fewer measured coordinates than unknowns of the initial state.
    #[error(
        "{measured} measured coordinates do not determine the {unknowns} unknowns of its initial state"
    )]
    TooFewCoordinates {
        /// Number of measured coordinates.
        measured: usize,
        /// Number of directions in which the initial state may be varied.
        unknowns: usize,
    },
    /// A known quantity has a name that the model does not have.
    #[error(
        "{name} is given as known, and the model {model} has the vectors and numbers {}",
        available.join(", ")
    )]
    UnknownKnownValue {
        /// The name in the dataset.
        name: String,
        /// Name of the model.
        model: String,
        /// Inputs, constants and states of the model.
        available: Vec<String>,
    },
    /// A parameter is known for this flight and estimated for all flights.
    #[error("{name} is given as known, and it is to be estimated for all flights")]
    KnownAndEstimated {
        /// The parameter.
        name: String,
    },
    /// Some components of a unit quaternion are known and others are not.
    #[error("{known} is given as known; a quaternion is known as a whole ({}) or not at all", components.join(", "))]
    PartialQuaternion {
        /// A component that is known.
        known: String,
        /// All components.
        components: Vec<String>,
    },
    /// Too few samples show the pose of a rigid body.
    #[error(
        "only {found} of its samples show three markers that are not collinear, and an initial guess needs {needed}"
    )]
    TooFewPoses {
        /// Samples that show a pose.
        found: usize,
        /// Samples that are needed.
        needed: usize,
    },
    /// Too few samples show the position of a point mass.
    #[error("only {found} of its samples show a position, and an initial guess needs {needed}")]
    TooFewPositions {
        /// Samples that show a position.
        found: usize,
        /// Samples that are needed.
        needed: usize,
    },
    /// No pair of poses is near enough in time to give an angular velocity.
    #[error("no two neighbouring samples show three markers each")]
    NoNeighbouringPoses,
    /// The model has no state within its domain of validity that moves as the markers do.
    #[error("the model has no state within its limits that moves as the markers do")]
    NoMatchingState,
    /// The trajectory cannot be integrated.
    #[error(transparent)]
    Integration(#[from] ode::IntegrationError),
    /// The normal equations of the initial state are singular.
    #[error("its samples do not determine its initial state")]
    SingularInitialState,
    /// All samples of a held-out flight belong to the conditioning segment.
    #[error("too short: no samples remain to be predicted after its first {samples}")]
    NothingToPredict {
        /// Samples of the conditioning segment.
        samples: usize,
    },
    /// No marker is measured after the conditioning segment of a held-out flight.
    #[error("no marker is measured in the samples that are to be predicted")]
    NothingMeasuredToPredict,
    /// The work was cancelled.
    #[error("interrupted")]
    Interrupted,
}

/// Where an unknown name comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NameSource {
    /// `[parameters]` of the dataset.
    DatasetParameters,
    /// [`FitOptions::fixed`](crate::FitOptions::fixed).
    Fixed,
    /// [`FitOptions::free`](crate::FitOptions::free).
    Free,
    /// [`FitOptions::priors`](crate::FitOptions::priors).
    Prior,
    /// [`FitOptions::profiles`](crate::FitOptions::profiles).
    Profile,
}

impl NameSource {
    fn phrase(self) -> &'static str {
        match self {
            Self::DatasetParameters => "the dataset sets",
            Self::Fixed => "to be held is",
            Self::Free => "to be freed is",
            Self::Prior => "a prior is given for",
            Self::Profile => "a profile is requested of",
        }
    }
}

/// A flight that cannot be used, with the reason.
#[derive(Clone, Debug, PartialEq)]
pub struct ExcludedFlight {
    /// The flight.
    pub flight: FlightId,
    /// Its file.
    pub file: String,
    /// Why it cannot be used.
    pub reason: FlightError,
}

/// Why a dataset cannot be fitted.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FitError {
    /// A name in the dataset or the options that the model does not have.
    #[error("{} {name}, and the model {model} has {}", given_in.phrase(), available.join(", "))]
    UnknownName {
        /// Where the name stands.
        given_in: NameSource,
        /// The name.
        name: String,
        /// Name of the model.
        model: String,
        /// Names that are possible there.
        available: Vec<String>,
    },
    /// A prior or a profile of a parameter that is fixed.
    #[error("{} {name}, which is not estimated", given_in.phrase())]
    NotEstimated {
        /// [`NameSource::Prior`] or [`NameSource::Profile`].
        given_in: NameSource,
        /// The parameter.
        name: String,
    },
    /// A number in the options is outside its range.
    #[error("{option} of {name} is {value}, expected {expected}")]
    InvalidOption {
        /// The option.
        option: &'static str,
        /// The parameter that it belongs to.
        name: String,
        /// The number.
        value: f64,
        /// What is allowed.
        expected: &'static str,
    },
    /// The model has no measurement equation.
    #[error("the model {model} does not say what is observed of it")]
    NoObservation {
        /// Name of the model.
        model: String,
    },
    /// The markers do not determine the attitude of a body that rotates.
    #[error(
        "the model {model} turns, and {} do not show how: three are needed that are not in line",
        count(*markers, "marker")
    )]
    AttitudeNotObservable {
        /// Name of the model.
        model: String,
        /// Number of markers.
        markers: usize,
    },
    /// Every flight of the dataset is held out.
    #[error("every flight is held out: none is left to fit")]
    NothingToFit,
    /// Values for a warm start do not match the unknowns in number.
    #[error(
        "a warm start needs {globals} global values and initial states of lengths {states:?}, one per fitted flight"
    )]
    WarmStartSize {
        /// Number of global parameters.
        globals: usize,
        /// Number of states of each fitted flight.
        states: Vec<usize>,
    },
    /// A flight cannot be used, and it stops the fit.
    #[error("{file}: {reason}")]
    Flight {
        /// Its file.
        file: String,
        /// Why it cannot be used.
        reason: FlightError,
    },
    /// No flight can be used.
    #[error("none of the flights can be fitted:\n{}", first_reasons(.0))]
    NoUsableFlight(Vec<ExcludedFlight>),
    /// The work was cancelled.
    #[error("interrupted")]
    Interrupted,
}

/// Number of excluded flights that a message lists.
const MAX_LISTED_FLIGHTS: usize = 10;

fn first_reasons(excluded: &[ExcludedFlight]) -> String {
    let each = excluded.iter().take(MAX_LISTED_FLIGHTS);
    let reasons: Vec<String> = each
        .map(|flight| format!("  {}: {}", flight.file, flight.reason))
        .collect();
    reasons.join("\n")
}
