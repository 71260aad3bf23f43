//! The least squares of some flights, or of their first samples.

use nalgebra::DVector;

use crate::levenberg::{Known, Problem};
use crate::normal::Block;
use crate::options::Options;
use crate::predict::{By, Loss, linearise};
use crate::setting::Setting;
use crate::track::Track;

/// The sum of squares over the first samples of some flights.
pub struct Squares<'a> {
    /// The model.
    pub setting: &'a Setting,
    /// The flights.
    pub tracks: Vec<&'a Track>,
    /// How many samples of each count.
    pub samples: Vec<usize>,
    /// How residuals count.
    pub loss: Loss<'a>,
    /// The shared unknowns where they are held, and not among the unknowns.
    pub held: Option<&'a DVector<f64>>,
    /// What is known of the shared unknowns.
    pub known: Vec<Known>,
    /// Flights worked on at once.
    pub threads: usize,
    /// Who looks on.
    pub options: &'a Options<'a>,
}

/// How many samples each flight has.
pub fn whole(tracks: &[Track]) -> Vec<usize> {
    tracks.iter().map(|track| track.times.len()).collect()
}

impl<'a> Squares<'a> {
    /// All samples of all flights, by all unknowns.
    pub fn of_all(
        setting: &'a Setting,
        tracks: impl IntoIterator<Item = &'a Track>,
        loss: Loss<'a>,
        options: &'a Options<'a>,
    ) -> Self {
        let tracks: Vec<&Track> = tracks.into_iter().collect();
        Self {
            setting,
            samples: tracks.iter().map(|track| track.times.len()).collect(),
            tracks,
            loss,
            held: None,
            known: setting.shared.iter().map(|shared| shared.known).collect(),
            threads: options.threads(),
            options,
        }
    }

    /// The first samples of one flight, by its own unknowns.
    pub fn of_own(
        setting: &'a Setting,
        track: &'a Track,
        samples: usize,
        loss: Loss<'a>,
        shared: &'a DVector<f64>,
        options: &'a Options<'a>,
    ) -> Self {
        Self {
            setting,
            tracks: vec![track],
            samples: vec![samples],
            loss,
            held: Some(shared),
            known: Vec::new(),
            threads: 1,
            options,
        }
    }
}

impl Problem for Squares<'_> {
    fn flights(&self) -> usize {
        self.tracks.len()
    }

    fn linearise(
        &self,
        flight: usize,
        shared: &DVector<f64>,
        own: &DVector<f64>,
    ) -> Result<Block, String> {
        let (shared, by) = match self.held {
            Some(held) => (held, By::Own),
            None => (shared, By::All),
        };
        let samples = self.samples[flight];
        let track = self.tracks[flight];
        let block = linearise(self.setting, track, (shared, own), samples, by, self.loss);
        if self.held.is_none() {
            self.options.part_done();
        }
        block
    }

    fn moved(&self, flight: usize, own: &DVector<f64>, step: &DVector<f64>) -> DVector<f64> {
        self.tracks[flight].chart.moved(own, step)
    }

    fn known(&self) -> &[Known] {
        &self.known
    }

    fn threads(&self) -> usize {
        self.threads
    }

    fn is_stopped(&self) -> bool {
        self.options.is_stopped()
    }
}
