//! Integration and observation of a model in SIMD lanes. [`LaneModel`] provides [`ode::fly`] with the functions of a
//! model, from generated code or from a tape; [`LaneObserver`] evaluates the measurement equation at many states.

#![forbid(unsafe_code)]

mod lane_model;
mod lane_observer;

pub use lane_model::LaneModel;
pub use lane_observer::LaneObserver;
