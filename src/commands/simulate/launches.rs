//! Flies all throws of a launch monitor and lists them in a table of results.

use flight::files::ResultFile;
use flight::release::Release;
use flight::throw::FlownThrow;
use flight::{CompiledModel, simulate, trajectory_csv};
use model_spec::model::Model;
use ode::IntegrationOptions;
use report::{CsvTable, Table, Units, hundredths};

use super::techdisc::Row;
use super::{check_rows, summary_file, throws};
use crate::cli::Simulate;
use crate::{Answer, output};

/// A throw and its flight, or why it could not be flown.
type Flight<'r> = (&'r Row, Result<FlownThrow, String>);

/// Flies every throw of a launch monitor. `Answer::No` if one could not be flown.
pub(super) fn run(
    options: &Simulate,
    rows: &[Row],
    (model, body, release): (&Model, &CompiledModel, &Release),
    out: Option<&output::Results<'_>>,
) -> anyhow::Result<Answer> {
    let names: Vec<&str> = model.states.iter().map(|s| s.name.as_str()).collect();
    let settings = IntegrationOptions::with_tolerance(options.tolerance);
    let mut files = Vec::new();
    let mut flights: Vec<Flight<'_>> = Vec::new();
    let mut seconds = 0.0;
    for row in rows {
        let mut own = release.clone();
        let flown = throws::apply(
            &options.throw,
            options.units,
            Some(row.throw),
            model,
            &mut own,
        )
        .and_then(|()| Ok(simulate(body, &own, &settings)?));
        let flight = match flown {
            Ok(flight) => flight,
            Err(error) => {
                flights.push((row, Err(output::chain(&error))));
                continue;
            }
        };
        seconds += flight.end;
        check_rows(options, seconds)?;
        let Some(flown) = FlownThrow::of(model, body, &own, &flight) else {
            continue;
        };
        if out.is_some() {
            let folder = format!("row-{:04}", row.number);
            let csv = trajectory_csv(&flight, &names, options.rate);
            files.push(ResultFile::new(format!("{folder}/trajectory.csv"), csv));
            let path = format!("{folder}/summary.json");
            files.push(summary_file(&path, &flown, model));
        }
        flights.push((row, Ok(flown)));
    }
    if let Some(out) = out {
        files.push(ResultFile::new("results.csv", csv(&flights)));
        let what = "results.csv, and trajectory.csv and summary.json of each row,";
        out.write(files, what)?;
    }
    output::print(table(&flights, options.units))?;
    Ok(Answer::of(flights.iter().all(|(_, flown)| flown.is_ok())))
}

fn table(flights: &[Flight<'_>], units: Units) -> String {
    let (m, length) = (units.length(), |value: f64| units.of_metres(value));
    let number = |flown: &Result<FlownThrow, String>, of: &dyn Fn(&FlownThrow) -> f64| {
        let flown = flown.as_ref().ok();
        flown.map_or_else(String::new, |flown| format!("{:.2}", hundredths(of(flown))))
    };
    let failure = |row: &Row, flown: &Result<FlownThrow, String>| match flown {
        Ok(_) => String::new(),
        Err(why) => format!("not flown: line {}: {why}", row.line),
    };
    Table::of(flights)
        .number("row", |(row, _)| row.number)
        .plain("id", |(row, _)| row.id.chars().take(16).collect::<String>())
        .number(units.speed(), |(_, flown)| {
            number(flown, &|f| units.of(f.release.speed, "m/s"))
        })
        .number(&format!("range, {m}"), |(_, flown)| {
            number(flown, &|f| length(f.range))
        })
        .number(&format!("left, {m}"), |(_, flown)| {
            number(flown, &|f| length(f.sideways))
        })
        .number(&format!("height, {m}"), |(_, flown)| {
            number(flown, &|f| length(f.apex.0))
        })
        .number("time, s", |(_, flown)| number(flown, &|f| f.seconds))
        .text("", |(row, flown)| failure(row, flown))
        .table()
        .text(usize::MAX)
}

fn csv(flights: &[Flight<'_>]) -> String {
    type Number = (&'static str, fn(&FlownThrow) -> Option<f64>);
    let numbers: [Number; 13] = [
        ("speed_m_s", |flown| Some(flown.release.speed)),
        ("launch_deg", |flown| Some(flown.release.launch)),
        ("nose_deg", |flown| flown.release.nose),
        ("hyzer_deg", |flown| flown.release.hyzer),
        ("spin_rpm", |flown| flown.release.spin),
        ("wobble_deg", |flown| flown.release.wobble),
        ("range_m", |flown| Some(flown.range)),
        ("left_m", |flown| Some(flown.sideways)),
        ("apex_m", |flown| Some(flown.apex.0)),
        ("seconds", |flown| Some(flown.seconds)),
        ("top_speed_m_s", |flown| Some(flown.top_speed)),
        ("end_speed_m_s", |flown| Some(flown.end.speed)),
        ("end_spin_rpm", |flown| flown.end.spin),
    ];
    let mut table = CsvTable::of(flights)
        .column("id", |(row, _)| &row.id)
        .column("row", |(row, _)| row.number);
    for (name, of) in numbers {
        table = table.optional(name, |(_, flown)| {
            let number = flown.as_ref().ok().and_then(of);
            number.map(|number| format!("{:.4}", number + 0.0))
        });
    }
    let status = |flown: &Result<FlownThrow, String>| flown.as_ref().err().cloned();
    table
        .column("status", |(_, flown)| {
            status(flown).unwrap_or_else(|| "flown".to_owned())
        })
        .text()
}
