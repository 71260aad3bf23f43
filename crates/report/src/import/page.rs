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

/// Number of flights whose figures are not folded: a row of a wide page.
const OPEN: usize = 3;

/// Renders the self-contained page of an import.
pub fn html(page: &ImportPage) -> String {
    let flights = page.takes.iter().map(|take| take.flights.len()).sum();
    let from = count(page.takes.len(), "recording");
    let mut body = Html::new();
    body.paragraph(format!(
        "{} from {from}. Each flight was cut where free flight begins and ends; blue is what the dataset holds, grey \
         what was cut away.",
        count(flights, "flight")
    ));
    body.alarms("Notes", notes(page));
    body.section("decisions", "What was decided", decisions(page));
    body.section("flights", "Flights", of_flights(page, flights));
    let pairs = pairs(page);
    if !pairs.is_empty() {
        let mut content = Html::new();
        content.table(&pairs);
        content.note(
            "Of each pair, the flight in which its distance departs farthest from its median. The distances of a \
             rigid body are constant: one that jumps has exchanged labels, one that drifts a loose marker.",
        );
        body.section("distances", "Distances between markers", content);
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

/// Notes on the recordings, with their names if there are several, and the recordings without a flight.
fn notes(page: &ImportPage) -> Vec<String> {
    let mut found: Vec<(String, Vec<&str>)> = Vec::new();
    for take in &page.takes {
        let empty = take.flights.is_empty();
        let empty = empty.then(|| "no throw was found".to_owned());
        for note in take.notes.iter().cloned().chain(empty) {
            match found.iter_mut().find(|(own, _)| *own == note) {
                Some((_, files)) => files.push(&take.file),
                None => found.push((note, vec![&take.file])),
            }
        }
    }
    let line = |(note, files): (String, Vec<&str>)| match page.takes.len() {
        1 => capitalized(&note),
        _ => format!("{}: {note}", first_of(&files)),
    };
    found.into_iter().map(line).collect()
}

/// The first of several recordings, and how many more there are.
fn first_of(files: &[&str]) -> String {
    match files.len() {
        1 => files[0].to_owned(),
        n => format!("{} and {} more", files[0], n - 1),
    }
}

/// Tables of decisions, one for all recordings on which they are the same; their lengths do not count.
fn decisions(page: &ImportPage) -> Html {
    let own = |take: &ImportedTake| {
        let mut own = take.decisions.clone();
        own.retain(|(what, _)| what != "samples" || page.takes.len() == 1);
        own
    };
    let mut groups: Vec<(&ImportedTake, Vec<&str>)> = Vec::new();
    for take in &page.takes {
        let alike = groups.iter_mut();
        let mut alike = alike.filter(|(first, _)| own(first) == own(take));
        match alike.next() {
            Some((_, files)) => files.push(&take.file),
            None => groups.push((take, vec![&take.file])),
        }
    }
    let mut tables = Html::from("\n");
    for (take, files) in groups.iter().take(MAX_ROWS) {
        let table = Table::of(own(take))
            .name("", |(what, _)| what.clone())
            .text("", |(_, decision)| decision.clone())
            .table();
        let mut content = Html::new();
        if page.takes.len() > 1 {
            content.heading(first_of(files));
        }
        content.table(&table);
        tables.element("div", "", content);
    }
    let mut content = Html::new();
    content.element("div", "two", tables);
    if groups.len() > MAX_ROWS {
        content.note(format!(
            "{} more recordings with other decisions are in import.txt.",
            groups.len() - MAX_ROWS
        ));
    }
    content
}

/// Table and figures of the flights, and the recordings of which something was cut away.
fn of_flights(page: &ImportPage, flights: usize) -> Html {
    let mut content = Html::new();
    content.table(&table(page));
    let all = page.takes.iter().flat_map(|take| &take.flights);
    let figures = all.take(MAX_ROWS).enumerate();
    let figures = figures.map(|(i, flight)| draw::flight(i + 1, flight));
    content.grid(figures.collect(), OPEN, true);
    if flights > MAX_ROWS {
        content.note(format!(
            "{} more flights are not drawn.",
            flights - MAX_ROWS
        ));
    }
    let cut = page.takes.iter().enumerate();
    let cut = cut.filter(|(_, take)| take.flights.len() != 1 || draw::is_cut(take));
    let mut whole = Html::new();
    for (i, take) in cut.take(MAX_ROWS) {
        whole.figure(draw::take(i + 1, take), false);
    }
    if !whole.is_empty() {
        content.heading("Whole recordings");
        match page.takes.len() {
            1 => content.push(whole),
            n => content.folded(
                format!("of {n}, those of which something was cut away"),
                whole,
            ),
        }
    }
    content
}

fn table(page: &ImportPage) -> Table {
    let flights = page.takes.iter();
    let flights =
        flights.flat_map(|take| take.flights.iter().map(move |flight| (&take.file, flight)));
    Table::of(flights)
        .name("table", |(_, flight)| &flight.file)
        .when(page.takes.len() > 1, |rows| {
            rows.file("recording", |(file, _)| *file)
        })
        .number("from, s", |(_, flight)| plain(flight.release.time, 3))
        .text("because", |(_, flight)| short(&flight.release.reason))
        .number("to, s", |(_, flight)| plain(flight.end.time, 3))
        .text("because", |(_, flight)| short(&flight.end.reason))
        .number("samples", |(_, flight)| flight.samples)
        .text("not seen", |(_, flight)| unseen(flight))
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
fn pairs(page: &ImportPage) -> Table {
    type Worst<'a> = (&'a Distance, &'a str, f64, f64);
    let mut worst: Vec<Worst<'_>> = Vec::new();
    for flight in page.takes.iter().flat_map(|take| &take.flights) {
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
