//! Tables of inputs over time: a column `t` and one for each input, by name.

use csv::{ReaderBuilder, StringRecord, Trim};

use super::{InputInterpolation, InputSeries};
use crate::release::Release;

/// Maximum number of values of a table; it bounds the memory used.
const MAX_VALUES: usize = 1 << 23;

/// Fault of a table of inputs.
#[derive(Clone, Debug, PartialEq)]
pub struct TableFault {
    /// Line, and number of the cell in it, from 1.
    pub place: (usize, usize),
    /// What was found.
    pub found: String,
    /// What was expected.
    pub expected: String,
}

/// Reads a table of inputs: a header with `t` and the names of inputs, then rows; commas, semicolons or tabs. An empty
/// cell or `NaN` is a sample that is missing. `seconds` converts a time of the table to s.
pub fn read_inputs(
    text: &str,
    interpolation: InputInterpolation,
    seconds: impl Fn(f64) -> f64,
) -> Result<Vec<(String, InputSeries)>, TableFault> {
    let mut rows = Rows::new(text);
    if !rows.next()? {
        return Err(rows.fault(0, "no header", "a header: t and the names of inputs"));
    }
    let names: Vec<String> = rows
        .record
        .iter()
        .map(|cell| unquoted(cell).to_owned())
        .collect();
    if let Some(second) = (1..names.len()).find(|&k| names[..k].contains(&names[k])) {
        let found = format!("a second column {:?}", names[second]);
        return Err(rows.fault(second, &found, "each column once"));
    }
    let Some(time) = names.iter().position(|name| name == "t") else {
        return Err(rows.fault(0, "no column t", "the time of each row, s, in a column t"));
    };
    if names.len() < 2 {
        return Err(rows.fault(0, "the column t alone", "a column for each input"));
    }
    let mut samples: Vec<Vec<(f64, f64)>> = vec![Vec::new(); names.len()];
    let (mut first, mut last, mut count) = (None, f64::NEG_INFINITY, 0);
    while rows.next()? {
        count += names.len();
        if rows.record.len() != names.len() {
            let found = format!("{} cells", rows.record.len());
            let expected = format!("{} as in the header", names.len());
            return Err(rows.fault(rows.record.len().min(names.len()), &found, &expected));
        }
        if count > MAX_VALUES {
            return Err(rows.fault(0, "a row more", &format!("at most {MAX_VALUES} values")));
        }
        let now = rows.number(time)?;
        let Some(now) = now.map(&seconds) else {
            return Err(rows.fault(time, "no time", "the time of the sample, s"));
        };
        if now <= last {
            return Err(rows.fault(
                time,
                &format!("t = {now}"),
                &format!("a time after {last} s"),
            ));
        }
        if now - *first.get_or_insert(now) > Release::MAX_DURATION {
            let most = Release::MAX_DURATION;
            let expected = format!("at most {most} s after the first one (milliseconds?)");
            return Err(rows.fault(time, &format!("t = {now}"), &expected));
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
            Err(rows.fault(index, &found, "the values of an input over time"))
        }
        false => Ok((name, InputSeries::new(&samples, interpolation))),
    });
    series.collect()
}

/// Text of a cell without the quotes at both of its ends.
fn unquoted(cell: &str) -> &str {
    let inner = cell
        .strip_prefix('"')
        .and_then(|cell| cell.strip_suffix('"'));
    inner.map_or(cell, str::trim)
}

/// Rows of a table, without blank lines and comments.
struct Rows<'t> {
    reader: csv::Reader<&'t [u8]>,
    record: StringRecord,
}

impl<'t> Rows<'t> {
    fn new(text: &'t str) -> Self {
        let text = text.trim_start_matches('\u{FEFF}');
        let mut lines = text.lines();
        let header = lines.find(|line| !line.trim().is_empty() && !line.starts_with('#'));
        let mut marks = [b'\t', b';'].into_iter();
        let mark =
            marks.find(|&mark| header.is_some_and(|header| header.contains(char::from(mark))));
        let reader = ReaderBuilder::new()
            .delimiter(mark.unwrap_or(b','))
            .comment(Some(b'#'))
            .quoting(false)
            .trim(Trim::All)
            .has_headers(false)
            .flexible(true)
            .from_reader(text.as_bytes());
        Self {
            reader,
            record: StringRecord::new(),
        }
    }

    fn next(&mut self) -> Result<bool, TableFault> {
        loop {
            let read = self.reader.read_record(&mut self.record);
            let read =
                read.map_err(|error| self.fault(0, &error.to_string(), "a readable table"))?;
            if !read
                || self.record.len() > 1
                || self.record.get(0).is_some_and(|cell| !cell.is_empty())
            {
                return Ok(read);
            }
        }
    }

    fn number(&self, index: usize) -> Result<Option<f64>, TableFault> {
        let cell = unquoted(self.record.get(index).unwrap_or_default());
        match cell.parse::<f64>() {
            _ if cell.is_empty() => Ok(None),
            Ok(number) if number.is_nan() => Ok(None),
            Ok(number) if number.is_finite() => Ok(Some(number)),
            _ => Err(self.fault(
                index,
                &format!("{cell:?}"),
                "a finite number, or nothing for a dropout",
            )),
        }
    }

    fn fault(&self, index: usize, found: &str, expected: &str) -> TableFault {
        let line = self
            .record
            .position()
            .map_or(1, |place| place.line() as usize);
        TableFault {
            place: (line.max(1), index + 1),
            found: found.to_owned(),
            expected: expected.to_owned(),
        }
    }
}
