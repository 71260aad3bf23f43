//! Times that a program rounded, as of frames at 240 Hz written with three decimals: the frames were evenly spaced.

/// Minimum number of samples from which the interval between frames is estimated.
const MIN_SAMPLES: usize = 8;
/// Decimal places with which times may be rounded.
const DECIMALS: std::ops::RangeInclusive<i32> = 1..=6;
/// Minimum rounding, as a part of the interval between samples, that is corrected: a body at 20 m/s moves by some 0.1 mm in
/// the error of less, at the rates of cameras.
const MIN_ROUNDING: f64 = 0.01;
/// Ratio of an interval to the usual one above which frames are missing in it.
const MISSING: f64 = 1.5;
/// Relative error of floating-point numbers that have few decimal places.
const ROUNDING: f64 = 1e-6;

/// Replaces times (s) that are rounded by those of evenly spaced frames, some of which may be missing. Returns the unit of
/// the last decimal place, s; `None` where the times are not rounded, or not those of evenly spaced frames.
pub(crate) fn space_evenly(times: &mut [f64]) -> Option<f64> {
    let (count, start) = (times.len(), *times.first()?);
    if count < MIN_SAMPLES {
        return None;
    }
    let since: Vec<f64> = times.iter().map(|time| time - start).collect();
    let intervals: Vec<f64> = since.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let mut sorted = intervals.clone();
    sorted.sort_unstable_by(f64::total_cmp);
    let usual = sorted[sorted.len() / 2];
    let whole: Vec<f64> = sorted
        .into_iter()
        .filter(|own| *own < MISSING * usual)
        .collect();
    let mean = whole.iter().sum::<f64>() / whole.len() as f64;
    let decimal = DECIMALS.map(|places| 10.0_f64.powi(places).recip());
    let is_rounded = |unit: &f64| {
        let is_multiple =
            |time: &f64| (time / unit - (time / unit).round()).abs() < ROUNDING / unit;
        since.iter().all(is_multiple)
    };
    let unit = decimal
        .filter(|unit| *unit > MIN_ROUNDING * mean)
        .find(is_rounded)?;
    let mut frame = 0.0;
    let frames = std::iter::once(0.0).chain(intervals.iter().map(|own| {
        frame += (own / mean).round().max(1.0);
        frame
    }));
    let frames: Vec<f64> = frames.collect();
    // Least squares: time = first + interval × frame.
    let mean_of = |values: &[f64]| values.iter().sum::<f64>() / count as f64;
    let (middle, centre) = (mean_of(&frames), mean_of(&since));
    let squares: f64 = frames.iter().map(|own| (own - middle).powi(2)).sum();
    let products = frames
        .iter()
        .zip(&since)
        .map(|(own, time)| (own - middle) * (time - centre));
    let interval = products.sum::<f64>() / squares;
    let errors = frames
        .iter()
        .zip(&since)
        .map(|(own, time)| time - interval * own);
    let (least, most) = errors.fold(
        (f64::INFINITY, f64::NEG_INFINITY),
        |(least, most), error| (least.min(error), most.max(error)),
    );
    // The interval is estimated, so that the errors may spread by a little more than the rounding.
    let is_even = most - least <= unit * (1.0 + (count as f64).sqrt().recip());
    let is_changed = most - least > ROUNDING * mean;
    if !(is_even && is_changed) {
        return None;
    }
    let first = start + 0.5 * (least + most);
    for (time, frame) in times.iter_mut().zip(frames) {
        *time = first + interval * frame;
    }
    Some(unit)
}

/// Sentence on the flights whose times were rounded, each with the unit of its last decimal place, s; `None` for none.
pub(crate) fn note(rounded: &[(String, f64)]) -> Option<String> {
    let (file, unit) = rounded.first()?;
    let of = match rounded.len() {
        1 => file.clone(),
        count => format!("{count} flights, such as {file},"),
    };
    Some(format!(
        "the times of {of} are rounded, in {file} to {unit} s, and taken as those of evenly spaced frames"
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rounded(rate: f64, unit: f64, frames: impl Iterator<Item = usize>) -> Vec<f64> {
        frames
            .map(|frame| (frame as f64 / rate / unit).round() * unit)
            .collect()
    }

    #[test]
    fn rounded_times_of_frames_are_evenly_spaced() {
        for (rate, unit) in [
            (240.0, 1e-3),
            (120.0, 1e-3),
            (60.0, 0.01),
            (119.88, 1e-3),
            (240.0, 1e-4),
        ] {
            let mut times = rounded(rate, unit, (0..200).filter(|frame| frame % 37 != 5));
            let found = space_evenly(&mut times).unwrap_or_else(|| panic!("{rate} {unit}"));
            assert!((found - unit).abs() < 1e-12);
            let frames = (0..200).filter(|frame| frame % 37 != 5);
            for (time, frame) in times.iter().zip(frames) {
                assert!(
                    (time - f64::from(frame) / rate).abs() < 0.25 * unit,
                    "{rate} {unit} {frame}"
                );
            }
        }
    }

    #[test]
    fn exact_times_and_those_of_uneven_samples_stay() {
        let even = rounded(100.0, 0.01, 0..50);
        let fine = rounded(120.0, 1e-6, 0..50);
        let uneven: Vec<f64> = (0..50)
            .map(|k| 0.01 * f64::from(k) + if k % 3 == 0 { 0.003 } else { 0.0 })
            .collect();
        for times in [even, fine, uneven, vec![0.0, 0.1, 0.25]] {
            let mut spaced = times.clone();
            assert_eq!(space_evenly(&mut spaced), None);
            assert_eq!(spaced, times);
        }
    }
}
