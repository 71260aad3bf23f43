//! Prints the points of a recording as CSV: index among the labelled points, frame, and coordinates in m along the
//! file's own axes. A point that was not seen in a frame has no row.
//!
//! `cargo run -p hyzer-dataset --example points -- FILE [UNIT]`; the unit of length is used if the file states none.

use std::io::Write;
use std::path::Path;

use dataset::takes::{LengthUnit, ReadOptions, TakeError, read};

fn points(file: &Path, unit: Option<LengthUnit>) -> Result<dataset::takes::Take, TakeError> {
    read(file, &ReadOptions::default()).or_else(|error| match unit {
        Some(_) => {
            let options = ReadOptions {
                length: unit,
                ..ReadOptions::default()
            };
            read(file, &options)
        }
        None => Err(error),
    })
}

fn main() -> std::io::Result<()> {
    let mut arguments = std::env::args().skip(1);
    let Some(file) = arguments.next() else {
        eprintln!("found no file, expected: points FILE [UNIT]");
        std::process::exit(2);
    };
    let unit = arguments.next().and_then(|unit| LengthUnit::parse(&unit));
    let take = points(Path::new(&file), unit).unwrap_or_else(|error| {
        eprintln!("{error}");
        std::process::exit(2)
    });
    let mut out = std::io::BufWriter::new(std::io::stdout().lock());
    writeln!(out, "point,frame,x,y,z")?;
    for (number, point) in take.points.iter().enumerate() {
        for (frame, position) in point.positions.iter().enumerate() {
            if let Some([x, y, z]) = position {
                writeln!(out, "{number},{frame},{x},{y},{z}")?;
            }
        }
    }
    out.flush()
}
