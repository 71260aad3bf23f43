//! Command `hyzer design`: searches for a throw that serves a purpose; writes its release and a report.

mod errors;

use analysis::design::{
    Aims, Bounds, Goal, SampleOptions, Scattered, SearchOptions, ThrownBody, design, spread,
};
use anyhow::{Context, bail};
use flight::files::ResultFile;
use flight::release::Release;
use nalgebra::Vector3;
use report::Figure;
use report::viewer::View;

use super::simulate::{apply_all, throws};
use super::vector;
use crate::cli::Design as Options;
use crate::{Answer, output};

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
    let (ground, air) = match found.goal.target() {
        Some(target) if target.z == 0.0 => (Some(target), None),
        other => (None, other),
    };
    let aims = Aims {
        landing: ground.unwrap_or(found.landing).xy(),
        circle: bounds.circle,
        target: air,
        obstacle: bounds.obstacle,
    };
    let samples = SampleOptions {
        count: options.samples as usize,
        seed: options.seed,
        threads,
    };
    let spread = spread(&flights, &found.throw, &aims, &scattered, &samples)?;
    output::print(report::design::text(&found, &bounds, &spread))?;
    if let Some(out) = &out {
        let settings = ode::IntegrationOptions::with_tolerance(1e-9);
        let path = flights.fly(&found.throw, None, &settings)?;
        let title = format!("{} · {}", body.model.name, goal.name());
        let (page, figures) = report::design::page(&title, &found, &bounds, &spread, &path);
        let mut files = vec![
            ResultFile::new("release.toml", found.release_toml(&options.model, &release)),
            ResultFile::new(
                "design.json",
                format!("{:#}\n", found.json(&body.model.name, Some(&spread))),
            ),
            ResultFile::new("report.html", page.html()),
        ];
        files.extend(figures.into_iter().flat_map(Figure::files));
        let view = View::of_trajectory(
            &title,
            &body.model,
            &body.compiled,
            &release,
            &path.trajectory,
        );
        files.extend(
            view.html(&title)
                .map(|html| ResultFile::new("flight.html", html)),
        );
        let what = "release.toml, design.json, report.html and flight.html";
        out.write(files, what)?;
    }
    Ok(if found.feasible {
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
