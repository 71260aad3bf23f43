//! What a column of summaries may measure.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, PI, TAU};

use super::unit::Dimension;

/// Quantity of the release or of the rest of a flight that a launch monitor tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum SummaryQuantity {
    /// Speed of the mass centre over the ground at the release.
    Speed,
    /// Angle of the velocity above the horizontal at the release.
    Launch,
    /// Horizontal direction of the velocity at the release, from +x; positive to the left.
    Heading,
    /// Angle of attack of a body at the release, positive nose-up.
    Nose,
    /// Tilt of a body about its velocity at the release, positive where its left edge is the lower one.
    Hyzer,
    /// Spin at the release: of a body about its third axis, positive clockwise seen from above; of a ball its size.
    Spin,
    /// Tilt of the axis of a ball's backspin about the direction of launch; positive if it turns the flight right.
    SpinAxis,
    /// Height of the mass centre above the ground at the release.
    Height,
    /// Angle between a body's axis and its angular momentum at the release.
    Wobble,
    /// Horizontal distance from the release to the landing.
    Carry,
    /// Horizontal distance of the landing from the line through the release along +x; positive to the right.
    Side,
    /// Height of the highest point above the ground.
    ApexHeight,
    /// Horizontal distance from the release to the highest point.
    ApexDistance,
    /// Time from the release to the landing.
    HangTime,
    /// Speed at the landing.
    LandingSpeed,
    /// Angle of the velocity below the horizontal at the landing.
    LandingAngle,
    /// Spin at the landing, as `Spin` at the release.
    FinalSpin,
}

/// Where on its path a quantity of a summary is seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SummaryEvent {
    /// At the release.
    Release,
    /// At the highest point.
    Apex,
    /// Where the mass centre falls to the ground, z = 0.
    Landing,
}

use Dimension::{Angle, Length, Rate, Speed, Time};
use SummaryEvent::{Apex, Landing, Release};
use SummaryQuantity as Q;

/// A quantity with its name, event, dimension, and range.
type Row = (Q, &'static str, SummaryEvent, Dimension, (f64, f64));

/// Each quantity with its name, event, dimension, and range of plausible values in the units that are named.
const ALL: [Row; 17] = [
    (Q::Speed, "speed", Release, Speed, (1e-3, 150.0)),
    (Q::Launch, "launch", Release, Angle, (-FRAC_PI_2, FRAC_PI_2)),
    (Q::Heading, "heading", Release, Angle, (-TAU, TAU)),
    (Q::Nose, "nose", Release, Angle, (-FRAC_PI_2, FRAC_PI_2)),
    (Q::Hyzer, "hyzer", Release, Angle, (-PI, PI)),
    (Q::Spin, "spin", Release, Rate, (-2100.0, 2100.0)),
    (Q::SpinAxis, "spin_axis", Release, Angle, (-PI, PI)),
    (Q::Height, "height", Release, Length, (-1e3, 1e4)),
    (Q::Wobble, "wobble", Release, Angle, (0.0, FRAC_PI_3)),
    (Q::Carry, "carry", Landing, Length, (0.0, 1e4)),
    (Q::Side, "side", Landing, Length, (-1e4, 1e4)),
    (Q::ApexHeight, "apex_height", Apex, Length, (-1e3, 1e4)),
    (Q::ApexDistance, "apex_distance", Apex, Length, (0.0, 1e4)),
    (Q::HangTime, "hang_time", Landing, Time, (1e-3, 600.0)),
    (
        Q::LandingSpeed,
        "landing_speed",
        Landing,
        Speed,
        (0.0, 150.0),
    ),
    (
        Q::LandingAngle,
        "landing_angle",
        Landing,
        Angle,
        (-FRAC_PI_2, FRAC_PI_2),
    ),
    (Q::FinalSpin, "final_spin", Landing, Rate, (-2100.0, 2100.0)),
];

impl SummaryQuantity {
    /// All quantities, those of the release first.
    pub fn all() -> impl Iterator<Item = Self> {
        ALL.iter().map(|own| own.0)
    }

    /// The quantity of a name, as `is` in `dataset.toml` states it.
    pub fn named(name: &str) -> Option<Self> {
        let own = ALL.iter().find(|own| own.1 == name)?;
        Some(own.0)
    }

    /// Name of the quantity.
    pub fn name(self) -> &'static str {
        ALL[self as usize].1
    }

    /// Where on the path it is seen.
    pub fn event(self) -> SummaryEvent {
        ALL[self as usize].2
    }

    /// SI unit.
    pub fn si_unit(self) -> &'static str {
        self.dimension().si()
    }

    pub(crate) fn dimension(self) -> Dimension {
        ALL[self as usize].3
    }

    /// Least and greatest plausible value, SI.
    pub(crate) fn range(self) -> (f64, f64) {
        ALL[self as usize].4
    }

    /// Whether the quantity is positive to the right; `None` if it has no side.
    pub fn is_positive_right(self) -> Option<bool> {
        match self {
            Self::Heading => Some(false),
            Self::Side | Self::SpinAxis => Some(true),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantities_are_found_by_their_names() {
        for (place, quantity) in SummaryQuantity::all().enumerate() {
            assert_eq!(quantity as usize, place);
            assert_eq!(SummaryQuantity::named(quantity.name()), Some(quantity));
        }
    }
}
