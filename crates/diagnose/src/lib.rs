//! Specification search for models of flight: tests whether measured flights contradict a model, finds the effect
//! that the model lacks, and measures how much better the extended model predicts.
//!
//! [`diagnose`] fits the model by the output-error method, tests every candidate effect by its score (Lagrange
//! multiplier) statistic without a refit, and selects the hypotheses that leave no significant effect: a model
//! confidence set. Each stage has its own folder:
//!
//! | stage | does |
//! |---|---|
//! | context | composes the encompassing model, every candidate at its null value |
//! | extension | composes the model with selected effects, as a file |
//! | score_test | χ² statistics, p-values, tolerances and one-step estimates of all candidates and library terms |
//! | noise | full-model estimate of the noise; random-walk loads |
//! | selection | forward selection and backward elimination of effects, BIC, stepwise regression with library terms |
//! | consensus | sign-flip tests over flights; discordant flights |
//! | validation | out-of-sample gain on held-out flights or by cross-validation |
//! | power, optimal_design | minimum detectable effects; the throw that best distinguishes hypotheses |
//! | report | `report.json` and its summary |
//!
//! ```no_run
//! use diagnose::{DiagnosisOptions, diagnose};
//!
//! let model = model_spec::load::load("disc", &[])?;
//! let dataset = dataset::load("examples/mystery".as_ref())?;
//! let found = diagnose(&model, &dataset, &DiagnosisOptions::default())?;
//! println!("{:?}: {}", found.report.verdict, found.report.summary);
//! if let Some((extended, _)) = &found.after {
//!     println!("{}", extended.text("Found in examples/mystery."));
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod base_fit;
mod consensus;
mod context;
mod diagnosis;
mod error;
mod extension;
mod noise;
mod offer;
mod optimal_design;
mod power;
mod report;
mod score_test;
mod selection;
mod validation;

#[cfg(test)]
mod test_support;

// Running a diagnosis.
pub use context::{DiagnosisOptions, OptionsError, ThrowRanges, identifier};
pub use diagnosis::{Diagnosis, diagnose};
pub use error::DiagnosisError;
pub use extension::ExtendedModel;
pub use validation::held_out_gain;

// What a diagnosis reports.
pub use identify::{LackOfFit, SmoothMisfit};
pub use noise::LoadHistory;
pub use optimal_design::ProposedThrow;
pub use power::{MinDetectableEffect, NotIdentifiable};
pub use report::{
    CandidateTest, Coefficient, CoefficientCurve, Consensus, Estimate, Explanation,
    ExplanationEffect, FlightGain, LoadChannel, RemainingEffect, Report, ScoreCorrelations,
    Threshold, Unattributed, Verdict, Verified, intervals,
};
pub use selection::StepwiseTerm;
pub use validation::PredictiveGain;
