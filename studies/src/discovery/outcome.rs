//! Outcome of one run: the answer of the diagnosis, scored against the effects added to the simulated flights.

use diagnose::Verdict;

use super::case::Case;

/// Result of the diagnosis of one simulated dataset, scored against the effects added to its flights.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// Settings with which the flights were simulated.
    pub case: Case,
    /// Verdict of the diagnosis; `None` if the diagnosis failed.
    pub verdict: Option<Verdict>,
    /// Error message of the diagnosis; `None` if it succeeded.
    pub failure: Option<String>,
    /// For each hypothesis of the diagnosis, the names of its effects, sorted; words are joined by underscores.
    pub hypotheses: Vec<Vec<String>>,
    /// For each hypothesis, the strongest remaining candidate (effect with the smallest p-value after the effects of
    /// the hypothesis have been added to the model) and its p-value; `None` if no candidate remains.
    pub strongest_remaining: Vec<Option<(String, f64)>>,
    /// Whether the effects added to the simulated flights are among the hypotheses of the diagnosis. For an effect
    /// outside the built-in effects catalogue: whether the verdict is `Unattributed`, or a hypothesis names a nearly
    /// equivalent effect of the catalogue.
    pub in_set: bool,
    /// Whether the diagnosis gives exactly one hypothesis, and this hypothesis is wrong.
    pub uniquely_wrong: bool,
    /// Whether the report lists an effect that was added to the simulated flights as not identifiable from these
    /// flights.
    pub not_identifiable: bool,
    /// Ratio of the size of an effect added to the simulated flights to its minimum detectable size. For several added
    /// effects, the smallest ratio. It is 0 if one of them is not identifiable. `None` if the ratio is not known, as
    /// for effects outside the built-in effects catalogue.
    pub detectability: Option<f64>,
    /// z-equivalent (two-sided standard normal quantile of the p-value) of the score test of the effect added to the
    /// simulated flights. For several added effects, the smallest one. `None` if none of them was tested.
    pub z: Option<f64>,
    /// Counts of the flights that the report lists as discordant: flights that contradict the effect found in most
    /// flights.
    pub discordant: Discordant,
    /// Number of terms that the diagnosis selected from its library of force and moment terms, to describe a misfit
    /// that no effect explains.
    pub terms: usize,
    /// Quantities of the model, such as lift, on which the force and moment terms act that the diagnosis selected from
    /// its term library.
    pub sites: Vec<String>,
    /// RMS errors with which three fitted models predict the held-out flights.
    pub held_out: HeldOutErrors,
    /// Computing time of the diagnosis, s; NaN if the diagnosis failed.
    pub seconds: f64,
    /// Number of processor threads on which the diagnosis ran.
    pub threads: usize,
}

/// Counts of the flights that a report lists as discordant: flights in which the effect found in most flights has
/// another sign or a much smaller size.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Discordant {
    /// Number of flights that the report lists as discordant.
    pub listed: usize,
    /// Number of the flights listed as discordant into which an error was introduced: their spin in the dataset was
    /// exchanged with that of another flight.
    pub exchanged: usize,
}

/// RMS prediction errors, m, of three fitted models on the held-out flights of a simulated dataset.
#[derive(Clone, Copy, Debug)]
pub struct HeldOutErrors {
    /// RMS prediction error, m, of the model without any added effect; NaN if the diagnosis failed.
    pub before: f64,
    /// RMS prediction error, m, of the model extended by the effects that the diagnosis found. Equal to that of the
    /// model without added effects if the diagnosis found no effect; NaN if the diagnosis failed.
    pub after: f64,
    /// RMS prediction error, m, of the model with the effects that were added to the simulated flights; `None` if there
    /// is no such model or its fit failed.
    pub truth: Option<f64>,
}

impl Outcome {
    /// Outcome of a run before its diagnosis: no verdict, no hypotheses, and NaN for the RMS prediction errors and the
    /// computing time.
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

    /// Number of wrong terms: effects in the first-ranked hypothesis of the diagnosis that were not added to the
    /// simulated flights, plus the terms that the diagnosis selected from its library of force and moment terms.
    pub fn terms_too_many(&self) -> usize {
        let truth = self.case.truth();
        let first = self.hypotheses.first().map_or(&[][..], Vec::as_slice);
        let extra = first.iter().filter(|name| !truth.contains(name)).count();
        extra + self.terms
    }

    /// Whether the diagnosis succeeded and detected a deviation from the model (verdict other than `Verdict::Adequate`).
    pub fn is_detected(&self) -> bool {
        self.verdict
            .is_some_and(|verdict| verdict != Verdict::Adequate)
    }

    /// Ratio of the RMS prediction errors of two models on held-out flights: the model extended by the effects that the
    /// diagnosis found / the model with the effects added to the simulated flights. `None` if the latter error is not
    /// known.
    pub fn held_out_ratio(&self) -> Option<f64> {
        Some(self.held_out.after / self.held_out.truth?)
    }

    /// Whether the effects added to the simulated flights have at least `ratio` times their minimum detectable size.
    /// False if no effect of the built-in effects catalogue was added.
    pub fn is_detectable(&self, ratio: f64) -> bool {
        self.detectability.is_some_and(|found| found >= ratio)
    }

    /// Formats the verdict and the hypotheses of the diagnosis as text.
    pub fn answer(&self) -> String {
        let hypotheses = self.hypotheses.iter().map(|effects| effects.join("+"));
        let hypotheses: Vec<String> = hypotheses.collect();
        match self.verdict {
            None => "failed".to_owned(),
            Some(Verdict::Adequate) => "nothing".to_owned(),
            Some(verdict) => {
                let verdict = format!("{verdict:?}").to_lowercase();
                format!("{verdict}: {}", hypotheses.join(" | "))
            }
        }
    }
}
