//! A mistake in the data of a flight, and how to correct it.

use std::fmt;

use serde::{Deserialize, Serialize};

use crate::Flight;

/// A mistake that screening found in the recorded data of one flight.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct DataFault {
    /// File name of the flight that has the mistake, as in `dataset.toml`.
    pub file: String,
    /// Kind of the mistake, such as a wrong unit.
    pub fault: FaultKind,
    /// Message for the user that describes the mistake, with the values that reveal it.
    pub detail: String,
    /// Instruction for the user: how to correct the data.
    pub correction: String,
}

/// Kind of a mistake in the data of a flight.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum FaultKind {
    /// Names of markers are exchanged, in the whole flight or in a part of it.
    LabelsExchanged,
    /// The axes are left-handed: the tracks are the mirror image of a flight.
    Mirrored,
    /// Lengths are not in metres.
    Units,
    /// The z axis does not point up.
    Axes,
    /// Times are not in seconds, or are based on a wrong frame rate.
    TimeUnit,
    /// Some samples are not of free flight: in the hand, after the catch, in a net, on the ground.
    NotFreeFlight,
    /// The recorded coordinates of a marker do not change while the body moves.
    Frozen,
    /// Quaternions have another convention than scalar part first and body to inertial.
    AttitudeConvention,
    /// Readings of an instrument are not in SI units.
    SensorUnit,
    /// A mistake in the data for which there is no separate kind, such as a copied flight.
    Other,
}

impl DataFault {
    /// Creates a fault of `flight`.
    pub(crate) fn new(
        flight: &Flight,
        fault: FaultKind,
        detail: impl Into<String>,
        correction: impl Into<String>,
    ) -> Self {
        Self {
            file: flight.file.clone(),
            fault,
            detail: detail.into(),
            correction: correction.into(),
        }
    }
}

impl fmt::Display for FaultKind {
    /// The name in reports, such as `labels_exchanged`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.serialize(f)
    }
}

impl fmt::Display for DataFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}; {}", self.file, self.detail, self.correction)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kinds_are_written_as_they_are_named() {
        use FaultKind::*;
        for kind in [
            LabelsExchanged,
            Mirrored,
            Units,
            Axes,
            TimeUnit,
            NotFreeFlight,
            Frozen,
            AttitudeConvention,
            SensorUnit,
            Other,
        ] {
            let quoted = format!("\"{kind}\"");
            let value = toml::Value::try_from(kind).map(|value| value.to_string());
            assert_eq!(value, Ok(quoted));
        }
    }
}
