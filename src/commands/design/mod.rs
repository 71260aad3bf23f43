//! Command `hyzer design`: searches for a throw that serves a purpose; writes its release and a report.

mod errors;
mod made;

use analysis::design::{
    Bounds, Goal, SampleOptions, Scattered, SearchOptions, ThrownBody, design, spread,
};
use anyhow::{Context, bail};
use flight::release::Release;
use nalgebra::Vector3;

use super::simulate::{apply_all, throws};
use super::vector;
use crate::cli::Design as Options;
use crate::{Answer, output};

pub use made::{Designed, aims};

/// Runs `hyzer design`: searches for the throw that serves a goal best, prints it, and writes the result files if an
/// output folder is given. Returns `Answer::No` if this throw violates a constraint of the goal, such as hitting the
/// target.
pub fn run(options: &Options) -> anyhow::Result<Answer> {
    let out = output::results(options.out.as_deref(), &options.figures)?;
    let mut model = model_spec::load::load(&options.model, &super::names(&options.with))?;
    let mut release = Release {
        // The search sets the motion of the throw.
        initial: Vec::new(),
        ..throws::at_defaults(&options.model, &model)
    };
    if let Some(wind) = &options.wind {
        model = super::wind::apply(wind, model, &mut release)?;
    }
    apply_all(&options.set, &model, &mut release)?;
    let body = ThrownBody::new(model)?;
    let flights = body.with(&release);
    let goal = goal(options)?;
    let mut bounds = match &options.bounds {
        Some(file) => Bounds::read_file(file, &body)?,
        None => Bounds::standard(&body),
    };
    // In still air neither range nor time depends on the heading.
    let is_calm = release.wind[0] == 0.0
        && release.wind[1] == 0.0
        && release.wind_field.is_none()
        && options.with.is_empty();
    if options.bounds.is_none() && is_calm && matches!(goal, Goal::Range | Goal::HangTime) {
        bounds.set("heading", 0.0, 0.0);
    }
    let threads = options
        .threads
        .map_or_else(flight::parallel::threads, |n| n as usize);
    let search = SearchOptions {
        starts: options.starts as usize,
        seed: options.seed,
        threads,
        ..SearchOptions::default()
    };
    let found = design(&flights, goal, &bounds, &search)?;
    let mut scattered = Scattered::of(&flights, &bounds.scatter);
    if let Some(file) = &options.fit {
        let (with, unknown) = scattered.with_coefficients(&flights, &errors::read(file)?);
        scattered = with;
        if !unknown.is_empty() {
            eprintln!("--fit: the model has no {}; left out", unknown.join(", "));
        }
    }
    let aims = aims(&found, &bounds);
    let samples = SampleOptions {
        count: options.samples as usize,
        seed: options.seed,
        threads,
    };
    let spread = spread(&flights, &found.throw, &aims, &scattered, &samples)?;
    let made = Designed {
        model: &options.model,
        release: &release,
        found,
        bounds,
        spread,
    };
    output::print(made.text())?;
    if let Some(out) = &out {
        let what = "release.toml, design.json, report.html and flight.html";
        out.write(made.files(&flights)?, what)?;
    }
    Ok(if made.found.feasible {
        Answer::Yes
    } else {
        Answer::No
    })
}

/// The goal of the throw that the options specify, with its target point.
fn goal(options: &Options) -> anyhow::Result<Goal> {
    let name = options.goal.as_str();
    let target = options
        .target
        .as_deref()
        .map(|text| vector("--target", text, "m"));
    let target = target.transpose()?.map(Vector3::from);
    let goal: anyhow::Result<Goal> = match (name, target) {
        ("range", None) => Ok(Goal::Range),
        ("hangtime", None) => Ok(Goal::HangTime),
        ("range" | "hangtime", Some(_)) => {
            bail!("--target: the goal {name} has no target; expected none")
        }
        ("hit", Some(target)) => Ok(Goal::Hit(target)),
        ("curve", Some(target)) => Ok(Goal::Curve(target)),
        ("flare", Some(target)) => Ok(Goal::Flare(target)),
        ("spread", Some(target)) => {
            if target.z == 0.0 {
                Ok(Goal::Spread(target))
            } else {
                bail!(
                    "--target: found a height of {} m, expected a point on the ground, X,Y,0",
                    target.z
                )
            }
        }
        _ => bail!("no --target: the goal {name} needs one, as in --target 30,0,0"),
    };
    goal.context("--goal")
}
