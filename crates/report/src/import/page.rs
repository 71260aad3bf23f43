//! HTML page of an import.

use identify::wording::count;
use model_spec::sort_by_number;

use super::{Distance, ImportPage, ImportedFlight, ImportedTake, draw};
use crate::html::Html;
use crate::page::{Page, heading};
use crate::table::Table;
use crate::thin::MAX_ROWS;
use identify::numbers::plain;
use identify::wording::{capitalized, names, short};

/// Maximum number of gaps that are listed for each flight.
const MAX_GAPS: usize = 5;

/// Renders the HTML page that reports an import of recordings.
pub(super) fn html(page: &ImportPage) -> String {
    let flights: usize = page.takes.iter().map(|take| take.flights.len()).sum();
    let from = count(page.takes.len(), "recording");
    let mut body = Html::new();
    body.paragraph(format!(
        "{} from {from}. Each flight was cut where free flight begins and ends; blue is what the dataset holds, grey \
         what was cut away.",
        count(flights, "flight")
    ));
    let mut drawn = 0;
    for (number, take) in page.takes.iter().enumerate() {
        let content = section(take, number + 1, drawn);
        body.section("", &take.file, content);
        drawn = (drawn + take.flights.len()).min(MAX_ROWS);
    }
    if flights > drawn {
        body.note(format!("{} more flights are not drawn.", flights - drawn));
    }
    let version = env!("CARGO_PKG_VERSION");
    body.note(format!(
        "hyzer {version}. The same decisions are in import.txt."
    ));
    Page {
        kind: "hyzer import",
        title: format!("Import of {}", page.dataset),
        heading: heading(&page.dataset, "for the model", &page.model),
        body,
    }
    .html()
}

/// Section of one recording with the number `number`; `drawn` flights of the recordings before it are drawn.
fn section(take: &ImportedTake, number: usize, drawn: usize) -> Html {
    let mut content = Html::new();
    content.heading("What was decided");
    let decisions = Table::of(&take.decisions)
        .name("", |(what, _)| what)
        .text("", |(_, decision)| decision)
        .table();
    content.table(&decisions);
    content.alarms("Notes", take.notes.iter().map(|note| capitalized(note)));
    if take.flights.is_empty() {
        content.paragraph("No throw was found.");
    } else {
        content.heading("Flights");
        content.table(&flights(take));
    }
    content.figure(&draw::take(number, take), false);
    let room = take.flights.iter().take(MAX_ROWS - drawn).enumerate();
    let figures = room.map(|(i, flight)| draw::flight(drawn + i + 1, flight));
    content.grid(&figures.collect::<Vec<_>>(), MAX_ROWS, true);
    let pairs = pairs(take);
    if !pairs.is_empty() {
        content.heading("Distances between markers");
        content.table(&pairs);
        content.note(
            "Of each pair, the flight in which its distance departs farthest from its median. The distances of a \
             rigid body are constant: one that jumps has exchanged labels, one that drifts a loose marker.",
        );
    }
    content
}

fn flights(take: &ImportedTake) -> Table {
    Table::of(&take.flights)
        .name("table", |flight| &flight.file)
        .number("from, s", |flight| plain(flight.release.time, 3))
        .text("because", |flight| short(&flight.release.reason))
        .number("to, s", |flight| plain(flight.end.time, 3))
        .text("because", |flight| short(&flight.end.reason))
        .number("samples", |flight| flight.samples)
        .text("not seen", |flight| unseen(flight))
        .table()
}

/// Text on the gaps of a flight and on its markers with missing samples.
fn unseen(flight: &ImportedFlight) -> String {
    let gaps = flight.gaps.iter().take(MAX_GAPS);
    let gaps =
        gaps.map(|(from, to)| format!("nothing from {} to {} s", plain(*from, 3), plain(*to, 3)));
    let mut unseen: Vec<String> = gaps.collect();
    if flight.gaps.len() > MAX_GAPS {
        unseen.push(format!("{} more gaps", flight.gaps.len() - MAX_GAPS));
    }
    let missing = flight.missing.iter();
    let missing: Vec<String> = missing.map(|(name, n)| format!("{name} in {n}")).collect();
    if !missing.is_empty() {
        unseen.push(names(&missing));
    }
    unseen.join("; ")
}

/// Table of the marker pairs of a recording, largest deviation from the median distance first. Each pair is listed
/// with the flight in which the distance of its markers deviates most from its median over that flight.
fn pairs(take: &ImportedTake) -> Table {
    struct Worst<'a> {
        pair: &'a Distance,
        file: &'a str,
        median: f64,
        farthest: f64,
    }
    let mut worst: Vec<Worst<'_>> = Vec::new();
    for flight in &take.flights {
        for pair in &flight.distances {
            let Some((median, farthest)) = draw::median_and_departure(flight, pair) else {
                continue;
            };
            let found = Worst {
                pair,
                file: &flight.file,
                median,
                farthest,
            };
            match worst.iter_mut().find(|known| known.pair.name == pair.name) {
                Some(known) if known.farthest < farthest => *known = found,
                Some(_) => {}
                None => worst.push(found),
            }
        }
    }
    sort_by_number(&mut worst, |found| -found.farthest);
    let millimetres = |metres: f64| plain(1e3 * metres, 1);
    Table::of(worst.iter().take(MAX_ROWS))
        .name("pair", |found| &found.pair.name)
        .number("template, mm", |found| millimetres(found.pair.template))
        .number("median, mm", |found| millimetres(found.median))
        .number("farthest from it, mm", |found| millimetres(found.farthest))
        .plain("in", |found| found.file)
        .table()
}
