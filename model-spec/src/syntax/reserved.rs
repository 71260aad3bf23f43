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

/// A quantity of each body after the first one, such as `position_of_payload`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BodyQuantity {
    /// Position of the mass centre, m.
    Position,
    /// Velocity of the mass centre, m/s.
    Velocity,
    /// Angular velocity, rad/s, of a body that turns.
    AngularVelocity,
    /// Angular momentum about the mass centre, kg·m²/s, of a body that turns.
    AngularMomentum,
    /// Mass, kg.
    Mass,
    /// Sum of the forces, N.
    Force,
    /// Sum of the moments about the mass centre, N·m, of a body that turns.
    Moment,
}

impl BodyQuantity {
    /// All of them.
    pub const ALL: [Self; 7] = [
        Self::Position,
        Self::Velocity,
        Self::AngularVelocity,
        Self::AngularMomentum,
        Self::Mass,
        Self::Force,
        Self::Moment,
    ];

    /// Name of the quantity of a body.
    pub fn of(self, body: &str) -> String {
        let words = match self {
            Self::Position => "position_of",
            Self::Velocity => "velocity_of",
            Self::AngularVelocity => "angular_velocity_of",
            Self::AngularMomentum => "angular_momentum_of",
            Self::Mass => "mass_of",
            Self::Force => "force_on",
            Self::Moment => "moment_on",
        };
        format!("{words}_{body}")
    }

    /// What it is, in plain words.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Position => "position of the mass centre",
            Self::Velocity => "velocity of the mass centre",
            Self::AngularVelocity => "angular velocity",
            Self::AngularMomentum => "angular momentum about the mass centre",
            Self::Mass => "mass",
            Self::Force => "sum of the forces",
            Self::Moment => "sum of the moments about the mass centre",
        }
    }
}
