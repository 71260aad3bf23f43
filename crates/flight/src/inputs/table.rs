//! Tables of inputs over time: a column `t` and one for each input, by name.

use super::{InputInterpolation, InputSeries};
use crate::release::Release;
use crate::table::{Fault, Location, Sheet, separator};

/// Maximum number of values of a table; it bounds the memory used.
const MAX_VALUES: usize = 1 << 23;

/// Reads a table of inputs: a header with `t` and the names of inputs, then rows, whose empty or `NaN` cells are missing
/// samples. `seconds` converts a time of the table to s.
///
/// # Errors
/// The first fault with its place.
pub fn read_inputs(
    text: &str,
    interpolation: InputInterpolation,
    seconds: impl Fn(f64) -> f64,
) -> Result<Vec<(String, InputSeries)>, Fault> {
    let text = text.trim_start_matches('\u{FEFF}');
    let mut rows = Sheet::strict(text, separator(text));
    if !rows.advance_line()? {
        let expected = "a header: t and the names of inputs";
        return Err(Fault::new(Location::Cell(1, 1), "no header", expected));
    }
    let names = rows.cells();
    if let Some(second) = (1..names.len()).find(|&k| names[..k].contains(&names[k])) {
        let found = format!("a second column {:?}", names[second]);
        return Err(rows.fault(second, found, "each column once"));
    }
    let Some(time) = names.iter().position(|name| name == "t") else {
        return Err(rows.fault(0, "no column t", "the time of each row, s, in a column t"));
    };
    if names.len() < 2 {
        return Err(rows.fault(0, "the column t alone", "a column for each input"));
    }
    let mut samples: Vec<Vec<(f64, f64)>> = vec![Vec::new(); names.len()];
    let (mut first, mut last, mut count) = (None, f64::NEG_INFINITY, 0);
    while rows.advance_line()? {
        count += names.len();
        if rows.width() != names.len() {
            let found = format!("{} cells", rows.width());
            let expected = format!("{} as in the header", names.len());
            return Err(rows.fault(rows.width().min(names.len()), found, expected));
        }
        if count > MAX_VALUES {
            return Err(rows.fault(0, "a row more", format!("at most {MAX_VALUES} values")));
        }
        let now = rows.number(time)?;
        let Some(now) = now.map(&seconds) else {
            return Err(rows.fault(time, "no time", "the time of the sample, s"));
        };
        if now <= last {
            return Err(rows.fault(time, format!("t = {now}"), format!("a time after {last} s")));
        }
        if now - *first.get_or_insert(now) > Release::MAX_DURATION {
            let most = Release::MAX_DURATION;
            let expected = format!("at most {most} s after the first one (milliseconds?)");
            return Err(rows.fault(time, format!("t = {now}"), expected));
        }
        last = now;
        for (index, own) in samples
            .iter_mut()
            .enumerate()
            .filter(|(index, _)| *index != time)
        {
            own.extend(rows.number(index)?.map(|value| (now, value)));
        }
    }
    let all = names.into_iter().zip(samples).enumerate();
    let inputs = all.filter(|(index, _)| *index != time);
    let series = inputs.map(|(index, (name, samples))| match samples.is_empty() {
        true => {
            let found = format!("no value in the column {name:?}");
            Err(rows.fault(index, found, "the values of an input over time"))
        }
        false => Ok((name, InputSeries::new(&samples, interpolation))),
    });
    series.collect()
}
