//! Throws for a purpose.

use analysis::design::{self, Bounds, Goal, SearchOptions, ThrownBody};
use flight::throw::Throw;

use crate::{Error, Model, Release};

/// Options of a search, from [`Design::of`].
#[derive(Clone, Debug)]
pub struct DesignBuilder {
    model: Model,
    goal: Goal,
    ranges: Vec<(String, f64, f64)>,
    search: SearchOptions,
}

impl DesignBuilder {
    /// Bounds a quantity of the throw: `speed` (m/s), `heading`, `launch`, `nose`, `hyzer` (deg), `spin` (rpm) or
    /// `height` (m).
    pub fn bound(mut self, name: &str, least: f64, greatest: f64) -> Self {
        self.ranges.push((name.to_owned(), least, greatest));
        self
    }

    /// Sets the seed of the starting points; default 1.
    pub fn seed(mut self, seed: u64) -> Self {
        self.search.seed = seed;
        self
    }

    /// Sets the number of threads, at least 1; by default that of the processors. The result does not depend on it.
    pub fn threads(mut self, threads: usize) -> Self {
        self.search.threads = threads;
        self
    }

    /// Searches for the throw that serves the goal best.
    ///
    /// # Errors
    /// [`Error::Throw`] if the body cannot be thrown; [`Error::UnknownName`] for a bound of an unknown quantity;
    /// [`Error::Design`] if bounds are no range, the number of threads is 0, or no throw within them can be flown to the ground.
    pub fn run(&self) -> Result<Design, Error> {
        let body = ThrownBody::new(self.model.checked().clone())?;
        let flights = body.with_parameters(body.compiled.layout().default_parameters());
        let mut bounds = Bounds::standard(&body);
        for (name, least, greatest) in &self.ranges {
            let mut known = flight::throw::FIELDS.iter();
            if !known.any(|(field, ..)| field == name) {
                return Err(Error::UnknownName {
                    model: self.model.name().to_owned(),
                    name: name.clone(),
                });
            }
            bounds.set(name, *least, *greatest);
        }
        let found = design::design(&flights, self.goal, &bounds, &self.search)?;
        let state = flights.state(&found.throw, None);
        let state = state.map_err(design::ThrowFlightError::from)?;
        Ok(Design {
            release: self.model.release_from(state),
            found,
        })
    }
}

/// The throw that serves a goal best, and its flight.
#[derive(Clone, Debug)]
pub struct Design {
    found: design::Design,
    release: Release,
}

impl Design {
    /// Prepares a search for the throw of a model that serves a goal best.
    ///
    /// ```no_run
    /// # fn main() -> Result<(), hyzer::Error> {
    /// let disc = hyzer::Model::load("disc")?;
    /// let far = hyzer::Design::of(&disc, hyzer::Goal::Range).bound("speed", 10.0, 22.0).run()?;
    /// let flight = disc.fly(far.release())?;
    /// println!("{:.1} m in {:.1} s", far.figure(), flight.duration());
    /// # Ok(())
    /// # }
    /// ```
    pub fn of(model: &Model, goal: Goal) -> DesignBuilder {
        DesignBuilder {
            model: model.clone(),
            goal,
            ranges: Vec::new(),
            search: SearchOptions::default(),
        }
    }

    /// Whether the throw meets the constraints of the goal, such as passing through the point.
    pub fn is_feasible(&self) -> bool {
        self.found.feasible
    }

    /// Value by which the goal is judged: the range, m, the time in the air, s, or another of the goal.
    pub fn figure(&self) -> f64 {
        self.found.figure
    }

    /// The throw: speed, angles and spin. If no throw meets the constraints, the one that violates them least.
    pub fn throw(&self) -> &Throw {
        &self.found.throw
    }

    /// The throw as a release that ends on the ground.
    pub fn release(&self) -> &Release {
        &self.release
    }

    /// Smallest distance between the path and the point of the goal, m; 0 for a goal without a point.
    pub fn miss(&self) -> f64 {
        self.found.miss
    }

    /// Position of the mass centre at landing, m.
    pub fn landing(&self) -> [f64; 3] {
        self.found.landing.into()
    }

    /// Duration of the flight, s.
    pub fn duration(&self) -> f64 {
        self.found.time
    }

    /// Derivatives of the landing x and y (m) by each quantity of the throw, with its name.
    pub fn sensitivity(&self) -> impl Iterator<Item = (&'static str, [f64; 2])> {
        let each = self.found.sensitivity.iter();
        each.map(|s| (flight::throw::FIELDS[s.field].0, s.landing.xy().into()))
    }
}
