//! Section of docs/studies/real-data.md on the table-tennis balls.

use dataset::Role;
use diagnose::Report as Diagnosis;
use diagnose::held_out_gain;
use identify::{Coefficient, FitReport};
use serde::Serialize;

use super::agreement::Agreement;
use super::lift::Lift;
use super::results::{Added, Balls};
use super::stretches::{AGREEING, is_agreeing};
use crate::error::StudyError;
use crate::page::render;
use crate::statistics::median;

#[derive(Serialize)]
struct Section {
    flights: usize,
    fitted: usize,
    held_out: usize,
    plain: FitSummary,
    drag: Estimate,
    outliers: usize,
    points: usize,
    outlier_fraction: f64,
    common: Vec<FitSummary>,
    free_lift: FitSummary,
    /// Median over the flights of the RMS residual along y (the direction of flight) / mean speed, s: an estimate of
    /// the timing error. `None` without a finite value.
    time_error: Option<f64>,
    stretches: String,
    agreement: Vec<AgreementRow>,
    /// Maximum angle between lift and ω × v, degrees, over the flights in those parts of the recording in which every
    /// lift agrees with the spin ω that the data state.
    greatest_angle: f64,
    /// Number of flights outside the file ranges [`AGREEING`] whose cosine between lift and ω × v is above 0.9.
    same_side: usize,
    /// Number of flights outside the file ranges [`AGREEING`] whose cosine between lift and ω × v is below −0.9.
    opposite_side: usize,
    lift_by_spin: Vec<LiftRow>,
    magnus: Estimate,
    /// Mean lift coefficient / mean advance ratio over the flights in the file ranges [`AGREEING`] with an advance
    /// ratio below 0.3.
    slope_low: f64,
    /// Mean lift coefficient / mean advance ratio over the flights in the file ranges [`AGREEING`] with an advance
    /// ratio of at least 0.7.
    slope_high: f64,
    added: Vec<AddedRow>,
    diagnoses: Vec<DiagnosisRow>,
}

/// Estimate of a coefficient, with its cluster-robust standard error (clusters are flights).
#[derive(Serialize)]
struct Estimate {
    name: String,
    value: f64,
    std_error: f64,
}

impl Estimate {
    fn of(name: &str, found: &Coefficient) -> Self {
        Self {
            name: name.to_owned(),
            value: found.value,
            std_error: found.std_error_cluster_robust.unwrap_or(found.std_error),
        }
    }
}

#[derive(Serialize)]
struct FitSummary {
    effects: String,
    rms_m: f64,
    /// Standard deviations of the noise of the measured positions along x, y and z, m.
    sigma_m: [f64; 3],
    ar1: f64,
    /// Estimates of the coefficients that the effects of this fit add to the model.
    coefficients: Vec<Estimate>,
}

#[derive(Serialize)]
struct AgreementRow {
    files: String,
    #[serde(flatten)]
    agreement: Agreement,
}

#[derive(Serialize)]
struct LiftRow {
    model: &'static str,
    rms_m: f64,
    /// Estimates of three coefficients: drag C_D, lift per advance ratio C_Lw, and lift per squared advance ratio
    /// C_Lww. `None` for a coefficient that the fitted model lacks.
    estimates: [Option<Estimate>; 3],
    held_out_m: Option<f64>,
    /// Decrease of the RMS prediction error on held-out flights from the model of the previous table row to the model
    /// of the present row, and standard error of the decrease, m. `None` for the first row or without held-out flights.
    reduction: Option<(f64, f64)>,
}

#[derive(Serialize)]
struct AddedRow {
    effect: &'static str,
    to_magnus: FitSummary,
    to_square: FitSummary,
}

#[derive(Serialize)]
struct DiagnosisRow {
    what: &'static str,
    failure: Option<String>,
    magnus: Option<MagnusScore>,
    summary: String,
}

/// Result of the score test of the effect `magnus` in a diagnosis of the table-tennis flights.
#[derive(Serialize)]
struct MagnusScore {
    statistic: f64,
    /// Score statistic of `magnus` / the maximum score statistic of all candidate effects.
    fraction: f64,
    discordant: usize,
}

/// Renders the section of docs/studies/real-data.md on the flights of table-tennis balls, as Markdown.
pub(in super::super) fn balls_section(balls: &Balls) -> Result<String, StudyError> {
    let report = &balls.plain;
    let count = |role: Role| report.flights.iter().filter(|f| f.role == role).count();
    let time_errors = balls.lifts.iter().map(|l| l.residual_along / l.speed);
    let inside = || balls.lifts.iter().filter(|lift| is_agreeing(&lift.file));
    let outside = || balls.lifts.iter().filter(|lift| !is_agreeing(&lift.file));
    let least = inside().map(Lift::cosine).fold(f64::INFINITY, f64::min);
    let stretches = AGREEING.map(|(first, last)| format!("{first} to {last}"));
    let files = ["all".into(), stretches.join(", "), "the others".into()];
    let agreement = files.into_iter().zip(balls.agreement);
    let square_names: Vec<&String> = balls.lift_by_spin[2].coefficients.keys().collect();
    let section = Section {
        flights: report.flights.len(),
        fitted: count(Role::Fit),
        held_out: count(Role::HeldOut),
        plain: fit_summary("", report, &["C_D"]),
        drag: Estimate::of("C_D", &report.coefficients["C_D"]),
        outliers: report.leading_noise().outliers,
        points: report.leading_noise().points,
        outlier_fraction: report.leading_noise().outlier_fraction,
        common: common_fits(balls),
        free_lift: fit_summary("", &balls.free_lift, &["C_D"]),
        time_error: median(time_errors),
        stretches: stretches.join(" and "),
        agreement: agreement
            .map(|(files, agreement)| AgreementRow { files, agreement })
            .collect(),
        greatest_angle: least.acos().to_degrees(),
        same_side: outside().filter(|lift| lift.cosine() > 0.9).count(),
        opposite_side: outside().filter(|lift| lift.cosine() < -0.9).count(),
        lift_by_spin: lift_rows(balls),
        magnus: Estimate::of("C_Lw", &balls.lift_by_spin[1].coefficients["C_Lw"]),
        slope_low: slope(inside(), 0.0, 0.3),
        slope_high: slope(inside(), 0.7, f64::INFINITY),
        added: balls
            .added
            .iter()
            .map(|added| added_row(added, &square_names))
            .collect(),
        diagnoses: diagnosis_rows(balls),
    };
    render(include_str!("page.md"), section)
}

fn fit_summary(effects: &str, report: &FitReport, without: &[&str]) -> FitSummary {
    let coefficients = report.coefficients.iter();
    let coefficients = coefficients.filter(|(name, _)| !without.contains(&name.as_str()));
    FitSummary {
        effects: effects.to_owned(),
        rms_m: report.rms(),
        sigma_m: ["x", "y", "z"].map(|axis| report.leading_noise().axes[axis].sigma),
        ar1: report.leading_noise().lag1_autocorrelation,
        coefficients: coefficients
            .map(|(name, found)| Estimate::of(name, found))
            .collect(),
    }
}

fn common_fits(balls: &Balls) -> Vec<FitSummary> {
    let fits = balls.common.iter().map(|(effects, report)| {
        let effects: Vec<String> = effects.iter().map(|name| format!("`{name}`")).collect();
        fit_summary(&effects.join(", "), report, &["C_D"])
    });
    fits.collect()
}

fn lift_rows(balls: &Balls) -> Vec<LiftRow> {
    let models = [
        "gravity and drag",
        "with `magnus`",
        "with `magnus` and its square",
    ];
    let noise = balls.free_lift.leading_noise().sigma;
    let reports = &balls.lift_by_spin;
    let rows = models.into_iter().enumerate().map(|(k, model)| {
        let report = &reports[k];
        let previous = k.checked_sub(1).map(|previous| &reports[previous]);
        let gain = previous.and_then(|previous| held_out_gain(previous, report, noise));
        let held_out = held_out_gain(report, report, noise);
        LiftRow {
            model,
            rms_m: report.rms(),
            estimates: ["C_D", "C_Lw", "C_Lww"].map(|name| {
                let found = report.coefficients.get(name)?;
                Some(Estimate::of(name, found))
            }),
            held_out_m: held_out.map(|gain| gain.rms_before_m),
            reduction: gain.map(|gain| {
                let reduction = gain.rms_before_m - gain.rms_after_m;
                (reduction, gain.std_error_m)
            }),
        }
    });
    rows.collect()
}

/// Mean lift coefficient / mean advance ratio over the flights whose advance ratio is at least `low` and below `high`.
fn slope<'l>(lifts: impl Iterator<Item = &'l Lift>, low: f64, high: f64) -> f64 {
    let within = lifts.filter(|lift| (low..high).contains(&lift.advance_ratio()));
    let (lift, ratio) = within.fold((0.0, 0.0), |(lift, ratio), each| {
        (
            lift + each.coefficient_by_spin(),
            ratio + each.advance_ratio(),
        )
    });
    lift / ratio
}

fn added_row(added: &Added, square_names: &[&String]) -> AddedRow {
    let without: Vec<&str> = square_names.iter().map(|name| name.as_str()).collect();
    AddedRow {
        effect: added.effect,
        to_magnus: fit_summary("", &added.to_magnus, &without),
        to_square: fit_summary("", &added.to_square, &without),
    }
}

fn diagnosis_rows(balls: &Balls) -> Vec<DiagnosisRow> {
    let what = [
        "`hyzer diagnose` of all flights",
        "Of the agreeing stretches",
        "Of the agreeing stretches with `magnus` in the model",
    ];
    let rows = what.into_iter().zip(&balls.diagnoses);
    let rows = rows.map(|(what, diagnosis)| match diagnosis {
        Ok(report) => DiagnosisRow {
            what,
            failure: None,
            magnus: magnus_score(report),
            summary: report.summary.replace('\n', "\n> "),
        },
        Err(error) => DiagnosisRow {
            what,
            failure: error.to_string().lines().next().map(str::to_owned),
            magnus: None,
            summary: String::new(),
        },
    });
    rows.collect()
}

fn magnus_score(report: &Diagnosis) -> Option<MagnusScore> {
    let magnus = report.tests.iter().find(|c| c.name == "magnus")?;
    let greatest = report.tests.first()?;
    let agreement = report.consensus.as_ref();
    Some(MagnusScore {
        statistic: magnus.score_chi2,
        fraction: magnus.score_chi2 / greatest.score_chi2,
        discordant: agreement.map_or(0, |a| a.discordant.len()),
    })
}
