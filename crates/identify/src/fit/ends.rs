//! Samples at the beginning and the end of a flight that do not belong to its free motion: of the hand that still holds
//! the body, of the net or the ground that already stops it. A late cut leaves too few of them to be seen without the
//! model. A run at an end is tested by the likelihood ratio with and without it; misfit of a wrong model grows smoothly
//! towards an end, so that the run next to it deviates, too.

use flight::parallel;
use nalgebra::DVector;

use super::FitError;
use super::reweighting::{Reweighted, reweight};
use super::state::State;
use crate::least_squares::{NormalBlock, ScaledCholesky};
use crate::noise::NoiseModel;
use crate::observations::Observations;
use crate::predict::FlightAt;
use dataset::levels::AT_NOISE;

/// Maximum number of samples of a run at an end of a flight; the cuts of an import are within as many.
const MAX_RUN: usize = 6;
/// Minimum number of samples of a flight, in units of [`MAX_RUN`], for its ends to be tested: most of it must be left.
const MIN_RUNS: usize = 5;
/// Minimum normal score at which a run deviates, and ratio of its excess, its mean square less the 1 of noise, to that of
/// the run next to it. Noise exceeds the score once in 300,000 runs, of which a flight has twelve.
const DEVIATING: (f64, f64) = (4.5, 3.0);

/// Maximum number of times that ends are left out and the flights are fitted again.
const MAX_PASSES: usize = 2;

/// End of the note of a flight whose first samples are left out.
const HELD: &str = "samples are left out: they deviate from the motion after them, as of a body that is still held, or where \
                    the model lacks something";

/// Numbers of samples to be left out at the beginning and at the end of a flight.
#[derive(Clone, Copy, Default)]
struct Runs {
    first: usize,
    last: usize,
}

/// Leaves out the runs at the ends of the flights that deviate from the fitted motion, and fits all flights again.
pub fn leave_out_ends(
    state: &mut State<'_>,
    mut reweighted: Reweighted,
) -> Result<Reweighted, FitError> {
    let options = state.options;
    if !state.problem.sees_positions() {
        return Ok(reweighted);
    }
    for _ in 0..MAX_PASSES {
        let noise = reweighted.noise.overall();
        if options.is_past_deadline() {
            break;
        }
        let iterate = &reweighted.solution.iterate;
        let found = parallel::each_on(options.threads(), state.flights.len(), |flight| {
            let unknowns = (&iterate.global, &iterate.local[flight]);
            let at = FlightAt::new(state.problem, &state.flights[flight], unknowns);
            deviating_runs(at, &reweighted.noise).unwrap_or_default()
        });
        if found.iter().all(|runs| runs.first + runs.last == 0) {
            break;
        }
        let with_ends = state.clone();
        for (observations, runs) in state.flights.iter_mut().zip(found) {
            leave_out(observations, runs);
        }
        let residuals = state.flown_residuals()?;
        let without = reweight(state, residuals, None)?;
        // Fewer samples leave more only if the fit of a wrong model ends elsewhere.
        if without.noise.overall() > AT_NOISE * noise {
            *state = with_ends;
            break;
        }
        reweighted = without;
    }
    Ok(reweighted)
}

fn leave_out(observations: &mut Observations, runs: Runs) {
    if runs.first > 0 {
        observations.forget_first(runs.first);
        // A later pass leaves out more samples, and counts those of the earlier one.
        observations.notes.retain(|note| !note.ends_with(HELD));
        let note = format!("its first {} {HELD}", runs.first);
        observations.notes.push(note);
    }
    if runs.last > 0 {
        observations.truncate(
            observations.times.len() - runs.last,
            "the samples after it deviate from the motion before them, as when something stops the body, or where the model \
             lacks something"
                .into(),
        );
    }
}

/// Runs at both ends of a flight that deviate from its motion; `None` if its samples do not determine this motion.
fn deviating_runs(at: FlightAt<'_>, noise: &NoiseModel) -> Option<Runs> {
    if at.samples < MIN_RUNS * MAX_RUN {
        return None;
    }
    let mut samples = by_sample(at, noise)?;
    let last = deviating_run(&samples)?;
    samples.truncate(samples.len() - last);
    samples.reverse();
    let first = deviating_run(&samples)?;
    Some(Runs { first, last })
}

/// Time, residual and its derivatives at the last value of a channel.
type Previous = (f64, [f64; 3], [DVector<f64>; 3]);

/// Normal equations of the initial state for each sample of a flight, with whitened residuals.
fn by_sample(at: FlightAt<'_>, noise: &NoiseModel) -> Option<Vec<NormalBlock>> {
    let (problem, observations) = (at.problem, at.observations);
    let zero = NormalBlock::zero(observations.manifold.dimension(), 0);
    let mut blocks = vec![zero; observations.times.len()];
    let mut previous: Vec<Option<Previous>> = vec![None; problem.channels.len()];
    let none = DVector::zeros(0);
    let done = at.each_residual(&[], &mut |point| {
        let channel = &problem.channels[point.channel];
        if observations.is_outlier(point.sample, point.channel) || channel.shows_rounding(noise) {
            return;
        }
        let (time, noise) = (observations.times[point.sample], noise.of(point.channel));
        let rows = point.rows.each_ref();
        let rows = rows.map(|row| DVector::from_column_slice(row));
        let before = previous[point.channel].as_ref();
        for axis in 0..channel.components {
            let (mut residual, mut row) = (point.residual[axis], rows[axis].clone());
            let gap = before.map(|(earlier, ..)| time - earlier);
            let (kept, sigma) = noise.innovation(axis, gap);
            if let Some((_, residuals, rows)) = before {
                residual -= kept * residuals[axis];
                row.axpy(-kept, &rows[axis], 1.0);
            }
            blocks[point.sample].add(residual / sigma, &(row / sigma), &none);
        }
        previous[point.channel] = Some((time, point.residual, rows));
    });
    done.ok()?;
    Some(blocks)
}

/// Number of the last samples that deviate from the motion in the other ones; `None` if these do not determine it.
fn deviating_run(samples: &[NormalBlock]) -> Option<usize> {
    let mut sum = samples[0].clone();
    let kept = samples.len() - 2 * MAX_RUN;
    samples[1..kept].iter().for_each(|block| sum.join(block));
    let mut without = vec![deviance(&sum)?];
    for block in &samples[kept..] {
        sum.join(block);
        without.push(deviance(&sum)?);
    }
    // Entry `run` is without the last `run` samples.
    without.reverse();
    let mean_square = |from: usize, to: usize, scale: f64| {
        let (more, less) = (without[from], without[to]);
        let count = more.1 - less.1;
        (count > 0).then(|| ((more.0 - less.0) / (scale * count as f64), count))
    };
    let scored = (1..=MAX_RUN).filter_map(|run| {
        let (rest, count) = without[run];
        let scale = (rest / count.checked_sub(sum.local.nrows())? as f64).max(1.0);
        let (own, count) = mean_square(0, run, scale)?;
        let beside = mean_square(run, 2 * run, scale).map_or(1.0, |(beside, _)| beside);
        let score = normal_score(own, count);
        let deviates = score > DEVIATING.0 && own - 1.0 > DEVIATING.1 * (beside - 1.0);
        deviates.then_some((run, score))
    });
    let best = scored.max_by(|a, b| a.1.total_cmp(&b.1));
    Some(best.map_or(0, |(run, _)| run))
}

/// Sum of the squared residuals at the best initial state, and their number; `None` if they do not determine it.
fn deviance(block: &NormalBlock) -> Option<(f64, usize)> {
    let factor = ScaledCholesky::independent(&block.local, 0.0)?;
    let explained = block
        .local_gradient
        .dot(&factor.solve(&block.local_gradient));
    Some((block.squares - explained, block.count))
}

/// Normal score of the mean of `count` squared residuals, by Wilson and Hilferty's cube root.
fn normal_score(mean_square: f64, count: usize) -> f64 {
    let variance = 2.0 / (9.0 * count as f64);
    (mean_square.max(0.0).cbrt() - (1.0 - variance)) / variance.sqrt()
}

#[cfg(test)]
mod tests {
    use crate::fit::fit;
    use crate::fit::tests::{pushed, simulated};
    use crate::options::FitOptions;
    use dataset::Flight;
    use dataset::synthesize::Plan;
    use nalgebra::Vector3;

    /// Numbers of samples left out at the beginning and the end of each of six flights of a disc, after `change` of the
    /// first of them.
    fn left_out(change: impl Fn(&mut Flight)) -> Vec<[usize; 2]> {
        let model = model_spec::load::load("disc", &[]).unwrap();
        let plan = Plan {
            flights: 6,
            duration: Some(0.5),
            ..Plan::default()
        };
        let mut dataset = simulated(&model, "backhand", &plan);
        change(&mut dataset.flights[0]);
        let fitted = fit(&model, &dataset, &FitOptions::default()).unwrap();
        let flights = fitted.flights.iter().flatten();
        let each = flights.zip(&dataset.flights).map(|(fitted, flight)| {
            let observations = &fitted.observations;
            let seen = |sample: usize| {
                (0..observations.channels)
                    .any(|channel| observations.value(sample, channel).is_some())
            };
            let first = (0..observations.times.len())
                .find(|sample| seen(*sample))
                .unwrap();
            [first, flight.times.len() - observations.times.len()]
        });
        each.collect()
    }

    #[test]
    fn a_late_cut_is_found_at_both_ends_and_in_its_flight_only() {
        assert_eq!(left_out(|_| {}), [[0, 0]; 6]);
        let stopped = |flight: &mut Flight| {
            let last = flight.times.len() - 4;
            *flight = pushed(flight, last as f64 + 0.5, Vector3::new(-1.0, 0.3, 0.4));
        };
        let found = left_out(stopped);
        assert!(found[0] == [0, 3] || found[0] == [0, 4], "{found:?}");
        assert_eq!(found[1..], [[0, 0]; 5]);
        let held = |flight: &mut Flight| {
            let first = flight.times[3];
            for (time, row) in flight.times.iter().zip(&mut flight.positions) {
                for point in row.iter_mut().flatten() {
                    point[0] += 0.8 * (first - time).max(0.0);
                }
            }
        };
        let found = left_out(held);
        assert_eq!(found[0], [3, 0], "{found:?}");
        assert_eq!(found[1..], [[0, 0]; 5]);
    }
}
