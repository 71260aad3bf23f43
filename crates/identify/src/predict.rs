//! What a model predicts of a flight's markers, with exact sensitivities to its unknowns.
//!
//! The sensitivities obey the variational equations dS/dt = J S + [0 | Jp], flown together with the state.

mod columns;
mod sums;

use flight::body::States;
use flight::sensitivity::{Linearised, Sensitivities};
use flight::{Dynamics, Method, Options, fly_landing};
use nalgebra::DVector;

use self::columns::Columns;
use self::sums::Sums;
use crate::noise::Noise;
use crate::normal::Block;
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
