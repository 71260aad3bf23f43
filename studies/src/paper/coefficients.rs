//! Converts a printed row of Table 1 to coefficients of the model `disc`, as a reading prescribes.

use super::columns::Columns;
use super::conventions::{Conventions, RollSpin, SpinDown};

/// Conversion factor from rad/s to revolutions per second.
const REV_PER_RAD: f64 = 0.5 / std::f64::consts::PI;

/// Coefficients of the model `disc`, SI. Pitch and roll damping are separate, because the study assumes a reversed sign
/// for each of them separately.
pub(super) struct Coefficients {
    /// Lift and drag coefficients `[C_L0, C_La, C_D0, C_Da]`: lift C_L0 + C_La α and drag C_D0 + C_Da α² at the angle
    /// of attack α, rad.
    pub(super) lift_and_drag: [f64; 4],
    /// Slope C_Ma of the pitching-moment coefficient over the angle of attack, 1/rad.
    pub(super) pitching_moment: f64,
    /// Coefficient C_Mq of the damping moment about the pitch axis, s.
    pub(super) pitch_damping: f64,
    /// Coefficient that takes the place of C_Mq in the damping moment about the roll axis, s.
    pub(super) roll_damping: f64,
    /// Coefficient of the roll moment due to spin: C_Rr in s; dimensionless if the moment is assumed proportional to
    /// the advance ratio.
    pub(super) roll_spin: f64,
    /// Coefficient of the spin damping: C_Nr in N m s; in s if the moment is assumed proportional to ρ V² A d/2.
    pub(super) spin_down: f64,
}

/// Converts a printed row of Table 1 of Hubbard & Hummel (2000) to coefficients, with an assumed order of columns and
/// assumed signs and units. `d` is the diameter of the disc, m, and `g` the gravitational acceleration, m/s².
pub(super) fn coefficients(
    row: &[f64; 8],
    columns: Columns,
    conventions: &Conventions,
    d: f64,
    g: f64,
) -> Coefficients {
    let sign = |reversed: bool| if reversed { -1.0 } else { 1.0 };
    let roll_scale = match conventions.roll_spin {
        RollSpin::RadPerSecond | RollSpin::SpinRatio => 1.0,
        RollSpin::RevPerSecond => REV_PER_RAD,
        RollSpin::RootDOverG => (d / g).sqrt(),
    };
    let spin_down_scale = match conventions.spin_down {
        SpinDown::NewtonMetreSecond | SpinDown::TimesDynamicPressure => 1.0,
        SpinDown::PerRevPerSecond => REV_PER_RAD,
    };
    Coefficients {
        lift_and_drag: columns.map(|column| row[column as usize]),
        pitching_moment: row[4],
        pitch_damping: sign(conventions.pitch_damping_reversed) * row[5],
        roll_damping: sign(conventions.roll_damping_reversed) * row[5],
        roll_spin: sign(conventions.roll_spin_reversed) * row[6] * roll_scale,
        // A positive coefficient slows the spin in the paper, a negative one in the model.
        spin_down: -sign(conventions.spin_down_reversed) * row[7] * spin_down_scale,
    }
}
