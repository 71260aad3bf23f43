//! What a model predicts of a flight's markers, with exact sensitivities to its unknowns.
//!
//! The sensitivities obey the variational equations dS/dt = J S + [0 | Jp], flown together with the state.

use flight::body::{Derivatives, States};
use flight::sensitivity::{Linearised, Sensitivities};
use flight::{Dynamics, Method, Options, fly_landing};
use nalgebra::DVector;

use crate::noise::{HUBER, Noise};
use crate::normal::Block;
use crate::rows::Rows;
use crate::setting::Setting;
use crate::track::Track;

/// Tolerance of the integration over the noise's size (per metre): errors stay below a hundredth of it.
const TOLERANCE: f64 = 0.007;

/// The same for residuals alone, which are looked at one by one.
const LOOSE_TOLERANCE: f64 = 0.07;

/// The same on the way, where another step follows.
const ROUGH_TOLERANCE: f64 = 0.7;

/// Bounds of the tolerance: what rounding allows, and what keeps a flight a flight.
const TOLERANCES: (f64, f64) = (1e-10, 1e-3);

fn tolerance(setting: &Setting, part: f64) -> f64 {
    (setting.floor * part).clamp(TOLERANCES.0, TOLERANCES.1)
}

/// Which unknowns a residual is differentiated by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    /// The flight's own.
    Own,
    /// And the shared ones.
    All,
}

/// How residuals count.
#[derive(Clone, Copy, Debug)]
pub enum Loss<'a> {
    /// By Huber's loss over this scale (m): by their squares near 0, by their sizes beyond.
    Huber(f64),
    /// By their innovations over the noise's, outliers left out.
    Whitened(&'a Noise),
}

/// Flies the first samples of a track and sums its residuals.
///
/// # Errors
/// In words, where the flight is impossible.
pub fn linearise(
    setting: &Setting,
    track: &Track,
    (shared, own): (&DVector<f64>, &DVector<f64>),
    samples: usize,
    by: By,
    loss: Loss<'_>,
) -> Result<Block, String> {
    let conditions = setting.body.with(track.parameters(setting, shared));
    let constants: Vec<usize> = match by {
        By::Own => Vec::new(),
        By::All => setting.shared.iter().map(|shared| shared.place).collect(),
    };
    let motion = conditions.linear_motion();
    let columns = Columns::new(track, motion.state_pattern(), constants.len());
    // Only how many columns there are counts here; they are filled along the chart.
    let moving: Vec<usize> = (0..columns.moving).collect();
    let mut variations = Sensitivities::new(motion, &moving, &constants);
    let part = match loss {
        Loss::Huber(_) => ROUGH_TOLERANCE,
        Loss::Whitened(_) => TOLERANCE,
    };
    let tangent = columns.tangent(&track.chart.tangent(own.as_slice()));
    let start = variations.start_along(own.as_slice(), &tangent);
    let flown = flown(
        &mut variations,
        start,
        &track.times[..samples],
        tolerance(setting, part),
    )?;
    let mut observer = conditions.observer();
    let mut sums = Sums::new(columns.rows(), track.markers, loss);
    for (sample, both) in flown.chunks(variations.len()).enumerate() {
        let time = track.times[sample];
        let state = variations.state(both);
        for (marker, position) in setting.markers.iter().enumerate() {
            // Where the noise is known an outlier is left out; before, it counts for little.
            let seen = match loss {
                Loss::Huber(_) => track.row(sample)[marker],
                Loss::Whitened(_) => track.good(sample, marker),
            };
            let Some(seen) = seen else { continue };
            let (y, derivatives) = observer.linearise(time, state, position);
            let row_of = |state: usize| variations.padded_row(both, state);
            sums.derive(&derivatives, row_of, &constants, &columns);
            let residual = [0, 1, 2].map(|axis| y[axis] - seen[axis]);
            sums.add(marker, time, residual);
        }
    }
    Ok(sums.rows.block())
}

/// The state at each of the first samples of a track, sample after sample.
///
/// # Errors
/// In words, where the flight is impossible.
pub fn states(
    setting: &Setting,
    track: &Track,
    (shared, own): (&DVector<f64>, &DVector<f64>),
    samples: usize,
) -> Result<Vec<f64>, String> {
    let conditions = setting.body.with(track.parameters(setting, shared));
    let start: States = own.as_slice().into();
    flown(
        &mut conditions.motion(),
        start,
        &track.times[..samples],
        tolerance(setting, LOOSE_TOLERANCE),
    )
}

/// Predicted less measured, by marker and sample, m; `None` where nothing was seen. Outliers are among them.
pub type Residuals = Vec<Vec<Option<[f64; 3]>>>;

/// The residuals at the first samples of a track.
///
/// # Errors
/// In words, where the flight is impossible.
pub fn residuals(
    setting: &Setting,
    track: &Track,
    unknowns: (&DVector<f64>, &DVector<f64>),
    samples: usize,
) -> Result<Residuals, String> {
    let flown = states(setting, track, unknowns, samples)?;
    Ok(residuals_of(setting, track, unknowns.0, &flown))
}

/// The residuals at states that were flown, sample after sample.
pub fn residuals_of(
    setting: &Setting,
    track: &Track,
    shared: &DVector<f64>,
    flown: &[f64],
) -> Residuals {
    let conditions = setting.body.with(track.parameters(setting, shared));
    let mut observer = conditions.observer();
    let states = track.chart.states();
    let mut residuals = vec![Vec::with_capacity(flown.len() / states); track.markers];
    for (sample, state) in flown.chunks(states).enumerate() {
        for (marker, position) in setting.markers.iter().enumerate() {
            let residual = track.row(sample)[marker].map(|seen| {
                let y = observer.position(track.times[sample], state, position);
                [0, 1, 2].map(|axis| y[axis] - seen[axis])
            });
            residuals[marker].push(residual);
        }
    }
    residuals
}

/// Flies from the first of the times to the last, and gives the state at each.
fn flown<D: Dynamics<State = States>>(
    dynamics: &mut D,
    start: States,
    times: &[f64],
    tolerance: f64,
) -> Result<Vec<f64>, String> {
    let mut samples = vec![0.0; start.len() * times.len()];
    let options = Options {
        method: Method::Tsit5,
        ..Options::tolerance(tolerance)
    };
    let from = (times[0], &start);
    fly_landing(dynamics, from, times, &options, &mut samples)
        .map_err(|error| error.to_string())?;
    Ok(samples)
}

/// Where the derivatives by each unknown stand in a row. A state that no rate depends on keeps its derivative of 1, and
/// need not be flown: its column stands behind those that are.
struct Columns {
    /// Directions of the chart that are flown, which come first; the shared unknowns follow.
    moving: usize,
    /// Place of each direction.
    own: Vec<usize>,
    /// Direction and state of those that are not flown.
    still: Vec<(usize, usize)>,
    shared: usize,
}

impl Columns {
    fn new(track: &Track, pattern: &[(usize, usize)], shared: usize) -> Self {
        let dimension = track.chart.dimension();
        let still: Vec<(usize, usize)> = (0..dimension)
            .filter_map(|direction| Some((direction, track.chart.plain(direction)?)))
            .filter(|(_, state)| pattern.iter().all(|(_, column)| column != state))
            .collect();
        let moving = dimension - still.len();
        let (mut next, mut behind) = (0, moving + shared);
        let own = (0..dimension).map(|direction| {
            let place = if still.iter().any(|(d, _)| *d == direction) {
                &mut behind
            } else {
                &mut next
            };
            *place += 1;
            *place - 1
        });
        Self {
            moving,
            own: own.collect(),
            still,
            shared,
        }
    }

    fn rows(&self) -> Rows {
        let shared = self.moving..self.moving + self.shared;
        Rows::new(self.own.clone(), shared.collect())
    }

    /// The entries of the chart's tangent in the columns that are flown.
    fn tangent(&self, entries: &[(usize, usize, f64)]) -> Vec<(usize, usize, f64)> {
        let placed = entries
            .iter()
            .map(|&(state, direction, value)| (state, self.own[direction], value));
        placed
            .filter(|(_, place, _)| *place < self.moving)
            .collect()
    }
}

/// Rows being summed, with the last row of each marker.
struct Sums<'a> {
    rows: Rows,
    loss: Loss<'a>,
    /// The rows of x, y and z of one marker.
    now: [Vec<f64>; 3],
    /// Time and rows of the last time that each marker was seen.
    before: Vec<Option<(f64, [Vec<f64>; 3])>>,
}

impl<'a> Sums<'a> {
    fn new(rows: Rows, markers: usize, loss: Loss<'a>) -> Self {
        let width = rows.width();
        Self {
            rows,
            loss,
            now: [0; 3].map(|_| vec![0.0; width]),
            before: vec![None; markers],
        }
    }

    /// Puts the derivatives of a marker's position by the unknowns into the rows of its axes.
    fn derive<'s>(
        &mut self,
        derivatives: &Derivatives<'_>,
        row_of: impl Fn(usize) -> &'s [f64],
        constants: &[usize],
        columns: &Columns,
    ) {
        let flown = columns.moving + columns.shared;
        for row in &mut self.now {
            row.fill(0.0);
        }
        let entries = derivatives.by_state_at.iter().zip(derivatives.by_state);
        for (&(axis, state), &value) in entries {
            let row = &mut self.now[axis];
            for (sum, part) in row[..flown].iter_mut().zip(row_of(state)) {
                *sum += value * part;
            }
            if let Some((direction, _)) = columns.still.iter().find(|(_, s)| *s == state) {
                row[columns.own[*direction]] += value;
            }
        }
        let entries = derivatives
            .by_parameter_at
            .iter()
            .zip(derivatives.by_parameter);
        for (&(axis, place), &value) in entries {
            if let Some(column) = constants.iter().position(|constant| *constant == place) {
                self.now[axis][columns.moving + column] += value;
            }
        }
    }

    fn add(&mut self, marker: usize, time: f64, residual: [f64; 3]) {
        let at = self.rows.residual();
        for (row, residual) in self.now.iter_mut().zip(residual) {
            row[at] = residual;
        }
        match self.loss {
            Loss::Huber(scale) => {
                // An outlier is one of a point, not of an axis.
                let size = residual.iter().map(|r| r * r).sum::<f64>().sqrt() / scale;
                let limit = HUBER * 3.0_f64.sqrt();
                let weight = if size > limit { limit / size } else { 1.0 };
                // What the loss has beyond the weighted square.
                let extra = (weight * size * size - limit * limit).max(0.0);
                for (axis, row) in self.now.iter().enumerate() {
                    let extra = if axis == 0 { extra } else { 0.0 };
                    self.rows.add(row, None, weight.sqrt() / scale, extra);
                }
            }
            Loss::Whitened(noise) => {
                for (axis, row) in self.now.iter().enumerate() {
                    match &self.before[marker] {
                        Some((earlier, before)) => {
                            let (kept, fresh) = noise.innovation(axis, time - earlier);
                            let before = Some((kept, before[axis].as_slice()));
                            self.rows.add(row, before, 1.0 / fresh, 0.0);
                        }
                        None => self.rows.add(row, None, 1.0 / noise.sigma[axis], 0.0),
                    }
                }
                match &mut self.before[marker] {
                    Some((earlier, before)) => {
                        *earlier = time;
                        for (before, now) in before.iter_mut().zip(&self.now) {
                            before.copy_from_slice(now);
                        }
                    }
                    none => *none = Some((time, self.now.clone())),
                }
            }
        }
    }
}
