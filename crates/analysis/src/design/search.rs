//! The search for a throw: starts from a low-discrepancy set with flights at a loose tolerance, then descents with
//! exact derivatives.

use std::cell::RefCell;
use std::cmp::Ordering;

use flight::parallel::each_on;
use flight::throw::{FIELDS, Throw};
use nalgebra::{DVector, Vector3};
use ode::IntegrationOptions;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::design::bounds::Bounds;
use crate::design::error::DesignError;
use crate::design::goal::{Goal, Side};
use crate::design::optimise::{Arrival, Values, descend, meet};
use crate::design::sensitivity::{Sensitivity, sensitivities};
use crate::design::spread::landing_covariance;
use crate::design::throw_flight::{By, ThrowFlightError, ThrowFlights};

/// Options of a search; see [`design`](fn@design).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SearchOptions {
    /// Number of starting throws that are simulated; default 384.
    pub starts: usize,
    /// Number of local descents, from the best starting throws; default 12.
    pub descents: usize,
    /// Seed of the random shift of the starting throws; default 1.
    pub seed: u64,
    /// Number of threads, which does not affect the result; default: all processors.
    pub threads: usize,
}

impl Default for SearchOptions {
    fn default() -> Self {
        SearchOptions {
            starts: 384,
            descents: 12,
            seed: 1,
            threads: flight::parallel::threads(),
        }
    }
}

/// The throw that serves a goal best, and its flight.
#[derive(Clone, Debug, PartialEq)]
pub struct Design {
    /// Goal of the search.
    pub goal: Goal,
    /// Whether the throw meets the constraints of the goal: root sum square of their violations (m, m/s) below 1e-3.
    pub feasible: bool,
    /// The throw; if none meets the constraints, the one that violates them least.
    pub throw: Throw,
    /// Smallest distance of the path from the target, m; horizontal for a target on the ground, 0 without a target.
    pub miss: f64,
    /// Vertical velocity at the target of a flare, m/s, upwards positive.
    pub vertical_speed: Option<f64>,
    /// Smallest lateral distance of the path from the obstacle, m; negative inside it or on the wrong side.
    pub clearance: Option<f64>,
    /// Side on which the path is required to pass the obstacle.
    pub side: Option<Side>,
    /// Position of the mass centre at landing, m, in the inertial frame: x = y = 0 at release, z upwards.
    pub landing: Vector3<f64>,
    /// Duration of the flight, s.
    pub time: f64,
    /// Value by which the goal is judged; [`Design::figure_name`] gives its name and unit.
    pub figure: f64,
    /// Influence of each quantity of the throw on the landing.
    pub sensitivity: Vec<Sensitivity>,
    /// Number of starting throws that could be flown to the ground.
    pub flown: usize,
}

/// Root sum square of the constraint violations, in m and m/s, below which a throw is feasible.
const SERVES: f64 = 1e-3;
/// Relative tolerances of the integration: of the starting throws, the descents and the final flight.
const TOLERANCES: [f64; 3] = [1e-4, 1e-6, 1e-9];
/// Bases of the Halton sequence of the starting throws, one per quantity.
const BASES: [u64; 8] = [2, 3, 5, 7, 11, 13, 17, 19];
/// Minimum distance of the starting points of two descents in the unit box.
const APART: f64 = 0.1;
const SPREAD_STEP: f64 = 1e-4;

/// Searches for the throw within bounds that serves a goal best.
///
/// # Errors
/// [`DesignError`] if goal and bounds contradict each other or no throw can be flown. Constraints that cannot be met are
/// no error: see [`Design::feasible`].
pub fn design(
    flights: &ThrowFlights<'_>,
    goal: Goal,
    bounds: &Bounds,
    options: &SearchOptions,
) -> Result<Design, DesignError> {
    if options.threads == 0 {
        return Err(DesignError::NoThreads);
    }
    match (goal, goal.target()) {
        (Goal::Curve(_), _) if bounds.obstacle.is_none() => return Err(DesignError::NoObstacle),
        (_, Some(target)) if !target.iter().all(|x| x.is_finite()) => {
            return Err(DesignError::NotFinite(target.into()));
        }
        (_, Some(target)) if target.z < 0.0 => return Err(DesignError::Buried(-target.z)),
        (Goal::Flare(_), Some(target)) if target.z == 0.0 => {
            return Err(DesignError::FlareOnGround);
        }
        _ => {}
    }
    if let Some((name, least, greatest)) = bounds.no_range() {
        return Err(DesignError::NoRange {
            name,
            least,
            greatest,
        });
    }
    let task = Task {
        flights,
        goal,
        bounds,
    };
    let sides = match bounds.obstacle.map(|obstacle| obstacle.side) {
        None => vec![None],
        Some(None) => vec![Some(Side::Left), Some(Side::Right)],
        Some(side) => vec![side],
    };
    let starts = task.explore(&sides, options)?;
    let mut jobs: Vec<(Option<Side>, DVector<f64>)> = Vec::new();
    let count = options.descents.div_ceil(sides.len());
    for (k, side) in sides.iter().enumerate() {
        let chosen = task.chosen(&starts, k, count).into_iter();
        jobs.extend(chosen.map(|at| (*side, at)));
    }
    let met = each_on(options.threads, jobs.len(), |k| {
        let (side, at) = &jobs[k];
        Some((*side, task.met(*side, at, 1)?))
    });
    let mut met: Vec<(Option<Side>, Arrival)> = met.into_iter().flatten().collect();
    // The sort is stable: equal results stay in the order of the starts.
    let order = |a: &Values, b: &Values| task.rank(a).partial_cmp(&task.rank(b));
    met.sort_by(|(_, a), (_, b)| order(&a.values, &b.values).unwrap_or(Ordering::Equal));
    // All starts are moved to the constraints, but only the best of them along the constraints.
    if jobs.iter().any(|(side, _)| task.is_constrained(*side)) {
        met.truncate(options.descents.div_ceil(4));
    }
    let best = each_on(options.threads, met.len(), |k| {
        let (side, from) = &met[k];
        let better = if from.values.violation() < SERVES {
            task.least(*side, &from.at)
        } else {
            task.nearest(*side, &from.at)
        };
        (*side, better.unwrap_or_else(|| from.clone()))
    });
    let is_better = |a: &Arrival, b: &Arrival| task.rank(&a.values) < task.rank(&b.values);
    let best = best.into_iter();
    let best = best.reduce(|best, other| {
        if is_better(&other.1, &best.1) {
            other
        } else {
            best
        }
    });
    let Some((side, best)) = best else {
        return Err(DesignError::NoDescent);
    };
    let refined = (best.values.violation() < SERVES).then(|| task.met(side, &best.at, 2));
    task.finished(side, &refined.flatten().unwrap_or(best), starts.len())
}

/// A search: the body with its parameters, the goal and the bounds.
struct Task<'t> {
    flights: &'t ThrowFlights<'t>,
    goal: Goal,
    bounds: &'t Bounds,
}

/// Starting throw that can be flown to the ground.
struct Start {
    /// Point in the unit box.
    at: DVector<f64>,
    /// Constraint violation and objective for each side of the obstacle, left before right; one pair without obstacle.
    of_sides: Vec<(f64, f64)>,
}

impl Task<'_> {
    fn explore(
        &self,
        sides: &[Option<Side>],
        options: &SearchOptions,
    ) -> Result<Vec<Start>, DesignError> {
        let n = self.bounds.free().count();
        let mut random = ChaCha8Rng::seed_from_u64(options.seed);
        let shift: Vec<f64> = (0..n).map(|_| random.random::<f64>()).collect();
        let point = |i: usize| match i {
            0 => DVector::from_element(n, 0.5),
            _ => DVector::from_fn(n, |k, _| {
                (radical_inverse(i as u64, BASES[k]) + shift[k]).fract()
            }),
        };
        let settings = IntegrationOptions::with_tolerance(TOLERANCES[0]);
        let tried = each_on(options.threads, options.starts.max(1), |i| {
            let at = point(i);
            let path = self.flights.fly(&self.bounds.throw(&at), None, &settings)?;
            let of_sides = sides.iter().map(|side| {
                let values = self.path_values(&path, *side);
                (values.violation(), values.objective)
            });
            let of_sides = of_sides.collect();
            Ok(Start { at, of_sides })
        });
        let mut last = None;
        let mut keep = |result: Result<Start, ThrowFlightError>| {
            result.map_err(|error| last = Some(error)).ok()
        };
        let starts: Vec<Start> = tried.into_iter().filter_map(&mut keep).collect();
        match last {
            Some(last) if starts.is_empty() => Err(DesignError::NoFlight {
                tried: options.starts.max(1),
                last,
            }),
            _ => Ok(starts),
        }
    }

    fn path_values(&self, path: &crate::design::path::Path<'_>, side: Option<Side>) -> Values {
        let obstacle = self.bounds.obstacle.as_ref();
        self.goal
            .values(path, obstacle.and_then(|obstacle| Some((obstacle, side?))))
    }

    /// The best `count` starting points for the side with this index, at least [`APART`] from each other.
    fn chosen(&self, starts: &[Start], side: usize, count: usize) -> Vec<DVector<f64>> {
        let mut order: Vec<&Start> = starts.iter().collect();
        // The sort is stable: equal points stay in the order of the starts.
        order.sort_by(|a, b| {
            let [a, b] = [a, b].map(|start| start.of_sides[side]);
            a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1))
        });
        let mut chosen: Vec<DVector<f64>> = Vec::new();
        for Start { at, .. } in order {
            if chosen.len() == count {
                break;
            }
            if chosen.iter().all(|other| (other - at).norm() > APART) {
                chosen.push(at.clone());
            }
        }
        chosen
    }

    /// Sort key of results: feasible ones by objective, then infeasible ones by constraint violation.
    fn rank(&self, values: &Values) -> (f64, f64) {
        let violation = values.violation();
        if violation < SERVES {
            (0.0, values.objective)
        } else {
            (violation, 0.0)
        }
    }

    fn is_constrained(&self, side: Option<Side>) -> bool {
        self.goal.target().is_some() || side.is_some()
    }

    /// Moves a starting point as near to the constraints as possible; `accuracy` is an index into [`TOLERANCES`].
    fn met(&self, side: Option<Side>, from: &DVector<f64>, accuracy: usize) -> Option<Arrival> {
        let near = RefCell::new(None);
        if !self.is_constrained(side) {
            let values = self.values(side, from, accuracy, &near, true)?;
            return Some(Arrival {
                at: from.clone(),
                values,
            });
        }
        let problem =
            |at: &DVector<f64>, objective: bool| self.values(side, at, accuracy, &near, objective);
        let mut arrival = meet(&problem, from)?;
        arrival.values.objective = self.objective(&arrival.at, arrival.values.objective)?;
        Some(arrival)
    }

    /// Minimizes the objective from a point that meets the constraints. `None` if the throw there cannot be flown.
    fn least(&self, side: Option<Side>, from: &DVector<f64>) -> Option<Arrival> {
        let near = RefCell::new(None);
        let problem =
            |at: &DVector<f64>, objective: bool| self.values(side, at, 1, &near, objective);
        descend(&problem, from)
    }

    /// Minimizes a remaining violation; unlike [`Task::met`] accounts for the curvature of the constraints.
    fn nearest(&self, side: Option<Side>, from: &DVector<f64>) -> Option<Arrival> {
        let near = RefCell::new(None);
        let problem = |at: &DVector<f64>, _: bool| {
            Some(self.values(side, at, 1, &near, false)?.violation_alone())
        };
        let found = descend(&problem, from)?;
        let values = self.values(side, &found.at, 1, &near, false)?;
        Some(Arrival {
            at: found.at,
            values,
        })
    }

    /// Objective of the goal at a point of the unit box; `of_path` is that of [`Goal::values`].
    fn objective(&self, at: &DVector<f64>, of_path: f64) -> Option<f64> {
        match self.goal {
            Goal::Hit(_) | Goal::Curve(_) => Some(0.5 * at.map(|v| v - 0.5).norm_squared()),
            Goal::Spread(_) => {
                let settings = IntegrationOptions::with_tolerance(TOLERANCES[1]);
                self.rms_spread(&self.bounds.throw(at), None, &settings)
            }
            _ => Some(of_path),
        }
    }

    /// Objective and constraints at a point of the unit box, with derivatives with respect to its coordinates. The
    /// objective of [`Goal::Spread`] is computed only if `objective` is true. `None` if the throw cannot be flown.
    fn values(
        &self,
        side: Option<Side>,
        at: &DVector<f64>,
        accuracy: usize,
        near: &RefCell<Option<Vec<f64>>>,
        objective: bool,
    ) -> Option<Values> {
        let throw = self.bounds.throw(at);
        let free: Vec<(usize, f64, f64)> = self.bounds.free().copied().collect();
        let by: Vec<By> = free.iter().map(|(field, ..)| By::Throw(*field)).collect();
        let settings = IntegrationOptions::with_tolerance(TOLERANCES[accuracy]);
        let known = near.borrow().clone();
        let path = self
            .flights
            .fly_with_derivatives(&throw, known.as_deref(), &by, &settings)
            .ok()?;
        let states = self.flights.body.compiled.layout().states.len();
        let first = path.trajectory.sample(0.0).map(|x| x[..states].to_vec());
        *near.borrow_mut() = first.clone();
        let mut values = self.path_values(&path, side);
        for (k, (_, least, greatest)) in free.iter().enumerate() {
            let width = greatest - least;
            values.gradient[k] *= width;
            values.equalities_by.column_mut(k).scale_mut(width);
            values.margins_by.column_mut(k).scale_mut(width);
        }
        match self.goal {
            Goal::Hit(_) | Goal::Curve(_) => {
                let off = at.map(|v| v - 0.5);
                values.objective = 0.5 * off.norm_squared();
                values.gradient = off;
            }
            Goal::Spread(_) if objective => {
                let spread = |at: &DVector<f64>| {
                    self.rms_spread(&self.bounds.throw(at), first.as_deref(), &settings)
                };
                values.objective = spread(at)?;
                let slope = |k: usize| {
                    let mut moved = at.clone();
                    // A step inwards, so that the throw stays within the bounds.
                    let is_high = at[k] > 0.5;
                    let step = if is_high { -SPREAD_STEP } else { SPREAD_STEP };
                    moved[k] += step;
                    Some((spread(&moved)? - values.objective) / step)
                };
                let slopes: Option<Vec<f64>> = (0..at.len()).map(slope).collect();
                values.gradient = DVector::from_vec(slopes?);
            }
            _ => {}
        }
        Some(values)
    }

    /// Root mean square distance of landings from their mean, m, to first order; `near` is a similar state at release.
    fn rms_spread(
        &self,
        throw: &Throw,
        near: Option<&[f64]>,
        settings: &IntegrationOptions,
    ) -> Option<f64> {
        let scatter = &self.bounds.scatter;
        let covariance = landing_covariance(self.flights, throw, near, scatter, settings).ok()?;
        Some(covariance.trace().sqrt())
    }

    fn finished(
        &self,
        side: Option<Side>,
        found: &Arrival,
        flown: usize,
    ) -> Result<Design, DesignError> {
        let throw = self.bounds.throw(&found.at);
        let settings = IntegrationOptions::with_tolerance(TOLERANCES[2]);
        // A separate flight with the model's limits as events and without derivatives.
        let path = self.flights.fly(&throw, None, &settings)?;
        let values = self.path_values(&path, side);
        let landing = path.landing();
        let point = path.point(self.goal.time(&path));
        let miss = self.goal.miss(&path);
        let is_flare = matches!(self.goal, Goal::Flare(_));
        let figure = match self.goal {
            Goal::Hit(_) | Goal::Curve(_) => miss,
            Goal::Range | Goal::HangTime => -values.objective,
            Goal::Flare(_) => values.objective,
            Goal::Spread(_) => self.rms_spread(&throw, None, &settings).unwrap_or(f64::NAN),
        };
        Ok(Design {
            goal: self.goal,
            feasible: values.violation() < SERVES,
            miss,
            vertical_speed: is_flare.then_some(point.velocity.z),
            clearance: values.margins.iter().copied().next(),
            side,
            landing: landing.position,
            time: landing.time,
            figure,
            sensitivity: sensitivities(self.flights, &throw, self.goal, &settings)?,
            throw,
            flown,
        })
    }
}

/// Digits of an integer in the given base, mirrored at the radix point; in [0, 1).
fn radical_inverse(mut index: u64, base: u64) -> f64 {
    let (mut value, mut unit) = (0.0, 1.0 / base as f64);
    while index > 0 {
        value += (index % base) as f64 * unit;
        index /= base;
        unit /= base as f64;
    }
    value
}

/// Names, units and values of the quantities that a throw has, in the order of [`FIELDS`].
pub fn numbers(throw: &Throw) -> impl Iterator<Item = (&'static str, &'static str, f64)> {
    let fields = FIELDS.iter();
    fields.filter_map(|(name, unit, ..)| Some((*name, *unit, throw.field(name)?)))
}
