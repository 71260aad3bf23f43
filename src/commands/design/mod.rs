//! Command `hyzer design`: searches for a throw that serves a purpose; writes its release and a report.

mod errors;

use analysis::design::{
    Aims, Bounds, Design, Goal, SampleOptions, Scattered, SearchOptions, Spread, ThrowFlightError,
    ThrowFlights, ThrownBody, design, spread,
};
use anyhow::bail;
use flight::files::ResultFile;
use flight::release::Release;
use report::viewer::View;

use super::simulate::{apply_all, throws};
use super::vector;
use crate::cli::Design as Options;
use crate::{Answer, output};

/// Runs `hyzer design`. `Answer::No` if the throw violates a constraint of the goal.
pub(super) fn run(options: &Options) -> anyhow::Result<Answer> {
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
    let threads = options.threads.map(|n| n as usize);
    let threads = threads.unwrap_or_else(flight::parallel::threads);
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
    Ok(Answer::of(made.found.feasible))
}

fn goal(options: &Options) -> anyhow::Result<Goal> {
    let name = options.goal.as_str();
    let target = options.target.as_deref();
    let target = target.map(|text| vector("--target", text, "m"));
    Ok(match (name, target.transpose()?) {
        ("range", None) => Goal::Range,
        ("hangtime", None) => Goal::HangTime,
        ("range" | "hangtime", Some(_)) => {
            bail!("--target: the goal {name} has no target; expected none")
        }
        ("hit", Some(target)) => Goal::Hit(target),
        ("curve", Some(target)) => Goal::Curve(target),
        ("flare", Some(target)) => Goal::Flare(target),
        ("spread", Some([x, y, 0.0])) => Goal::Spread([x, y]),
        ("spread", Some([.., z])) => {
            bail!("--target: found a height of {z} m, expected a point on the ground, X,Y,0")
        }
        _ => bail!("no --target: the goal {name} needs one, as in --target 30,0,0"),
    })
}

/// A throw that was found, with the spread of its landings.
pub struct Designed<'a> {
    /// Name or path of the model, as it is written to `release.toml`.
    pub model: &'a str,
    /// Parameters and wind of the flights.
    pub release: &'a Release,
    /// The throw and its flight.
    pub found: Design,
    /// Bounds of the search.
    pub bounds: Bounds,
    /// Distribution of the landings.
    pub spread: Spread,
}

/// What the spread of the landings is judged by.
pub fn aims(found: &Design, bounds: &Bounds) -> Aims {
    let (ground, air) = match found.target() {
        Some(target) if target.z == 0.0 => (Some(target), None),
        other => (None, other),
    };
    Aims {
        landing: ground.unwrap_or(found.landing).xy(),
        circle: bounds.circle,
        target: air,
        obstacle: bounds.obstacle,
    }
}

impl Designed<'_> {
    /// Summary for the terminal.
    pub fn text(&self) -> String {
        report::design::text(&self.found, &self.bounds, &self.spread)
    }

    /// Text of the file `design.json`; `model` is the name of the model.
    pub fn json(&self, model: &str) -> String {
        format!("{:#}\n", self.found.json(model, Some(&self.spread)))
    }

    /// Result files of `hyzer design`.
    ///
    /// # Errors
    /// If the throw cannot be flown.
    pub fn files(&self, flights: &ThrowFlights<'_>) -> Result<Vec<ResultFile>, ThrowFlightError> {
        let (found, body) = (&self.found, flights.body);
        let settings = ode::IntegrationOptions::with_tolerance(1e-9);
        let path = flights.fly(&found.throw, None, &settings)?;
        let title = format!("{} · {}", body.model.name, found.goal_name());
        let page = report::design::page(&title, found, &self.bounds, &self.spread, &path);
        let release = found.release_toml(self.model, self.release);
        let mut files = vec![
            ResultFile::new("release.toml", release),
            ResultFile::new("design.json", self.json(&body.model.name)),
        ];
        files.extend(page.files());
        let (model, compiled) = (&body.model, &body.compiled);
        let view = View::of_trajectory(&title, model, compiled, self.release, &path.trajectory);
        let view = view.html(&title);
        files.extend(view.map(|html| ResultFile::new("flight.html", html)));
        Ok(files)
    }
}
