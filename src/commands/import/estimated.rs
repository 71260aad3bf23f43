//! Estimates a template from the free flights, for takes without a given template.

use std::collections::BTreeMap;
use std::fmt::Write;

use anyhow::{Context, ensure};
use dataset::takes::{
    FreeFlight, ReadOptions, Take, ThrowOptions, Throws, estimate_template, found_otherwise,
};
use dataset::{BodyTemplate, Marker};
use flight::table::{listed, shown};

use super::no_throw;
use crate::cli::Import;

/// A template estimated from recordings, a text on how it was estimated, and a comment for each marker.
pub struct Estimated {
    pub template: BodyTemplate,
    pub decisions: String,
    pub comments: Vec<String>,
    /// Standard errors of the centre of mass along the axes of the body, m.
    pub origin_error: [f64; 3],
    /// Standard error of the direction of the third axis, rad.
    pub axis_error: f64,
}

/// Estimates the template of the points that move as one rigid body in all throws; adds valid names to `names`.
pub fn estimated(
    options: &Import,
    reading: &ReadOptions,
    names: &mut BTreeMap<String, String>,
) -> anyhow::Result<Estimated> {
    let up = super::up(options)?;
    let mut thrown: Vec<(Take, Throws)> = Vec::new();
    let mut reasons = Vec::new();
    for file in &options.takes {
        let mut take = match dataset::takes::read(file, reading) {
            Ok(take) => take,
            Err(error) if options.takes.len() > 1 => {
                reasons.push(error.to_string());
                continue;
            }
            Err(error) => return Err(error.into()),
        };
        // The positions are estimated from the single points, not from poses of bodies.
        take.bodies.clear();
        let up = dataset::takes::up_of(&take, file, up)?;
        let turned = take.clone().with_z_up(up, options.left_handed);
        let found = dataset::takes::find_throws(&turned, &[], &ThrowOptions::default());
        if found.throws.is_empty() {
            let why = found_otherwise(&take, file, &[], (up, options.left_handed));
            reasons.push(match why {
                Some(error) if options.takes.len() == 1 => return Err(error.into()),
                Some(error) => error.to_string(),
                None => format!("{}: no throw", file.display()),
            });
        } else {
            thrown.push((turned, found));
        }
    }
    ensure!(
        !thrown.is_empty(),
        "{} to estimate the template from, or a template by --markers; check --length and --up\n  {}",
        no_throw(),
        reasons.join("\n  ")
    );
    let (labels, left_out) = labels(&thrown);
    let mut flights = Vec::new();
    for (take, found) in &thrown {
        let place = |label: &String| take.points.iter().position(|p| p.label == *label);
        let points: Vec<Option<usize>> = labels.iter().map(place).collect();
        for throw in &found.throws {
            let row = |sample: usize| -> Vec<Option<[f64; 3]>> {
                let position = |point: &Option<usize>| take.points[(*point)?].positions[sample];
                points.iter().map(position).collect()
            };
            let rows: Vec<_> = throw.samples().map(row).collect();
            flights.push((&take.times[throw.samples()], rows));
        }
    }
    let flights = flights.iter();
    let flights = flights.map(|(times, positions)| FreeFlight { times, positions });
    let flights: Vec<FreeFlight<'_>> = flights.collect();
    let mut decisions = "template\n".to_owned();
    for label in &labels {
        let name = name(label);
        if name != *label && !names.contains_key(label) {
            let _ = writeln!(decisions, "  the label {} is named {name}", shown(label));
            names.insert(label.clone(), name);
        }
    }
    let name = |label: &String| names.get(label).unwrap_or(label).clone();
    let labels: Vec<String> = labels.iter().map(name).collect();
    let found = estimate_template(&labels, &flights, options.centre_height)
        .context("the template from the takes")?;
    for line in found.decisions() {
        let _ = writeln!(decisions, "  {line}");
    }
    if !left_out.is_empty() {
        let names = listed(&left_out);
        let _ = writeln!(
            decisions,
            "  left out, since they do not keep their distances to the others in every take: {names}"
        );
    }
    let comments = found.markers.iter().map(|marker| {
        let [x, y, z] = marker.std_error.map(|error| format!("{error:.6}"));
        format!("estimated from the takes; standard errors of the position, m: {x}, {y}, {z}")
    });
    let markers = found.markers.iter().map(|marker| Marker {
        name: marker.label.clone(),
        // More digits than a nanometre would suggest a precision that no estimate has.
        position: marker.position.map(|x| (x * 1e9).round() / 1e9 + 0.0),
    });
    Ok(Estimated {
        origin_error: found.origin_error(),
        axis_error: found.axis_error(),
        comments: comments.collect(),
        template: BodyTemplate {
            markers: markers.collect(),
            ..BodyTemplate::default()
        },
        decisions,
    })
}

/// Marker name of a label: letters, digits, `_`, `-` and `.`; `_` stands for other characters.
pub(super) fn name(label: &str) -> String {
    let is_kept = |c: char| c.is_alphanumeric() || matches!(c, '_' | '-' | '.');
    let each = label.chars().map(|c| if is_kept(c) { c } else { '_' });
    each.collect()
}

/// Labels of the points that move as one rigid body in all recordings, and of the others, by first occurrence.
fn labels(thrown: &[(Take, Throws)]) -> (Vec<String>, Vec<String>) {
    let is_rigid = |label: &String| thrown.iter().all(|(_, found)| found.labels.contains(label));
    let mut all: Vec<String> = Vec::new();
    for (take, _) in thrown {
        for label in take.labels() {
            if !all.iter().any(|known| known == label) {
                all.push(label.to_owned());
            }
        }
    }
    all.into_iter().partition(is_rigid)
}
