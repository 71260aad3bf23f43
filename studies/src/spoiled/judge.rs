//! Classifies the answer of a fit to spoiled data: whether it could mislead a user.

use std::collections::BTreeMap;

use identify::{FitError, FitReport, FlightOutcome};

/// Maximum error of an estimated coefficient that counts as correct, in standard errors.
pub(super) const MAX_Z: f64 = 4.0;

/// How a fit responds to data with a recording mistake that was introduced on purpose.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Judgement {
    /// The fit reports every flight with the recording mistake as faulty, truncated or excluded. In addition, every
    /// coefficient is within four standard errors of the true value, or the report states that it is unreliable.
    Named,
    /// The fit does not report every flight with the recording mistake, but every coefficient is within four standard
    /// errors of the true value.
    Right,
    /// The fit does not report every flight with the recording mistake, but its report states that the results are
    /// unreliable.
    Unreliable,
    /// The fit ended with an error message and without a result.
    Refused,
    /// A coefficient has no estimate within four standard errors of the true value, and the report does not state that
    /// its results are unreliable.
    Wrong,
    /// The fit was cancelled because it reached the limit of its computing time.
    TooLong,
}

impl Judgement {
    /// Whether the result does not mislead a user: it is neither wrong without a warning nor too late.
    pub fn is_safe(self) -> bool {
        !matches!(self, Self::Wrong | Self::TooLong)
    }

    /// Text of this class of a fit's result, as printed on the page of results.
    pub fn label(self) -> &'static str {
        match self {
            Self::Named => "named",
            Self::Right => "right",
            Self::Unreliable => "do not rely",
            Self::Refused => "refused",
            Self::Wrong => "**wrong**",
            Self::TooLong => "**too long**",
        }
    }
}

/// Result of a fit of data with a recording mistake, and its classification.
#[derive(Clone, Debug)]
pub struct Judged {
    /// Classification of the fit's result by whether it could mislead a user.
    pub judgement: Judgement,
    /// Maximum error of a coefficient, in standard errors (the larger of the plain and the cluster-robust one); `None`
    /// if the fit failed or lacks a coefficient.
    pub max_z: Option<f64>,
    /// File names of flights into which no mistake was introduced, but which the fit reports as faulty, truncated or
    /// excluded.
    pub blamed: Vec<String>,
    /// Messages of the fit: the first flight that is reported as faulty, truncated or excluded, with the reason, and
    /// the reasons why the report is unreliable. If the fit failed, its error message.
    pub description: String,
}

/// Classifies the result of a fit of a dataset in which a mistake was introduced into the flights with the file names
/// `spoiled`. `truth` contains the names and true values of the coefficients.
pub(super) fn judge(
    result: &Result<FitReport, FitError>,
    spoiled: &[String],
    truth: &[(String, f64)],
) -> Judged {
    let report = match result {
        Ok(report) => report,
        Err(error) => {
            let judgement = match error {
                FitError::Interrupted => Judgement::TooLong,
                _ => Judgement::Refused,
            };
            return Judged {
                judgement,
                max_z: None,
                blamed: Vec::new(),
                description: error.to_string().replace('\n', " "),
            };
        }
    };
    let named = named(report);
    let mut errors = truth.iter().map(|(name, truth)| {
        let found = report.coefficients.get(name)?;
        let error = found
            .std_error
            .max(found.std_error_cluster_robust.unwrap_or(0.0));
        Some((found.value - truth).abs() / error)
    });
    let max_z = errors.try_fold(0.0_f64, |most, z| Some(most.max(z?)));
    let is_right = max_z.is_some_and(|z| z <= MAX_Z);
    let is_named = spoiled.iter().all(|file| named.contains_key(file));
    let distrust = distrust(report);
    // Even if all spoiled flights are named, the coefficients must be right or the report must warn.
    let judgement = match () {
        () if !report.reliable => match is_named {
            true => Judgement::Named,
            false => Judgement::Unreliable,
        },
        () if is_named && is_right => Judgement::Named,
        () if is_right => Judgement::Right,
        () => Judgement::Wrong,
    };
    let blamed = named.keys().filter(|file| !spoiled.contains(file));
    let blamed: Vec<String> = blamed.cloned().collect();
    let first = named.iter().next();
    let says = first.map(|(file, why)| format!("{file}: {why}"));
    let says = says.into_iter().chain(distrust).collect::<Vec<_>>();
    Judged {
        judgement,
        max_z,
        blamed,
        description: says.join("; ").replace('\n', " "),
    }
}

/// Maps the file name of each flight that the report names as faulty, excluded or truncated to the reason.
fn named(report: &FitReport) -> BTreeMap<String, String> {
    let mut named = BTreeMap::new();
    for fault in &report.data_faults {
        let says = format!("{}; {}", fault.detail, fault.correction);
        named.insert(fault.file.clone(), says);
    }
    for flight in &report.flights {
        if let FlightOutcome::Excluded { reason } = &flight.outcome {
            named
                .entry(flight.file.clone())
                .or_insert_with(|| reason.clone());
        } else if let Some(cut) = &flight.cut {
            named
                .entry(flight.file.clone())
                .or_insert_with(|| cut.reason.clone());
        }
    }
    named
}

/// Reasons that the report gives for its results being unreliable; empty if they are reliable.
fn distrust(report: &FitReport) -> Vec<String> {
    match report.reliable {
        true => Vec::new(),
        false => report.cautions.clone(),
    }
}
