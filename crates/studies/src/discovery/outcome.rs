//! Outcome of one run: what the diagnosis answered, and how that compares with the truth.

use diagnose::Verdict;

use super::case::Case;

/// Outcome of one run.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The run.
    pub case: Case,
    /// Verdict of the diagnosis; `None` if it failed.
    pub verdict: Option<Verdict>,
    /// Why the diagnosis failed.
    pub failure: Option<String>,
    /// Effects of each hypothesis in the answer, sorted, with underscores.
    pub hypotheses: Vec<Vec<String>>,
    /// Strongest remaining candidate of each hypothesis, with its p-value.
    pub strongest_remaining: Vec<Option<(String, f64)>>,
    /// Whether the truth is among the hypotheses; for an unlisted effect, whether the verdict is `outside`.
    pub in_set: bool,
    /// Whether the answer is one single hypothesis that is not the truth.
    pub uniquely_wrong: bool,
    /// Whether the report lists a seeded effect as not identifiable from these flights.
    pub not_identifiable: bool,
    /// Seeded size / minimum detectable effect; of two effects the lesser, 0 if not identifiable.
    pub detectability: Option<f64>,
    /// Equivalent z of the seeded effect's score test; of two effects the lesser.
    pub z: Option<f64>,
    /// Flights that the report lists as discordant.
    pub discordant: Discordant,
    /// Number of terms that the diagnosis wrote.
    pub terms: usize,
    /// Sites of the terms that the diagnosis wrote for an unlisted effect.
    pub sites: Vec<String>,
    /// Errors of prediction on the held-out flights.
    pub held_out: HeldOutErrors,
    /// Time of the diagnosis, s.
    pub seconds: f64,
    /// Number of threads of the diagnosis.
    pub threads: usize,
}

/// Flights that a report lists as discordant.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Discordant {
    /// Number of listed flights.
    pub listed: usize,
    /// Those among them whose stated spin is another flight's.
    pub exchanged: usize,
}

/// Root mean squares of the prediction error on held-out flights, m.
#[derive(Clone, Copy, Debug)]
pub struct HeldOutErrors {
    /// Of the model without an extension.
    pub before: f64,
    /// Of the extended model.
    pub after: f64,
    /// Of the model with the seeded effects; `None` if no model has them.
    pub truth: Option<f64>,
}

impl Outcome {
    /// An outcome of which nothing is known yet.
    pub(super) fn unknown(case: &Case) -> Self {
        Self {
            case: case.clone(),
            verdict: None,
            failure: None,
            hypotheses: Vec::new(),
            strongest_remaining: Vec::new(),
            in_set: false,
            uniquely_wrong: false,
            not_identifiable: false,
            detectability: None,
            z: None,
            discordant: Discordant::default(),
            terms: 0,
            sites: Vec::new(),
            held_out: HeldOutErrors {
                before: f64::NAN,
                after: f64::NAN,
                truth: None,
            },
            seconds: f64::NAN,
            threads: 1,
        }
    }

    /// Number of effects of the first hypothesis that are not seeded, and of library terms in its place.
    pub fn terms_too_many(&self) -> usize {
        let truth = self.case.truth();
        let first = self.hypotheses.first().map_or(&[][..], Vec::as_slice);
        let extra = first.iter().filter(|name| !truth.contains(name)).count();
        extra + self.terms
    }

    /// Whether the verdict is other than `none`.
    pub fn is_detected(&self) -> bool {
        self.verdict.is_some_and(|verdict| verdict != Verdict::None)
    }

    /// Held-out error of the extended model / that of the model with the seeded effects.
    pub fn held_out_ratio(&self) -> Option<f64> {
        Some(self.held_out.after / self.held_out.truth?)
    }

    /// Whether the seeded effect has at least `ratio` times the minimum detectable size; false without a seeded effect of
    /// the catalogue.
    pub fn is_detectable(&self, ratio: f64) -> bool {
        self.detectability.is_some_and(|found| found >= ratio)
    }

    /// The verdict and its hypotheses in words.
    pub fn answer(&self) -> String {
        let hypotheses = self.hypotheses.iter().map(|effects| effects.join("+"));
        let hypotheses: Vec<String> = hypotheses.collect();
        match self.verdict {
            None => "failed".to_owned(),
            Some(Verdict::None) => "nothing".to_owned(),
            Some(verdict) => {
                let verdict = format!("{verdict:?}").to_lowercase();
                format!("{verdict}: {}", hypotheses.join(" | "))
            }
        }
    }
}
