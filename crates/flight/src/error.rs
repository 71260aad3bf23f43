//! Why a flight came to no end.

use std::fmt;

/// A flight that could not be flown, with the time at which it failed and the last good state.
#[derive(Clone, Debug, PartialEq)]
pub struct FlightError {
    /// When, s.
    pub time: f64,
    /// The last good state, by name.
    pub states: Vec<(String, f64)>,
    /// Why.
    pub cause: Cause,
}

/// Why a flight could not be flown.
#[derive(Clone, Debug, PartialEq)]
pub enum Cause {
    /// A number that the flight starts with is not one.
    Start {
        /// Which: a state, or a setting such as the tolerance.
        what: String,
        /// Its value.
        value: f64,
    },
    /// The flight starts beyond the event that ends it, such as below the ground.
    StartsBeyond {
        /// Name of the event.
        event: String,
    },
    /// The model gives no finite rate of change for a state.
    NotFinite {
        /// Name of the state.
        state: String,
        /// What the model gives.
        rate: f64,
    },
    /// No step was short enough for the tolerance.
    StepTooSmall {
        /// The last that was tried, s.
        step: f64,
        /// Name of the state that changes most by its own size, and its rate of change.
        state: (String, f64),
    },
    /// More steps than allowed.
    TooManySteps {
        /// How many.
        steps: usize,
    },
    /// The model's limit was reached.
    Limit {
        /// What the model says of it.
        reason: String,
    },
    /// The event that was to end the flight did not come.
    NoEnd {
        /// Name of the event.
        event: String,
    },
}

impl fmt::Display for FlightError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.cause {
            Cause::Start { what, value } => {
                write!(f, "the flight cannot start: {what} is {value}")?
            }
            Cause::StartsBeyond { event } => write!(
                f,
                "the flight cannot start: it is past its end ({event}) already"
            )?,
            Cause::NotFinite { state, rate } => write!(
                f,
                "at {} s the model has no answer: the rate of change of {state} is {rate}",
                Short(self.time)
            )?,
            Cause::StepTooSmall {
                step,
                state: (name, rate),
            } => write!(
                f,
                "at {} s no step is short enough (the last was {} s): {name} changes at {} a second",
                Short(self.time),
                Short(*step),
                Short(*rate)
            )?,
            Cause::TooManySteps { steps } => write!(
                f,
                "at {} s the flight was not over after {steps} steps",
                Short(self.time)
            )?,
            Cause::Limit { reason } => {
                write!(f, "at {} s the model ends: {reason}", Short(self.time))?
            }
            Cause::NoEnd { event } => write!(
                f,
                "by {} s the flight was not over: no {event}",
                Short(self.time)
            )?,
        }
        for (i, (name, value)) in self.states.iter().enumerate() {
            write!(
                f,
                "{}{name} = {}",
                if i == 0 { "\n  last state: " } else { ", " },
                Short(*value)
            )?;
        }
        Ok(())
    }
}

impl std::error::Error for FlightError {}

/// A number in at most seven digits.
struct Short(f64);

impl fmt::Display for Short {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = self.0.abs();
        if size == 0.0 || (1e-4..1e7).contains(&size) {
            let places = if size == 0.0 {
                0
            } else {
                (6 - size.log10().floor() as i32).clamp(0, 9) as usize
            };
            let text = format!("{:.places$}", self.0);
            let text = if text.contains('.') {
                text.trim_end_matches('0').trim_end_matches('.')
            } else {
                &text
            };
            f.write_str(text)
        } else {
            write!(f, "{:.3e}", self.0)
        }
    }
}
