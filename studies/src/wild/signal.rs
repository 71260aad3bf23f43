//! What software does to recorded tracks before a user sees them: low-pass filters and interpolation.

use dataset::Flight;

/// Coordinates of one marker over the samples of a flight, one axis.
type Track = Vec<f64>;

/// Filters every coordinate of every marker by a Butterworth low-pass of second order with the cut-off frequency
/// `cutoff` (Hz), forwards and backwards, as laboratories do.
pub(super) fn low_pass(flight: &mut Flight, rate: f64, cutoff: f64) {
    each_track(flight, |track| {
        let once: Track = butterworth(track, rate, cutoff).into_iter().rev().collect();
        butterworth(&once, rate, cutoff).into_iter().rev().collect()
    });
}

/// Second-order Butterworth filter by the bilinear transformation, started at rest at the first value.
fn butterworth(track: &[f64], rate: f64, cutoff: f64) -> Track {
    let k = (std::f64::consts::PI * cutoff / rate).tan();
    let root = std::f64::consts::SQRT_2;
    let norm = 1.0 / (1.0 + root * k + k * k);
    let b = k * k * norm;
    let (a1, a2) = (2.0 * (k * k - 1.0) * norm, (1.0 - root * k + k * k) * norm);
    let first = track.first().copied().unwrap_or(0.0);
    let (mut x, mut y) = ([first; 2], [first; 2]);
    let each = track.iter().map(|&now| {
        let out = b * (now + 2.0 * x[0] + x[1]) - a1 * y[0] - a2 * y[1];
        (x, y) = ([now, x[0]], [out, y[0]]);
        out
    });
    each.collect()
}

/// Replaces the samples of a flight by `factor` times as many, interpolated linearly, or by cubic Hermite polynomials if
/// `is_cubic`.
pub(super) fn upsample(flight: &mut Flight, factor: usize, is_cubic: bool) {
    let between = |values: &[f64]| -> Track {
        let last = values.len() - 1;
        let slope = |k: usize| {
            let (from, to) = (k.saturating_sub(1), (k + 1).min(last));
            (values[to] - values[from]) / (to - from).max(1) as f64
        };
        let each = (0..=last * factor).map(|sample| {
            let (k, s) = (sample / factor, (sample % factor) as f64 / factor as f64);
            if k == last {
                return values[last];
            }
            let linear = values[k] + s * (values[k + 1] - values[k]);
            let step = values[k + 1] - values[k];
            let bend = s * (1.0 - s) * ((1.0 - s) * (slope(k) - step) - s * (slope(k + 1) - step));
            if is_cubic { linear + bend } else { linear }
        });
        each.collect()
    };
    let times = {
        let last = flight.times.len() - 1;
        let each = (0..=last * factor).map(|sample| {
            let (k, s) = (sample / factor, (sample % factor) as f64 / factor as f64);
            let next = flight.times[(k + 1).min(last)];
            flight.times[k] + s * (next - flight.times[k])
        });
        each.collect()
    };
    each_track(flight, between);
    flight.times = times;
}

/// Replaces each coordinate of each marker by a function of it. All tracks must become equally long. Missing positions
/// are filled with the preceding one first.
fn each_track(flight: &mut Flight, mut change: impl FnMut(&[f64]) -> Track) {
    let markers = flight.positions.first().map_or(0, Vec::len);
    let mut tracks: Vec<Track> = Vec::new();
    for marker in 0..markers {
        let seen = flight.positions.iter().filter_map(|row| row[marker]);
        let mut last = seen.clone().next().unwrap_or([0.0; 3]);
        let filled = flight.positions.iter().map(|row| {
            last = row[marker].unwrap_or(last);
            last
        });
        let filled: Vec<[f64; 3]> = filled.collect();
        for axis in 0..3 {
            let track: Track = filled.iter().map(|point| point[axis]).collect();
            tracks.push(change(&track));
        }
    }
    let samples = tracks.first().map_or(0, Vec::len);
    let row = |k: usize| {
        let point = |marker: usize| Some(std::array::from_fn(|axis| tracks[3 * marker + axis][k]));
        (0..markers).map(point).collect()
    };
    flight.positions = (0..samples).map(row).collect();
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sine(rate: f64, frequency: f64) -> Flight {
        let times: Vec<f64> = (0..200).map(|k| f64::from(k) / rate).collect();
        let position = |t: &f64| {
            vec![Some([
                (std::f64::consts::TAU * frequency * t).sin(),
                0.0,
                0.0,
            ])]
        };
        Flight {
            positions: times.iter().map(position).collect(),
            times,
            ..Flight::default()
        }
    }

    fn amplitude(flight: &Flight) -> f64 {
        let middle = &flight.positions[60..140];
        let values = middle.iter().filter_map(|row| row[0]);
        values.fold(0.0, |most, point| most.max(point[0].abs()))
    }

    #[test]
    fn a_low_pass_halves_the_cut_off_and_spares_slow_motion() {
        // Twice the filter: half the amplitude at the cut-off frequency.
        for (frequency, expected) in [(10.0, 0.5), (2.0, 1.0), (40.0, 0.004)] {
            let mut flight = sine(200.0, frequency);
            low_pass(&mut flight, 200.0, 10.0);
            let found = amplitude(&flight);
            assert!((found - expected).abs() < 0.03, "{frequency} Hz: {found}");
        }
    }

    #[test]
    fn interpolation_keeps_the_samples_and_cubic_is_closer() {
        let exact = sine(400.0, 12.0);
        let mut error = Vec::new();
        for is_cubic in [false, true] {
            let mut flight = sine(100.0, 12.0);
            upsample(&mut flight, 4, is_cubic);
            let pairs = flight.positions.iter().zip(&exact.positions);
            let off = pairs
                .take(150)
                .filter_map(|(a, b)| Some((a[0]?[0] - b[0]?[0]).abs()));
            error.push(off.fold(0.0, f64::max));
            assert!((flight.times[6] - 0.015).abs() < 1e-12);
        }
        assert!(error[0] > 0.05 && error[1] < 0.03, "{error:?}");
    }
}
