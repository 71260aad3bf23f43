//! Flights that are flown once for all who look at them from one point: most of a look is the flight.

use std::sync::Mutex;

use identify::{FitProblem, Iterate, NormalBlock};

/// Bytes that are kept at most; what is beyond is flown again.
const MOST: usize = 128 << 20;

/// Flights with all sensitivities, flown from one point in one setting.
#[derive(Debug, Default)]
pub struct Kept(Vec<Mutex<Option<Vec<f64>>>>);

/// A point in a setting, and the flights from there.
#[derive(Clone, Copy)]
pub struct Vantage<'p> {
    /// The setting.
    pub problem: &'p FitProblem,
    /// The point.
    pub point: &'p Iterate,
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
pub(crate) fn without_terms(block: &NormalBlock, global: usize) -> NormalBlock {
    NormalBlock {
        cross: block.cross.columns(0, global).into_owned(),
        global: block.global.view((0, 0), (global, global)).into_owned(),
        global_gradient: block.global_gradient.rows(0, global).into_owned(),
        local: block.local.clone(),
        local_gradient: block.local_gradient.clone(),
        ..*block
    }
}

#[cfg(test)]
mod tests {
    use identify::{FitOptions, NoiseModel, fit};

    use super::*;
    use crate::bench::Bench;
    use crate::catalogue::Catalogue;

    #[test]
    fn a_kept_flight_is_seen_as_one_that_is_flown_again() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/mystery");
        let mut dataset = identify::dataset::load(folder.as_ref()).unwrap();
        dataset.flights.truncate(3);
        let model = model_spec::load::load("disc", &[]).unwrap();
        let options = FitOptions::default();
        let fitted = fit(&model, &dataset, &options).unwrap();
        let catalogue = Catalogue::new(&model, &[], &[]).unwrap();
        let (bench, point) = Bench::new(&catalogue, &dataset, &fitted, &options).unwrap();
        let problem = &bench.problem;
        let point = &point;
        let look = |kept: &Kept, noise: &NoiseModel| {
            let from = Vantage {
                problem,
                point,
                kept,
            };
            bench.look_further(from, noise).unwrap()
        };
        let (one, other) = (fitted.noise(), NoiseModel::white(0.01, 0.01));
        let kept = Kept::of(bench.observation_sets.len());
        assert_eq!(look(&kept, one), look(&Kept::default(), one));
        assert!(kept.0.iter().all(|slot| slot.lock().unwrap().is_some()));
        assert_eq!(look(&kept, &other), look(&Kept::default(), &other));
        // The terms only come behind.
        let further = look(&kept, one);
        let global = point.global.len();
        assert!(further[0].global.nrows() > global);
        let further: Vec<NormalBlock> = further.iter().map(|b| without_terms(b, global)).collect();
        assert_eq!(further, bench.look(problem, point, one).unwrap());
    }

    #[test]
    fn what_is_too_much_is_not_kept() {
        let kept = Kept::of(2);
        let half = MOST / 8 - 1;
        for flight in [0, 1] {
            kept.with(flight, |flown| *flown = Some(vec![0.0; half]));
        }
        assert!(kept.with(0, |flown| flown.is_some()));
        assert!(kept.with(1, |flown| flown.is_none()));
    }
}
