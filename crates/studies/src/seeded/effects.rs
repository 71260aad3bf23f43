//! Effects and noise added to a simulated dataset.

use identify::synthesize::Corruption;

/// Effects and noise added to a simulated dataset.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SeededEffects {
    /// Effects of the catalogue: name, and its coefficients (SI) in their order. An effect with states has their standard
    /// deviations over the flights after its coefficients.
    pub listed: Vec<(String, Vec<f64>)>,
    /// Effects outside the catalogue: name and size; see [`super::UnlistedEffect`] for the units.
    pub unlisted: Vec<(String, f64)>,
    /// Noise of the marker positions; `None` leaves them exact.
    pub noise: Option<Corruption>,
    /// Number of held-out flights, the last ones of the dataset.
    pub held_out: usize,
}

impl SeededEffects {
    /// One effect of the catalogue, without noise.
    pub fn listed(name: &str, values: &[f64]) -> Self {
        Self {
            listed: vec![(name.to_owned(), values.to_vec())],
            ..Self::default()
        }
    }

    /// One effect outside the catalogue, without noise.
    pub fn unlisted(name: &str, size: f64) -> Self {
        Self {
            unlisted: vec![(name.to_owned(), size)],
            ..Self::default()
        }
    }

    /// The effects under a noise.
    pub fn with_noise(self, noise: Corruption) -> Self {
        Self {
            noise: Some(noise),
            ..self
        }
    }
}
