//! HTML page of an import.
use identify::numbers::plain;
use identify::wording::{capitalized, count, names, short};
use model_spec::sort_by_number;

use super::{Distance, ImportPage, ImportedFlight, ImportedTake, draw};
use crate::html::Html;
use crate::page::{Page, heading};
use crate::table::Table;
use crate::thin::MAX_ROWS;

const MAX_GAPS: usize = 5;

/// Renders the self-contained page of an import.
pub fn html(page: &ImportPage) -> String {
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

/// Section of one recording; `drawn` flights of the recordings before it are drawn.
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
    content.figure(draw::take(number, take), false);
    let room = take.flights.iter().take(MAX_ROWS - drawn).enumerate();
    let figures = room.map(|(i, flight)| draw::flight(drawn + i + 1, flight));
    content.grid(figures.collect(), MAX_ROWS, true);
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

/// Gaps of a flight, and its markers with missing samples.
fn unseen(flight: &ImportedFlight) -> String {
    let gaps = flight.gaps.iter().take(MAX_GAPS).map(|(from, to)| {
        let (from, to) = (plain(*from, 3), plain(*to, 3));
        format!("nothing from {from} to {to} s")
    });
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

/// Table of the marker pairs, each in the flight in which its distance departs farthest from the median.
fn pairs(take: &ImportedTake) -> Table {
    type Worst<'a> = (&'a Distance, &'a str, f64, f64);
    let mut worst: Vec<Worst<'_>> = Vec::new();
    for flight in &take.flights {
        for pair in &flight.distances {
            let Some((median, farthest)) = draw::median_and_departure(flight, pair) else {
                continue;
            };
            let found = (pair, flight.file.as_str(), median, farthest);
            match worst.iter_mut().find(|known| known.0.name == pair.name) {
                Some(known) if known.3 < farthest => *known = found,
                Some(_) => {}
                None => worst.push(found),
            }
        }
    }
    sort_by_number(&mut worst, |found| -found.3);
    let millimetres = |metres: f64| plain(1e3 * metres, 1);
    Table::of(worst.iter().take(MAX_ROWS))
        .name("pair", |(pair, ..)| &pair.name)
        .number("template, mm", |(pair, ..)| millimetres(pair.template))
        .number("median, mm", |(_, _, median, _)| millimetres(*median))
        .number("farthest from it, mm", |(.., farthest)| {
            millimetres(*farthest)
        })
        .plain("in", |(_, file, ..)| *file)
        .table()
}
