//! What a model predicts of a flight's markers, with exact sensitivities to its unknowns.
//!
//! The sensitivities obey the variational equations dS/dt = J S + [0 | Jp], flown together with the state.

mod jacobian_columns;
mod weighted_rows;

use std::ops::Range;

use flight::ModelState;
use model_spec::model::Model;
use nalgebra::DVector;
use ode::{DifferentiableRhs, Sensitivities};
use ode::{IntegrationOptions, Method, integrate_at, integrate_with_callback};

use self::jacobian_columns::JacobianColumns;
use self::weighted_rows::WeightedRows;
use crate::least_squares::NormalBlock;
use crate::marker_observers::MarkerConditions;
use crate::noise::NoiseModel;
use crate::observations::Observations;
use crate::problem::FitProblem;

/// Tolerance of the integration over the noise's size (per metre), where there are any number of flights. A disc then stays far below a
/// thousandth of the noise after a second, and one that spins fast and is told by a quaternion, whose errors add up, below a
/// fiftieth.
pub(crate) const FINE: f64 = 0.007;

/// The same where there are so few flights of a body that is not told by a quaternion, still below a thousandth of the noise. The
/// errors of many would together hide what the last steps gain.
const OF_FEW: (f64, usize) = (0.02, 200);

/// The tolerance for so many flights of a model.
pub(crate) fn tolerance(model: &Model, flights: usize) -> f64 {
    let (coarse, few) = OF_FEW;
    if model.quaternions().next().is_some() {
        return FINE;
    }
    let part = few as f64 / flights.max(few) as f64;
    (coarse * part.sqrt()).max(FINE)
}

/// The same for residuals alone, which are looked at one by one.
const LOOSE_TOLERANCE: f64 = 0.02;

/// The same on the way, where another step follows: below a quarter of the noise at worst; over the scale of the loss where
/// that is more than so many times the noise's.
const ROUGH_TOLERANCE: f64 = 0.08;
const FAR: f64 = 2.0;

/// Bounds of the tolerance: what rounding allows, and what keeps a flight a flight.
const TOLERANCES: (f64, f64) = (1e-10, 1e-3);

/// Which unknowns a residual is differentiated by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unknowns {
    /// The flight's own.
    Local,
    /// And the shared ones.
    All,
}

/// How residuals count.
#[derive(Clone, Copy, Debug)]
pub enum Loss<'a> {
    /// By Huber's loss over this scale (m): by their squares near 0, by their sizes beyond.
    Huber(f64),
    /// By their innovations over the noise's, outliers left out.
    Whitened(&'a NoiseModel),
}

/// Flies the first samples of a track and sums its residuals.
///
/// # Errors
/// In words, where the flight is impossible.
pub fn linearise(
    problem: &FitProblem,
    observations: &Observations,
    (global, local): (&DVector<f64>, &DVector<f64>),
    samples: usize,
    by: Unknowns,
    loss: Loss<'_>,
) -> Result<NormalBlock, String> {
    let conditions = problem.body.bind(observations.parameters(problem, global));
    let constants: Vec<usize> = match by {
        Unknowns::Local => Vec::new(),
        Unknowns::All => problem.globals.iter().map(|global| global.param).collect(),
    };
    let by = (conditions.differentiable_rhs(), constants.as_slice());
    linearise_with(
        problem,
        observations,
        (global, local),
        samples,
        loss,
        by,
        None,
    )
}

/// As [`linearise`], by equations of motion of one's own and these constants of them, which stand in the place of the shared
/// unknowns. Where the flight is `kept` for another look at it, none before the first, nothing else than the loss and the
/// outliers may differ from look to look.
///
/// # Errors
/// In words, where the flight is impossible.
pub fn linearise_with<M: DifferentiableRhs>(
    problem: &FitProblem,
    observations: &Observations,
    (global, local): (&DVector<f64>, &DVector<f64>),
    samples: usize,
    loss: Loss<'_>,
    (motion, constants): (M, &[usize]),
    kept: Option<&mut Option<Vec<f64>>>,
) -> Result<NormalBlock, String> {
    let columns = JacobianColumns::new(observations, motion.jacobian_pattern(), constants.len());
    let tolerance = match loss {
        // Where residuals are far from noise yet, what is left of them counts.
        Loss::Huber(scale) if scale > FAR * problem.sigma0 => ROUGH_TOLERANCE * scale,
        Loss::Huber(_) => ROUGH_TOLERANCE * problem.sigma0,
        Loss::Whitened(_) => problem.tolerance * problem.sigma0,
    };
    let mut sums = WeightedRows::new(columns.rows(), observations.markers, loss);
    let flight = TrajectoryPass {
        problem,
        observations,
        global,
        local,
        samples,
        tolerance,
        // Where the noise is known an outlier is left out; before, it counts for little.
        outliers: matches!(loss, Loss::Huber(_)),
    };
    flight.each((motion, constants), &columns, kept, |seen| {
        sums.add(seen.marker, seen.time, seen.rows, seen.residual);
    })?;
    Ok(sums.rows.block())
}

/// Hands out every residual of a track, outliers too, sample by sample and marker by marker, with its derivatives by
/// the flight's own unknowns and then by these constants of the motion.
///
/// # Errors
/// In words, where the flight is impossible.
pub fn each_residual<M: DifferentiableRhs>(
    problem: &FitProblem,
    observations: &Observations,
    (global, local): (&DVector<f64>, &DVector<f64>),
    motion: M,
    constants: &[usize],
    mut each: impl FnMut(PointResidual<'_>),
) -> Result<(), String> {
    let columns = JacobianColumns::new(observations, motion.jacobian_pattern(), constants.len());
    let flight = TrajectoryPass {
        problem,
        observations,
        global,
        local,
        samples: observations.times.len(),
        tolerance: LOOSE_TOLERANCE * problem.sigma0,
        outliers: true,
    };
    let places: Vec<usize> = columns
        .local
        .iter()
        .copied()
        .chain(columns.moving..columns.moving + columns.global)
        .collect();
    let mut rows = [0; 3].map(|_| vec![0.0; places.len()]);
    flight.each((motion, constants), &columns, None, |seen| {
        for (to, from) in rows.iter_mut().zip(seen.rows.iter()) {
            for (to, &place) in to.iter_mut().zip(&places) {
                *to = from[place];
            }
        }
        each(PointResidual {
            marker: seen.marker,
            sample: seen.sample,
            residual: seen.residual,
            rows: &rows,
        });
    })
}

/// The residual of one marker at one sample, with its derivatives.
#[derive(Clone, Copy, Debug)]
pub struct PointResidual<'r> {
    /// Which marker.
    pub marker: usize,
    /// Which sample.
    pub sample: usize,
    /// Predicted less measured, m.
    pub residual: [f64; 3],
    /// Derivatives of each axis, by the flight's own unknowns and then by the constants.
    pub rows: &'r [Vec<f64>; 3],
}

/// A flight along which residuals are differentiated.
struct TrajectoryPass<'a> {
    problem: &'a FitProblem,
    observations: &'a Observations,
    global: &'a DVector<f64>,
    local: &'a DVector<f64>,
    samples: usize,
    /// Of the integration, m.
    tolerance: f64,
    outliers: bool,
}

/// A residual on its way to the sums.
struct ObservedPoint<'r> {
    marker: usize,
    sample: usize,
    time: f64,
    residual: [f64; 3],
    rows: &'r mut [Vec<f64>; 3],
}

impl TrajectoryPass<'_> {
    fn each<M: DifferentiableRhs>(
        &self,
        (motion, constants): (M, &[usize]),
        columns: &JacobianColumns,
        kept: Option<&mut Option<Vec<f64>>>,
        mut each: impl FnMut(ObservedPoint<'_>),
    ) -> Result<(), String> {
        let (problem, observations) = (self.problem, self.observations);
        // Only how many columns there are counts here; they are filled along the chart.
        let moving: Vec<usize> = (0..columns.moving).collect();
        let mut variations = Sensitivities::new(motion, &moving, constants);
        let places = variations.layout();
        let parameters = observations.parameters(problem, self.global);
        let sight = MarkerConditions::new(&problem.body, &parameters, observations.markers);
        let mut observers = sight.observers();
        let mut rows = columns.empty_rows();
        let times = &observations.times[..self.samples];
        let mut visit = |sample: usize, both: &[f64]| {
            let (time, state) = (times[sample], places.state(both));
            for (marker, position) in problem.markers.iter().enumerate() {
                let seen = match self.outliers {
                    true => observations.points(sample)[marker],
                    false => observations.inlier(sample, marker),
                };
                let Some(seen) = seen else { continue };
                let (y, derivatives) = observers.linearise(time, state, (marker, position));
                let row_of = |state: usize| places.padded_row(both, state);
                columns.derive(&derivatives, row_of, constants, &mut rows);
                each(ObservedPoint {
                    marker,
                    sample,
                    time,
                    residual: [0, 1, 2].map(|axis| y[axis] - seen[axis]),
                    rows: &mut rows,
                });
            }
        };
        let length = variations.len();
        if let Some(Some(cache)) = kept {
            for (sample, both) in cache.chunks(length).enumerate() {
                visit(sample, both);
            }
            return Ok(());
        }
        let tangent = columns.tangent(&observations.manifold.tangent(self.local.as_slice()));
        let start = variations.initial_state_with(self.local.as_slice(), &tangent);
        let (from, options) = ((times[0], &start), options(self.tolerance));
        let cache = match kept {
            Some(kept) => {
                let mut cache = vec![0.0; length * times.len()];
                integrate_at(&mut variations, from, times, &options, &mut [], &mut cache).map(
                    |_| {
                        for (sample, both) in kept.insert(cache).chunks(length).enumerate() {
                            visit(sample, both);
                        }
                    },
                )
            }
            None => {
                let observed = problem.body.observed_states();
                let observed = observed.into_iter().map(|state| places.row_range(state));
                let shown = joined(std::iter::once(places.state_range()).chain(observed));
                integrate_with_callback(&mut variations, from, times, &options, &shown, visit)
            }
        };
        cache.map_err(|error| error.to_string())
    }
}

/// The same places, those that meet joined.
fn joined(places: impl Iterator<Item = Range<usize>>) -> Vec<Range<usize>> {
    let mut joined: Vec<Range<usize>> = Vec::new();
    for places in places {
        match joined.last_mut() {
            Some(last) if last.end == places.start => last.end = places.end,
            _ => joined.push(places),
        }
    }
    joined
}

/// The state at each of the first samples of a track, sample after sample.
///
/// # Errors
/// In words, where the flight is impossible.
pub fn states(
    problem: &FitProblem,
    observations: &Observations,
    (global, local): (&DVector<f64>, &DVector<f64>),
    samples: usize,
) -> Result<Vec<f64>, String> {
    let conditions = problem.body.bind(observations.parameters(problem, global));
    let start: ModelState = local.as_slice().into();
    let times = &observations.times[..samples];
    let mut states = vec![0.0; start.len() * times.len()];
    let (from, options) = (
        (times[0], &start),
        options(LOOSE_TOLERANCE * problem.sigma0),
    );
    let mut motion = conditions.rhs();
    integrate_at(&mut motion, from, times, &options, &mut [], &mut states)
        .map_err(|error| error.to_string())?;
    Ok(states)
}

/// Predicted less measured, by marker and sample, m; `None` where nothing was seen. Outliers are among them.
pub type Residuals = Vec<Vec<Option<[f64; 3]>>>;

/// The residuals at the first samples of a track.
///
/// # Errors
/// In words, where the flight is impossible.
pub fn residuals(
    problem: &FitProblem,
    observations: &Observations,
    unknowns: (&DVector<f64>, &DVector<f64>),
    samples: usize,
) -> Result<Residuals, String> {
    let cache = states(problem, observations, unknowns, samples)?;
    Ok(residuals_of(problem, observations, unknowns.0, &cache))
}

/// The residuals at states that were flown, sample after sample.
pub fn residuals_of(
    problem: &FitProblem,
    observations: &Observations,
    global: &DVector<f64>,
    cache: &[f64],
) -> Residuals {
    let parameters = observations.parameters(problem, global);
    let sight = MarkerConditions::new(&problem.body, &parameters, observations.markers);
    let mut observers = sight.observers();
    let states = observations.manifold.states();
    let mut residuals = vec![Vec::with_capacity(cache.len() / states); observations.markers];
    for (sample, state) in cache.chunks(states).enumerate() {
        for (marker, position) in problem.markers.iter().enumerate() {
            let residual = observations.points(sample)[marker].map(|seen| {
                let y = observers.position(observations.times[sample], state, (marker, position));
                [0, 1, 2].map(|axis| y[axis] - seen[axis])
            });
            residuals[marker].push(residual);
        }
    }
    residuals
}

/// IntegrationOptions of an integration of this tolerance, m, within its bounds.
fn options(tolerance: f64) -> IntegrationOptions {
    IntegrationOptions {
        method: Method::Tsit5,
        ..IntegrationOptions::with_tolerance(tolerance.clamp(TOLERANCES.0, TOLERANCES.1))
    }
}
