//! Simulates and fits all disc-golf throws.

use std::path::Path;

use model_spec::model::Model;

use super::band::{Band, band};
use super::launch_fit::{LaunchFit, launch_fit};
use super::read::{disc, throws};
use super::simulate::Simulator;
use super::throw::Throw;
use crate::error::StudyError;

/// Number of simulated flights of each filmed throw, with launch quantities drawn at random within their uncertainties.
pub(super) const DRAWS: usize = 100;

/// Simulations and fits of one filmed disc-golf throw.
pub(super) struct ThrowResult {
    pub(super) throw: Throw,
    pub(super) band: Band,
    /// Two fits of the launch to the measured track: of the launch alone, and together with factors on the tabulated
    /// lift, drag and pitching moment. `None` if the normal equations are singular.
    pub(super) fits: [Option<LaunchFit>; 2],
}

/// Simulations and fits of all disc-golf throws.
pub(in super::super) struct DiscGolf {
    pub(super) throws: Vec<ThrowResult>,
}

impl DiscGolf {
    /// Simulates and fits the throws of a folder that contains `dd2.yaml` (the disc), `throw_params.csv` (launch
    /// conditions) and the tracks (measured paths).
    pub(in super::super) fn of(folder: &Path, model: &Model) -> Result<Self, StudyError> {
        let disc = disc(&folder.join("dd2.yaml"))?;
        let simulator = Simulator::new(model, &disc)?;
        let throws = throws(folder)?.into_iter().map(|throw| ThrowResult {
            band: band(&simulator, &throw, DRAWS, u64::from(throw.number)),
            fits: [false, true].map(|factors| launch_fit(&simulator, &throw, factors)),
            throw,
        });
        Ok(Self {
            throws: throws.collect(),
        })
    }

    /// For each throw, two fits of the launch to the measured track: of the launch alone, and together with factors on
    /// the tabulated lift, drag and pitching moment. `None` if the normal equations are singular.
    pub(in super::super) fn fits(&self) -> impl Iterator<Item = &[Option<LaunchFit>; 2]> {
        self.throws.iter().map(|result| &result.fits)
    }
}
