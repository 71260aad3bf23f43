//! Runs all fits, tests and diagnoses of the balls.

use dataset::Dataset;
use diagnose::{DiagnosisError, Report as Diagnosis};
use identify::FitReport;
use model_spec::model::Model;

use super::agreement::{Agreement, agreement};
use super::lift::{Lift, lifts};
use super::models::{MAGNUS_BY_SQUARE, diagnosed, fitted};
use super::stretches::{agreeing, is_agreeing};
use crate::error::StudyError;

/// Sets of effects that could deflect all paths in the same way, independently of the spins that the data state. Each
/// set is added to the model with gravity and drag and fitted separately.
const COMMON_EFFECTS: [&[&str]; 8] = [
    &["gravity"],
    &["tilted_vertical"],
    &["scale"],
    &["clock_rate"],
    &["wind"],
    &["drag_crisis"],
    &["magnus"],
    &["magnus", "spin_decay"],
];

/// Names of effects that are added, one at a time, to two ball models: with lift proportional to the advance ratio, and
/// with an additional lift proportional to its square.
const ADDED_EFFECTS: [&str; 6] = [
    "spin_decay",
    "gravity",
    "tilted_vertical",
    "wind",
    "wind_by_height",
    "drag_crisis",
];

/// Two fits of the flights with the same effect added: once to the model with `magnus` (lift proportional to the
/// advance ratio), once to the model that also has a lift proportional to the squared advance ratio.
pub(super) struct Added {
    pub(super) effect: &'static str,
    /// Fit of the model with two added effects: `magnus` (lift proportional to the advance ratio, radius × spin /
    /// speed) and `effect`.
    pub(super) to_magnus: FitReport,
    /// Fit of the model with three added effects: `magnus` (lift proportional to the advance ratio, radius × spin /
    /// speed), a lift proportional to the square of this ratio, and `effect`.
    pub(super) to_square: FitReport,
}

/// Results of all fits, tests and diagnoses of the table-tennis balls.
pub(in super::super) struct Balls {
    /// Fit of all flights with a model that contains only gravity and drag.
    pub(in super::super) plain: FitReport,
    /// Fits of all flights, each with one of the sets of effects in [`COMMON_EFFECTS`], which could deflect all paths
    /// in the same way. Pairs (names of the effects, fit).
    pub(super) common: Vec<(&'static [&'static str], FitReport)>,
    pub(super) lifts: Vec<Lift>,
    /// Fit of all flights with an unknown, constant lift vector for each flight.
    pub(super) free_lift: FitReport,
    /// Agreement of lift and spin for all flights, for the agreeing stretches (parts of the recording in which every
    /// lift agrees with the stated spin), and for the remaining flights.
    pub(in super::super) agreement: [Agreement; 3],
    /// Fits of the flights in the parts of the recording in which every lift agrees with the stated spin: with gravity
    /// and drag, then also with `magnus` (lift proportional to the advance ratio), then also with a lift proportional
    /// to the squared advance ratio.
    pub(in super::super) lift_by_spin: [FitReport; 3],
    /// Fits of the flights in the parts of the recording in which every lift agrees with the stated spin. Each of the
    /// effects [`ADDED_EFFECTS`] is added to two models: with lift proportional to the advance ratio, and with an
    /// additional lift proportional to its square.
    pub(super) added: Vec<Added>,
    /// Diagnoses of three cases: all flights; the flights of the recording's parts in which every lift agrees with the
    /// stated spin; and these latter flights with the effect `magnus` in the model. `Err` contains the error of a
    /// failed diagnosis.
    pub(super) diagnoses: [Result<Diagnosis, DiagnosisError>; 3],
}

impl Balls {
    /// Fits, tests and diagnoses the measured flights of table-tennis balls.
    pub(in super::super) fn of(flights: &Dataset) -> Result<Self, StudyError> {
        let model: Model = model_spec::load::load(&flights.model, &[])?;
        let part = agreeing(flights);
        let fit_all = |effects: &[&str]| fitted(&model, flights, effects);
        let fit_part = |effects: &[&str]| fitted(&model, &part, effects);
        let (lifts, free_lift) = lifts(&model, flights)?;
        let (inside, outside): (Vec<&Lift>, Vec<&Lift>) =
            lifts.iter().partition(|lift| is_agreeing(&lift.file));
        let common = COMMON_EFFECTS.iter();
        let common = common.map(|effects| Ok((*effects, fit_all(effects)?)));
        let added = ADDED_EFFECTS.iter().map(|effect| {
            Ok(Added {
                effect,
                to_magnus: fit_part(&["magnus", effect])?,
                to_square: fit_part(&["magnus", MAGNUS_BY_SQUARE, effect])?,
            })
        });
        Ok(Self {
            plain: fit_all(&[])?,
            common: common.collect::<Result<_, StudyError>>()?,
            agreement: [
                agreement(&lifts.iter().collect::<Vec<_>>(), 0),
                agreement(&inside, 1),
                agreement(&outside, 2),
            ],
            lift_by_spin: [
                fit_part(&[])?,
                fit_part(&["magnus"])?,
                fit_part(&["magnus", MAGNUS_BY_SQUARE])?,
            ],
            added: added.collect::<Result<_, StudyError>>()?,
            diagnoses: [
                diagnosed(&model, flights, &[])?,
                diagnosed(&model, &part, &[])?,
                diagnosed(&model, &part, &["magnus".into()])?,
            ],
            lifts,
            free_lift,
        })
    }
}
