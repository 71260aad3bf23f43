//! Index types of a fit.

use model_spec::index_type;

index_type!(
    /// Index of a flight in [`Dataset::flights`](crate::dataset::Dataset::flights).
    pub struct FlightId;
);

index_type!(
    /// Index of a global parameter in [`FitProblem::globals`](crate::FitProblem::globals), and in
    /// [`Iterate::global`](crate::Iterate::global).
    pub struct GlobalId;
);

index_type!(
    /// Index of a direction in which a flight's initial state may be varied (see [`StateManifold`](crate::StateManifold)).
    pub struct LocalId;
);
