//! Command `hyzer design`: searches for a throw that serves a purpose; writes its release and a report.

use analysis::Estimates;
use analysis::design::{
    Aims, Bounds, Design, Goal, SampleOptions, Scattered, SearchOptions, Spread, ThrowFlightError,
    ThrowFlights, ThrownBody, design, spread,
};
use anyhow::bail;
use flight::files::ResultFile;
use flight::release::{Release, ReleaseError};
use model_spec::model::Model;
use report::Units;
use report::viewer::View;

use super::simulate::{apply_all, throws};
use super::vector;
use crate::cli::Design as Options;
use crate::{Answer, output};

/// Runs `hyzer design`. `Answer::No` if the throw violates a constraint of the goal.
pub(super) fn run(options: &Options) -> anyhow::Result<Answer> {
    let out = output::results(options.out.as_deref(), &options.figures, &[])?;
    let fit = options.fit.as_deref().map(|file| {
        let place = format!("--fit: {}", file.display());
        match Estimates::text(file) {
            Ok(text) => Ok((place, text)),
            Err(error) => bail!("{place}: {error}"),
        }
    });
    let bounds = |body: &ThrownBody| match &options.bounds {
        Some(file) => Ok(Some(Bounds::read_file(file, body)?)),
        None => Ok(None),
    };
    let asked = Asked {
        name: &options.model,
        model: model_spec::load::load(&options.model, &super::names(&options.with))?,
        goal: goal(options)?,
        bounds: &bounds,
        wind: options.wind.as_deref(),
        units: options.units,
        set: &options.set,
        fit: fit.transpose()?,
        samples: options.samples as usize,
        search: SearchOptions {
            starts: options.starts as usize,
            seed: options.seed,
            threads: (options.threads).map_or_else(flight::parallel::threads, |n| n as usize),
            ..SearchOptions::default()
        },
    };
    designed(asked, |made, flights| {
        if !made.left_out.is_empty() {
            let names = made.left_out.join(", ");
            eprintln!("--fit: the model has no {names}; left out");
        }
        if let Some(doubt) = &made.doubt {
            eprintln!("--fit: {doubt}");
        }
        output::print(made.text(options.units))?;
        if let Some(out) = &out {
            let what = "release.toml, design.json, report.html and flight.html";
            out.write(made.files(flights)?, what)?;
        }
        Ok(Answer::of(made.found.feasible))
    })
}

/// What is to be designed, and how.
pub struct Asked<'a> {
    /// Name or path of the model.
    pub name: &'a str,
    /// The model, with its effects.
    pub model: Model,
    /// Purpose of the throw.
    pub goal: Goal,
    /// Bounds for the body; `None` for the standard ones.
    pub bounds: &'a dyn Fn(&ThrownBody) -> Result<Option<Bounds>, ReleaseError>,
    /// Wind as in the option `--wind`.
    pub wind: Option<&'a str>,
    /// Units of the components of the wind.
    pub units: Units,
    /// Parameters and coefficients as in the option `--set`.
    pub set: &'a [String],
    /// Name in messages and text of the `report.json` of a fit, whose estimates are flown and whose standard errors scatter them.
    pub fit: Option<(String, String)>,
    /// Number of flights that are sampled for the spread.
    pub samples: usize,
    /// Starts, seed and threads.
    pub search: SearchOptions,
}

/// Designs a throw, and calls `then` with it and what flies it.
///
/// # Errors
/// If an input is faulty, or no throw can be flown.
pub fn designed<R>(
    asked: Asked<'_>,
    then: impl FnOnce(&Designed<'_>, &ThrowFlights<'_>) -> anyhow::Result<R>,
) -> anyhow::Result<R> {
    let mut model = asked.model;
    let mut release = Release {
        // The search sets the motion of the throw.
        initial: Vec::new(),
        ..throws::at_defaults(asked.name, &model)
    };
    let is_plain = model.effects.is_empty();
    if let Some(wind) = asked.wind {
        model = super::wind::apply(wind, asked.units, model, &mut release)?;
    }
    let estimates = match &asked.fit {
        Some((place, text)) => match Estimates::read(text) {
            Ok(estimates) => estimates,
            Err(error) => bail!("{place}: {error}"),
        },
        None => Estimates::default(),
    };
    // What was fitted is flown, unless another value is asked for.
    for own in &estimates.coefficients {
        if model
            .coefficients
            .iter()
            .any(|known| known.name == own.name)
        {
            release.coefficients.push((own.name.clone(), own.value));
        }
    }
    apply_all(asked.set, &model, &mut release)?;
    let body = ThrownBody::new(model)?;
    let flights = body.with(&release);
    let given = (asked.bounds)(&body)?;
    // In still air neither range nor time depends on the heading.
    let is_calm = release.wind[0] == 0.0
        && release.wind[1] == 0.0
        && release.wind_field.is_none()
        && is_plain;
    let holds_heading = given.is_none() && is_calm;
    let mut bounds = given.unwrap_or_else(|| Bounds::standard(&body));
    if holds_heading && matches!(asked.goal, Goal::Range | Goal::HangTime) {
        bounds.set("heading", 0.0, 0.0);
    }
    let found = design(&flights, asked.goal, &bounds, &asked.search)?;
    let (scattered, left_out) =
        Scattered::of(&flights, &bounds.scatter).with_coefficients(&flights, &estimates);
    let aims = aims(&found, &bounds);
    let samples = SampleOptions {
        count: asked.samples,
        seed: asked.search.seed,
        threads: asked.search.threads,
    };
    let spread = spread(&flights, &found.throw, &aims, &scattered, &samples)?;
    let made = Designed {
        model: asked.name,
        release: &release,
        found,
        bounds,
        spread,
        left_out,
        doubt: estimates.doubt,
    };
    then(&made, &flights)
}

fn goal(options: &Options) -> anyhow::Result<Goal> {
    let name = options.goal.as_str();
    let target = options.target.as_deref();
    let (unit, size) = options.units.instead_of("m");
    let target = target.map(|text| vector("--target", text, unit));
    let target = target
        .transpose()?
        .map(|target| target.map(|own| own * size));
    Ok(match (name, target) {
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
    /// Coefficients of the fit that the model does not have.
    pub left_out: Vec<String>,
    /// Why the errors of the coefficients are not to be relied on.
    pub doubt: Option<String>,
}

/// What the spread of the landings is judged by.
fn aims(found: &Design, bounds: &Bounds) -> Aims {
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
    /// Summary for the terminal, in `units`.
    pub fn text(&self, units: Units) -> String {
        report::design::text(&self.found, &self.bounds, &self.spread, units)
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
