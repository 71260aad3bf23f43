//! Failure of an integration: return code, time and last state.

use std::fmt;

/// Failed integration: the return code, with the time of failure and the last accepted state.
#[derive(Clone, Debug, PartialEq)]
pub struct IntegrationError {
    /// Time of failure, in the time unit of the right-hand side.
    pub time: f64,
    /// Last accepted state, as name and value of each component. Components that the error norm of the step-size
    /// control does not include, such as sensitivities, are omitted. Empty if the input was invalid.
    pub states: Vec<(String, f64)>,
    /// Return code: reason of the failure.
    pub cause: IntegrationFailure,
}

/// Return code of a failed integration.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum IntegrationFailure {
    /// Invalid input: a component of the initial state or a time is NaN or infinite, or the duration, a tolerance or a
    /// step bound is not a positive number.
    #[error("invalid integration input: {what} is {value}")]
    InvalidInput {
        /// Name of the invalid quantity: a component of the initial state, a time, or an option.
        what: String,
        /// Value of the invalid quantity.
        value: f64,
    },
    /// At the initial state, the event function of a terminal event is already past its zero.
    #[error("invalid initial state: it is already past the terminal event ({event})")]
    StartsPastEvent {
        /// Name of the terminal event whose event function is past its zero.
        event: String,
    },
    /// The right-hand side is NaN or infinite, however short the step.
    #[error("the derivative of {state} is {rate}")]
    NonFiniteDerivative {
        /// Name of the state component whose derivative is NaN or infinite.
        state: String,
        /// Value of the derivative: NaN or infinite.
        rate: f64,
    },
    /// The error test fails at the minimum step size.
    #[error("step size below minimum ({} s): d({})/dt is {}", Short(*.step), .state.0, Short(.state.1))]
    StepTooSmall {
        /// Size of the last rejected step, in the time unit of the right-hand side.
        step: f64,
        /// Name and derivative of the state component that changes fastest relative to its value.
        state: (String, f64),
    },
    /// The maximum number of accepted and rejected steps was reached.
    #[error("the end was not reached in {steps} steps")]
    TooManySteps {
        /// Number of accepted and rejected steps together, equal to
        /// [`IntegrationOptions::max_steps`](crate::IntegrationOptions::max_steps).
        steps: usize,
    },
    /// A limit of the model's domain of validity, given as [`Event::limit`](crate::Event::limit), was crossed.
    #[error("limit of validity of the model: {reason}")]
    Limit {
        /// Description of the crossed limit of validity: the argument `reason` of `Event::limit`.
        reason: String,
    },
    /// No terminal event occurred before the final time, although the integration was to end at one.
    #[error("no terminal event occurred (expected: {event})")]
    NoTerminalEvent {
        /// Names of the terminal events, joined by commas.
        event: String,
    },
}

impl fmt::Display for IntegrationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let cause = &self.cause;
        match cause {
            IntegrationFailure::InvalidInput { .. }
            | IntegrationFailure::StartsPastEvent { .. } => write!(f, "{cause}")?,
            _ => write!(
                f,
                "integration failed at t = {} s: {cause}",
                Short(self.time)
            )?,
        }
        for (i, (name, value)) in self.states.iter().enumerate() {
            let lead = if i == 0 { "\n  last state: " } else { ", " };
            write!(f, "{lead}{name} = {}", Short(*value))?;
        }
        Ok(())
    }
}

impl std::error::Error for IntegrationError {}

/// Wrapper that displays a number with at most seven significant digits.
struct Short(f64);

impl fmt::Display for Short {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let magnitude = self.0.abs();
        if magnitude != 0.0 && !(1e-4..1e7).contains(&magnitude) {
            return write!(f, "{:.3e}", self.0);
        }
        let decimals = if magnitude == 0.0 {
            0
        } else {
            (6 - magnitude.log10().floor() as i32).clamp(0, 9) as usize
        };
        let text = format!("{:.decimals$}", self.0);
        f.write_str(match text.contains('.') {
            true => text.trim_end_matches('0').trim_end_matches('.'),
            false => &text,
        })
    }
}
