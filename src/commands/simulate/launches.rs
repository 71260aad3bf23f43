//! Flies all throws of a launch monitor and lists them in a table of results.

use std::fmt::Write;

use flight::files::{ResultFile, ResultFolder};
use flight::release::Release;
use flight::{CompiledModel, simulate, trajectory_csv};
use model_spec::model::Model;
use ode::IntegrationOptions;

use super::flown::Flown;
use super::techdisc::Row;
use super::{check_rows, summary_file, throws};
use crate::cli::Simulate;
use crate::commands::hundredths;
use crate::{Answer, output};

/// Header line of the CSV table of simulated throws of a launch monitor, with units in the column names.
const HEAD: &str = "id,row,speed_m_s,launch_deg,nose_deg,hyzer_deg,spin_rpm,wobble_deg,range_m,left_m,apex_m,seconds,\
    top_speed_m_s,end_speed_m_s,end_spin_rpm,status";

/// Simulates every throw recorded by a launch monitor; prints the table of results, and writes the table and a folder
/// per flight if an output folder is given. Returns `Answer::No` if a throw could not be simulated.
pub fn run(
    options: &Simulate,
    rows: &[Row],
    (model, body, release): (&Model, &CompiledModel, &Release),
    out: Option<&ResultFolder>,
) -> anyhow::Result<Answer> {
    let names: Vec<&str> = model.states.iter().map(|s| s.name.as_str()).collect();
    let settings = IntegrationOptions::with_tolerance(options.tolerance);
    let mut files = Vec::new();
    let mut table = format!("{HEAD}\n");
    let mut printed = format!(
        "{:>4} {:16} {:>8} {:>9} {:>9} {:>9} {:>7}\n",
        "row", "id", "m/s", "range, m", "left, m", "height, m", "time, s"
    );
    let mut seconds = 0.0;
    let mut answer = Answer::Yes;
    for row in rows {
        let mut own = release.clone();
        let flown = throws::apply(&options.throw, Some(row.throw), model, &mut own)
            .and_then(|()| Ok(simulate(body, &own, &settings)?));
        let id: String = row.id.chars().take(16).collect();
        match flown {
            Ok(flight) => {
                seconds += flight.end;
                check_rows(options, seconds)?;
                let Some(flown) = Flown::of(model, body, &own, &flight) else {
                    continue;
                };
                if out.is_some() {
                    let folder = format!("row-{:04}", row.number);
                    let csv = trajectory_csv(&flight, &names, options.rate);
                    files.push(ResultFile::new(format!("{folder}/trajectory.csv"), csv));
                    let path = format!("{folder}/summary.json");
                    files.push(summary_file(&path, &flown, model));
                }
                let _ = writeln!(table, "{}", cells(row, &flown));
                let _ = writeln!(
                    printed,
                    "{:>4} {id:16} {:>8.2} {:>9.2} {:>9.2} {:>9.2} {:>7.2}",
                    row.number,
                    flown.release.speed,
                    flown.range,
                    hundredths(flown.sideways),
                    flown.apex.0,
                    flown.seconds
                );
            }
            Err(error) => {
                answer = Answer::No;
                let why = format!("{error:#}");
                let _ = writeln!(
                    table,
                    "{},{}{}{}",
                    quoted(&row.id),
                    row.number,
                    ",".repeat(14),
                    quoted(&why)
                );
                let _ = writeln!(
                    printed,
                    "{:>4} {id:16} not flown: line {}: {why}",
                    row.number, row.line
                );
            }
        }
    }
    if let Some(folder) = out {
        files.push(ResultFile::new("results.csv", table));
        output::replace(folder, &files)?;
    }
    output::print(printed)?;
    if let Some(folder) = &options.out {
        eprintln!(
            "results.csv, and trajectory.csv and summary.json of each row, are in {}",
            folder.display()
        );
    }
    Ok(answer)
}

/// Line of the CSV table of results for one simulated throw of a launch monitor.
fn cells(row: &Row, flown: &Flown) -> String {
    let start = &flown.release;
    let numbers = [
        Some(start.speed),
        Some(start.launch),
        start.nose,
        start.hyzer,
        start.spin,
        start.wobble,
        Some(flown.range),
        Some(flown.sideways),
        Some(flown.apex.0),
        Some(flown.seconds),
        Some(flown.top_speed),
        Some(flown.end.speed),
        flown.end.spin,
    ];
    let cells = numbers.map(|n| n.map_or_else(String::new, |n| format!("{:.4}", n + 0.0)));
    format!(
        "{},{},{},flown",
        quoted(&row.id),
        row.number,
        cells.join(",")
    )
}

/// A cell of a CSV file, in quotation marks if its text requires them.
fn quoted(text: &str) -> String {
    match text.contains([',', '"', '\n', '\r']) {
        true => format!("\"{}\"", text.replace('"', "\"\"")),
        false => text.to_owned(),
    }
}
