//! Estimates aerodynamic coefficients from measured flights: the output-error fit of a model to all flights at once.
//!
//! [`fit`] determines its own initial guesses and minimises the residuals, weighted by a noise model that it estimates,
//! with the exact sensitivities of the compiled model. Its [`Fit`] holds a [`FitReport`].

mod assumptions;
mod channel;
mod contact_time;
mod error;
mod fit;
mod ids;
mod initial_state;
mod inputs;
mod lack_of_fit;
mod least_squares;
mod noise;
mod noise_floor;
pub mod numbers;
mod observations;
mod observers;
mod options;
pub mod outliers;
mod predict;
mod problem;
mod report;
mod rounding;
mod screening;
mod state_manifold;
mod summary;
mod summary_value;
mod uncertainty;
mod unknowns;
mod vertical;
pub mod wording;

// Fitting a dataset.
pub use error::{ExcludedFlight, FitError, FlightError, NameSource};
pub use fit::{CONDITIONING_FRACTION, Fit, fit_observations, refit};
pub use ids::{FlightId, GlobalId, LocalId};
pub use options::{CancellationToken, FitOptions, Prior, Progress};

// The report of a fit.
pub use report::{
    AxisNoise, AxisResiduals, Coefficient, Estimate, FitReport, FitStatus, FlightEvidence,
    FlightOutcome, FlightReport, InputNoise, Iterations, LackOfFit, MarkerDistance, MissingTerm,
    NoiseReport, NonIdentifiable, Profile, Rms, SeenValue, SensorEvidence, SensorReport,
    SmoothMisfit, convergence_caution, exclusion_caution, input_noise, leading_noise,
};
pub use uncertainty::interval;

pub use unknowns::{Resolved, fit, resolve};
pub use vertical::{ANGLES as VERTICAL_ANGLES, upward};

// The estimation problem, and predictions with their derivatives.
pub use channel::{Channel, ChannelKind, MARKER};
pub use initial_state::{InitialGuess, initial_guesses, state_for_motion};
pub use noise::{AxesNoise, Moments, NoiseModel, group_count};
pub use observations::{Observations, Truncation};
pub use predict::{FlightAt, Loss, PointResidual, Residuals};
pub use problem::{FitProblem, GlobalParameter};
pub use state_manifold::StateManifold;
pub use summary::SummaryModel;
pub use summary_value::SummaryValue;

// Mistakes in the data.
pub use dataset::{DataFault, FaultKind};

// Least squares over many flights.
pub use least_squares::{
    Constraint, FailedFlight, Iterate, LeastSquaresProblem, NormalBlock, ReducedSystem, Solution,
    SolveError, StopReason, StoppingCriteria, UndeterminedFlight, Unknowns, add_priors, eliminate,
    pseudo_inverse, solve, solve_with_watchdog,
};
