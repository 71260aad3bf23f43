//! Names that have a meaning of their own.

/// Names that no model can declare.
pub(crate) const FIXED: [&str; 3] = ["pi", "time", PREVIOUS];

/// Name that stands for the replaced definition in a `replace` statement of an effect.
pub(crate) const PREVIOUS: &str = "previous";

/// Names that are predefined in models with a body; models without a body may declare them.
pub(crate) const OF_BODY: [&str; 5] = [
    "position",
    "velocity",
    "angular_velocity",
    "specific_force",
    "angular_acceleration",
];
