//! Options of a diagnosis.

use identify::FitOptions;
use model_spec::model::Model;

use super::encompassing::identifier;

/// Options of a diagnosis; its dataset and model are passed separately.
///
/// ```
/// use diagnose::DiagnosisOptions;
///
/// let model = model_spec::load::load("disc", &[])?;
/// let without = ["wind".to_owned()];
/// let options = DiagnosisOptions { without: &without, ..DiagnosisOptions::default() };
/// assert!(options.validate(&model).is_ok());
/// # Ok::<(), model_spec::load::LoadError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct DiagnosisOptions<'a> {
    /// Name of the dataset in the report and in the doc comments of created effects.
    pub dataset: &'a str,
    /// Names of effects that the diagnosis does not consider as candidates for a missing effect.
    pub without: &'a [String],
    /// Options of every fit; threads, progress and cancellation apply to the whole diagnosis.
    pub fit: FitOptions<'a>,
    /// Familywise probability that a candidate is detected although the model is correct; default 0.004.
    pub alpha_detect: f64,
    /// Probability that the correct explanation is rejected, familywise over all tests; default 0.002.
    pub alpha_reject: f64,
    /// Ranges of feasible launch conditions, within which the next throw is chosen.
    pub throws: ThrowRanges,
}

impl Default for DiagnosisOptions<'_> {
    fn default() -> Self {
        Self {
            dataset: "",
            without: &[],
            fit: FitOptions::default(),
            alpha_detect: 0.004,
            alpha_reject: 0.002,
            throws: ThrowRanges::default(),
        }
    }
}

/// Ranges (minimum, maximum) of launch conditions that a thrower can achieve, and how the throws are observed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThrowRanges {
    /// Speed of the body at release, m/s.
    pub speed: (f64, f64),
    /// Launch angle: angle of the velocity above the horizontal, rad.
    pub launch: (f64, f64),
    /// Nose angle: angle of attack at release, positive nose up, rad.
    pub nose: (f64, f64),
    /// Hyzer angle: tilt about the velocity, rad; positive if the left edge, from behind, is lower.
    pub hyzer: (f64, f64),
    /// Absolute spin rate about the axis of symmetry, rad/s; throws with either sense of rotation are drawn.
    pub spin: (f64, f64),
    /// Number of possible headings of the velocity, evenly spaced over the full circle.
    pub headings: usize,
    /// Height of release above the ground, m.
    pub height: f64,
    /// Duration of the observed part of a flight, s.
    pub duration: f64,
    /// Sampling rate of the observed positions, 1/s.
    pub rate: f64,
}

impl Default for ThrowRanges {
    fn default() -> Self {
        Self {
            speed: (6.0, 24.0),
            launch: (-0.1, 0.5),
            nose: (-0.15, 0.4),
            hyzer: (-0.6, 0.6),
            spin: (20.0, 90.0),
            headings: 8,
            height: 1.5,
            duration: 1.5,
            rate: 120.0,
        }
    }
}

/// Reason why the options of a diagnosis are invalid.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum OptionsError {
    /// A name in `without` is neither a built-in effect nor one in the model's file.
    #[error("there is no effect `{name}`{}", nearest.as_ref().map(|near| format!("; did you mean `{near}`?")).unwrap_or_default())]
    UnknownEffect {
        /// The unknown name, as given in the options.
        name: String,
        /// The existing name with the smallest edit distance; `None` if no name is close.
        nearest: Option<String>,
    },
    /// A significance level is not between 0 and 1.
    #[error("the significance level {name} is {value}; it must lie between 0 and 1")]
    SignificanceLevel {
        /// Name of the option: `alpha_detect` or `alpha_reject`.
        name: &'static str,
        /// Invalid value of the option.
        value: f64,
    },
    /// A range is empty or not finite, or a number not positive or too large.
    #[error("the throws have no usable {name}")]
    ThrowRange {
        /// Name of the invalid field of [`ThrowRanges`].
        name: &'static str,
    },
}

impl DiagnosisOptions<'_> {
    /// Checks the names in `without` and the numeric options.
    ///
    /// # Errors
    /// [`OptionsError`] of the first invalid option.
    pub fn validate(&self, model: &Model) -> Result<(), OptionsError> {
        let levels = [
            ("alpha_detect", self.alpha_detect),
            ("alpha_reject", self.alpha_reject),
        ];
        for (name, value) in levels {
            if !(value > 0.0 && value < 1.0) {
                return Err(OptionsError::SignificanceLevel { name, value });
            }
        }
        self.throws.validate()?;
        let own = model.tree.effects().map(|own| own.name.text.as_str());
        let built_in = model_spec::load::EFFECTS.iter();
        let known: Vec<&str> = own.chain(built_in.map(|effect| effect.0)).collect();
        let unknown = |name: &&String| !known.contains(&identifier(name).as_str());
        match self.without.iter().find(unknown) {
            Some(name) => Err(OptionsError::UnknownEffect {
                name: name.clone(),
                nearest: model_spec::nearest_name(&identifier(name), known.iter().copied())
                    .map(str::to_owned),
            }),
            None => Ok(()),
        }
    }
}

impl ThrowRanges {
    fn validate(&self) -> Result<(), OptionsError> {
        let ranges = [
            ("speed", self.speed),
            ("launch", self.launch),
            ("nose", self.nose),
            ("hyzer", self.hyzer),
            ("spin", self.spin),
            ("headings", (1.0, self.headings as f64)),
            ("height", (self.height, self.height)),
            ("duration", (f64::MIN_POSITIVE, self.duration)),
            ("rate", (f64::MIN_POSITIVE, self.rate)),
            // At least two samples, and at most `MAX_DESIGN_SAMPLES`, which bounds the memory.
            ("duration", (2.0, self.duration * self.rate)),
            ("rate", (self.duration * self.rate, MAX_DESIGN_SAMPLES)),
        ];
        let usable = |(low, high): (f64, f64)| low.is_finite() && high.is_finite() && low <= high;
        match ranges.iter().find(|(_, range)| !usable(*range)) {
            Some((name, _)) => Err(OptionsError::ThrowRange { name }),
            None => Ok(()),
        }
    }
}

/// Maximum number of samples of one simulated throw; bounds the memory of the experimental design.
const MAX_DESIGN_SAMPLES: f64 = 1e5;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_out_of_range_are_refused() {
        let model = model_spec::load::load("disc", &[]).unwrap();
        let default = DiagnosisOptions::default();
        assert_eq!(default.validate(&model), Ok(()));
        let misspelt = ["stal".to_owned()];
        let cases = [
            DiagnosisOptions {
                without: &misspelt,
                ..default
            },
            DiagnosisOptions {
                alpha_detect: 0.0,
                ..default
            },
            DiagnosisOptions {
                alpha_reject: f64::NAN,
                ..default
            },
            DiagnosisOptions {
                throws: ThrowRanges {
                    headings: 0,
                    ..ThrowRanges::default()
                },
                ..default
            },
            DiagnosisOptions {
                throws: ThrowRanges {
                    rate: 1e12,
                    ..ThrowRanges::default()
                },
                ..default
            },
            // A throw of one and a half samples.
            DiagnosisOptions {
                throws: ThrowRanges {
                    rate: 0.5,
                    duration: 3.0,
                    ..ThrowRanges::default()
                },
                ..default
            },
        ];
        for options in &cases {
            assert!(options.validate(&model).is_err(), "{options:?}");
        }
        let error = cases[0].validate(&model).unwrap_err();
        assert_eq!(
            error.to_string(),
            "there is no effect `stal`; did you mean `stall`?"
        );
    }
}
