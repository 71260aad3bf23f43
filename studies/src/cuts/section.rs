//! Section of docs/studies/spoiled.md on truncation at ground contact.

use serde::Serialize;

use super::bounces::Bounce;
use super::free::FreeFlight;

/// Maximum number of examples that docs/studies/spoiled.md lists for each kind of flight: flights without ground contact that
/// were truncated or excluded, and bouncing flights not truncated at the ground contact.
const MAX_EXAMPLES: usize = 12;

/// Boundaries, m/s, of the ranges of impact speed by which the bouncing flights are grouped in a table.
const CLASSES: [f64; 4] = [0.0, 1.0, 2.5, f64::INFINITY];

/// Data of the section on truncation in docs/studies/spoiled.md: counts and examples of flights without ground contact and of
/// flights that bounce on the ground.
#[derive(Clone, Debug, Serialize)]
pub struct CutSection {
    free: Vec<FreeRow>,
    /// For the flights without ground contact: number of all flights, of flights that the fits truncated, and of
    /// flights that they excluded.
    totals: [usize; 3],
    bounces: Vec<BounceRow>,
    /// For the flights that bounce: their number, and how many of them the fits truncated within two samples of the
    /// first ground contact.
    bounce_totals: [usize; 2],
    examples: Vec<String>,
}

#[derive(Clone, Debug, Serialize)]
struct FreeRow {
    group: &'static str,
    flights: usize,
    cut: usize,
    excluded: usize,
}

#[derive(Clone, Debug, Serialize)]
struct BounceRow {
    speeds: String,
    flights: usize,
    cut_there: usize,
    early: usize,
    late: usize,
    excluded: usize,
}

impl CutSection {
    /// Counts the truncated and excluded flights without ground contact per group of throws, and the bouncing flights
    /// per range of impact speed.
    pub fn new(free: &[FreeFlight], bounces: &[Bounce]) -> Self {
        let mut groups: Vec<&'static str> = Vec::new();
        for flight in free {
            if !groups.contains(&flight.group) {
                groups.push(flight.group);
            }
        }
        let rows: Vec<FreeRow> = groups
            .into_iter()
            .map(|group| {
                let of: Vec<_> = free.iter().filter(|flight| flight.group == group).collect();
                FreeRow {
                    group,
                    flights: of.len(),
                    cut: of.iter().filter(|flight| flight.cut.is_some()).count(),
                    excluded: of.iter().filter(|flight| flight.excluded.is_some()).count(),
                }
            })
            .collect();
        let sum = |of: fn(&FreeRow) -> usize| rows.iter().map(of).sum();
        let cut_free = free.iter().filter_map(|flight| {
            let why = flight.cut.as_ref().or(flight.excluded.as_ref())?;
            Some(format!(
                "touches nothing, {}, seed {}, {}: {why}",
                flight.group, flight.seed, flight.file
            ))
        });
        let missed = bounces.iter().filter(|bounce| !bounce.is_cut_there());
        let missed = missed.map(|bounce| {
            let used = bounce.used.map_or("none".to_owned(), |used| used.to_string());
            let why = bounce.excluded.as_ref();
            format!(
                "bounces, seed {}, {}: touches at {:.3} s with {:.1} m/s, {} samples before, {used} used{}",
                bounce.seed,
                bounce.file,
                bounce.time,
                bounce.speed,
                bounce.before,
                why.map_or(String::new(), |why| format!(" ({why})"))
            )
        });
        let examples = cut_free.take(MAX_EXAMPLES).chain(missed.take(MAX_EXAMPLES));
        Self {
            totals: [
                sum(|row| row.flights),
                sum(|row| row.cut),
                sum(|row| row.excluded),
            ],
            free: rows,
            bounce_totals: [
                bounces.len(),
                bounces
                    .iter()
                    .filter(|bounce| bounce.is_cut_there())
                    .count(),
            ],
            bounces: CLASSES
                .windows(2)
                .map(|limits| class(limits, bounces))
                .collect(),
            examples: examples.map(|text| text.replace('\n', " ")).collect(),
        }
    }
}

fn class(limits: &[f64], bounces: &[Bounce]) -> BounceRow {
    let of = bounces
        .iter()
        .filter(|bounce| (limits[0]..limits[1]).contains(&bounce.speed));
    let of: Vec<&Bounce> = of.collect();
    let count = |has: &dyn Fn(&Bounce) -> bool| of.iter().filter(|bounce| has(bounce)).count();
    BounceRow {
        speeds: match limits[1].is_finite() {
            true => format!("{} to {}", limits[0], limits[1]),
            false => format!("over {}", limits[0]),
        },
        flights: of.len(),
        cut_there: count(&Bounce::is_cut_there),
        early: count(&|bounce| bounce.used.is_some_and(|used| used + 2 < bounce.before)),
        late: count(&|bounce| bounce.used.is_some_and(|used| used > bounce.before + 2)),
        excluded: count(&|bounce| bounce.used.is_none()),
    }
}
