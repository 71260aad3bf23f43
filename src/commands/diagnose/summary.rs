//! Terminal summary of a diagnosis.

use std::fmt::Write;

use comfy_table::Table;
use comfy_table::presets::UTF8_BORDERS_ONLY;
use diagnose::Report;
use report::diagnosis::{lack_of_fit_sentence, paired_gain_sentence, verdict_name};

use crate::commands::fit::cautions;

/// Maximum number of candidate effects in the terminal summary of a diagnosis.
const LISTED: usize = 10;

/// Text of the terminal summary of a diagnosis.
pub fn summary(report: &Report) -> String {
    let mut text = cautions("diagnosis", &report.cautions, &report.data_faults);
    let _ = write!(
        text,
        "{}: {}\n\n",
        verdict_name(report.verdict),
        wrapped(&report.summary)
    );
    for (index, explanation) in report.explanations.iter().enumerate() {
        let names: Vec<&str> = explanation
            .effects
            .iter()
            .map(|e| e.name.as_str())
            .collect();
        let _ = write!(text, "explanation {}: {}", index + 1, names.join(" with "));
        for effect in &explanation.effects {
            for (name, estimate) in &effect.estimates {
                let unit = if estimate.unit == "1" {
                    ""
                } else {
                    &estimate.unit
                };
                let _ = write!(
                    text,
                    ", {name} = {:.4e} ± {:.1e} {unit}",
                    estimate.value, estimate.std_error
                );
            }
        }
        if explanation.explained_fraction > 0.0 {
            let _ = write!(
                text,
                "; explains {:.0} % of the misfit, {:.2} mm remain beyond the noise",
                1e2 * explanation.explained_fraction,
                1e3 * explanation.remaining_rms_m
            );
        }
        text.push('\n');
    }
    if let Some(gain) = &report.predictive_gain {
        let how = if gain.held_out_by_dataset {
            "held-out flights"
        } else {
            "cross-validation"
        };
        let _ = writeln!(
            text,
            "{how} ({} flights): RMS prediction error {:.2} mm before, {:.2} mm after (gain {:.2} ± {:.2} mm; noise {:.2} mm)",
            gain.flights,
            1e3 * gain.rms_before_m,
            1e3 * gain.rms_after_m,
            1e3 * (gain.rms_before_m - gain.rms_after_m),
            1e3 * gain.std_error_m,
            1e3 * gain.noise_m,
        );
    }
    if let Some(gain) = &report.predictive_gain
        && let Some(paired) = paired_gain_sentence(gain)
    {
        let _ = writeln!(text, "{}", wrapped(&paired));
    }
    if let Some(test) = &report.lack_of_fit {
        let _ = writeln!(text, "{}", wrapped(&lack_of_fit_sentence(test)));
    }
    for note in &report.notes {
        let _ = writeln!(text, "note: {note}");
    }
    if let Some(throw) = &report.proposed_throw {
        let _ = writeln!(text, "proposed throw: {}", throw.description);
    }
    if let Some(verified) = &report.verified {
        let holds = if verified.holds { "passes" } else { "FAILS" };
        let _ = writeln!(
            text,
            "the extended model {holds} its checks ({})",
            verified.checks.len()
        );
    }
    let _ = writeln!(text, "\n{}\n", candidates(report));
    if !report.not_identifiable.is_empty() {
        text.push_str("not identifiable from these flights:\n");
        for hidden in &report.not_identifiable {
            let by = match hidden.confounded_with.as_slice() {
                [] => "no influence here".to_owned(),
                names => format!("confounded with {}", names.join(", ")),
            };
            let _ = writeln!(text, "  {} ({by})", hidden.name);
        }
    }
    let _ = writeln!(
        text,
        "noise per coordinate: {:.2} mm, lag-1 autocorrelation {:.2}, {:.1} % outliers",
        1e3 * report.leading_noise().sigma,
        report.leading_noise().lag1_autocorrelation,
        1e2 * report.leading_noise().outlier_fraction
    );
    text
}

/// Line width of a paragraph in the terminal summary, characters.
const WIDTH: usize = 100;

fn wrapped(text: &str) -> String {
    let mut lines = String::new();
    let mut width = 12;
    for word in text.split_whitespace() {
        if width + word.len() >= WIDTH {
            lines.push('\n');
            width = 0;
        } else if !lines.is_empty() {
            lines.push(' ');
            width += 1;
        }
        lines.push_str(word);
        width += word.chars().count();
    }
    lines
}

fn candidates(report: &Report) -> Table {
    let mut table = Table::new();
    table.load_style(UTF8_BORDERS_ONLY).set_header(vec![
        "effect",
        "site",
        "score χ²",
        "d.o.f.",
        "z",
        "tolerance",
    ]);
    for candidate in report.tests.iter().take(LISTED) {
        let mark = if candidate.significant { " *" } else { "" };
        table.add_row(vec![
            format!("{}{mark}", candidate.name),
            candidate.site.clone(),
            format!("{:.1}", candidate.score_chi2),
            candidate.degrees_of_freedom.to_string(),
            format!("{:.1}", candidate.z),
            format!("{:.1e}", candidate.tolerance),
        ]);
    }
    let rest = report.tests.len().saturating_sub(LISTED);
    if rest > 0 {
        table.add_row(vec![format!("… and {rest} more")]);
    }
    table
}
