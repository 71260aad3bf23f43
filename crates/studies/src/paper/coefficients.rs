//! Coefficients of the model `disc` that a reading makes of a printed row.

use super::columns::Columns;
use super::conventions::{Conventions, RollSpin, SpinDown};

/// Revolutions per second in 1 rad/s.
const REV_PER_RAD: f64 = 0.5 / std::f64::consts::PI;

/// Coefficients of the model `disc`, SI, with pitch and roll damping apart: their signs are separate hypotheses.
pub(super) struct Coefficients {
    /// C_L0, C_La, C_D0, C_Da.
    pub(super) lift_and_drag: [f64; 4],
    /// C_Ma.
    pub(super) pitching_moment: f64,
    /// C_Mq of pitch.
    pub(super) pitch_damping: f64,
    /// C_Mq of roll.
    pub(super) roll_damping: f64,
    /// Roll moment due to spin: C_Rr in s, or the number that multiplies the advance ratio where the reading takes it so.
    pub(super) roll_spin: f64,
    /// Spin damping: C_Nr in N m s, or the number that multiplies ρ V² A d/2 where the reading takes it so.
    pub(super) spin_down: f64,
}

/// The coefficients that a reading makes of a printed row; `d` in m, `g` in m/s².
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
        // The paper's coefficient slows the spin where positive, the model's where negative.
        spin_down: -sign(conventions.spin_down_reversed) * row[7] * spin_down_scale,
    }
}
