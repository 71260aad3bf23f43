//! Formats one line per run of a row, for the option `--details`.

use super::outcome::Outcome;
use super::run::RowResult;

/// Lines of text about the runs under one combination of simulation settings: a heading and one line per run. For a run
/// with an entry in `rejections` a second line follows: the result of the diagnosis repeated with a model that contains
/// the effects added to the simulated flights.
pub fn details(result: &RowResult, rejections: &[Option<String>]) -> Vec<String> {
    let mut lines = vec![result.row.key()];
    for (run, outcome) in result.outcomes.iter().enumerate() {
        lines.push(line(run, outcome));
        if let Some(text) = rejections.get(run).and_then(Option::as_ref) {
            lines.push(format!("      {text}"));
        }
    }
    lines
}

fn line(run: usize, outcome: &Outcome) -> String {
    let remaining = outcome.strongest_remaining.iter().flatten();
    let remaining: Vec<String> = remaining
        .map(|(name, p)| format!("{name} p={p:.1e}"))
        .collect();
    let remaining = match remaining.is_empty() {
        true => "–".to_owned(),
        false => remaining.join(", "),
    };
    let number = |value: Option<f64>| value.map_or("–".into(), |value| format!("{value:.2}"));
    let held_out = &outcome.held_out;
    let failure = outcome.failure.as_ref();
    let failure = failure.map_or(String::new(), |why| {
        format!("; {}", why.lines().next().unwrap_or(""))
    });
    format!(
        "  {run} seed {} {} [{}] answer {}; remaining {remaining}; z = {}, size / detectable {}{}; held out {:.2} -> {:.2} mm, true model {} mm; {:.1} s{failure}",
        outcome.case.seed,
        mark(outcome),
        truth(outcome),
        outcome.answer(),
        number(outcome.z),
        number(outcome.detectability),
        if outcome.not_identifiable {
            " (not identifiable)"
        } else {
            ""
        },
        1e3 * held_out.before,
        1e3 * held_out.after,
        number(held_out.truth.map(|rms| 1e3 * rms)),
        outcome.seconds,
    )
}

fn mark(outcome: &Outcome) -> &'static str {
    match () {
        () if outcome.failure.is_some() => "FAILED",
        () if outcome.uniquely_wrong => "WRONG",
        () if outcome.in_set => "found",
        () if outcome.is_detectable(1.0) => "MISSED",
        () if outcome.is_detected() => "detected",
        () => "none",
    }
}

/// Names of the effects added to the simulated flights, with their values in parentheses.
fn truth(outcome: &Outcome) -> String {
    let seeded = &outcome.case.seeded;
    let listed = seeded.listed.iter().map(|(name, values)| {
        let values: Vec<String> = values.iter().map(|v| format!("{v:.3e}")).collect();
        format!("{name}({})", values.join(", "))
    });
    let unlisted = seeded.unlisted.iter();
    let unlisted = unlisted.map(|(name, size)| format!("{name}({size:.3e})"));
    let all: Vec<String> = listed.chain(unlisted).collect();
    all.join(" ")
}
