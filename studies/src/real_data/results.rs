//! Collects the results on all measured data.

use std::path::Path;

use identify::FitReport;
use model_spec::model::Model;

use super::balls::{Agreement, Balls};
use super::disc_golf::{DiscGolf, LaunchFit};
use super::disc_pose::{DiscPose, Ratio};
use super::spin_decay::{DecayFit, Form, SpinDecay};
use super::wind_tunnel::{Measured, read};
use crate::error::StudyError;
use crate::oracle_flights::disc;

/// Results of the studies of all measured data.
pub struct RealData {
    pub(super) balls: Balls,
    pub(super) spin_decay: SpinDecay,
    pub(super) disc_pose: DiscPose,
    pub(super) disc_golf: DiscGolf,
    /// Rows of Potts and Crowther's wind-tunnel table: aerodynamic coefficients by angle of attack.
    pub(super) table: Vec<Measured>,
    /// The built-in model `disc`, with the coefficients of its model file.
    pub(super) disc: Model,
}

impl RealData {
    /// Fits the data in the subfolders `spindoe`, `spindown`, `disc-pose`, `windtunnel` and `discgolf` of `folder`.
    ///
    /// # Errors
    /// [`StudyError`] if a file is missing or malformed, or if a fit fails.
    pub fn of(folder: &Path) -> Result<Self, StudyError> {
        let flights = dataset::load(&folder.join("spindoe"))?;
        let disc = disc();
        Ok(Self {
            balls: Balls::of(&flights)?,
            spin_decay: SpinDecay::of(&folder.join("spindown/flight.csv"), &disc)?,
            disc_pose: DiscPose::of(&folder.join("disc-pose"))?,
            disc_golf: DiscGolf::of(&folder.join("discgolf"), &disc)?,
            table: read(&folder.join("windtunnel/potts_crowther.csv"))?,
            disc,
        })
    }

    /// Fit of the table-tennis balls' flights with a model that contains only gravity and drag.
    pub fn ball(&self) -> &FitReport {
        &self.balls.plain
    }

    /// Agreement of the lifts of table-tennis balls with the spins that the data state: for all flights, for the
    /// agreeing stretches, and for the remaining flights.
    pub fn agreement(&self) -> [Agreement; 3] {
        self.balls.agreement
    }

    /// Fits of the agreeing stretches: with gravity and drag, then also with lift proportional to the advance ratio,
    /// then also with lift proportional to its square.
    pub fn lift_by_spin(&self) -> &[FitReport; 3] {
        &self.balls.lift_by_spin
    }

    /// For each disc-golf throw, two fits of the launch to the measured track: of the launch alone, and together with
    /// factors on the tabulated lift, drag and pitching moment. `None` if the normal equations are singular.
    pub fn launches(&self) -> impl Iterator<Item = &[Option<LaunchFit>; 2]> {
        self.disc_golf.fits()
    }

    /// Ratio I_a/I_d of the axial to the diametral moment of inertia of a golf disc, from the poses of all throws.
    pub fn inertia_ratio(&self) -> Ratio {
        self.disc_pose.ratio()
    }

    /// Fit of the torque law `form` to the measured spin of a disc; `None` if that fit failed.
    pub fn spin_down(&self, form: Form) -> Option<&DecayFit> {
        self.spin_decay.fit(form)
    }
}
