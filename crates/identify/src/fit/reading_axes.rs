//! Axes and times of instruments beside positions, compared with the motion of the fit: readings with exchanged axes follow
//! it only where they are exchanged back, and delayed ones where they are shifted back.

use model_spec::compose::Instrument;
use nalgebra::{Matrix3, Vector3};

use super::residual_cache::ResidualCache;
use super::state::State;
use crate::channel::ChannelKind;
use dataset::levels::{AS_GOOD, MAX_DELAY, is_clear};
use dataset::pose::nearest_rotation;
use dataset::screening::SignedAxes;
use dataset::statistics::median_of;

/// Predicted and measured readings of one flight, less their means, as instruments have offsets, and the time between them, s.
type Readings = (Vec<[Vector3<f64>; 2]>, f64);

/// Sentences on instruments whose readings follow the motion of the fit clearly better along other axes or at other times;
/// none without positions, where the fit turns the body as the readings ask.
pub fn exchanged(state: &State<'_>, cache: &ResidualCache) -> Vec<String> {
    let problem = state.problem;
    if !problem.sees_positions() {
        return Vec::new();
    }
    let channels = problem.channels.iter().enumerate();
    let each = channels.filter_map(|(channel, own)| {
        let ChannelKind::Instrument(place) = own.kind else {
            return None;
        };
        let key = match problem.instruments[place].0 {
            Instrument::Gyroscope => "gyroscope_axes",
            Instrument::Accelerometer => "accelerometer_axes",
            Instrument::Speed => return None,
        };
        let flights = readings(state, cache, channel);
        let (turn, if_turned) = best_turn(&flights);
        let clearly = AS_GOOD * if_turned;
        // An oblique mounting, and a delay, turn what rotates with the body, too.
        let axes = better_axes(&flights)
            .filter(|(axes, left)| *left < clearly || *axes == SignedAxes::nearest(&turn));
        if let Some((delay, left)) = delay(&flights)
            && axes.is_none_or(|(_, other)| left < other)
            && left < clearly
        {
            return Some(format!(
                "{} follows the motion of the body only if it is about {:.3} s {}: correct its times",
                own.name,
                delay.abs(),
                if delay > 0.0 { "late" } else { "early" },
            ));
        }
        let (axes, _) = axes?;
        Some(format!(
            "{} follows the motion of the body only with the axes {axes} for x, y, z: state `{key} = {}` in [recording], or turn the readings",
            own.name,
            axes.toml()
        ))
    });
    each.collect()
}

fn readings(state: &State<'_>, cache: &ResidualCache, channel: usize) -> Vec<Readings> {
    let scale = state.problem.channels[channel].scale;
    let of_flight = |(place, flight): (usize, &crate::observations::Observations)| {
        let path = cache.path(&state.flights, place).ok()?;
        let samples = path.residuals[channel].iter().enumerate();
        let pairs = samples.filter_map(|(sample, residual)| {
            let measured = Vector3::from(flight.inlier(sample, channel)?);
            let predicted = measured + Vector3::from((*residual)?) / scale;
            Some((flight.times[sample], [predicted, measured]))
        });
        let (times, mut pairs): (Vec<f64>, Vec<[Vector3<f64>; 2]>) = pairs.unzip();
        let sums = pairs
            .iter()
            .fold([Vector3::zeros(); 2], |[a, b], [c, d]| [a + c, b + d]);
        let means = sums.map(|sum| sum / pairs.len().max(1) as f64);
        for pair in &mut pairs {
            *pair = [pair[0] - means[0], pair[1] - means[1]];
        }
        let intervals = times.windows(2).map(|pair| pair[1] - pair[0]);
        Some((pairs, median_of(intervals)?))
    };
    state
        .flights
        .iter()
        .enumerate()
        .filter_map(of_flight)
        .collect()
}

/// Axes with which the readings are clearly nearer to the prediction, along the axes that they change, and the mean square
/// that they leave.
fn better_axes(flights: &[Readings]) -> Option<(SignedAxes, f64)> {
    let [own, others @ ..] = &SignedAxes::all()[..] else {
        return None;
    };
    let squares = |axes: &SignedAxes| {
        let each = flights.iter().flat_map(|own| &own.0);
        let each = each.map(|[predicted, measured]| {
            let off = axes.turned(*measured) - predicted;
            off.component_mul(&off)
        });
        each.sum::<Vector3<f64>>()
    };
    let as_they_are = squares(own);
    let better = others.iter().map(|axes| (axes, squares(axes)));
    let (axes, found) = better.min_by(|(_, a), (_, b)| a.sum().total_cmp(&b.sum()))?;
    let changed = (0..3).filter(|axis| axes.along(*axis) != own.along(*axis));
    let sum = |squares: &Vector3<f64>| changed.clone().map(|axis| squares[axis]).sum::<f64>();
    let count = flights.iter().map(|own| own.0.len()).sum::<usize>();
    let of_changed = count * changed.clone().count();
    is_clear(sum(&as_they_are) / sum(&found), of_changed as f64)
        .then_some((*axes, found.sum() / count as f64))
}

/// The rotation that brings the readings nearest to the prediction, and the mean square that it leaves.
fn best_turn(flights: &[Readings]) -> (Matrix3<f64>, f64) {
    let pairs = || flights.iter().flat_map(|own| &own.0);
    let products = pairs().map(|[predicted, measured]| predicted * measured.transpose());
    let sizes = pairs().flatten().map(Vector3::norm_squared);
    let turn = nearest_rotation(&products.sum(), sizes.sum::<f64>() / 2.0);
    let turn = turn.unwrap_or_default().to_rotation_matrix().into_inner();
    let squares = pairs().map(|[predicted, measured]| (turn * measured - predicted).norm_squared());
    let sum: f64 = squares.sum();
    (turn, sum / pairs().count() as f64)
}

/// Delay of the readings, s, with which they are clearly nearer to the prediction, and the mean square that it leaves.
fn delay(flights: &[Readings]) -> Option<(f64, f64)> {
    let mean_square = |shift: isize| {
        let [late, early] = [shift.max(0), (-shift).max(0)].map(isize::unsigned_abs);
        let pairs = flights.iter().flat_map(|(pairs, _)| {
            let measured = pairs.iter().skip(late).map(|pair| pair[1]);
            let predicted = pairs.iter().skip(early).map(|pair| pair[0]);
            measured.zip(predicted)
        });
        let squares = pairs.map(|(measured, predicted)| (measured - predicted).norm_squared());
        let (count, sum) = squares.fold((0.0, 0.0), |(count, sum), own| (count + 1.0, sum + own));
        (sum / count, count)
    };
    let furthest = MAX_DELAY as isize;
    let shifts = (-furthest..=furthest).filter(|shift| *shift != 0);
    let shifts = shifts.map(|shift| (shift, mean_square(shift)));
    let (shift, (left, count)) = shifts.min_by(|a, b| a.1.0.total_cmp(&b.1.0))?;
    let interval = median_of(flights.iter().map(|own| own.1))?;
    is_clear(mean_square(0).0 / left, 3.0 * count).then_some((shift as f64 * interval, left))
}
