//! The page that tells which readings of the paper's tables survive its own claims.

use std::fmt::Write;

use crate::paper::claims::Claim;
use crate::paper::reading::{Reading, Table1};
use crate::paper::study::{PRICE, Scored, Study};

/// How many readings the ranking shows.
const SHOWN: usize = 20;

/// The page, in Markdown.
pub fn page(study: &Study) -> String {
    let mut text = String::new();
    head(&mut text, study);
    as_printed(&mut text, study);
    ranking(&mut text, study);
    best(&mut text, study);
    worth(&mut text, study);
    undecided(&mut text, study);
    text
}

fn line(text: &mut String, line: impl AsRef<str>) {
    text.push_str(line.as_ref());
    text.push('\n');
}

fn head(text: &mut String, study: &Study) {
    line(text, "# The paper, reproduced and questioned\n");
    line(
        text,
        "<!-- Written by `hyzer-studies paper`; do not edit. -->\n",
    );
    line(
        text,
        "Hubbard & Hummel, \"Simulation of Frisbee Flight\" (2000), simulates two flights, fssh3 and bffl8, from the",
    );
    line(
        text,
        "release conditions of its Table 3 with the coefficients of its Table 1, and says in words what came out. This page",
    );
    line(
        text,
        "flies both under every combination of declared hypotheses on what the tables mean, and holds the outcomes",
    );
    line(
        text,
        format!(
            "against the paper's {} statements. It is made by `hyzer-studies paper --out docs/paper.md`.\n",
            study.claims.len()
        ),
    );
    line(
        text,
        "The hypotheses: the sign of the pitch damping, of the roll damping, of the rolling moment by spin and of the",
    );
    line(
        text,
        "spin-down, each on its own; the four lift and drag columns of Table 1 in any order, the same for both flights or",
    );
    line(
        text,
        "not; the rolling moment's spin in rad/s, in rev/s, times √(d/g), or as the spin ratio r d/2V; C_Nr in N m s, in",
    );
    line(
        text,
        "N m per rev/s, or in s with ρV²Ad/2 before it. That makes",
    );
    line(
        text,
        format!(
            "{} readings of the two flights together.\n",
            study.ranking.len()
        ),
    );
    line(
        text,
        "A reading's misfit is the sum of its squared departures from the claims, each in units of the claim's tolerance and",
    );
    line(
        text,
        format!(
            "counted as 10 at most; its score adds {PRICE} for every hypothesis it uses (an interchange of two columns is one,"
        ),
    );
    line(text, "made in both flights alike it still is one).\n");
}

fn as_printed(text: &mut String, study: &Study) {
    line(text, "## Taken as printed\n");
    claims_table(text, study, &Reading::PRINTED);
    let held = study.of(&Reading::PRINTED).map_or(0, |scored| scored.held);
    line(
        text,
        format!(
            "\nTaken at its word, the print reproduces {held} of its own {} claims.\n",
            study.claims.len()
        ),
    );
}

fn claims_table(text: &mut String, study: &Study, reading: &Reading) {
    line(
        text,
        "| flight | claim | the paper says | comes out | departure, in tolerances | holds |",
    );
    line(text, "|---|---|---|---|---|---|");
    for claim in &study.claims {
        let (value, departure, holds) = match study.outcome(reading, &claim.flight) {
            Some(outcome) => {
                let departure = outcome.departure(claim);
                let holds = if departure.abs() <= 1.0 { "yes" } else { "no" };
                (
                    format!("{:.3}", outcome.quantity(&claim.quantity)),
                    format!("{departure:+.2}"),
                    holds,
                )
            }
            None => ("the flight is impossible".to_owned(), "–".to_owned(), "no"),
        };
        let stated = format!("{} ± {}", claim.value, claim.tolerance);
        let unit = if claim.unit == "1" {
            String::new()
        } else {
            format!(" {}", claim.unit)
        };
        line(
            text,
            format!(
                "| {} | {} | {stated}{unit} | {value}{unit} | {departure} | {holds} |",
                claim.flight,
                what(claim)
            ),
        );
    }
}

fn what(claim: &Claim) -> String {
    let quantity = match claim.quantity.as_str() {
        "delta_x" => "distance along x",
        "delta_z" => "height gained",
        "gammadot_change_fraction" => "change of the spin, as a fraction",
        "time_of_highest_z" => "time of the greatest height",
        other => other,
    };
    claim
        .at
        .map_or_else(|| quantity.to_owned(), |at| format!("{quantity} at {at} s"))
}

fn ranking(text: &mut String, study: &Study) {
    line(text, "## The readings, ranked\n");
    line(
        text,
        "| rank | score | misfit | hypotheses | claims that hold | reading |",
    );
    line(text, "|---|---|---|---|---|---|");
    for (rank, scored) in study.ranking.iter().take(SHOWN).enumerate() {
        row(text, rank + 1, scored, study.claims.len());
    }
    let printed = study
        .ranking
        .iter()
        .position(|scored| scored.reading == Reading::PRINTED);
    if let Some(rank) = printed.filter(|&rank| rank >= SHOWN) {
        row(text, rank + 1, &study.ranking[rank], study.claims.len());
    }
    line(text, "");
}

fn row(text: &mut String, rank: usize, scored: &Scored, claims: usize) {
    let (score, misfit, count) = (scored.score(), scored.misfit, scored.reading.hypotheses());
    let _ = writeln!(
        text,
        "| {rank} | {score:.2} | {misfit:.2} | {count} | {} of {claims} | {} |",
        scored.held,
        scored.reading.words()
    );
}

fn best(text: &mut String, study: &Study) {
    let best = &study.ranking[0];
    line(text, "## The best reading\n");
    line(text, format!("{}.\n", capitalised(&best.reading.words())));
    claims_table(text, study, &best.reading);
    let table = Table1::printed();
    line(text, "\nIts coefficients, by the paper's names:\n");
    line(text, "| flight | C_L0 | C_La | C_D0 | C_Da |");
    line(text, "|---|---|---|---|---|");
    for (name, row, order) in [
        ("fssh3", table.fssh3, best.reading.fssh3),
        ("bffl8", table.bffl8, best.reading.bffl8),
    ] {
        let [a, b, c, d] = order.map(|column| row[column as usize]);
        line(text, format!("| {name} | {a} | {b} | {c} | {d} |"));
    }
    line(text, "");
}

fn capitalised(words: &str) -> String {
    let mut characters = words.chars();
    characters.next().map_or_else(String::new, |first| {
        first.to_uppercase().chain(characters).collect()
    })
}

/// Whether a reading uses a hypothesis.
type Uses = Box<dyn Fn(&Reading) -> bool>;

/// What each hypothesis of the best reading is worth: the best score that is reached without it.
fn worth(text: &mut String, study: &Study) {
    let best = &study.ranking[0];
    line(text, "## What each hypothesis is worth\n");
    line(
        text,
        "The best score that any reading reaches without it, against the best of all:\n",
    );
    line(
        text,
        "| hypothesis | best score without it | claims that hold then | loss |",
    );
    line(text, "|---|---|---|---|");
    let mut parts: Vec<(String, Uses)> = Vec::new();
    for word in best.reading.common.hypotheses() {
        parts.push((
            word.to_owned(),
            Box::new(move |reading| reading.common.hypotheses().contains(&word)),
        ));
    }
    let printed = crate::paper::reading::PRINTED;
    let (first, second) = (best.reading.fssh3, best.reading.bffl8);
    if first != printed {
        parts.push((
            "columns of fssh3 interchanged".to_owned(),
            Box::new(move |reading| reading.fssh3 != printed),
        ));
    }
    if second != printed {
        parts.push((
            "columns of bffl8 interchanged".to_owned(),
            Box::new(move |reading| reading.bffl8 != printed),
        ));
    }
    for (word, uses) in parts {
        if let Some(without) = study.ranking.iter().find(|scored| !uses(&scored.reading)) {
            let (score, loss) = (without.score(), without.score() - best.score());
            line(
                text,
                format!(
                    "| {word} | {score:.2} | {} of {} | {loss:.2} |",
                    without.held,
                    study.claims.len()
                ),
            );
        }
    }
    line(text, "");
}

/// Readings as good as the best that differ from it in one answer.
fn undecided(text: &mut String, study: &Study) {
    let best = &study.ranking[0];
    let flights = ["fssh3", "bffl8"];
    let set = study.indistinguishable();
    line(text, "## What the claims cannot tell apart\n");
    line(
        text,
        format!(
            "{} readings hold as many claims as the best with a misfit less than one squared tolerance above its",
            set.len()
        ),
    );
    line(
        text,
        "own. These differ from it in one answer, which the claims therefore do not decide:\n",
    );
    line(
        text,
        "| the best reading has | as good is | misfit, against the best's | hypotheses |",
    );
    line(text, "|---|---|---|---|");
    for scored in &set[1..] {
        let Some((here, there)) = best.reading.difference(&scored.reading) else {
            continue;
        };
        let outcome = |reading: &Reading| flights.map(|flight| study.outcome(reading, flight));
        let same = if outcome(&best.reading) == outcome(&scored.reading) {
            " (the same numbers)"
        } else {
            ""
        };
        let (misfit, count) = (scored.misfit, scored.reading.hypotheses());
        line(
            text,
            format!(
                "| {here} | {there}{same} | {misfit:.2}, {:.2} | {count} |",
                best.misfit
            ),
        );
    }
    line(
        text,
        "\nReadings of the columns that give the same numbers do so because fssh3 has 0.83 in both of its drag columns.",
    );
}
