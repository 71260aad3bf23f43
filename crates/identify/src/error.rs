//! Errors of a fit, and reasons for which a single flight cannot be used.

use std::fmt;

use crate::ids::FlightId;
use crate::wording::count;
use dataset::DataFault;

/// Reason why one flight cannot be fitted or predicted.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FlightError {
    /// No value is measured in any sample of the flight.
    #[error("no marker is measured in any of its samples")]
    NoMeasurement,
    /// The flight has fewer measured coordinates than its initial state has unknowns.
    #[error(
        "{measured} measured coordinates do not determine the {unknowns} unknowns of its initial state"
    )]
    TooFewCoordinates {
        /// Number of measured coordinates of the flight.
        measured: usize,
        /// Number of unknowns (free directions) of the initial state.
        unknowns: usize,
    },
    /// The dataset gives the known value of a quantity under a name that the model does not have.
    #[error(
        "{name} is given as known, and the model {model} has the vectors and numbers {}",
        available.join(", ")
    )]
    UnknownKnownValue {
        /// Name under which the dataset gives the value.
        name: String,
        /// Name of the model.
        model: String,
        /// Names that are allowed: inputs, constants and states of the model.
        available: Vec<String>,
    },
    /// The standard deviation of a known value that cannot be estimated for one flight, because it is no quantity that
    /// states can stand for.
    #[error("{name} is known with a standard deviation, and cannot be estimated for each flight")]
    SigmaOfConstant {
        /// Name of the known value.
        name: String,
    },
    /// An input over time that the model does not have.
    #[error(
        "its table has a column {name}, which is no marker, no sensor and no input of {model} ({})",
        inputs_of(available)
    )]
    UnknownInput {
        /// Name of the column.
        name: String,
        /// Name of the model.
        model: String,
        /// Names of the inputs of the model that may vary during a flight.
        available: Vec<String>,
    },
    /// An input over time that does not cover the flight.
    #[error(
        "the input {name} is given from {} to {} s, and the flight lasts from {} to {} s; expected values over all of it",
        given.0, given.1, needed.0, needed.1
    )]
    InputSpan {
        /// Name of the input.
        name: String,
        /// Times of its first and last sample, s.
        given: (f64, f64),
        /// Times of the first and last sample of the flight, s.
        needed: (f64, f64),
    },
    /// An input over time with a value outside the bounds that the model states.
    #[error(
        "the input {name} is {value} at {time} s; expected {} to {}, its bounds in the model, in SI units",
        bounds.0, bounds.1
    )]
    InputBounds {
        /// Name of the input.
        name: String,
        /// The first such value, SI.
        value: f64,
        /// Its time, s.
        time: f64,
        /// Least and greatest value of the input, SI.
        bounds: (f64, f64),
    },
    /// An input that is given over time is to be estimated as one number for all flights.
    #[error(
        "the input {name} is given over time, and it is to be estimated as one number for all flights: the effect bias_of_{name} estimates an error of its samples"
    )]
    RecordedAndEstimated {
        /// Name of the input.
        name: String,
    },
    /// A parameter is both known for one flight and estimated for all flights.
    #[error("{name} is given as known, and it is to be estimated for all flights")]
    KnownAndEstimated {
        /// Name of the parameter.
        name: String,
    },
    /// Some components of a unit quaternion are known and others are not.
    #[error("{known} is given as known; a quaternion is known as a whole ({}) or not at all", components.join(", "))]
    PartialQuaternion {
        /// Name of a quaternion component whose value is known.
        known: String,
        /// Names of all four components of the quaternion.
        components: Vec<String>,
    },
    /// No body has the moments of inertia that are given as known, for the stated reason.
    #[error("with its known values {0}")]
    Inertia(String),
    /// Too few samples determine the pose of the rigid body, so that there is no initial guess.
    #[error(
        "only {found} of its samples show three markers that are not collinear, and an initial guess needs {needed}"
    )]
    TooFewPoses {
        /// Number of samples of the flight that determine a pose.
        found: usize,
        /// Minimum number of samples with a pose for an initial guess.
        needed: usize,
    },
    /// Too few samples determine the position of the point mass, so that there is no initial guess.
    #[error("only {found} of its samples show a position, and an initial guess needs {needed}")]
    TooFewPositions {
        /// Number of samples of the flight that determine a position.
        found: usize,
        /// Minimum number of samples with a position for an initial guess.
        needed: usize,
    },
    /// Screening found a fault in the data of the flight.
    #[error("{}; {}", .0.detail, .0.correction)]
    DataFault(DataFault),
    /// No two samples with a pose are near enough in time to give an angular velocity.
    #[error("no two neighbouring samples show three markers each")]
    NoNeighbouringPoses,
    /// No state within the model's domain of validity reproduces the measured motion.
    #[error("the model has no state within its limits that moves as the markers do")]
    NoMatchingState,
    /// No state of the model has the release of the flight.
    #[error("its release: {0}")]
    NoRelease(String),
    /// The trajectory of the flight cannot be integrated numerically.
    #[error(transparent)]
    Integration(#[from] ode::IntegrationError),
    /// The normal equations of the initial state are singular: the samples do not determine it.
    #[error("its samples do not determine its initial state")]
    SingularInitialState,
    /// All samples of a held-out flight belong to its conditioning segment, so that none remains to be predicted.
    #[error("too short: no samples remain to be predicted after its first {samples}")]
    NothingToPredict {
        /// Number of samples in the conditioning segment, to which the initial state is fitted.
        samples: usize,
    },
    /// No marker is measured after the conditioning segment of a held-out flight.
    #[error("no marker is measured in the samples that are to be predicted")]
    NothingMeasuredToPredict,
    /// The residuals of the flight are far larger than those of the other flights, from every initial state tried.
    #[error(
        "its residuals are {:.0} mm, where those of the other flights are {:.1} mm: it does not fly as they do",
        1e3 * scale,
        1e3 * usual
    )]
    UnlikeTheOthers {
        /// Robust standard deviation of the residuals of this flight, m.
        scale: f64,
        /// Median of the robust standard deviations of the other flights' residuals, m.
        usual: f64,
    },
    /// The deadline of the fit passed, or the fit was cancelled, before the flight was processed.
    #[error("the time limit was reached before it was looked at")]
    Deadline,
}

/// Section of the dataset or option of the fit in which a name was given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NameSource {
    /// The name is a key of the section `[parameters]` of the dataset, the values of known constants.
    DatasetParameters,
    /// The name is in the option `FitOptions::fixed`, the coefficients that are not estimated.
    Fixed,
    /// The name is in `FitOptions::free`, the constants and components of inputs that are estimated, too.
    Free,
    /// The name is in the option `FitOptions::priors`, the Gaussian priors of parameters.
    Prior,
    /// The name is in the option `FitOptions::profiles`, the parameters whose profile likelihood is computed.
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

/// A flight that is excluded from the fit, with the reason.
#[derive(Clone, Debug, PartialEq)]
pub struct ExcludedFlight {
    /// Index of the flight in the dataset.
    pub flight: FlightId,
    /// File name of the flight.
    pub file: String,
    /// Reason why the flight cannot be used.
    pub reason: FlightError,
}

/// Reason why a dataset cannot be fitted.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FitError {
    /// The dataset or the options of the fit contain a name that the model does not have.
    #[error("{} {name}, and the model {model} has {}", given_in.phrase(), available.join(", "))]
    UnknownName {
        /// Place where the name is given: a section of the dataset or an option of the fit.
        given_in: NameSource,
        /// Name that the model does not have.
        name: String,
        /// Name of the model.
        model: String,
        /// Names that are allowed in the section or option `given_in`.
        available: Vec<String>,
    },
    /// A prior or a profile likelihood is requested for a parameter that is not estimated.
    #[error("{} {name}, which is not estimated", given_in.phrase())]
    NotEstimated {
        /// Option that names the parameter: [`NameSource::Prior`] or [`NameSource::Profile`].
        given_in: NameSource,
        /// Name of the parameter that is not estimated.
        name: String,
    },
    /// A value in the options is outside its allowed range.
    #[error("{option} of {name} is {value}, expected {expected}")]
    InvalidOption {
        /// Name of the option.
        option: &'static str,
        /// Name of the parameter to which the option applies.
        name: String,
        /// Value of the option, which is outside the allowed range.
        value: f64,
        /// Allowed range, as text for the message.
        expected: &'static str,
    },
    /// The model has no measurement equation, which gives the predicted position of a point of the body.
    #[error(
        "the model {model} does not say what is observed of it: add a marker and where it is seen, such as `marker spot in FRAME; observe spot = position + spot;`"
    )]
    NoObservation {
        /// Name of the model.
        model: String,
    },
    /// A constraint of the model depends on a coefficient that is to be estimated, so that the initial states of the
    /// flights would have to change with it.
    #[error(
        "found the coefficient {name} of the model {model} in a constraint; expected constraints of constants: declare it as `param`, or give its value with the dataset"
    )]
    Constraint {
        /// Name of the model.
        model: String,
        /// Name of the coefficient.
        name: String,
    },
    /// A quantity that the dataset calls unknown, or measured with an error, cannot be estimated for each flight.
    #[error("what the dataset has of single flights does not fit the model {model}: {reason}")]
    Unknown {
        /// Name of the model.
        model: String,
        /// Reason, as text for the message.
        reason: String,
    },
    /// No body has the moments of inertia that the dataset gives, for the stated reason.
    #[error("with the constants in [parameters] of the dataset {0}")]
    Inertia(String),
    /// The model has no measurement equation for a sensor of the dataset.
    #[error("the model {model} has no reading for the dataset's sensors: {reason}")]
    Sensor {
        /// Name of the model.
        model: String,
        /// Reason why the model has no measurement equation for the sensor, as text for the message.
        reason: String,
    },
    /// The body of the model rotates, but the markers do not determine its attitude.
    #[error(
        "the model {model} turns, and {} do not show how: three are needed that are not in line, or two that are not on the axis if it is fixed",
        count(*markers, "marker")
    )]
    AttitudeNotObservable {
        /// Name of the model.
        model: String,
        /// Number of markers of the dataset.
        markers: usize,
    },
    /// Every flight of the dataset is held out.
    #[error("every flight is held out: none is left to fit")]
    NothingToFit,
    /// The values given for a warm start do not match the number of global parameters or of states.
    #[error(
        "a warm start needs {globals} global values and initial states of lengths {states:?}, one per fitted flight"
    )]
    WarmStartSize {
        /// Number of global parameters, for each of which one starting value is required.
        globals: usize,
        /// Required number of initial-state values for each fitted flight.
        states: Vec<usize>,
    },
    /// The known values of a flight do not match the model, or the flight cannot be predicted from given values.
    #[error("{file}: {reason}")]
    Flight {
        /// File name of the flight.
        file: String,
        /// Reason why the flight cannot be used.
        reason: FlightError,
    },
    /// The data of every flight to be fitted have a fault. Contains the faults found.
    #[error("the data of every flight are faulty:\n{}\ncorrect them; if they are right as they are, `--trust-data` fits them", first(.0))]
    FaultyData(Vec<DataFault>),
    /// No flight can be fitted. Contains all excluded flights with their reasons.
    #[error("none of the flights can be fitted:\n{}", first(.0))]
    NoUsableFlight(Vec<ExcludedFlight>),
    /// The caller cancelled the fit.
    #[error("interrupted")]
    Interrupted,
}

/// Maximum number of excluded flights or data faults that an error message lists.
const MAX_LISTED_FLIGHTS: usize = 10;

fn first(all: &[impl fmt::Display]) -> String {
    let each = all.iter().take(MAX_LISTED_FLIGHTS);
    let lines: Vec<String> = each.map(|own| format!("  {own}")).collect();
    lines.join("\n")
}

impl fmt::Display for ExcludedFlight {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.file, self.reason)
    }
}

fn inputs_of(available: &[String]) -> String {
    match available.is_empty() {
        true => "it has no scalar input: `input NAME: UNIT = DEFAULT;`".to_owned(),
        false => format!("it has {}", available.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_lists_the_first_faults() {
        let faults = (1..=12).map(|number| DataFault {
            file: format!("{number}.csv"),
            fault: dataset::FaultKind::Units,
            detail: "feet".to_owned(),
            correction: "state metres".to_owned(),
        });
        let text = FitError::FaultyData(faults.collect()).to_string();
        assert!(
            text.contains(" 1.csv: feet") && text.contains(" 10.csv: feet"),
            "{text}"
        );
        assert!(!text.contains("11.csv"), "{text}");
    }
}
