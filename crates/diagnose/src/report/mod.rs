//! Last stage of a diagnosis: its report, with a summary as text.

mod curves;
mod extension;
mod narrative;
mod report_builder;
mod residuals;
mod types;

pub(crate) use curves::curves;
pub(crate) use extension::{
    add_alternative, add_extension, note_not_applied, use_clustered_errors,
};
pub(crate) use narrative::{refused, summary, term_alone};
pub(crate) use report_builder::{build_report, noise, unattributed_report};
pub(crate) use residuals::{
    add_residuals, describe_departures, display_names, note_incomplete, note_not_offered,
    withdraw_by_doubts, withdraw_by_excess, withdraw_inadequate, withdraw_stand_ins,
};

pub use curves::{CoefficientCurve, intervals};
pub use types::{
    CandidateTest, Coefficient, Consensus, Estimate, Explanation, ExplanationEffect, FlightGain,
    LoadChannel, RemainingEffect, Report, ScoreCorrelations, Threshold, Unattributed, Verdict,
    Verified,
};
