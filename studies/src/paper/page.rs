//! Renders docs/studies/paper.md.

use serde::Serialize;

use super::claims::Claim;
use super::columns::{Columns, PRINTED};
use super::reading::Reading;
use super::study::{PENALTY, Scored, Study};
use super::table::Table1;
use crate::error::StudyError;
use crate::page::Page;

/// Number of interpretations of Table 1 of Hubbard & Hummel (2000) that the page of results ranks.
const SHOWN: usize = 20;

#[derive(Serialize)]
struct Results {
    claims: usize,
    readings: usize,
    penalty: f64,
    printed: Vec<ClaimRow>,
    printed_held: usize,
    ranking: Vec<ReadingRow>,
    best: Vec<ClaimRow>,
    best_reading: String,
    columns: Vec<(&'static str, [f64; 4])>,
    hypotheses: Vec<HypothesisRow>,
    indistinguishable: usize,
    alternatives: Vec<Alternative>,
}

#[derive(Serialize)]
struct ClaimRow {
    flight: String,
    claim: String,
    /// Value that Hubbard & Hummel (2000) state, and the tolerance allowed for a reproduction, in `unit`.
    stated: [f64; 2],
    /// Unit of the stated value, with a leading space; empty if dimensionless.
    unit: String,
    /// Simulated value in `unit`, and its deviation from the value that Hubbard & Hummel (2000) state, in units of the
    /// tolerance; `None` if the integration fails.
    simulated: Option<(f64, f64)>,
}

#[derive(Serialize)]
struct ReadingRow {
    rank: usize,
    score: f64,
    misfit: f64,
    hypotheses: usize,
    held: usize,
    description: String,
}

/// One hypothesis of the best-ranked interpretation of Table 1 of Hubbard & Hummel (2000), with the best (lowest) score
/// among the interpretations without this hypothesis. The score is the misfit plus a penalty for each hypothesis. Its
/// increase shows how much the hypothesis contributes to the agreement with the publication.
#[derive(Serialize)]
struct HypothesisRow {
    description: &'static str,
    score: f64,
    held: usize,
    loss: f64,
}

/// An interpretation of Table 1 of Hubbard & Hummel (2000) that differs from the best-ranked one in a single hypothesis
/// on signs or units, or only in the order of columns. The outcomes that the publication states cannot distinguish the
/// two.
#[derive(Serialize)]
struct Alternative {
    best_has: String,
    alternative: String,
    /// Whether this interpretation of Table 1 of Hubbard & Hummel (2000) gives exactly the same simulated outcomes as
    /// the best-ranked interpretation.
    is_equivalent: bool,
    misfit: f64,
    best_misfit: f64,
    hypotheses: usize,
}

/// Renders docs/studies/paper.md from the ranking of all interpretations of Table 1 of Hubbard & Hummel (2000).
///
/// # Errors
/// [`StudyError::Page`] if the template cannot be rendered with the results.
pub fn paper_page(study: &Study) -> Result<Page, StudyError> {
    let best = &study.ranking[0];
    let indistinguishable = study.indistinguishable();
    let results = Results {
        claims: study.claims.len(),
        readings: study.ranking.len(),
        penalty: PENALTY,
        printed: claim_rows(study, &Reading::PRINTED),
        printed_held: study.score_of(&Reading::PRINTED).map_or(0, |s| s.held),
        ranking: ranking(study),
        best: claim_rows(study, &best.reading),
        best_reading: capitalised(&best.reading.description()),
        columns: columns(&best.reading),
        hypotheses: hypotheses(study, best),
        indistinguishable: indistinguishable.len(),
        alternatives: indistinguishable[1..]
            .iter()
            .filter_map(|scored| alternative(study, best, scored))
            .collect(),
    };
    Page::without_figures(include_str!("page.md"), results)
}

fn claim_rows(study: &Study, reading: &Reading) -> Vec<ClaimRow> {
    let rows = study.claims.iter().map(|claim| {
        let outcome = study.outcome(reading, &claim.flight);
        ClaimRow {
            flight: claim.flight.clone(),
            claim: describe(claim),
            stated: [claim.value, claim.tolerance],
            unit: match claim.unit.as_str() {
                "1" => String::new(),
                unit => format!(" {unit}"),
            },
            simulated: outcome
                .map(|outcome| (outcome.quantity(&claim.quantity), outcome.departure(claim))),
        }
    });
    rows.collect()
}

fn describe(claim: &Claim) -> String {
    let quantity = match claim.quantity.as_str() {
        "delta_x" => "distance along x",
        "delta_z" => "height gained",
        "gammadot_change_fraction" => "change of the spin, as a fraction",
        "time_of_highest_z" => "time of the greatest height",
        other => other,
    };
    match claim.at {
        Some(at) => format!("{quantity} at {at} s"),
        None => quantity.to_owned(),
    }
}

/// Table rows of the [`SHOWN`] best interpretations of Table 1 of Hubbard & Hummel (2000), and of the table as printed
/// if it ranks lower.
fn ranking(study: &Study) -> Vec<ReadingRow> {
    let ranked = study.ranking.iter().enumerate();
    let shown = ranked.filter(|(k, scored)| *k < SHOWN || scored.reading == Reading::PRINTED);
    let rows = shown.map(|(k, scored)| ReadingRow {
        rank: k + 1,
        score: scored.score(),
        misfit: scored.misfit,
        hypotheses: scored.reading.hypotheses(),
        held: scored.held,
        description: scored.reading.description(),
    });
    rows.collect()
}

/// Names of the flights, each with its lift and drag coefficients `[C_L0, C_La, C_D0, C_Da]` under an interpretation of
/// Table 1 of Hubbard & Hummel (2000).
fn columns(reading: &Reading) -> Vec<(&'static str, [f64; 4])> {
    let table = Table1::printed();
    let flight = |row: [f64; 8], order: Columns| order.map(|column| row[column as usize]);
    vec![
        ("fssh3", flight(table.fssh3, reading.fssh3)),
        ("bffl8", flight(table.bffl8, reading.bffl8)),
    ]
}

fn capitalised(text: &str) -> String {
    let mut characters = text.chars();
    let first = characters.next().into_iter().flat_map(char::to_uppercase);
    first.chain(characters).collect()
}

/// Predicate on interpretations of Table 1 of Hubbard & Hummel (2000): whether an interpretation contains a certain
/// hypothesis.
type Uses = Box<dyn Fn(&Reading) -> bool>;

fn hypotheses(study: &Study, best: &Scored) -> Vec<HypothesisRow> {
    let mut hypotheses: Vec<(&'static str, Uses)> = Vec::new();
    for hypothesis in best.reading.conventions.hypotheses() {
        let uses = move |reading: &Reading| reading.conventions.hypotheses().contains(&hypothesis);
        hypotheses.push((hypothesis, Box::new(uses)));
    }
    if best.reading.fssh3 != PRINTED {
        let uses = |reading: &Reading| reading.fssh3 != PRINTED;
        hypotheses.push(("columns of fssh3 interchanged", Box::new(uses)));
    }
    if best.reading.bffl8 != PRINTED {
        let uses = |reading: &Reading| reading.bffl8 != PRINTED;
        hypotheses.push(("columns of bffl8 interchanged", Box::new(uses)));
    }
    let rows = hypotheses.into_iter().filter_map(|(description, uses)| {
        let mut ranking = study.ranking.iter();
        let without = ranking.find(|scored| !uses(&scored.reading))?;
        Some(HypothesisRow {
            description,
            score: without.score(),
            held: without.held,
            loss: without.score() - best.score(),
        })
    });
    rows.collect()
}

fn alternative(study: &Study, best: &Scored, scored: &Scored) -> Option<Alternative> {
    let (best_has, alternative) = best.reading.difference(&scored.reading)?;
    let outcomes =
        |reading: &Reading| ["fssh3", "bffl8"].map(|flight| study.outcome(reading, flight));
    Some(Alternative {
        best_has,
        alternative,
        is_equivalent: outcomes(&best.reading) == outcomes(&scored.reading),
        misfit: scored.misfit,
        best_misfit: best.misfit,
        hypotheses: scored.reading.hypotheses(),
    })
}
