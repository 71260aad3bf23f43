//! All fits, tests and diagnoses of the balls.

use diagnose::Report as Diagnosis;
use identify::FitReport;
use identify::dataset::Dataset;
use model_spec::model::Model;

use super::agreement::{Agreement, agreement};
use super::lift::{Lift, lifts};
use super::models::{MAGNUS_BY_SQUARE, diagnosed, fitted};
use super::stretches::{agreeing, is_agreeing};
use crate::error::StudyError;

/// Effects that would bend all paths in the same way, fitted one set at a time.
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

/// Effects that are added to the lift by spin, one at a time.
const ADDED_EFFECTS: [&str; 6] = [
    "spin_decay",
    "gravity",
    "tilted_vertical",
    "wind",
    "wind_by_height",
    "drag_crisis",
];

/// Fits with one effect added to the lift by spin.
pub(super) struct Added {
    pub(super) effect: &'static str,
    /// Added to `magnus`.
    pub(super) to_magnus: FitReport,
    /// Added to `magnus` and the lift by the square of the advance ratio.
    pub(super) to_square: FitReport,
}

/// Results on the table-tennis balls.
pub(in super::super) struct Balls {
    /// Fit with gravity and drag alone.
    pub(in super::super) plain: FitReport,
    /// Fits with [`COMMON_EFFECTS`] to all flights.
    pub(super) common: Vec<(&'static [&'static str], FitReport)>,
    pub(super) lifts: Vec<Lift>,
    /// Fit with a free lift of each flight.
    pub(super) free_lift: FitReport,
    /// Agreement of lift and spin: of all flights, of the agreeing stretches, of the others.
    pub(in super::super) agreement: [Agreement; 3],
    /// Fits to the agreeing stretches: gravity and drag, with `magnus`, with its square.
    pub(in super::super) lift_by_spin: [FitReport; 3],
    /// Fits to the agreeing stretches with [`ADDED_EFFECTS`].
    pub(super) added: Vec<Added>,
    /// Diagnoses of all flights, of the agreeing stretches, and of these with `magnus`.
    pub(super) diagnoses: [Result<Diagnosis, String>; 3],
}

impl Balls {
    /// Fits, tests and diagnoses the flights.
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
