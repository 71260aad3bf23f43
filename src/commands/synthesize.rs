//! Command `hyzer synthesize`: makes a dataset from a model, releases and simulated noise.

use std::path::Path;

use anyhow::{Context, bail};
use dataset::synthesize::{Corruption, Plan, Spread, SyntheticDataset, flights};
use dataset::{Marker, write_with};
use flight::release::Release;
use model_spec::model::Model;

use super::fit::model_file;
use super::simulate::{apply_all, released};
use super::vector;
use crate::cli::Synthesize;
use crate::{Answer, output, progress};

/// Runs `hyzer synthesize`: makes flights from releases, and writes the dataset and the true values.
pub(super) fn run(options: &Synthesize) -> anyhow::Result<Answer> {
    output::new_folder(&options.out)?;
    let (model, releases) = prepare(options)?;
    let plan = plan(options)?;
    let mut made = flights(&model, &releases, &plan)?;
    // A model that is not built in is copied into the dataset.
    let named = options.model.as_deref().unwrap_or(&releases[0].model);
    let mut beside = Vec::from_iter(model_file(named)?);
    if let [(file, _)] = &beside[..] {
        made.dataset.model.clone_from(file);
    }
    beside.push(("truth.toml".to_owned(), made.truth.text()));
    progress::writing(|| write_with(&options.out, &made.dataset, &beside))
        .with_context(|| format!("--out {}", options.out.display()))?;
    output::print(summary(&made, &options.out))?;
    output::next(format_args!(
        "hyzer fit {} --out fitted",
        options.out.display()
    ));
    Ok(Answer::Yes)
}

/// The releases, with the changes by options, and the model that they have in common.
fn prepare(options: &Synthesize) -> anyhow::Result<(Model, Vec<Release>)> {
    let mut model: Option<Model> = None;
    let mut releases = Vec::with_capacity(options.release.len());
    for name in &options.release {
        let (own, mut release) = released(name, false, options.model.as_deref(), &options.with)?;
        apply_all(&options.set, &own, &mut release)?;
        releases.push(release);
        match &model {
            Some(model) if model.name != own.name => bail!(
                "--release: found one of the model {} and one of {}, expected one model",
                model.name,
                own.name
            ),
            _ => model = Some(own),
        }
    }
    let model = model.context("no --release")?;
    Ok((model, releases))
}

fn plan(options: &Synthesize) -> anyhow::Result<Plan> {
    let markers = options.marker.iter().map(|text| marker(text));
    Ok(Plan {
        flights: options.flights,
        held_out: options.held_out,
        duration: options.duration,
        rate: options.rate,
        markers: markers.collect::<anyhow::Result<_>>()?,
        spread: Spread {
            fraction: options.spread,
            ..Spread::default()
        },
        noise: Corruption {
            sigma: options.noise_sigma,
            ar1: options.noise_ar1,
            outliers: options.outliers,
            outlier_size: options.outlier_size,
            dropouts: options.dropouts,
        },
        seed: options.seed,
        ..Plan::default()
    })
}

/// Parses a marker `NAME=X,Y,Z`: its position in the body frame, m.
fn marker(text: &str) -> anyhow::Result<Marker> {
    let Some((name, position)) = text.split_once('=') else {
        bail!("--marker: found {text:?}, expected NAME=X,Y,Z in m");
    };
    Ok(Marker {
        name: name.trim().to_owned(),
        position: vector("--marker", position, "m")?,
    })
}

fn summary(made: &SyntheticDataset, folder: &Path) -> String {
    let flights = &made.dataset.flights;
    let samples: usize = flights.iter().map(|flight| flight.times.len()).sum();
    let seen: usize = flights.iter().map(dataset::measurements).sum();
    let all = samples * made.dataset.markers.len();
    format!(
        "{}: {} flights of {}, {samples} samples, {seen} of {all} marker points measured\n",
        folder.display(),
        flights.len(),
        made.truth.model,
    )
}
