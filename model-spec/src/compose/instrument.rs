//! Instruments on a body, and what each usually measures.

/// An instrument whose reading is a quantity of the model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Instrument {
    /// Angular velocity, rad/s, in the frame that markers are fixed in.
    Gyroscope,
    /// Specific force where it sits on the body, m/s², in the frame that markers are fixed in.
    Accelerometer,
    /// Speed, m/s; of the mass centre over the ground unless the model declares another.
    Speed,
}

impl Instrument {
    /// All instruments.
    pub const ALL: [Self; 3] = [Self::Gyroscope, Self::Accelerometer, Self::Speed];

    /// Name of the quantity in a model, and of the kind in a dataset.
    pub fn name(self) -> &'static str {
        match self {
            Self::Gyroscope => "gyroscope",
            Self::Accelerometer => "accelerometer",
            Self::Speed => "speed",
        }
    }

    /// Number of components of a reading.
    pub fn components(self) -> usize {
        match self {
            Self::Gyroscope | Self::Accelerometer => 3,
            Self::Speed => 1,
        }
    }

    /// The usual definition, given the frame and the name of the model's marker.
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
