//! Terminal summary of a fit.

use std::fmt::Write;

use comfy_table::Table;
use comfy_table::presets::UTF8_BORDERS_ONLY;
use dataset::Role;
use identify::{DataFault, FitReport, FlightReport};
use model_spec::model::Model;
use model_spec::sort_by_number;

use super::tables::role;

/// Maximum number of flights in the terminal summary; if there are more, those with the largest residuals are listed.
const LISTED: usize = 20;

/// Text of the terminal summary of a fit.
pub fn summary(model: &Model, report: &FitReport) -> String {
    let left_out = report.excluded().count();
    let mut text = cautions("fit", &report.cautions, &report.data_faults);
    let _ = write!(
        text,
        "{}{}: {} flights fitted, {} held out",
        report.model,
        report
            .effects
            .iter()
            .map(|effect| format!(" with {effect}"))
            .collect::<String>(),
        report.used(Role::Fit).count(),
        report.used(Role::HeldOut).count()
    );
    if left_out > 0 {
        let _ = write!(text, ", {left_out} excluded");
    }
    if let Some(noise) = report.position_noise() {
        let _ = writeln!(
            text,
            "; rms {:.2} mm\nnoise per coordinate: {:.2} mm ({}), lag-1 autocorrelation {:.2}, {} of {} points outliers",
            1e3 * report.rms(),
            1e3 * noise.sigma,
            if noise.estimated {
                "estimated"
            } else {
                "given"
            },
            noise.lag1_autocorrelation,
            noise.outliers,
            noise.points,
        );
    } else {
        text.push('\n');
    }
    for sensor in &report.sensors {
        let _ = writeln!(
            text,
            "{} ({}): rms {:.3} {unit}, noise {:.3} {unit}, lag-1 autocorrelation {:.2}, {} of {} outliers",
            sensor.name,
            sensor.measures,
            sensor.rms,
            sensor.sigma,
            sensor.lag1_autocorrelation,
            sensor.outliers,
            sensor.points,
            unit = sensor.unit,
        );
    }
    text.push('\n');
    let _ = writeln!(text, "{}\n", coefficients(model, report));
    for undetermined in &report.not_identifiable {
        let _ = writeln!(text, "not identifiable: {}\n", undetermined.reason);
    }
    if let Some(scatter) = scatter(report) {
        let _ = writeln!(text, "{scatter}\n");
    }
    for profile in &report.profiles {
        let end = |end: Option<f64>| {
            end.map_or("beyond the profiled range".into(), |end| {
                format!("{end:.5}")
            })
        };
        let _ = writeln!(
            text,
            "{}: 95 % profile-likelihood interval {} .. {}",
            profile.name,
            end(profile.interval[0]),
            end(profile.interval[1])
        );
    }
    text.push_str(&flights(report));
    text
}

/// Text of the reasons not to rely on a result (`what`, such as a fit), and of the faults of the data with instructions
/// for correcting them; empty if there are neither reasons nor faults.
pub fn cautions(what: &str, reasons: &[String], faults: &[DataFault]) -> String {
    let mut text = String::new();
    if !reasons.is_empty() {
        let _ = writeln!(text, "DO NOT RELY ON THIS {}:", what.to_uppercase());
        for reason in reasons {
            let _ = writeln!(text, "  {reason}");
        }
        text.push('\n');
    }
    if !faults.is_empty() {
        let _ = writeln!(text, "faults of the data ({}):", faults.len());
        for fault in faults.iter().take(LISTED) {
            let DataFault {
                file,
                fault,
                detail,
                correction,
            } = fault;
            let _ = writeln!(
                text,
                "  {file}: {}: {detail}; {correction}",
                fault.name().replace('_', " ")
            );
        }
        if faults.len() > LISTED {
            let _ = writeln!(
                text,
                "  … and {} more, in report.json",
                faults.len() - LISTED
            );
        }
        text.push('\n');
    }
    text
}

fn table(head: &[&str]) -> Table {
    let mut table = Table::new();
    table
        .load_style(UTF8_BORDERS_ONLY)
        .set_header(head.to_vec());
    table
}

/// Terminal table of the estimates of a fit: the coefficients, in the order in which the model declares them, then the
/// parameters that the fit estimated too.
fn coefficients(model: &Model, report: &FitReport) -> Table {
    let mut table = table(&[
        "coefficient",
        "value",
        "standard error",
        "95 % interval",
        "unit",
        "",
    ]);
    let declared: Vec<&str> = model.coefficients.iter().map(|c| c.name.as_str()).collect();
    let freed = report.coefficients.keys().map(String::as_str);
    let freed = freed.filter(|name| !declared.contains(name));
    for name in declared.iter().copied().chain(freed) {
        let Some(found) = report.coefficients.get(name) else {
            continue;
        };
        let digits = digits(found.std_error);
        let number = |value: f64| written(value, digits);
        let interval = match found.fixed {
            true => String::new(),
            false => format!(
                "{} .. {}",
                number(found.interval[0]),
                number(found.interval[1])
            ),
        };
        let error = match found.fixed {
            true => String::new(),
            false => format!("{:.1e}", found.std_error),
        };
        let remark = match (found.fixed, found.at_bound, found.prior) {
            (true, ..) => "fixed",
            (_, true, _) => "at its bound",
            (.., Some(_)) => "with a prior",
            _ => "",
        };
        table.add_row([
            name,
            &number(found.value),
            &error,
            &interval,
            &found.unit,
            remark,
        ]);
    }
    table
}

/// Number of decimals, at least 0, with which a number shows two significant digits of its standard error; 6 if the
/// standard error is 0.
pub fn digits(std_error: f64) -> i32 {
    if std_error > 0.0 {
        (1 - std_error.log10().floor() as i32).max(0)
    } else {
        6
    }
}

/// Formats a number with `digits` decimals; a negative number of decimals counts as 0, one above 8 as 8. Nonzero
/// magnitudes below 1e-3 are written with an exponent, rounded to the same decimal place.
pub fn written(value: f64, digits: i32) -> String {
    if value != 0.0 && value.abs() < 1e-3 {
        let size = value.abs().log10().floor() as i32;
        return format!("{value:.*e}", (digits + size).clamp(0, 8) as usize);
    }
    format!("{value:.*}", digits.clamp(0, 8) as usize)
}

/// Sentence that warns of large ratios of cluster-robust to Cramér–Rao standard errors; `None` if no ratio is large.
fn scatter(report: &FitReport) -> Option<String> {
    let worst = report
        .coefficients
        .iter()
        .filter_map(|(name, found)| Some((name, found.std_error_cluster_robust? / found.std_error)))
        .filter(|(_, ratio)| ratio.is_finite())
        .max_by(|a, b| a.1.total_cmp(&b.1))?;
    (worst.1 > 1.7).then(|| {
        format!(
            "the flights differ by more than their noise: the cluster-robust standard error of {} is {:.1} times the one above; the model may lack an effect",
            worst.0, worst.1
        )
    })
}

fn flights(report: &FitReport) -> String {
    let mut order: Vec<&FlightReport> = report.flights.iter().collect();
    let mut text = String::new();
    if order.len() > LISTED {
        sort_by_number(&mut order, |flight| -flight.rms());
        order.truncate(LISTED);
        let _ = writeln!(
            text,
            "the {LISTED} flights with the largest residuals; all are in flights.csv"
        );
    }
    let mut table = table(&["flight", "role", "samples", "rms, mm", "outliers", ""]);
    for flight in order {
        let cut = flight
            .cut
            .iter()
            .map(|cut| format!("cut at {:.3} s: {}", cut.t, cut.reason));
        let remarks: Vec<String> = cut.chain(flight.notes.iter().cloned()).collect();
        let rms = match flight.is_used() {
            true => format!("{:.2}", 1e3 * flight.rms()),
            false => String::new(),
        };
        table.add_row([
            flight.file.as_str(),
            role(flight.role),
            &flight.samples.to_string(),
            &rms,
            &flight.outliers.to_string(),
            &remarks.join("; "),
        ]);
    }
    let _ = writeln!(text, "{table}");
    if report.used(Role::HeldOut).next().is_some() {
        text.push_str(
            "held out: initial state fitted to the first 30 % of the samples; rms of the prediction of the rest\n",
        );
    }
    text
}
