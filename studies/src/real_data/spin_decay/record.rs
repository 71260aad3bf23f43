//! Record of a gyroscope in a disc.

use std::path::Path;

use crate::error::StudyError;
use crate::real_data::files::{absent, bad_line, rows, text_of};

/// Times at which the disc's flight starts and ends in the table of sensor readings, s.
pub(super) const FLIGHT: (f64, f64) = (0.14, 2.38);

/// A table of sensor readings is rejected if it contains fewer samples of the flight than this number.
const MIN_SAMPLES: usize = 10;

/// Measured spin of a disc in flight.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Record {
    /// Times since the release of the disc, s.
    pub(super) times: Vec<f64>,
    /// Angular rate about the disc's axis at each of the `times`, rad/s: the signed gyroscope reading `gz`.
    pub(super) rates: Vec<f64>,
}

impl Record {
    /// Reads the disc's spin during the flight from a table `t,gx,gy,gz,…` in s and rad/s.
    pub(super) fn read(file: &Path) -> Result<Self, StudyError> {
        let text = text_of(file)?;
        let mut record = Self::default();
        for row in rows(&text, 1) {
            let mut cells = row.1.split(',').map(|cell| cell.trim().parse::<f64>().ok());
            let (Some(Some(time)), Some(Some(rate))) = (cells.next(), cells.nth(2)) else {
                return Err(bad_line(file, row, "t,gx,gy,gz"));
            };
            if (FLIGHT.0 - 1e-9..=FLIGHT.1 + 1e-9).contains(&time) {
                record.times.push(time - FLIGHT.0);
                record.rates.push(rate);
            }
        }
        if record.times.len() < MIN_SAMPLES {
            return Err(absent(file, "flight"));
        }
        Ok(record)
    }

    /// The part of the record after `start` (s), with times relative to `start`.
    pub(super) fn from(&self, start: f64) -> Self {
        let first = self.times.partition_point(|time| *time < start);
        Self {
            times: self.times[first..].iter().map(|t| t - start).collect(),
            rates: self.rates[first..].to_vec(),
        }
    }
}
