//! Events are found where they are, and flights that cannot be flown say why.

use crate::{disc, rhs};
use ode::{
    Event, IntegrationError, IntegrationFailure, IntegrationOptions, Method, integrate,
    integrate_at, integrate_to_end, integrate_to_event,
};
use proptest::prelude::*;

const METHODS: [Method; 2] = [Method::Tsit5, Method::Dop853];

/// Right-hand side of a stone in free fall; the state is its height and its vertical velocity.
fn stone(_: f64, x: &[f64; 2], dx: &mut [f64; 2]) {
    *dx = [x[1], -9.81];
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..Default::default() })]

    #[test]
    fn a_stone_lands_when_it_should(height in 0.0..100.0_f64, speed in -20.0..20.0_f64, step in 0.05..5.0_f64) {
        prop_assume!(height > 0.0 || speed > 0.0);
        for method in METHODS {
            // Long steps too, in which it rises and lands at once.
            let options = IntegrationOptions { method, max_step: step, ..IntegrationOptions::default() };
            let mut events = [Event::falls_to("ground", 0, 0.0).terminal(), Event::peak_of("apex", 0)];
            let flight = integrate_to_event(&mut rhs(&["z", "vz"], stone), (0.0, &[height, speed]), 20.0, &options, &mut events).unwrap();
            let lands = (speed + (speed * speed + 2.0 * 9.81 * height).sqrt()) / 9.81;
            prop_assert!((flight.end - lands).abs() < 3e-12 * lands.max(1.0), "{} is {}", flight.end, lands);
            prop_assert!(flight.end_state[0].abs() < 1e-10 && flight.end_state[0] <= 0.0);
            prop_assert_eq!(flight.terminal_event.as_deref(), Some("ground"));
            let apex = flight.events.iter().find(|e| e.event == "apex");
            prop_assert_eq!(apex.is_some(), speed > 0.0);
            if let Some(apex) = apex {
                prop_assert!((apex.time - speed / 9.81).abs() < 3e-12);
                prop_assert!((apex.state[0] - (height + speed * speed / 2.0 / 9.81)).abs() < 1e-10);
            }
        }
    }
}

#[test]
fn every_crossing_is_recorded_in_order() {
    let mut d = rhs(&[], |_, x: &[f64; 2], dx: &mut [f64; 2]| {
        *dx = [x[1], -x[0]];
    });
    for method in METHODS {
        let mut events = [
            Event::falls_to("falls", 0, 0.0),
            Event::falling("rises", |_, x: &[f64; 2]| -x[0]),
            Event::falling("half", |_, x: &[f64; 2]| x[0] - 0.5),
        ];
        let options = IntegrationOptions {
            method,
            ..IntegrationOptions::with_tolerance(1e-11)
        };
        let flight = integrate(&mut d, (0.0, &[1.0, 0.0]), 10.0, &options, &mut events).unwrap();
        let found: Vec<_> = flight.events.iter().map(|e| (&*e.event, e.time)).collect();
        let pi = std::f64::consts::PI;
        let expected = [
            ("half", pi / 3.0),
            ("falls", pi / 2.0),
            ("rises", 1.5 * pi),
            ("half", 7.0 * pi / 3.0),
            ("falls", 2.5 * pi),
        ];
        assert_eq!(found.len(), 5, "{found:?}");
        for (found, expected) in found.iter().zip(expected) {
            assert_eq!(found.0, expected.0);
            assert!(
                (found.1 - expected.1).abs() < 1e-9,
                "{found:?} is not {expected:?}"
            );
        }
    }
}

#[test]
fn two_crossings_in_one_step_are_both_found() {
    // It dips below 0 from 0.9 to 1.1, in one step.
    let mut d = rhs(&[], |t, _: &[f64; 1], dx: &mut [f64; 1]| {
        dx[0] = 2.0 * (t - 1.0);
    });
    for method in METHODS {
        let options = IntegrationOptions {
            method,
            first_step: Some(2.0),
            ..IntegrationOptions::default()
        };
        let events: [fn() -> Event<'static, [f64; 1]>; 3] = [
            || Event::falls_to("0.9", 0, 0.0),
            || Event::falling("0.9", |_, x: &[f64; 1]| x[0]),
            || Event::falling("1.1", |_, x: &[f64; 1]| -x[0]),
        ];
        // One by one: what one finds, the others would be looked for too.
        for event in events {
            let flight = integrate(&mut d, (0.0, &[0.99]), 2.0, &options, &mut [event()]).unwrap();
            assert_eq!(flight.stats.steps, 1);
            let [found] = &flight.events[..] else {
                panic!("{:?}", flight.events)
            };
            let expected: f64 = found.event.parse().unwrap();
            assert!((found.time - expected).abs() < 1e-12, "{found:?}");
        }
    }
}

#[test]
fn a_peak_between_two_rises_is_found() {
    // It rises, falls from 0.9 to 1.1, and rises again, in one step.
    let mut d = rhs(&[], |t, _: &[f64; 1], dx: &mut [f64; 1]| {
        dx[0] = (t - 0.9) * (t - 1.1);
    });
    for method in METHODS {
        let options = IntegrationOptions {
            method,
            first_step: Some(2.0),
            ..IntegrationOptions::default()
        };
        let peak = Event::peak_of("peak", 0);
        let flight = integrate(&mut d, (0.0, &[0.0]), 2.0, &options, &mut [peak]).unwrap();
        assert_eq!((flight.stats.steps, flight.events.len()), (1, 1));
        assert!((flight.events[0].time - 0.9).abs() < 1e-12);
    }
}

#[test]
fn samples_beyond_the_landing_are_the_landing() {
    let mut samples = [0.0; 8];
    let mut ground = [Event::falls_to("ground", 0, 0.0).terminal()];
    let times = [0.0, 0.5, 1.5, 2.0];
    let end = integrate_at(
        &mut rhs(&[], stone),
        (0.0, &[5.0, 0.0]),
        &times,
        &IntegrationOptions::default(),
        &mut ground,
        &mut samples,
    )
    .unwrap();
    assert!((end.time - (10.0 / 9.81_f64).sqrt()).abs() < 1e-12);
    assert_eq!(samples[..2], [5.0, 0.0]);
    assert!((samples[2] - (5.0 - 9.81 / 8.0)).abs() < 1e-12);
    assert_eq!(samples[4..6], end.state);
    assert_eq!(samples[6..8], end.state);
}

/// Message of the error with which an integration failed; panics if it succeeded or if the error contains a state that
/// is not finite.
#[track_caller]
fn refused<T: std::fmt::Debug>(flight: Result<T, IntegrationError>) -> String {
    let error = flight.expect_err("no such flight");
    assert!(error.states.iter().all(|(_, v)| v.is_finite()));
    error.to_string()
}

#[test]
fn a_model_without_an_answer() {
    // A cliff at x = 1: no rate of change beyond.
    let cliff = |_: f64, x: &[f64; 2], dx: &mut [f64; 2]| *dx = [x[1], (1.0 - x[0]).sqrt()];
    for method in METHODS {
        let options = IntegrationOptions {
            method,
            ..IntegrationOptions::default()
        };
        let error = integrate(
            &mut rhs(&["x", "v"], cliff),
            (0.0, &[0.0, 1.0]),
            5.0,
            &options,
            &mut [],
        )
        .unwrap_err();
        assert!(
            matches!(&error.cause, IntegrationFailure::NonFiniteDerivative { state, rate } if state == "v" && rate.is_nan()),
            "{error}"
        );
        assert!(error.states[0].1 <= 1.0 && error.states[0].1 > 1.0 - 1e-6);
    }
    let never = |_: f64, _: &[f64; 1], dx: &mut [f64; 1]| dx[0] = f64::INFINITY;
    insta::assert_snapshot!(refused(integrate(&mut rhs(&["z"], never), (0.0, &[2.0]), 1.0, &IntegrationOptions::default(), &mut [])), @r#"
    integration failed at t = 0 s: the derivative of z is inf
      last state: z = 2
    "#);
    insta::assert_snapshot!(refused(integrate(&mut rhs(&["x", "v"], cliff), (0.0, &[0.0, 1.0]), 5.0, &IntegrationOptions::default(), &mut [])), @r#"
    integration failed at t = 0.7613056 s: the derivative of v is NaN
      last state: x = 1, v = 1.527524
    "#);
}

#[test]
fn a_state_that_grows_without_bound() {
    let explosion = |_: f64, x: &[f64; 1], dx: &mut [f64; 1]| dx[0] = x[0] * x[0];
    insta::assert_snapshot!(refused(integrate(&mut rhs(&["x"], explosion), (0.0, &[1.0]), 2.0, &IntegrationOptions::default(), &mut [])), @r#"
    integration failed at t = 1.000001 s: step size below minimum (1.907e-14 s): d(x)/dt is 9.184e25
      last state: x = 9.583e12
    "#);
    let overflow = |_: f64, x: &[f64; 1], dx: &mut [f64; 1]| dx[0] = 1e300 * x[0].signum();
    insta::assert_snapshot!(refused(integrate(&mut rhs(&["x"], overflow), (0.0, &[1.0]), 1e10, &IntegrationOptions::default(), &mut [])), @r#"
    integration failed at t = 0 s: step size below minimum (0 s): d(x)/dt is 1.000e300
      last state: x = 1
    "#);
}

#[test]
fn a_stiff_model_ends_by_the_count_of_steps() {
    let stiff = |t: f64, x: &[f64; 1], dx: &mut [f64; 1]| dx[0] = -1e9 * (x[0] - t.cos());
    let options = IntegrationOptions {
        max_steps: 5000,
        ..IntegrationOptions::default()
    };
    insta::assert_snapshot!(refused(integrate(&mut rhs(&["x"], stiff), (0.0, &[1.0]), 10.0, &options, &mut [])), @r#"
    integration failed at t = 1.767e-5 s: the end was not reached in 5000 steps
      last state: x = 0.9999987
    "#);
}

#[test]
fn limits_grounds_and_times_that_do_not_come() {
    let limit = || {
        Event::limit("it is 10 m below the cliff's edge", |_, x: &[f64; 2]| {
            x[0] + 10.0
        })
    };
    let ground = || Event::falls_to("ground", 0, 0.0).terminal();
    let mut d = rhs(&["z", "vz"], stone);
    let options = IntegrationOptions::default();
    insta::assert_snapshot!(refused(integrate(&mut d, (0.0, &[0.0, 2.0]), 10.0, &options, &mut [limit()])), @r#"
    integration failed at t = 1.646198 s: limit of validity of the model: it is 10 m below the cliff's edge
      last state: z = -10, vz = -14.1492
    "#);
    insta::assert_snapshot!(refused(integrate(&mut d, (0.0, &[-11.0, 2.0]), 10.0, &options, &mut [limit()])), @r#"
    integration failed at t = 0 s: limit of validity of the model: it is 10 m below the cliff's edge
      last state: z = -11, vz = 2
    "#);
    insta::assert_snapshot!(refused(integrate(&mut d, (0.0, &[0.0, -2.0]), 10.0, &options, &mut [ground()])), @r#"
    invalid initial state: it is already past the terminal event (ground)
      last state: z = 0, vz = -2
    "#);
    insta::assert_snapshot!(refused(integrate(&mut d, (0.0, &[-0.5, 20.0]), 10.0, &options, &mut [ground()])), @r#"
    invalid initial state: it is already past the terminal event (ground)
      last state: z = -0.5, vz = 20
    "#);
    insta::assert_snapshot!(refused(integrate_to_event(&mut d, (0.0, &[500.0, 0.0]), 5.0, &options, &mut [ground()])), @r#"
    integration failed at t = 5 s: no terminal event occurred (expected: ground)
      last state: z = 377.375, vz = -49.05
    "#);
    // Up from the ground is no landing.
    assert!(
        integrate_to_event(&mut d, (0.0, &[0.0, 2.0]), 10.0, &options, &mut [ground()]).is_ok()
    );
}

#[test]
fn starts_that_are_no_numbers() {
    let mut d = rhs(&["z", "vz"], stone);
    let fly_with = |d: &mut _, x: [f64; 2], end: f64, options: IntegrationOptions| {
        refused(integrate_to_end(d, (0.0, &x), end, &options, &mut []))
    };
    let some = IntegrationOptions::default;
    insta::assert_snapshot!(fly_with(&mut d, [1.0, f64::NAN], 1.0, some()), @"invalid integration input: the initial vz is NaN");
    insta::assert_snapshot!(fly_with(&mut d, [1.0, 0.0], 0.0, some()), @"invalid integration input: the time from start to end (s) is 0");
    insta::assert_snapshot!(fly_with(&mut d, [1.0, 0.0], f64::INFINITY, some()), @"invalid integration input: the final time (s) is inf");
    insta::assert_snapshot!(fly_with(&mut d, [1.0, 0.0], 1.0, IntegrationOptions { rtol: -1e-6, ..some() }), @"invalid integration input: rtol is -0.000001");
    insta::assert_snapshot!(fly_with(&mut d, [1.0, 0.0], 1.0, IntegrationOptions { first_step: Some(f64::NAN), ..some() }), @"invalid integration input: first_step (s) is NaN");
}

#[test]
fn a_disc_lands_within_tolerance_of_where_it_lands() {
    let ground = || Event::falls_to("ground", 2, 0.0).terminal();
    let tight = IntegrationOptions {
        method: Method::Dop853,
        ..IntegrationOptions::with_tolerance(1e-13)
    };
    let exact = integrate_to_event(
        &mut disc::disc(),
        (0.0, &disc::THROW),
        20.0,
        &tight,
        &mut [ground()],
    )
    .unwrap();
    for method in METHODS {
        let options = IntegrationOptions {
            method,
            ..IntegrationOptions::default()
        };
        let found = integrate_to_event(
            &mut disc::disc(),
            (0.0, &disc::THROW),
            20.0,
            &options,
            &mut [ground()],
        )
        .unwrap();
        assert!(
            (exact.end - found.end).abs() < 1e-6
                && (exact.end_state[0] - found.end_state[0]).abs() < 1e-5
        );
        assert!(found.end_state[2].abs() < 1e-11);
    }
}
