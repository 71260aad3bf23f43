//! Contacts of a disc and of a ball, detected with the model that simulates the flights.

use ::flight::release::{Vocabulary, built_in, read};
use nalgebra::Vector3;

use super::{Onset, contact_time};
use crate::fit::FixedGlobal;
use crate::fit::tests::pushed;
use crate::noise::{AxesNoise, NoiseModel};
use crate::observations::Observations;
use crate::options::FitOptions;
use crate::problem::FitProblem;
use dataset::Flight;
use dataset::synthesize::{Corruption, Plan, flights};

/// Number of samples at the start of a flight to which its initial state is fitted; contacts with the ground are
/// searched in the later samples.
const SHOWN: usize = 30;

/// First contact with the ground or an object found in each of 12 simulated flights, with the true parameter values of
/// the model. The flights are simulated with the named model and launch conditions, and then modified by `change`,
/// which receives the index of the flight and the flight.
fn contacts(
    (model, release): (&str, &str),
    noise: Corruption,
    change: impl Fn(usize, &Flight) -> Flight,
) -> Vec<Option<Onset>> {
    let model = model_spec::load::load(model, &[]).unwrap();
    let release = read(release, built_in(release).unwrap(), |_| {
        Ok(Vocabulary::of(&model))
    });
    let plan = Plan {
        flights: 12,
        duration: Some(0.5),
        noise,
        ..Plan::default()
    };
    let made = flights(&model, &[release.unwrap()], &plan).unwrap();
    let problem = FitProblem::new(&model, &made.dataset, &FitOptions::default()).unwrap();
    let global = problem.model_values();
    let at = FixedGlobal {
        problem: &problem,
        global: &global,
        options: &FitOptions::default(),
    };
    let mut axes = AxesNoise::white(noise.sigma, 1.0 / plan.rate);
    axes.ar1 = [noise.ar1; 3];
    let noise = NoiseModel::from(axes);
    let each = made
        .dataset
        .flights
        .iter()
        .enumerate()
        .map(|(index, flight)| {
            let changed = Observations::new(&problem, &change(index, flight)).unwrap();
            let guesses = crate::initial_state::initial_guesses(&problem, &changed).unwrap();
            let start = guesses[0].state.clone();
            let fitted = at.flight(&changed).first(SHOWN).fit(start);
            let (_, local) = fitted.unwrap();
            let end = changed.times.len();
            let tried = SHOWN..end;
            contact_time(&problem, &changed, (&global, &local), &noise, tried)
        });
    each.collect()
}

/// Measurement errors that make the detection hard: correlated noise with outliers and missing markers.
const HARD: Corruption = Corruption {
    sigma: 0.0015,
    ar1: 0.6,
    outliers: 0.01,
    outlier_size: 0.05,
    dropouts: 0.12,
};

#[test]
fn a_contact_is_timed_within_two_samples() {
    for case in [("disc", "backhand"), ("ball", "serve")] {
        for noise in [Corruption::default(), HARD] {
            let push = Vector3::new(-0.3, 0.1, 0.8);
            let found = contacts(case, noise, |index, flight| {
                pushed(flight, 34.5 + index as f64, push)
            });
            let in_time = found.iter().enumerate().filter(|(index, found)| {
                found.as_ref().is_some_and(|found| {
                    found.sample.abs_diff(35 + index) <= 2 && (found.jump - push).norm() < 0.6
                })
            });
            // Outliers and missing markers may spoil one flight.
            assert!(in_time.count() >= 11, "{case:?}: {found:?}");
        }
    }
}

#[test]
fn a_flight_that_touches_nothing_has_no_contact() {
    for case in [("disc", "backhand"), ("ball", "serve")] {
        for noise in [Corruption::default(), HARD] {
            let found = contacts(case, noise, |_, flight| flight.clone());
            assert!(found.iter().all(Option::is_none), "{case:?}: {found:?}");
        }
    }
}

#[test]
fn a_smooth_departure_is_no_contact() {
    let found = contacts(("disc", "backhand"), Corruption::default(), |_, flight| {
        let mut flight = flight.clone();
        for (time, row) in flight.times.iter().zip(&mut flight.positions) {
            for point in row.iter_mut().flatten() {
                // A force of a fifth of the weight that the model does not contain.
                point[2] += 0.5 * 2.0 * time * time;
            }
        }
        flight
    });
    assert!(found.iter().all(Option::is_none), "{found:?}");
}
