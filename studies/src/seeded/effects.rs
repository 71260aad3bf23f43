//! Specification of the effects and noise that are added to a simulated dataset.

use dataset::synthesize::Corruption;

/// Physical effects and measurement noise that are added to a simulated dataset.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SeededEffects {
    /// Effects of the built-in effects catalogue: name, and values (SI) of the coefficients in order. If the effect has
    /// states, the standard deviations of the states over the flights follow.
    pub listed: Vec<(String, Vec<f64>)>,
    /// Effects outside the built-in effects catalogue: name, and size in the effect's own unit, such as m/s for a wind.
    /// The units are listed at [`super::UNLISTED`].
    pub unlisted: Vec<(String, f64)>,
    /// Noise of the marker positions; `None` leaves them exact.
    pub noise: Option<Corruption>,
    /// Number of held-out flights, which are the last ones of the dataset.
    pub held_out: usize,
}

impl SeededEffects {
    /// Specifies one effect of the built-in effects catalogue, and no noise. The values (SI) are the effect's
    /// coefficients, then the standard deviations of its states over the flights.
    pub fn listed(name: &str, values: &[f64]) -> Self {
        Self {
            listed: vec![(name.to_owned(), values.to_vec())],
            ..Self::default()
        }
    }

    /// Specifies one effect outside the built-in effects catalogue, with its size, and no noise.
    pub fn unlisted(name: &str, size: f64) -> Self {
        Self {
            unlisted: vec![(name.to_owned(), size)],
            ..Self::default()
        }
    }

    /// Returns the same effects with the noise `noise` of the marker positions.
    pub fn with_noise(self, noise: Corruption) -> Self {
        Self {
            noise: Some(noise),
            ..self
        }
    }
}
