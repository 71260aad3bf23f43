//! Errors: models without a reference implementation or without derivable equations of motion.

use thiserror::Error;

/// Reason why the reference implementation of a law of motion cannot be applied to the model that names this law.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum BindError {
    /// No reference implementation has the name that the model gives after the keyword `reference`.
    #[error("there is no reference `{name}`; available: {}", available.join(", "))]
    UnknownReference {
        /// Unknown name that the model gives after `reference`.
        name: String,
        /// Names of all reference laws.
        available: Vec<&'static str>,
    },
    /// A parameter or coefficient of the reference law is missing from the model.
    #[error("`{name}` is not declared")]
    MissingConstant {
        /// Name, in the reference law, of the parameter or coefficient that the model does not declare.
        name: &'static str,
    },
    /// A state of the reference law is missing from the model.
    #[error("the state `{name}` of the reference is not declared")]
    MissingState {
        /// Name, in the reference law, of the state that the model does not declare.
        name: &'static str,
    },
    /// An input that the reference law takes as an inertial vector is declared in another frame.
    #[error(
        "the input `{name}` is declared in the frame `{frame}`; the reference expects it in the inertial frame"
    )]
    InputFrame {
        /// Name of the input.
        name: &'static str,
        /// Name of the frame in which the model declares the input.
        frame: String,
    },
}

/// Reason why the reference evaluation in this crate cannot derive a model's equations of motion.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum Unsupported {
    /// The components of a vector refer to a frame whose angular velocity the model does not define.
    #[error("the angular velocity of the frame of {vector} is not defined")]
    FrameRate {
        /// Name of the vector for the error message, such as `the velocity`.
        vector: &'static str,
    },
    /// The angular velocity is a state, but the attitude is not a quaternion from the inertial frame.
    #[error("the attitude is not a quaternion from the inertial frame")]
    Attitude,
    /// The attitude is not a sequence of three rotations whose rates are states.
    #[error("the attitude is not three rotations with their rates")]
    Rotations,
}
