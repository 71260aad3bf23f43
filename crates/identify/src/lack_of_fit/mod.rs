//! Lack-of-fit test: whether the residuals of a fit are pure noise. Noise is estimated from short time scales, which no
//! smooth motion can follow. If the model is right, splines reduce the sum of squares by no more than expected for this
//! noise.

mod banded;
mod input_noise;
mod missing_terms;
mod noise_floor;
mod series;
mod smooth_misfit;

use std::time::Instant;

use flight::parallel;
use model_spec::sort_by_number;

use self::missing_terms::{MAX_COMPARED, Source, compared};
use self::noise_floor::{FlightSeries, NoiseFloor};
use self::series::{Series, SplineBasis};
use self::smooth_misfit::{FlightMisfit, ScaledStatistic, greatest_misfit, least_p};
use crate::channel::{Channel, ChannelKind};
use crate::error::FitError;
use crate::fit::{Fit, flight_error};
use crate::ids::FlightId;
use crate::observations::Observations;
use crate::problem::RESIDUAL_TOLERANCE;
use crate::report::{
    FlightEvidence, InputNoise, LACK_OF_FIT_LEVEL, LackOfFit, MissingTerm, SmoothMisfit,
};
use dataset::Role;
use dataset::statistics::median_of;

/// Numbers of knot intervals over a flight of the splines that follow slow deviations, and at least of those that follow
/// fast ones.
const INTERVALS: (f64, f64) = (5.0, 12.0);

/// Number of knots per period of the fastest predicted motion of the markers.
const KNOTS_PER_PERIOD: f64 = 4.0;

/// Minimum knot interval, in samples; faster changes are noise.
const MIN_SAMPLES_PER_KNOT: f64 = 3.0;

/// Maximum number of flights whose largest smooth deviation is listed in the result of the lack-of-fit test.
const MAX_DESCRIBED: usize = 6;

impl Fit {
    /// Tests the residuals for lack of fit and, if they pass as noise, whether a coefficient or an equation of motion lacks a
    /// term; decides again whether the fit is reliable.
    ///
    /// # Errors
    /// [`FitError::Flight`] if a trajectory cannot be integrated.
    pub fn with_lack_of_fit(mut self, threads: usize) -> Result<Fit, FitError> {
        let clock = Instant::now();
        self.report.lack_of_fit = LackOfFit::with_missing_term(&self, threads)?;
        self.report.assess();
        let elapsed = clock.elapsed().as_secs_f64();
        let seconds = &mut self.report.seconds;
        seconds.insert("lack_of_fit".to_owned(), elapsed);
        *seconds.entry("total".to_owned()).or_default() += elapsed;
        Ok(self)
    }
}

impl LackOfFit {
    /// Tests the residuals of the fitted flights; `None` if they are too few to separate noise from smooth motion.
    ///
    /// # Errors
    /// [`FitError::Flight`] if a trajectory cannot be integrated.
    pub fn of_fit(fit: &Fit, threads: usize) -> Result<Option<Self>, FitError> {
        Self::of_flights(fit, &FittedFlight::all(fit, threads), threads)
    }

    /// [`of_fit`](Self::of_fit), with the tests of missing terms if the residuals pass as noise.
    ///
    /// # Errors
    /// [`FitError::Flight`] if a trajectory cannot be integrated.
    pub fn with_missing_term(fit: &Fit, threads: usize) -> Result<Option<Self>, FitError> {
        let flights = FittedFlight::all(fit, threads);
        let mut found = Self::of_flights(fit, &flights, threads)?;
        if let Some(found) = &mut found
            && !found.fails(LACK_OF_FIT_LEVEL)
        {
            found.missing_term = MissingTerm::of_fit(fit, &flights, threads)?;
        }
        Ok(found)
    }

    fn of_flights<'f>(
        fit: &Fit,
        flights: &'f [FittedFlight<'_>],
        threads: usize,
    ) -> Result<Option<Self>, FitError> {
        let intervals = flights.iter().filter_map(|f| f.observed.interval());
        let Some(interval) = median_of(intervals) else {
            return Ok(None);
        };
        let of_flight = |flight: &'f FittedFlight<'_>| Some((flight, flight.residuals.as_ref()?));
        let (kept, series): (Vec<&FittedFlight<'_>>, Vec<&FlightSeries>) =
            flights.iter().filter_map(of_flight).unzip();
        let channels = &fit.problem().channels;
        let Some(floor) = NoiseFloor::estimate(&series, channels, interval, threads) else {
            return Ok(None);
        };
        // Smaller noise cannot be told from 0.
        let sigma0 = RESIDUAL_TOLERANCE * fit.problem().sigma0;
        let least_ratio = sigma0 / floor.noise.overall();
        let misfits = parallel::each_on(threads, kept.len(), |index| {
            let with = kept[index].with_derivatives(fit, series[index])?;
            let slow = kept[index].slow();
            Ok(FlightMisfit::new(&with, &slow, &floor.noise, least_ratio))
        });
        let misfits: Vec<Option<FlightMisfit>> = misfits.into_iter().collect::<Result<_, _>>()?;
        let misfits = (misfits.as_slice(), channels.as_slice());
        let mut found = Self::of_misfits((&kept, &series), misfits, &floor);
        if found.fails(LACK_OF_FIT_LEVEL) {
            found.input_noise = InputNoise::of_fit(fit, &kept, &floor.noise);
        }
        Ok(Some(found))
    }

    fn of_misfits(
        (flights, series): (&[&FittedFlight<'_>], &[&FlightSeries]),
        (misfits, channels): (&[Option<FlightMisfit>], &[Channel]),
        floor: &NoiseFloor,
    ) -> Self {
        let error = floor.relative_error();
        let (mut slow, mut fine) = (ScaledStatistic::default(), ScaledStatistic::default());
        let mut p_values: Vec<(usize, f64)> = Vec::new();
        for (index, misfit) in misfits.iter().enumerate() {
            let Some(misfit) = misfit else { continue };
            slow.add(&misfit.slow);
            fine.add(&misfit.fine);
            p_values.push((index, misfit.p_value(error)));
        }
        let count = p_values.len() as f64;
        sort_by_number(&mut p_values, |p_value| p_value.1);
        let least = p_values.first().map_or(1.0, |(_, p)| count * p);
        let p_value = (2.0 * least_p(slow, fine, error).min(least)).min(1.0);
        let largest_misfits =
            p_values
                .iter()
                .take(MAX_DESCRIBED)
                .filter_map(|&(index, p_value)| {
                    let flight = &flights[index];
                    let basis = flight.slow();
                    let found = greatest_misfit(series[index], &basis, &floor.noise, channels)?;
                    Some(SmoothMisfit {
                        file: flight.observed.file.clone(),
                        p_value,
                        ..found
                    })
                });
        let largest_misfits = largest_misfits.collect();
        let (mut squares, mut by_noise, mut points) = (0.0, 0.0, 0.0);
        for flight in series {
            for (channel, axes) in flight.series.iter().enumerate() {
                for (series, sigma) in axes.iter().zip(floor.noise.of(channel).sigma) {
                    let count = series.sides.len() as f64;
                    squares += series.sides.iter().map(|r| r * r).sum::<f64>();
                    by_noise += count * sigma * sigma;
                    points += count;
                }
            }
        }
        let noise_m = (by_noise / f64::max(points, 1.0)).sqrt();
        let beyond = (squares - by_noise) / f64::max(points, 1.0);
        Self {
            p_value,
            flights: p_values
                .iter()
                .map(|&(index, p)| (flights[index].observed.file.clone(), p))
                .collect(),
            largest_misfits,
            noise_m,
            beyond_noise_m: beyond.max(0.0).sqrt(),
            excess_chi2: (slow.value - slow.degrees_of_freedom)
                .max(fine.value - fine.degrees_of_freedom)
                .max(0.0),
            has_length: channels.iter().all(Channel::is_position),
            noise: floor.noise.clone(),
            missing_term: None,
            input_noise: None,
        }
    }
}

/// A track that was used in the fit.
struct FittedFlight<'f> {
    observed: &'f Observations,
    id: FlightId,
    /// Residuals of the inliers, with the basis that follows fast misfits; `None` if there are none to test.
    residuals: Option<FlightSeries>,
    /// Values of what a missing term may follow; of many flights, at some of their samples.
    compared: Vec<Vec<f64>>,
}

impl<'f> FittedFlight<'f> {
    /// The tracks of a fit that have the role `fit` and were not excluded.
    fn all(fit: &'f Fit, threads: usize) -> Vec<Self> {
        let all = (0..fit.report.flights.len()).map(FlightId::new);
        let fitted = all.filter_map(|id| {
            let (observed, _) = fit.flight(id)?;
            let is_track = observed.role == Role::Fit && !observed.is_summary;
            is_track.then_some((observed, id))
        });
        let fitted: Vec<_> = fitted.collect();
        let samples = fitted.iter().map(|(observed, _)| observed.times.len());
        let every = samples.sum::<usize>().div_ceil(MAX_COMPARED).max(1);
        let sources = Source::all(fit.problem());
        let flights = parallel::each_on(threads, fitted.len(), |index| {
            let (observed, id) = fitted[index];
            let evidence = fit.evidence(id)?;
            Some(Self {
                observed,
                id,
                residuals: residuals(fit, observed, &evidence),
                compared: compared(&sources, &evidence, every),
            })
        });
        flights.into_iter().flatten().collect()
    }
}

impl FittedFlight<'_> {
    /// Basis that follows slow deviations, with fewer knots than [`INTERVALS`] for few samples.
    fn slow(&self) -> SplineBasis {
        let duration = duration(self.observed);
        let least = MIN_SAMPLES_PER_KNOT * self.observed.interval().unwrap_or(duration);
        SplineBasis::new((0.0, duration), (duration / INTERVALS.0).max(least))
    }

    /// Residuals of the inliers with their derivatives by the local parameters, and the basis of `from`.
    fn with_derivatives(&self, fit: &Fit, from: &FlightSeries) -> Result<FlightSeries, FitError> {
        let Some(at) = fit.at(self.id) else {
            return Ok(FlightSeries {
                series: Vec::new(),
                fine: from.fine,
            });
        };
        let (channels, observed) = (&at.problem.channels, at.observations);
        let count = 1 + observed.manifold.dimension();
        let mut series = empty_series(observed.channels, count);
        let done = at.each_residual(&[], &mut |point| {
            let channel = &channels[point.channel];
            let is_left_out = channel.shows_rounding(fit.noise());
            if is_left_out || observed.inlier(point.sample, point.channel).is_none() {
                return;
            }
            let axes = series[point.channel].iter_mut().zip(point.rows);
            for ((series, row), residual) in axes.zip(point.residual).take(channel.components) {
                series.times.push(observed.times[point.sample]);
                series.sides.push(residual);
                series.sides.extend_from_slice(row);
            }
        });
        done.map_err(|reason| flight_error(observed, reason))?;
        Ok(FlightSeries {
            series,
            fine: from.fine,
        })
    }
}

/// Time from the first to the last sample of a flight, s.
fn duration(observed: &Observations) -> f64 {
    observed.times.last().copied().unwrap_or(0.0)
}

/// Predicted positions `[sample][point]`, m, of the points of the pose, which turn with the body where a sensor
/// measures poses; `None` without such a sensor.
fn points_of_pose(
    fit: &Fit,
    observed: &Observations,
    evidence: &FlightEvidence,
) -> Option<Vec<Vec<[f64; 3]>>> {
    let problem = fit.problem();
    let mut channels = problem.channels.iter();
    channels.find(|own| own.kind == ChannelKind::Attitude)?;
    let bound = observed.bound(problem, fit.global());
    let mut observer = bound.observer();
    let samples = evidence.times.iter().zip(&evidence.states);
    let rows = samples.map(|(time, state)| {
        let points = problem.points.markers.iter();
        points
            .map(|point| observer.position(*time, state, point))
            .collect()
    });
    Some(rows.collect())
}

/// Residuals of the inliers of a flight, as in [`FittedFlight`].
fn residuals(
    fit: &Fit,
    observed: &Observations,
    evidence: &FlightEvidence,
) -> Option<FlightSeries> {
    let duration = duration(observed);
    let interval = observed.interval().filter(|interval| *interval > 0.0)?;
    let frequency = match points_of_pose(fit, observed, evidence) {
        Some(points) => frequency(&points, interval),
        None => frequency(&evidence.predicted, interval),
    };
    let wanted = (1.0 / (KNOTS_PER_PERIOD * frequency)).min(duration / INTERVALS.1);
    let knot_interval = wanted.max(MIN_SAMPLES_PER_KNOT * interval);
    let channels = &fit.problem().channels;
    let mut series = empty_series(channels.len(), 1);
    let is_rounding: Vec<bool> = channels
        .iter()
        .map(|own| own.shows_rounding(fit.noise()))
        .collect();
    for (sample, &time) in evidence.times.iter().enumerate() {
        let mut positions = 0..;
        let mut sensors = evidence.sensors.iter();
        for (index, (channel, axes)) in channels.iter().zip(&mut series).enumerate() {
            let residual = match channel.is_position() {
                true => positions
                    .next()
                    .and_then(|index| evidence.residual(sample, index)),
                false => sensors
                    .next()
                    .and_then(|own| own.residuals[sample].filter(|_| !own.outlier[sample])),
            };
            let Some(residual) = residual.filter(|_| !is_rounding[index]) else {
                continue;
            };
            for (series, residual) in axes.iter_mut().zip(residual).take(channel.components) {
                series.times.push(time);
                series.sides.push(-residual * channel.scale);
            }
        }
    }
    Some(FlightSeries {
        series,
        fine: SplineBasis::new((0.0, duration), knot_interval),
    })
}

fn empty_series(channels: usize, count: usize) -> Vec<[Series; 3]> {
    (0..channels)
        .map(|_| [0; 3].map(|_| Series::new(count)))
        .collect()
}

/// Characteristic frequency of the predicted marker motion, 1/s, by Rice's formula: rms jerk over the rms fluctuation
/// of the acceleration, over 2π. `predicted[sample][marker]` is in m; 0 if the acceleration does not change.
fn frequency(predicted: &[Vec<[f64; 3]>], interval: f64) -> f64 {
    let (mut of_jerk, mut of_acceleration) = (0.0, f64::MIN_POSITIVE);
    let markers = predicted.first().map_or(0, Vec::len);
    for marker in 0..markers {
        for axis in 0..3 {
            let second: Vec<f64> = predicted
                .windows(3)
                .map(|w| w[0][marker][axis] - 2.0 * w[1][marker][axis] + w[2][marker][axis])
                .collect();
            let mean = second.iter().sum::<f64>() / second.len().max(1) as f64;
            of_acceleration += second.iter().map(|a| (a - mean).powi(2)).sum::<f64>();
            of_jerk += second
                .windows(2)
                .map(|w| (w[1] - w[0]).powi(2))
                .sum::<f64>();
        }
    }
    (of_jerk / of_acceleration).sqrt() / (std::f64::consts::TAU * interval)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::options::FitOptions;
    use crate::unknowns::fit;
    use dataset::Dataset;

    /// Loads the first `flights` flights of the dataset `examples/mystery`.
    fn mystery(flights: usize) -> Dataset {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/mystery");
        let mut dataset = dataset::load(folder.as_ref()).unwrap();
        dataset.flights.truncate(flights);
        dataset
    }

    fn tested(effects: &[&str]) -> LackOfFit {
        let model = model_spec::load::load("disc", effects).unwrap();
        let fit = fit(&model, &mystery(6), &FitOptions::default()).unwrap();
        LackOfFit::of_fit(&fit, 1).unwrap().unwrap()
    }

    #[test]
    fn residuals_of_the_true_model_are_noise_and_those_of_another_are_not() {
        let found = tested(&["stall"]);
        assert!(found.p_value > 0.05, "{found:?}");
        // The dataset was made with noise of 1.5 mm.
        assert!((found.noise_m / 0.0015 - 1.0).abs() < 0.05, "{found:?}");
        assert!(found.beyond_noise_m < 0.0005, "{found:?}");
        let wrong = tested(&[]);
        assert!(wrong.p_value < 1e-6, "{wrong:?}");
        // The noise floor does not depend on the misfit of the model.
        assert!((wrong.noise_m / 0.0015 - 1.0).abs() < 0.05, "{wrong:?}");
        assert!(
            wrong.beyond_noise_m > 0.002 && wrong.excess_chi2 > 100.0,
            "{wrong:?}"
        );
        assert_eq!(wrong.flights.len(), 6);
        let first = &wrong.largest_misfits[0];
        let least = wrong.flights.values().copied().fold(1.0, f64::min);
        assert_eq!((wrong.flights[&first.file], first.p_value), (least, least));
        assert!(
            first.size_m.abs() > 0.002 && first.from_s < first.to_s,
            "{first:?}"
        );
    }

    #[test]
    fn the_frequency_of_a_turning_marker_is_that_of_its_turns() {
        let turn = |sample: usize| 50.0 * sample as f64 / 500.0;
        let samples = (0..400).map(|k| vec![[turn(k).cos(), turn(k).sin(), 3.0 * k as f64]]);
        let found = frequency(&samples.collect::<Vec<_>>(), 1.0 / 500.0);
        assert!(
            (found * std::f64::consts::TAU / 50.0 - 1.0).abs() < 0.02,
            "{found}"
        );
    }
}
