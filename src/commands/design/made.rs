//! A designed throw: what is printed and written of it.

use analysis::design::{Aims, Bounds, Design, Spread, ThrowFlightError, ThrowFlights};
use flight::files::ResultFile;
use flight::release::Release;
use report::Figure;
use report::viewer::View;

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

/// What the spread of the landings is judged by: the point where the throw lands or that it aims at, and the obstacle.
pub fn aims(found: &Design, bounds: &Bounds) -> Aims {
    let (ground, air) = match found.goal.target() {
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
        let title = format!("{} · {}", body.model.name, found.goal.name());
        let (page, figures) =
            report::design::page(&title, found, &self.bounds, &self.spread, &path);
        let release = found.release_toml(self.model, self.release);
        let mut files = vec![
            ResultFile::new("release.toml", release),
            ResultFile::new("design.json", self.json(&body.model.name)),
            ResultFile::new("report.html", page.html()),
        ];
        files.extend(figures.into_iter().flat_map(Figure::files));
        let (model, compiled) = (&body.model, &body.compiled);
        let view = View::of_trajectory(&title, model, compiled, self.release, &path.trajectory);
        let view = view.html(&title);
        files.extend(view.map(|html| ResultFile::new("flight.html", html)));
        Ok(files)
    }
}
