//! Assessment whether a fit is reliable, with the reasons if it is not.

use super::{Coefficient, FitReport, FitStatus, InputNoise, LackOfFit, stated};
use crate::numbers::{Digits, significant};
use crate::wording::{count, listed};
use dataset::Role;
use dataset::levels::{CONFOUNDED, FAR_ABOVE, LEAST_NOISE, SIGNIFICANT};

/// Ratio of the rms residual to the noise floor above which a fit is not reliable; AR(1) noise of coefficient 0.9 stays
/// below.
const NOISE_LIMIT: f64 = 5.0;

/// Fraction of the flights to be fitted that are excluded, above which the fit is not reliable.
const MAX_EXCLUDED: f64 = 1.0 / 3.0;

/// p-value below which a fit is not reliable, of the lack-of-fit test and of the tests of missing terms: one of two is
/// below it in a hundredth of right fits.
pub(crate) const LACK_OF_FIT_LEVEL: f64 = 0.005;

/// Difference of a prior from what the data alone give, in standard deviations, above which they contradict it.
pub const MAX_PRIOR_CONFLICT: f64 = 3.0;

/// Maximum relative difference of an estimate from the negative of its declared value: signs of small coefficients differ
/// from body to body, and seldom those alone.
const NEGATIVE: f64 = 0.3;

impl FitReport {
    /// Decides whether the fit is reliable, and states the reasons if it is not.
    pub(crate) fn assess(&mut self) {
        self.cautions = cautions(self);
        self.reliable = self.cautions.is_empty();
    }

    /// Whether the residuals exceed the noise floor, or the noise that the distances between markers show.
    pub(crate) fn is_above_noise(&self) -> bool {
        self.excess.is_some() || above_noise_floor(self).is_some()
    }

    /// Sentences on what the user states and the data contradict.
    #[doc(hidden)]
    pub fn conflicts(&self) -> Vec<String> {
        let priors = self.prior_conflicts().map(|(why, _)| why);
        let stated = self.contradicted.iter().chain(&self.misread).cloned();
        priors.chain(stated).collect()
    }

    /// Cautions of constants that seem to be stated in another unit than the model's.
    #[doc(hidden)]
    pub fn doubtful_constants(&self) -> impl Iterator<Item = &String> {
        let is_constant =
            |why: &&String| self.far_constants.iter().any(|far| far.sentence == **why);
        self.cautions.iter().filter(is_constant)
    }

    /// Whether the model does not fly as the flights do, and a constant seems to be stated in another unit.
    #[doc(hidden)]
    pub fn has_misstated_constant(&self) -> bool {
        self.is_above_noise() && self.doubtful_constants().next().is_some()
    }

    /// Sentences on priors that the data contradict, each with the number of standard deviations: without the prior, χ²
    /// falls by its square.
    #[doc(hidden)]
    pub fn prior_conflicts(&self) -> impl Iterator<Item = (String, f64)> {
        let coefficients = self.coefficients.iter();
        coefficients.filter_map(|(name, own)| prior_conflict(name, own))
    }
}

/// Reasons, as text for the report, why a fit is not reliable; empty if it is reliable.
fn cautions(report: &FitReport) -> Vec<String> {
    let cautions = [
        convergence_caution(report, "the fit"),
        exclusion_caution(report),
        stated_noise(report)
            .or_else(|| above_noise_floor(report))
            .or_else(|| lack_of_fit(report)),
        confounded(report),
        input_noise(report),
        missing_term(report),
        data_faults(report),
        marker_distances(report),
        opposite_signs(report),
    ];
    let mut cautions: Vec<String> = cautions.into_iter().flatten().collect();
    let doubts = report.doubts.iter().chain(&report.doubt_of_summaries);
    cautions.extend(report.excess.iter().chain(doubts).cloned());
    let coefficients = report.coefficients.iter();
    cautions.extend(coefficients.filter_map(|(name, own)| at_bound(name, own)));
    cautions.extend(report.conflicts());
    // A wrong unit explains the others.
    let mut all: Vec<String> = stated::cautions(report, !cautions.is_empty()).collect();
    all.append(&mut cautions);
    all
}

/// Caution that the fit, called `fit` in the sentence, did not converge; `None` if it converged.
pub fn convergence_caution(report: &FitReport, fit: &str) -> Option<String> {
    let steps = count(report.iterations.steps, "step");
    match report.iterations.status {
        FitStatus::Converged => None,
        FitStatus::Deadline => Some(format!(
            "the time limit was reached after {steps}, before {fit} converged"
        )),
        FitStatus::MaxSteps | FitStatus::NoDescent | FitStatus::NoiseNotConverged => {
            Some(format!("{fit} did not converge in {steps}"))
        }
    }
}

/// Caution that more than a third of the flights to be fitted are excluded; `None` if fewer are.
pub fn exclusion_caution(report: &FitReport) -> Option<String> {
    let to_fit = report.flights.iter().filter(|f| f.role == Role::Fit);
    let (all, used) = (to_fit.count(), report.used(Role::Fit).count());
    let excluded = all - used;
    (excluded as f64 > MAX_EXCLUDED * all as f64).then(|| {
        format!(
            "{excluded} of {} to be fitted were excluded",
            count(all, "flight")
        )
    })
}

fn above_noise_floor(report: &FitReport) -> Option<String> {
    let floor = report.position_noise()?.floor?.max(LEAST_NOISE);
    let ratio = report.rms() / floor;
    (ratio > NOISE_LIMIT).then(|| {
        format!(
            "the residuals ({:.1} mm) are {ratio:.0} times the noise of the measurements ({:.2} mm): the model does not fly as these flights do",
            1e3 * report.rms(),
            1e3 * floor
        )
    })
}

/// Caution that the dataset states another noise of positions than the measurements show: their scatter without a model is
/// far above it, or the residuals, which no model makes smaller than the noise, are far below.
fn stated_noise(report: &FitReport) -> Option<String> {
    let noise = report.position_noise().filter(|noise| !noise.estimated)?;
    let shown = [noise.floor?, report.rms()].map(|own| own.max(LEAST_NOISE));
    let [floor, rms] = shown.map(|own| own / noise.sigma);
    let (seen, ratio) = match floor > FAR_ABOVE {
        true => ("the scatter of the measurements", floor),
        false => ("the residuals", rms),
    };
    (floor > FAR_ABOVE || rms * FAR_ABOVE < 1.0).then(|| {
        format!(
            "the dataset states a noise of {:.2} mm, and {seen} is {} times that: correct `sigma`, in m, or leave it out to have it estimated",
            1e3 * noise.sigma,
            significant(ratio, 2)
        )
    })
}

/// Caution that coefficients have no finite standard error, as the flights show a combination of them alone.
fn confounded(report: &FitReport) -> Option<String> {
    let found = report.not_identifiable.first()?;
    (found.relative_error > CONFOUNDED).then(|| {
        format!(
            "the flights do not determine {}{}: hold one by `--hold`, or state a prior",
            listed(&found.combination),
            if found.combination.len() > 1 {
                " apart from one another"
            } else {
                ""
            },
        )
    })
}

/// Caution that the residuals are not noise: the standard errors of the estimates count noise alone.
fn lack_of_fit(report: &FitReport) -> Option<String> {
    let test = report.lack_of_fit.as_ref()?;
    (test.p_value < LACK_OF_FIT_LEVEL).then(|| {
        format!(
            "{} The standard errors do not hold: `hyzer diagnose` searches for the cause",
            test.sentence()
        )
    })
}

/// Caution that the residuals may be those of a noisy input.
#[doc(hidden)]
pub fn input_noise(report: &FitReport) -> Option<String> {
    let test = report.lack_of_fit.as_ref()?;
    test.input_noise.as_ref().map(InputNoise::sentence)
}

/// Caution that a term is missing: the estimates are those of a model that lacks a force or moment.
fn missing_term(report: &FitReport) -> Option<String> {
    let sentence = report.lack_of_fit.as_ref()?.missing_term()?;
    Some(format!(
        "{sentence} The standard errors do not hold: `hyzer diagnose` searches for the cause"
    ))
}

impl LackOfFit {
    /// Sentence on the term that the tests show to be missing; `None` if they show none.
    #[doc(hidden)]
    pub fn missing_term(&self) -> Option<String> {
        let test = self.missing_term.as_ref()?;
        (test.p_value < LACK_OF_FIT_LEVEL).then(|| test.sentence())
    }
}

/// Caution that an estimate is at a bound, where the likelihood has no maximum and thus gives no standard error.
fn at_bound(name: &str, coefficient: &Coefficient) -> Option<String> {
    coefficient.at_bound.then(|| {
        format!(
            "{name} is at its bound {}: the data ask for a value beyond it (`--unbounded`), or for another model",
            coefficient.value
        )
    })
}

/// Caution that coefficients have the opposite of the declared sign, where the recordings leave open which side of the
/// body is up: a body that is turned over flies the same way with them.
fn opposite_signs(report: &FitReport) -> Option<String> {
    let why = report.open_side.as_ref()?;
    let is_opposite = |own: &Coefficient| {
        (own.value + own.model_value).abs() < NEGATIVE * own.model_value.abs()
            && own.value.abs() > SIGNIFICANT * own.std_error
    };
    let coefficients = report.coefficients.iter();
    let opposite = coefficients.filter(|(_, own)| is_opposite(own));
    let names: Vec<&String> = opposite.map(|(name, _)| name).collect();
    (!names.is_empty()).then(|| {
        format!(
            "{}: the sign is the opposite of the declared one, and {why}",
            listed(&names)
        )
    })
}

/// The data alone give d with the variance V_d, the fit with the prior m ± σ gives e with V. Since 1/V = 1/V_d + 1/σ²,
/// (d − m)²/(V_d + σ²) = (e − m)²/(σ² − V).
fn prior_conflict(name: &str, coefficient: &Coefficient) -> Option<(String, f64)> {
    let [mean, sigma] = coefficient.prior?;
    let variance = coefficient.std_error.powi(2);
    let moved = coefficient.value - mean;
    let of_data = sigma * sigma - variance;
    let conflict = moved.abs() / of_data.max(0.0).sqrt();
    (of_data > 0.0 && conflict > MAX_PRIOR_CONFLICT).then(|| {
        let by_data = mean + moved * sigma * sigma / of_data;
        let digits = Digits::of(by_data, sigma.min(coefficient.std_error));
        let why = format!(
            "the data contradict the prior {name} = {mean} ± {sigma}: they alone give {}, {conflict:.1} standard deviations away",
            digits.one(by_data)
        );
        (why, conflict)
    })
}

/// Reason not to rely on a fit of flights whose data have faults; `None` if there are no such flights.
fn data_faults(report: &FitReport) -> Option<String> {
    let is_fitted = |file: &str| report.used(Role::Fit).any(|flight| flight.file == file);
    let mut faults = report.data_faults.iter().filter(|f| is_fitted(&f.file));
    let first = faults.next()?;
    let number = 1 + faults.count();
    let others = match number {
        1 => String::new(),
        _ => format!(", and {} more", number - 1),
    };
    Some(format!(
        "{} in the data that were fitted: {}: {}{others}",
        count(number, "fault"),
        first.file,
        first.detail
    ))
}

/// Caution that markers are not at their stated positions.
fn marker_distances(report: &FitReport) -> Option<String> {
    let worst = report.marker_distances.iter();
    let worst = worst.max_by(|a, b| a.difference_m.abs().total_cmp(&b.difference_m.abs()))?;
    let [one, other] = &worst.markers;
    let difference = 1e3 * worst.difference_m;
    let apart = match difference > 0.0 {
        true => "farther apart",
        false => "closer together",
    };
    Some(format!(
        "markers {one} and {other} are {:.1} ± {:.1} mm {apart} than their stated positions: correct the positions of the markers, or their times if they are seen one after the other",
        difference.abs(),
        1e3 * worst.std_error_m
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::noise::NoiseModel;
    use crate::report::MissingTerm;

    /// An estimate of 7 ± 1 with the prior 1 ± 2: the data alone give 9 ± 1.15, 3.5 standard deviations away.
    #[test]
    fn a_prior_that_the_data_contradict_is_told() {
        let estimated = |value: f64, std_error: f64| Coefficient {
            value,
            std_error,
            std_error_cluster_robust: None,
            interval: [0.0; 2],
            unit: "1".to_owned(),
            at_bound: false,
            fixed: false,
            model_value: 1.0,
            prior: Some([1.0, 2.0]),
        };
        let (why, conflict) = prior_conflict("c", &estimated(7.0, 1.0)).expect("a conflict");
        let (data, of_data) = (9.0, 4.0_f64 / 3.0);
        assert!((conflict - (data - 1.0) / (of_data + 4.0).sqrt()).abs() < 1e-12);
        assert!(
            why.contains("they alone give 9.0, 3.5 standard deviations"),
            "{why}"
        );
        assert_eq!(prior_conflict("c", &estimated(6.0, 1.0)), None);
        assert_eq!(prior_conflict("c", &estimated(7.0, 2.0)), None);
    }

    #[test]
    fn a_missing_term_is_told_if_it_is_significant() {
        let told = |p_value: f64| {
            let missing_term = Some(MissingTerm {
                target: "der(vx)".to_owned(),
                changes_with: Some("V".to_owned()),
                tests: 3,
                p_value,
            });
            let test = LackOfFit {
                p_value: 1.0,
                flights: Default::default(),
                largest_misfits: Vec::new(),
                missing_term,
                input_noise: None,
                noise_m: 0.0,
                beyond_noise_m: 0.0,
                excess_chi2: 0.0,
                has_length: true,
                noise: NoiseModel::white(0.0, 1.0),
            };
            test.missing_term()
        };
        assert!(
            told(0.001).is_some_and(|why| why.contains("der(vx) lacks a term that changes with V"))
        );
        assert_eq!(told(0.01), None);
    }
}
