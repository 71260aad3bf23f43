//! Throws, true coefficients and noise conditions shared by the studies.

use dataset::synthesize::Corruption;

use super::dataset::Plan;
use super::throws::Throws;

/// Coefficients of the disc with which the studies simulate flights, SI. They are plausible and differ from the model
/// file's values, which are the initial values of a fit.
pub const TRUTH: [(&str, f64); 8] = [
    ("C_L0", 0.15),
    ("C_La", 2.8),
    ("C_D0", 0.10),
    ("C_Da", 1.6),
    ("C_Ma", -0.30),
    ("C_Mq", -0.008),
    ("C_Rr", -0.0006),
    ("C_Nr", -5e-5),
];

/// Plan of twelve throws of a disc with the coefficients [`TRUTH`], each observed for 1 s at 120 Hz.
pub const TWELVE: Plan<'static> = Plan {
    truth: &TRUTH,
    throws: Throws::SPREAD,
    flights: 12,
    duration: (1.0, 1.0),
    rate: 120.0,
};

/// Noise that is added to the simulated marker positions of a study (white or correlated noise, outliers, missing
/// positions), with a name.
#[derive(Clone, Debug, PartialEq)]
pub struct NoiseCondition {
    /// Name of the noise condition on documentation pages. The seeds of the discovery study are derived from it, so
    /// another name would give other datasets.
    pub name: &'static str,
    /// Noise that is added to the simulated marker positions under this condition.
    pub noise: Corruption,
}

/// Returns the five noise conditions of the studies, all with a standard deviation of 1.5 mm: white; lag-1 correlation
/// of 0.6; 1 % outliers of 5 cm; correlation and outliers together; 12 % of the marker positions missing.
pub fn noise_conditions() -> Vec<NoiseCondition> {
    let white = Corruption {
        sigma: 0.0015,
        ar1: 0.0,
        outliers: 0.0,
        outlier_size: 0.05,
        dropouts: 0.0,
    };
    let (ar1, outliers, dropouts) = (0.6, 0.01, 0.12);
    let condition = |name, noise| NoiseCondition { name, noise };
    let both = Corruption {
        ar1,
        outliers,
        ..white
    };
    vec![
        condition("white", white),
        condition("AR(0.6)", Corruption { ar1, ..white }),
        condition("1 % outliers", Corruption { outliers, ..white }),
        condition("AR(0.6) and 1 % outliers", both),
        condition("12 % dropouts", Corruption { dropouts, ..white }),
    ]
}
