//! Renders docs/studies/identification.md.

use serde::Serialize;

use super::coverage::{CoefficientCoverage, Coverage};
use super::paper_fits::{BFFL8_HALF, FSSH3_HALF, PaperFits, Scenario};
use super::scatter::scatter;
use crate::error::StudyError;
use crate::oracle_flights::TRUTH;
use crate::page::{Page, render};
use crate::paper::printed_coefficient;

#[derive(Serialize)]
struct Results<'r> {
    coverage: CoverageSection<'r>,
    paper: PaperSection<'r>,
}

#[derive(Serialize)]
struct CoverageSection<'r> {
    seeds: usize,
    truth: String,
    conditions: Vec<ConditionRow<'r>>,
    first: &'r str,
    coefficients: &'r [CoefficientCoverage],
}

/// Table row: coverage of the 95 % confidence intervals under one noise condition (fraction of the intervals that
/// contain the true value).
#[derive(Serialize)]
struct ConditionRow<'r> {
    name: &'r str,
    covered: f64,
    least: f64,
    greatest: f64,
    covered_clustered: f64,
    max_z: f64,
    failed: usize,
}

#[derive(Serialize)]
struct PaperSection<'r> {
    seeds: usize,
    scenarios: Vec<ScenarioRow<'r>>,
    coefficients: Vec<CoefficientRow<'r>>,
    messages: &'r [String],
    /// Coefficient whose standard deviation decreases least from the fit of flight fssh3 alone to the fit of twelve
    /// throws, and the ratio of these two standard deviations.
    least_improvement: (&'r str, f64),
    last: ScenarioRow<'r>,
}

#[derive(Serialize)]
struct ScenarioRow<'r> {
    name: &'r str,
    implausible: usize,
    non_identifiable: usize,
    /// Names of the coefficients that the fit reports call non-identifiable for more than half of the noise seeds.
    which: String,
    failed: usize,
}

#[derive(Serialize)]
struct CoefficientRow<'r> {
    name: &'r str,
    truth: f64,
    printed: [f64; 2],
    /// Standard deviations of the estimates of this coefficient over the seeds of the noise, one for each scenario (set
    /// of fitted flights).
    deviations: Vec<f64>,
    /// Absolute difference between the values of the coefficient that Hubbard & Hummel (2000) print for their two
    /// flights.
    difference: f64,
    /// Standard deviation expected of the difference between two estimates, one from half a second of flight fssh3 and
    /// one from half a second of flight bffl8.
    expected: f64,
}

/// Renders docs/studies/identification.md from the coverages of confidence intervals and the fits of the flights of Hubbard &
/// Hummel (2000).
///
/// # Errors
/// [`StudyError::Page`] if the template cannot be rendered with the results.
pub fn identification_page(coverages: &[Coverage], fits: &PaperFits) -> Result<Page, StudyError> {
    let results = Results {
        coverage: coverage_section(coverages),
        paper: paper_section(fits)?,
    };
    Ok(Page {
        text: render(include_str!("page.md"), results)?,
        figures: vec![("identification-scatter.svg".into(), scatter(fits))],
    })
}

fn coverage_section(coverages: &[Coverage]) -> CoverageSection<'_> {
    let first = coverages.first();
    CoverageSection {
        seeds: first.map_or(0, |coverage| coverage.seeds),
        truth: TRUTH
            .map(|(name, value)| format!("{name} {value}"))
            .join(", "),
        conditions: coverages.iter().map(condition_row).collect(),
        first: first.map_or("", |coverage| coverage.condition.name),
        coefficients: first.map_or(&[], |coverage| &coverage.coefficients),
    }
}

fn condition_row(coverage: &Coverage) -> ConditionRow<'_> {
    let rows = &coverage.coefficients;
    let covered = || {
        rows.iter()
            .map(|row| row.covered as f64 / coverage.seeds as f64)
    };
    ConditionRow {
        name: coverage.condition.name,
        covered: coverage.covered(),
        least: covered().fold(1.0, f64::min),
        greatest: covered().fold(0.0, f64::max),
        covered_clustered: coverage.covered_clustered(),
        max_z: rows.iter().map(|row| row.max_z).fold(0.0, f64::max),
        failed: coverage.failed,
    }
}

fn paper_section(fits: &PaperFits) -> Result<PaperSection<'_>, StudyError> {
    let named = |name: &str| {
        let mut scenarios = fits.scenarios.iter();
        let found = scenarios.find(|scenario| scenario.name == name);
        found.ok_or_else(|| StudyError::Name {
            of: "scenarios",
            name: name.to_owned(),
        })
    };
    let (fssh3, bffl8) = (named(FSSH3_HALF)?, named(BFFL8_HALF)?);
    let twelve = fits.scenarios.last().unwrap_or(bffl8);
    let first = fits.scenarios.first().unwrap_or(fssh3);
    let deviation = |scenario: &Scenario, k: usize| scenario.mean_and_deviation(k).1;
    let coefficients = fits.truth.iter().enumerate();
    let coefficients = coefficients.filter_map(|(k, (name, truth))| {
        let printed = printed_coefficient(name)?;
        Some(CoefficientRow {
            name,
            truth: *truth,
            printed,
            deviations: fits.scenarios.iter().map(|s| deviation(s, k)).collect(),
            difference: (printed[0] - printed[1]).abs(),
            expected: deviation(fssh3, k).hypot(deviation(bffl8, k)),
        })
    });
    let improvements = fits
        .truth
        .iter()
        .enumerate()
        .map(|(k, (name, _))| (name.as_str(), deviation(fssh3, k) / deviation(twelve, k)));
    let least = improvements.fold(("", f64::INFINITY), |least, next| {
        if next.1 < least.1 { next } else { least }
    });
    Ok(PaperSection {
        seeds: fits.seeds,
        scenarios: fits
            .scenarios
            .iter()
            .map(|s| scenario_row(fits, s))
            .collect(),
        coefficients: coefficients.collect(),
        messages: &first.messages,
        least_improvement: least,
        last: scenario_row(fits, twelve),
    })
}

fn scenario_row<'r>(fits: &'r PaperFits, scenario: &'r Scenario) -> ScenarioRow<'r> {
    let counts = fits.truth.iter().zip(&scenario.non_identifiable);
    let most = counts.filter(|(_, count)| 2 * **count > fits.seeds);
    let names: Vec<String> = most.map(|((name, _), _)| format!("`{name}`")).collect();
    ScenarioRow {
        name: scenario.name,
        implausible: scenario.implausible,
        non_identifiable: scenario.any_non_identifiable,
        which: names.join(" "),
        failed: scenario.failed,
    }
}
