//! Instruments mounted on a body, and the default definitions of the quantities that they measure.

/// An instrument mounted on the body. The value that it measures is predicted by an auxiliary variable of the model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Instrument {
    /// Measures the angular velocity of the body, rad/s, with components in the frame of the model's marker.
    Gyroscope,
    /// Measures the specific force at the position of the model's marker, m/s², with components in the frame of the
    /// marker.
    Accelerometer,
    /// Measures a speed, m/s: the value of the auxiliary variable `speed` if the model declares one, otherwise the
    /// speed of the centre of mass relative to the ground.
    Speed,
}

impl Instrument {
    /// All instruments.
    pub const ALL: [Self; 3] = [Self::Gyroscope, Self::Accelerometer, Self::Speed];

    /// Name of the predicting variable in models, and of the measurement in datasets.
    pub fn name(self) -> &'static str {
        match self {
            Self::Gyroscope => "gyroscope",
            Self::Accelerometer => "accelerometer",
            Self::Speed => "speed",
        }
    }

    /// Number of scalar components of the measured quantity: 3 for a vector, 1 for a speed.
    pub fn components(self) -> usize {
        match self {
            Self::Gyroscope | Self::Accelerometer => 3,
            Self::Speed => 1,
        }
    }

    /// Default `let` of the measured quantity, in `frame`, at the vector `marker` from the centre of mass.
    pub(super) fn definition(self, frame: &str, marker: &str) -> String {
        match self {
            Self::Gyroscope => format!("let gyroscope = in_{frame}(angular_velocity);"),
            Self::Accelerometer => format!(
                "let accelerometer = in_{frame}(specific_force) + cross(in_{frame}(angular_acceleration), {marker}) \
                 + cross(in_{frame}(angular_velocity), cross(in_{frame}(angular_velocity), {marker}));"
            ),
            Self::Speed => "let speed = norm(velocity);".to_owned(),
        }
    }
}
