//! Fits that are cancelled.

use std::sync::atomic::{AtomicUsize, Ordering};

use dataset::synthesize::{Plan, flights};
use identify::{CancellationToken, FitError, FitOptions, Progress, fit};
use model_spec::compose::Instrument;

use crate::support::release;
use crate::units_of_readings::{readings, with_readings};

/// Cancels after a number of flights, and counts those that are done.
#[derive(Debug)]
struct CancelAfter {
    flights: usize,
    done: AtomicUsize,
    token: CancellationToken,
}

impl Progress for CancelAfter {
    fn stage_started(&self, _: &str, _: usize) {}

    fn flight_done(&self) {
        if self.done.fetch_add(1, Ordering::Relaxed) >= self.flights {
            self.token.cancel();
        }
    }
}

#[test]
fn a_fit_that_is_cancelled_at_any_flight_ends_as_interrupted() {
    let model = model_spec::load::load("disc", &[]).expect("built in");
    let release = release("backhand", &model);
    let plan = Plan {
        flights: 2,
        duration: Some(0.4),
        ..Plan::default()
    };
    let tracks = flights(&model, &[release], &plan).expect("made").dataset;
    let exact = readings(&model, &tracks, Instrument::Gyroscope);
    let mut turning = with_readings(&tracks, Instrument::Gyroscope, None, |flight, sample| {
        exact[flight][sample]
    });
    turning.markers.clear();
    for flight in &mut turning.flights {
        flight.positions.iter_mut().for_each(Vec::clear);
    }
    for dataset in [tracks, turning] {
        let mut cancelled = 0;
        for flights in std::iter::successors(Some(0), |flights| Some(1 + flights + flights / 2)) {
            let progress = CancelAfter {
                flights,
                done: AtomicUsize::new(0),
                token: CancellationToken::default(),
            };
            let options = FitOptions {
                progress: Some(&progress),
                cancellation: Some(&progress.token),
                threads: Some(1),
                ..FitOptions::default()
            };
            match fit(&model, &dataset, &options) {
                Err(FitError::Interrupted) => {
                    let after = progress.done.into_inner() - flights;
                    assert_eq!(after, 1, "flights done after {flights}");
                    cancelled += 1;
                }
                found => {
                    assert!(found.is_ok(), "{flights}: {:?}", found.err());
                    assert!(!progress.token.is_cancelled());
                    break;
                }
            }
        }
        assert!(cancelled > 4, "{cancelled}");
    }
}
