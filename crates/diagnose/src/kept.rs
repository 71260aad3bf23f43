//! Flights that are flown once for all who look at them from one point: most of a look is the flight.

use std::sync::Mutex;

use identify::levenberg::Point;
use identify::normal::Block;
use identify::setting::Setting;

/// Bytes that are kept at most; what is beyond is flown again.
const MOST: usize = 128 << 20;

/// Flights with all sensitivities, flown from one point in one setting.
#[derive(Debug, Default)]
pub struct Kept(Vec<Mutex<Option<Vec<f64>>>>);

/// A point in a setting, and the flights from there.
#[derive(Clone, Copy)]
pub struct Vantage<'p> {
    /// The setting.
    pub setting: &'p Setting,
    /// The point.
    pub point: &'p Point,
    /// Flights from there.
    pub kept: &'p Kept,
}

impl Kept {
    /// For so many flights.
    pub fn of(flights: usize) -> Self {
        Self((0..flights).map(|_| Mutex::new(None)).collect())
    }

    /// Whether there is room for none.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Works on a flight: takes it where it was flown before, and keeps it.
    pub(crate) fn with<R>(
        &self,
        flight: usize,
        work: impl FnOnce(&mut Option<Vec<f64>>) -> R,
    ) -> R {
        let Some(slot) = self.0.get(flight) else {
            return work(&mut None);
        };
        let mut slot = slot.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
        let done = work(&mut slot);
        // Flights are about as long as each other.
        let size = slot.as_ref().map_or(0, |flown| 8 * flown.len());
        if (flight + 1).saturating_mul(size) > MOST {
            *slot = None;
        }
        done
    }
}

/// The normal equations without the terms, whose unknowns stand behind so many others.
pub(crate) fn without_terms(block: &Block, shared: usize) -> Block {
    Block {
        cross: block.cross.columns(0, shared).into_owned(),
        shared: block.shared.view((0, 0), (shared, shared)).into_owned(),
        shared_gradient: block.shared_gradient.rows(0, shared).into_owned(),
        own: block.own.clone(),
        own_gradient: block.own_gradient.clone(),
        ..*block
    }
}
