//! Search of one flight for its ground contact, with the global parameters of a fit held fixed.

use nalgebra::DVector;

use super::LEFT_OUT_RATIO;
use crate::contact_time::{Onset, contact_time};
use crate::fit::initial_guess::{first_segment, refined_guesses};
use crate::fit::one_flight::FixedGlobal;
use crate::fit::taking_back::LIKE_RATIO;
use crate::ground_contact::MIN_UPWARD_PART;
use crate::noise::NoiseModel;
use crate::observations::Observations;
use dataset::Flight;

/// Range in which the ground contact of a truncated flight is searched again: numbers of samples before and after its
/// last used sample, which was determined without the fitted model.
const SEARCH_RANGE: (usize, usize) = (12, 14);
/// Number of samples by which the ranges of two successive searches for a ground contact in one flight overlap.
const OVERLAP: usize = 8;

/// A flight whose last used sample was changed in the search for a ground contact: its observations up to the new last
/// sample, and the initial state fitted to them.
pub struct Retruncated {
    pub observations: Observations,
    pub local: DVector<f64>,
}

/// Data for the search for ground contacts: the global parameters and the noise from the reference fit, which leaves
/// out flights that may contain a ground contact.
pub struct Search<'a> {
    pub at: FixedGlobal<'a>,
    pub noise: &'a NoiseModel,
    /// Usual residual scale (robust standard deviation of residuals) of a flight, m: the median over the flights of the
    /// reference fit, which leaves out flights that may contain a ground contact; or `sigma0` if that is greater.
    pub usual: f64,
}

impl Search<'_> {
    /// Searches a fitted flight for its ground contact, and returns the flight truncated there. `present` are the
    /// observations used so far and `local` the initial state fitted to them. If the search does not confirm the
    /// contact at which `present` is truncated, the flight is returned with its whole length. `None` if the last used
    /// sample of the flight does not change, or if the model does not predict the flight until there.
    pub fn retruncated(
        &self,
        flight: &Flight,
        present: &Observations,
        local: &DVector<f64>,
    ) -> Option<Retruncated> {
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
                self.is_within(LIKE_RATIO, &moved).then_some(moved)
            }
            None => {
                let samples = whole.times.len();
                let local = was_found.then(|| self.fitted(&whole, samples, local))??;
                let restored = Retruncated {
                    observations: whole,
                    local,
                };
                self.is_within(LEFT_OUT_RATIO, &restored)
                    .then_some(restored)
            }
        }
    }

    /// Truncates an excluded flight at its ground contact. The flight was excluded because no fit predicts its whole
    /// length. `None` if no contact is found, if the velocity jump at the contact is not upward, or if the residuals
    /// before the contact are far larger than those of the fitted flights.
    pub fn excluded_until_contact(&self, flight: &Flight) -> Option<Retruncated> {
        let whole = Observations::new(self.at.problem, flight).ok()?;
        let guesses = refined_guesses(self.at, &whole).ok()?;
        let best = guesses.into_iter().min_by(|a, b| a.0.total_cmp(&b.0))?;
        let within = (first_segment(&whole), whole.times.len());
        let (onset, local) = self.contact(&whole, best.1.state, within)?;
        let moved = is_upward(&onset).then(|| self.truncated(whole, &onset, local))??;
        self.is_within(LIKE_RATIO, &moved).then_some(moved)
    }

    /// Whether the residual scale (robust standard deviation of the residuals) of a flight up to its new last sample is
    /// at most `ratio` times `self.usual`, the residual scale that is typical of the fitted flights.
    fn is_within(&self, ratio: f64, moved: &Retruncated) -> bool {
        let (observations, local) = (&moved.observations, &moved.local);
        let samples = observations.times.len();
        let scale = self.at.residual_scale(observations, local, samples);
        scale.is_some_and(|scale| scale <= ratio * self.usual)
    }

    /// Searches the samples `from..to` of the flight `whole` for the first ground contact, in successive ranges.
    /// Returns the contact, and the initial state fitted to the samples before the range of the contact; `None` if no
    /// contact was found. `local` is the initial guess of the initial state.
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
            // A contact just before the end of one search is detected in the next one, whose fit still includes the
            // samples after it.
            samples = match until < to {
                true => until.saturating_sub(OVERLAP).max(samples + 1),
                false => to,
            };
        }
        None
    }

    /// Truncates the flight `whole` at the contact `onset` and fits its initial state to the remaining samples,
    /// starting from `local`; `None` if these samples do not determine it.
    fn truncated(
        &self,
        mut whole: Observations,
        onset: &Onset,
        local: DVector<f64>,
    ) -> Option<Retruncated> {
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
        Some(Retruncated {
            observations: whole,
            local,
        })
    }

    /// Initial state of the flight `whole`, fitted to its first `samples` samples from the initial guess `start`;
    /// `None` if these samples do not determine it.
    fn fitted(
        &self,
        whole: &Observations,
        samples: usize,
        start: &DVector<f64>,
    ) -> Option<DVector<f64>> {
        let found = self.at.fit_initial_state(whole, samples, start.clone());
        Some(found.ok()?.1)
    }
}

/// Whether the velocity jump of a detected contact is sufficiently upward for a contact with the ground.
fn is_upward(onset: &Onset) -> bool {
    onset.jump.z > MIN_UPWARD_PART * onset.jump.norm()
}
