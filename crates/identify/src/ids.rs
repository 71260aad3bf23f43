//! Index types for flights, global parameters and local parameters of a fit.

use model_spec::index_type;

index_type!(
    /// Index of a flight in [`Dataset::flights`](dataset::Dataset::flights).
    pub struct FlightId;
);

index_type!(
    /// Index of a global parameter (estimated, common to all flights) in
    /// [`FitProblem::globals`](crate::FitProblem::globals), and in [`Iterate::global`](crate::Iterate::global).
    pub struct GlobalId;
);

index_type!(
    /// Index of a local unknown of a flight: a direction in which its initial state may vary (see
    /// [`StateManifold`](crate::StateManifold)).
    pub struct LocalId;
);
