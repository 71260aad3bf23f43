//! Whether an answer to spoiled data can be trusted.

use std::collections::BTreeMap;

use identify::{FitError, FitReport, FlightOutcome};

/// Greatest error of a coefficient that counts as right, in standard errors.
pub(super) const MAX_Z: f64 = 4.0;

/// What the answer is worth.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Judgement {
    /// The spoiled flights are named or set aside.
    Named,
    /// Nothing is named, and every coefficient is within four standard errors of the truth.
    Right,
    /// The report says not to rely on it.
    Unreliable,
    /// The fit ended with a message.
    Refused,
    /// Wrong coefficients without a word.
    Wrong,
    /// The fit took too long.
    TooLong,
}

impl Judgement {
    /// Whether a user is not misled.
    pub fn is_safe(self) -> bool {
        !matches!(self, Self::Wrong | Self::TooLong)
    }

    /// The judgement in a word.
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

/// A judged answer.
#[derive(Clone, Debug)]
pub struct Judged {
    /// What the answer is worth.
    pub judgement: Judgement,
    /// Greatest error of a coefficient, in standard errors; `None` without a result.
    pub max_z: Option<f64>,
    /// Untouched flights that are named or set aside.
    pub blamed: Vec<String>,
    /// What the answer says.
    pub says: String,
}

/// Judges a fit of flights of which those named `spoiled` were changed.
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
                says: error.to_string().replace('\n', " "),
            };
        }
    };
    let named = named(report);
    let mut errors = truth.iter().map(|(name, truth)| {
        let found = report.coefficients.get(name)?;
        let error = found
            .std_error
            .max(found.std_error_clustered.unwrap_or(0.0));
        Some((found.value - truth).abs() / error)
    });
    let max_z = errors.try_fold(0.0_f64, |most, z| Some(most.max(z?)));
    let is_right = max_z.is_some_and(|z| z <= MAX_Z);
    let is_named = spoiled.iter().all(|file| named.contains_key(file));
    let distrust = distrust(report);
    // With a named flight the coefficients must still be right, or the report must warn.
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
        says: says.join("; ").replace('\n', " "),
    }
}

/// Flights that are named as faulty, truncated or excluded, with the reason.
fn named(report: &FitReport) -> BTreeMap<String, String> {
    let mut named = BTreeMap::new();
    for fault in &report.data_faults {
        let says = format!("{}; {}", fault.detail, fault.mend);
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
                .or_insert_with(|| cut.why.clone());
        }
    }
    named
}

/// Reasons not to rely on a report.
fn distrust(report: &FitReport) -> Vec<String> {
    match report.reliable {
        true => Vec::new(),
        false => report.why.clone(),
    }
}
