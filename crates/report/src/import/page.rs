//! HTML page of an import, rendered from a template.

use identify::wording::count;
use minijinja::context;
use minijinja::value::Value;
use model_spec::sort_by_number;
use serde::Serialize;

use super::{ImportPage, ImportedFlight, ImportedTake, draw};
use crate::fit::flights::short;
use crate::fit::page::{capitalized, one, plain_values, rendered};
use crate::fit::words::names;
use crate::numbers::plain;

/// Maximum number of imported flights that are drawn, over all recordings.
const MAX_FLIGHTS: usize = 60;
/// Maximum number of gaps (intervals without a measured marker) that are listed for each flight.
const MAX_GAPS: usize = 5;
/// Maximum number of marker pairs whose distances are listed for each recording.
const MAX_PAIRS: usize = 30;

/// A motion-capture recording, as input of the HTML template.
#[derive(Serialize)]
struct Take {
    file: String,
    decisions: Vec<(String, String)>,
    notes: Vec<String>,
    flights: Vec<Row>,
    pairs: Vec<Pair>,
}

/// An imported flight, as input of the HTML template; all values are formatted as text.
#[derive(Serialize)]
struct Row {
    file: String,
    samples: usize,
    from: String,
    release: String,
    to: String,
    end: String,
    unseen: String,
}

/// A pair of markers with their distance, as input of the HTML template; all lengths are formatted in mm.
#[derive(Serialize)]
struct Pair {
    name: String,
    template: String,
    measured: String,
    farthest: String,
    file: String,
}

/// Renders the HTML page that reports an import of recordings.
pub(super) fn html(page: &ImportPage) -> String {
    let flights: usize = page.takes.iter().map(|take| take.flights.len()).sum();
    let mut takes = Vec::new();
    let mut drawn = 0;
    for (number, take) in page.takes.iter().enumerate() {
        let room = MAX_FLIGHTS.saturating_sub(drawn);
        let figures = take.flights.iter().take(room).enumerate();
        let figures: Vec<Value> = figures
            .map(|(i, flight)| one(&draw::flight(drawn + i + 1, flight)))
            .collect();
        drawn += figures.len();
        takes.push(context! {
            of => plain_values(&table(take)),
            overview => one(&draw::take(number + 1, take)),
            figures => figures,
        });
    }
    let context = context! {
        css => Value::from_safe_string(include_str!("../fit/page.css").to_owned() + include_str!("page.css")),
        model => &page.model,
        dataset => &page.dataset,
        summary => format!("{} from {}.", count(flights, "flight"), count(page.takes.len(), "recording")),
        undrawn => flights - drawn,
        takes => takes,
    };
    rendered(include_str!("page.html"), context)
}

fn table(take: &ImportedTake) -> Take {
    Take {
        file: take.file.clone(),
        decisions: take.decisions.clone(),
        notes: take.notes.iter().map(|note| capitalized(note)).collect(),
        flights: take.flights.iter().map(row).collect(),
        pairs: pairs(take),
    }
}

fn row(flight: &ImportedFlight) -> Row {
    let mut unseen: Vec<String> = flight
        .gaps
        .iter()
        .take(MAX_GAPS)
        .map(|(from, to)| format!("nothing from {} to {} s", plain(*from, 3), plain(*to, 3)))
        .collect();
    if flight.gaps.len() > MAX_GAPS {
        unseen.push(format!("{} more gaps", flight.gaps.len() - MAX_GAPS));
    }
    let missing = flight.missing.iter();
    let missing: Vec<String> = missing.map(|(name, n)| format!("{name} in {n}")).collect();
    if !missing.is_empty() {
        unseen.push(names(&missing));
    }
    Row {
        file: flight.file.clone(),
        samples: flight.samples,
        from: plain(flight.release.time, 3),
        release: short(&flight.release.reason),
        to: plain(flight.end.time, 3),
        end: short(&flight.end.reason),
        unseen: unseen.join("; "),
    }
}

/// Marker pairs of a recording with their distances, largest deviation from the median distance first. Each pair is
/// listed with the flight in which the distance of its markers deviates most from its median over that flight.
fn pairs(take: &ImportedTake) -> Vec<Pair> {
    let mut worst: Vec<(&str, f64, f64, f64, &str)> = Vec::new();
    for flight in &take.flights {
        for pair in &flight.distances {
            let Some((median, farthest)) = draw::median_and_departure(flight, pair) else {
                continue;
            };
            let entry = (
                pair.name.as_str(),
                pair.template,
                median,
                farthest,
                flight.file.as_str(),
            );
            match worst.iter_mut().find(|known| known.0 == pair.name) {
                Some(known) if known.3 < farthest => *known = entry,
                Some(_) => {}
                None => worst.push(entry),
            }
        }
    }
    sort_by_number(&mut worst, |pair| -pair.3);
    worst.truncate(MAX_PAIRS);
    let millimetres = |metres: f64| plain(1e3 * metres, 1);
    let pair = |(name, template, median, farthest, file): (&str, f64, f64, f64, &str)| Pair {
        name: name.to_owned(),
        template: millimetres(template),
        measured: millimetres(median),
        farthest: millimetres(farthest),
        file: file.to_owned(),
    };
    worst.into_iter().map(pair).collect()
}
