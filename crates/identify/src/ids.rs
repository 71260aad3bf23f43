//! Index types for flights, global parameters and local parameters of a fit.

use model_spec::index_type;

index_type!(
    /// Index of a flight in [`Dataset::flights`](dataset::Dataset::flights).
    pub struct FlightId;
);

index_type!(
    /// Index of a global parameter in [`FitProblem::globals`](crate::FitProblem::globals).
    pub struct GlobalId;
);

index_type!(
    /// Index of a direction in which the initial state of a flight may vary (see
    /// [`StateManifold`](crate::StateManifold)).
    pub struct LocalId;
);
