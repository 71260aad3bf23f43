//! A weak and a strong value of each effect of the catalogue, for the discovery study.

/// Weak and strong values of an effect, SI: first its coefficients, then the standard deviations, over flights, of its
/// states.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strength {
    /// Name of the effect in the built-in effects catalogue.
    pub effect: &'static str,
    /// Values of a weak effect, each about the smallest that occurs in practice, SI. The coefficients come first, then
    /// the standard deviations of the states over the flights.
    pub weak: &'static [f64],
    /// Values of a strong effect, each about the largest that occurs in practice, SI. The coefficients come first, then
    /// the standard deviations of the states over the flights.
    pub strong: &'static [f64],
}

const fn row(effect: &'static str, weak: &'static [f64], strong: &'static [f64]) -> Strength {
    Strength {
        effect,
        weak,
        strong,
    }
}

/// Weak and strong values of every effect of the built-in effects catalogue.
#[rustfmt::skip]
pub const STRENGTHS: &[Strength] = &[
    row("zero_lift_drag_angle", &[-0.02], &[-0.07]),
    row("drag_by_spin", &[0.01], &[0.05]),
    row("drag_by_reynolds", &[-0.01], &[-0.05]),
    row("constant_pitching_moment", &[-0.003], &[-0.015]),
    row("cubic_pitching_moment", &[-0.3], &[-1.5]),
    row("pitching_moment_by_spin", &[0.005], &[0.02]),
    row("roll_damping", &[-0.002], &[-0.01]),
    row("rolling_moment_by_angle", &[0.005], &[0.03]),
    row("rolling_moment_by_spin_ratio", &[0.005], &[0.02]),
    row("rolling_moment_at_low_angle", &[0.005], &[0.02]),
    row("quadratic_spin_down", &[-3e-7], &[-2e-6]),
    row("spin_down_by_pressure", &[-0.001], &[-0.005]),
    row("spin_down_by_angle", &[-5e-5], &[-3e-4]),
    row("side_force_by_spin", &[0.01], &[0.05]),
    row("side_force_by_spin_and_angle", &[0.05], &[0.3]),
    row("stall", &[1.0], &[5.0]),
    row("lift_by_spin", &[0.02], &[0.1]),
    row("ground_effect", &[0.1], &[0.5]),
    row("wind", &[0.1, 0.05], &[0.7, -0.4]),
    row("wind_of_each_flight", &[0.1, 0.1], &[0.5, 0.5]),
    row("wind_by_height", &[0.05, 0.03], &[0.3, -0.2]),
    row("air_density", &[0.02], &[0.1]),
    row("gravity", &[0.001], &[0.005]),
    row("added_mass", &[0.004], &[0.01]),
    row("mass_imbalance", &[5e-6, -3e-6], &[3e-5, 2e-5]),
    row("unequal_diametral_inertias", &[1e-5], &[5e-5]),
    row("tilted_vertical", &[0.003, -0.002], &[0.02, 0.01]),
    row("scale", &[0.002], &[0.01]),
    row("marker_time_offset", &[1e-4, 2e-4], &[1e-3, 2e-3]),
    row("marker_1_misplaced", &[0.001, -0.001, 0.0005], &[0.004, 0.003, -0.002]),
    row("marker_2_misplaced", &[0.001, -0.001, 0.0005], &[0.004, 0.003, -0.002]),
    row("marker_3_misplaced", &[0.001, -0.001, 0.0005], &[0.004, 0.003, -0.002]),
    row("marker_height", &[0.002], &[0.01]),
    row("marker_radius", &[0.005], &[0.03]),
    row("clock_rate", &[0.001], &[0.01]),
    row("magnus", &[0.2], &[1.0]),
    row("spin_decay", &[0.1], &[0.5]),
    row("drag_crisis", &[0.05], &[0.25]),
    row("buoyancy", &[0.3], &[1.0]),
];

/// Looks up the weak and strong values of an effect by its name in the built-in effects catalogue; `None` for an
/// unknown name.
pub fn strength(effect: &str) -> Option<&'static Strength> {
    STRENGTHS.iter().find(|row| row.effect == effect)
}
