//! Search of one flight for its ground contact, with the global parameters of a fit held fixed.

use nalgebra::DVector;

use super::LEFT_OUT;
use crate::contact_time::{Onset, contact_time};
use crate::fit::FittedFlight;
use crate::fit::initial_guess::{first_segment, refined_guesses};
use crate::fit::output_error::FixedGlobal;
use crate::noise::NoiseModel;
use crate::observations::Observations;
use dataset::Flight;
use dataset::contact::MIN_UPWARD_PART;
use dataset::levels::FAR_ABOVE;

/// Numbers of samples before and after the last used sample of a truncated flight that are searched again.
const SEARCH_RANGE: (usize, usize) = (12, 14);
/// Number of samples by which the ranges of two successive searches for a ground contact in one flight overlap.
const OVERLAP: usize = 8;

/// Global parameters and noise of the reference fit.
pub struct Search<'a> {
    pub at: FixedGlobal<'a>,
    pub noise: &'a NoiseModel,
    /// Usual residual scale of a flight, m.
    pub usual: f64,
}

impl Search<'_> {
    /// Searches a fitted flight, whose present observations are `present`, and truncates it at its contact. If the
    /// contact at which it is truncated is not confirmed, it gets its whole length back. `None` if nothing changes, or
    /// the model does not predict the flight until there.
    pub fn retruncated(
        &self,
        flight: &Flight,
        present: &Observations,
        local: &DVector<f64>,
    ) -> Option<FittedFlight> {
        let mut whole = Observations::new(self.at.problem, flight).ok()?;
        whole.notes.clone_from(&present.notes);
        let (least, end) = (first_segment(&whole), present.times.len());
        let was_found = present.truncation.is_some();
        let within = match was_found {
            true => (
                end.saturating_sub(SEARCH_RANGE.0).max(least),
                end + SEARCH_RANGE.1,
            ),
            false => (least, end),
        };
        match self.contact(&whole, local.clone(), within) {
            Some((onset, local)) => {
                let is_new = onset.sample != end && (was_found || is_upward(&onset));
                let moved = is_new.then(|| self.truncated(whole, &onset, local))??;
                self.is_within(FAR_ABOVE, &moved).then_some(moved)
            }
            None => {
                let samples = whole.times.len();
                let local = was_found.then(|| self.fitted(&whole, samples, local))??;
                let restored = FittedFlight {
                    observations: whole,
                    state: local,
                };
                self.is_within(LEFT_OUT.0, &restored).then_some(restored)
            }
        }
    }

    /// Truncates an excluded flight at its contact; `None` if none is found, or the flight before it is unlike the
    /// others.
    pub fn excluded_until_contact(&self, flight: &Flight) -> Option<FittedFlight> {
        let whole = Observations::new(self.at.problem, flight).ok()?;
        let guesses = refined_guesses(self.at.flight(&whole)).ok()?;
        let best = guesses.into_iter().min_by(|a, b| a.0.total_cmp(&b.0))?;
        let within = (first_segment(&whole), whole.times.len());
        let (onset, local) = self.contact(&whole, best.1.state, within)?;
        let moved = is_upward(&onset).then(|| self.truncated(whole, &onset, local))??;
        self.is_within(FAR_ABOVE, &moved).then_some(moved)
    }

    /// Whether the residual scale up to the new last sample is at most `ratio` times the usual one.
    fn is_within(&self, ratio: f64, moved: &FittedFlight) -> bool {
        let scale = self.at.flight(&moved.observations).scale(&moved.state);
        scale.is_some_and(|scale| scale <= ratio * self.usual)
    }

    /// Searches the samples `from..to` of `whole` in successive ranges. Returns the contact, and the initial state
    /// fitted to the samples before its range. `local` is the initial guess.
    fn contact(
        &self,
        whole: &Observations,
        mut local: DVector<f64>,
        (from, to): (usize, usize),
    ) -> Option<(Onset, DVector<f64>)> {
        let to = to.min(whole.times.len());
        let mut samples = from;
        while samples < to && !self.at.options.is_past_deadline() {
            // Few samples may not determine all components of the initial state.
            local = self.fitted(whole, samples, &local).unwrap_or(local);
            // A prediction far beyond the fitted samples is not linear in the initial state.
            let until = to.min(2 * samples);
            let unknowns = (self.at.global, &local);
            let sought = samples..until;
            let found = contact_time(self.at.problem, whole, unknowns, self.noise, sought);
            if let Some(onset) = found {
                return Some((onset, local));
            }
            // A contact just before the end of one search is found in the next, whose fit includes samples after it.
            samples = match until < to {
                true => until.saturating_sub(OVERLAP).max(samples + 1),
                false => to,
            };
        }
        None
    }

    /// Truncates the flight `whole` at the contact and fits its initial state to the remaining samples.
    fn truncated(
        &self,
        mut whole: Observations,
        onset: &Onset,
        local: DVector<f64>,
    ) -> Option<FittedFlight> {
        let (sample, jump) = (onset.sample, onset.jump);
        let time = whole.origin + whole.times[sample];
        whole.truncate(
            sample,
            format!(
                "it leaves the free flight that the model predicts, and its velocity jumps by ({:.1}, {:.1}, {:.1}) m/s at t = {time:.3} s, as at a touch of the ground",
                jump.x, jump.y, jump.z
            ),
        );
        let local = self.fitted(&whole, sample, &local)?;
        Some(FittedFlight {
            observations: whole,
            state: local,
        })
    }

    /// Initial state fitted to the first `samples` samples from the guess `start`; `None` if they do not determine it.
    fn fitted(
        &self,
        whole: &Observations,
        samples: usize,
        start: &DVector<f64>,
    ) -> Option<DVector<f64>> {
        let first = self.at.flight(whole).first(samples);
        Some(first.fit(start.clone()).ok()?.1)
    }
}

/// Whether the velocity jump of a detected contact is sufficiently upward for a contact with the ground.
fn is_upward(onset: &Onset) -> bool {
    onset.jump.z > MIN_UPWARD_PART * onset.jump.norm()
}
