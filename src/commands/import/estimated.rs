//! Estimates a template from the free flights, for takes without a given template.

use std::collections::BTreeMap;
use std::fmt::Write;

use anyhow::{Context, bail};
use dataset::takes::words::{listed, shown};
use dataset::takes::{FreeFlight, ReadOptions, Take, ThrowOptions, Throws, estimate_template};
use dataset::{BodyTemplate, Marker};

use super::no_throw;
use crate::cli::Import;

/// Maximum magnitude of the value of `--centre-height`, m; larger values suggest millimetres.
const MAX_HEIGHT: f64 = 2.0;

/// A template estimated from recordings, a text on how it was estimated, and for
/// each marker the comment that is written above its position in `dataset.toml`.
pub struct Estimated {
    pub template: BodyTemplate,
    pub decisions: String,
    pub comments: Vec<String>,
    /// Standard errors of the estimated centre of mass along the axes of the body, m.
    pub origin_error: [f64; 3],
    /// Standard error of the direction of the third body axis relative to the markers, rad.
    pub axis_error: f64,
}

/// Estimates the positions on the body of the points that move as one rigid body in every recording with a throw.
/// `names` maps labels of the recordings to marker names. For each label that is not a valid marker name and has no
/// entry, an entry with a valid name is added.
pub fn estimated(
    options: &Import,
    reading: &ReadOptions,
    names: &mut BTreeMap<String, String>,
) -> anyhow::Result<Estimated> {
    if let Some(height) = options
        .centre_height
        .filter(|h| h.is_nan() || h.abs() > MAX_HEIGHT)
    {
        bail!(
            "--centre-height: found {height}, expected metres, at most {MAX_HEIGHT} (millimetres?)"
        );
    }
    let up = super::up(options)?;
    let mut thrown: Vec<(Take, Throws)> = Vec::new();
    for file in &options.takes {
        let mut take = dataset::takes::read(file, reading)?;
        // The positions are estimated from the single points, not from poses of bodies.
        take.bodies.clear();
        let up = dataset::takes::up_of(&take, file, up)?;
        let turned = take.with_z_up(up, options.left_handed);
        let found = dataset::takes::find_throws(&turned, &[], &ThrowOptions::default());
        if !found.throws.is_empty() {
            thrown.push((turned, found));
        }
    }
    if thrown.is_empty() {
        bail!(
            "{} to estimate the template from, or a template by --markers",
            no_throw()
        );
    }
    let (labels, left_out) = labels(&thrown);
    let mut flights = Vec::new();
    for (take, found) in &thrown {
        let points = labels
            .iter()
            .map(|label| take.points.iter().position(|p| p.label == *label));
        let points: Vec<Option<usize>> = points.collect();
        for throw in &found.throws {
            let row = |sample: usize| -> Vec<Option<[f64; 3]>> {
                let each = points.iter();
                each.map(|point| take.points[(*point)?].positions[sample])
                    .collect()
            };
            let rows: Vec<_> = throw.samples().map(row).collect();
            flights.push((&take.times[throw.samples()], rows));
        }
    }
    let flights: Vec<FreeFlight<'_>> = flights
        .iter()
        .map(|(times, positions)| FreeFlight { times, positions })
        .collect();
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
    Ok(Estimated {
        origin_error: found.origin_error(),
        axis_error: found.axis_error(),
        comments: comments.collect(),
        template: BodyTemplate {
            model: None,
            parameters: BTreeMap::new(),
            markers: found
                .markers
                .iter()
                .map(|marker| Marker {
                    name: marker.label.clone(),
                    // More digits than a nanometre would suggest a precision that no estimate has.
                    position: marker.position.map(|x| (x * 1e9).round() / 1e9 + 0.0),
                })
                .collect(),
        },
        decisions,
    })
}

/// Valid marker name made from the label of a recording: every character except letters, digits, `_`, `-` and `.` is
/// replaced by `_`.
pub(super) fn name(label: &str) -> String {
    let is_kept = |c: char| c.is_alphanumeric() || matches!(c, '_' | '-' | '.');
    let each = label.chars().map(|c| if is_kept(c) { c } else { '_' });
    each.collect()
}

/// Labels of the points that move as one rigid body in all recordings, and labels of the remaining points; each list is
/// in the order of first occurrence.
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
