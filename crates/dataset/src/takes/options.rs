//! Options that supply what the file of a recording does not state.

use crate::takes::{Fault, Format, LengthUnit, Location, TimeUnit, checked_rate};

/// Properties of a recording that the user states, such as units; they override those that the file states.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ReadOptions {
    /// Format of the file; recognised by the content if `None`.
    pub format: Option<Format>,
    /// Unit of the coordinates; if `None`, it must be specified in the file.
    pub length: Option<LengthUnit>,
    /// Unit of the times; if `None`, it must be specified in the file.
    pub time: Option<TimeUnit>,
    /// Frames per second; if `None`, the file must specify the rate or contain times.
    pub rate: Option<f64>,
}

impl ReadOptions {
    /// Unit of length: the user's, or else the one `stated` in the file; a note if they differ, a fault without.
    pub(crate) fn length(
        &self,
        stated: Option<LengthUnit>,
        location: Location,
        notes: &mut Vec<String>,
    ) -> Result<LengthUnit, Fault> {
        if let (Some(option), Some(stated)) = (self.length, stated)
            && option != stated
        {
            notes.push(format!(
                "the file states lengths in {stated}; read in {option}, by the option --length"
            ));
        }
        let expected = "a unit in the file, or the option --length m, cm, mm, in or ft";
        let absent = || Fault::new(location, "no unit of length", expected);
        self.length.or(stated).ok_or_else(absent)
    }

    /// Frames per second: the user's, otherwise the rate `stated`; a note if they differ, a fault without a valid one.
    pub(crate) fn rate(
        &self,
        stated: Option<f64>,
        location: Location,
        notes: &mut Vec<String>,
    ) -> Result<f64, Fault> {
        if let (Some(option), Some(stated)) = (self.rate, stated)
            && option != stated
        {
            notes.push(format!(
                "the file states {stated} frames per second; read with {option}, by the option --rate"
            ));
        }
        let expected = "times in the file, or the option --rate with the frames per second";
        let absent = || Fault::new(location, "no times", expected);
        let rate = self.rate.or(stated).ok_or_else(absent)?;
        checked_rate(rate).map_err(|(found, expected)| Fault::new(location, found, expected))
    }
}
