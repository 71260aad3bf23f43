//! What a file of a recording may leave unstated.

use crate::error::{Fault, Place};
use crate::format::Format;
use crate::unit::{LengthUnit, TimeUnit};

/// Statements about a file that complete its own, or replace them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ReadOptions {
    /// Format; recognised by the content if `None`.
    pub format: Option<Format>,
    /// Unit of the coordinates.
    pub length: Option<LengthUnit>,
    /// Unit of the times.
    pub time: Option<TimeUnit>,
    /// Frames per second.
    pub rate: Option<f64>,
}

/// Greatest frame rate, Hz.
const FASTEST: f64 = 1e6;

impl ReadOptions {
    /// Unit of length by the option or the file, with a note where they contradict each other.
    pub(crate) fn length(
        &self,
        stated: Option<LengthUnit>,
        place: Place,
        notes: &mut Vec<String>,
    ) -> Result<LengthUnit, Fault> {
        match (self.length, stated) {
            (Some(option), Some(stated)) if option != stated => {
                notes.push(format!(
                    "the file states lengths in {stated}; read in {option}, by the option --length"
                ));
                Ok(option)
            }
            (Some(unit), _) | (None, Some(unit)) => Ok(unit),
            (None, None) => Err(Fault::new(
                place,
                "no unit of length",
                "a unit in the file, or the option --length m, cm, mm, in or ft",
            )),
        }
    }

    /// Frames per second by the option or the file, with a note where they contradict each other.
    pub(crate) fn rate(
        &self,
        stated: Option<f64>,
        place: Place,
        notes: &mut Vec<String>,
    ) -> Result<f64, Fault> {
        let rate = match (self.rate, stated) {
            (Some(option), Some(stated)) if option != stated => {
                notes.push(format!(
                    "the file states {stated} frames per second; read with {option}, by the option --rate"
                ));
                option
            }
            (Some(rate), _) | (None, Some(rate)) => rate,
            (None, None) => {
                let expected = "times in the file, or the option --rate with the frames per second";
                return Err(Fault::new(place, "no times", expected));
            }
        };
        if rate > 0.0 && rate <= FASTEST {
            return Ok(rate);
        }
        let expected = format!("frames per second above 0, at most {FASTEST}");
        Err(Fault::new(place, format!("the rate {rate}"), expected))
    }
}
