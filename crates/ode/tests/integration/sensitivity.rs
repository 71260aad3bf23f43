//! Sensitivities against closed forms and against flights that start a little elsewhere.

use crate::rhs;
use ode::{DifferentiableRhs, RhsProperties, Sensitivities};
use ode::{IntegrationOptions, Method, integrate, integrate_at, integrate_with_callback};

/// Driven pendulum with three parameters: stiffness, friction, and one on which the right-hand side does not depend.
struct Pendulum([f64; 3]);

impl Pendulum {
    fn rate(p: &[f64; 3], t: f64, x: &[f64; 2]) -> [f64; 2] {
        [x[1], -p[0] * x[0].sin() - p[1] * x[1].powi(3) + t.cos()]
    }
}

impl DifferentiableRhs for Pendulum {
    fn states(&self) -> usize {
        2
    }
    fn jacobian_pattern(&self) -> &[(usize, usize)] {
        &[(0, 1), (1, 0), (1, 1)]
    }
    fn parameter_jacobian_pattern(&self) -> &[(usize, usize)] {
        &[(1, 0), (1, 1)]
    }
    fn derivative_with_jacobians(
        &mut self,
        t: f64,
        x: &[f64],
        dx: &mut [f64],
        by_state: &mut [f64],
        by_constant: &mut [f64],
    ) {
        dx.copy_from_slice(&Pendulum::rate(&self.0, t, &[x[0], x[1]]));
        by_state.copy_from_slice(&[1.0, -self.0[0] * x[0].cos(), -3.0 * self.0[1] * x[1] * x[1]]);
        by_constant.copy_from_slice(&[-x[0].sin(), -x[1].powi(3)]);
    }
}

impl RhsProperties for Pendulum {}

const P: [f64; 3] = [4.0, 0.1, 9.0];
const X: [f64; 2] = [1.2, -0.7];
/// Columns along the second initial state and the first.
const SWAPPED: [(usize, usize, f64); 2] = [(1, 0, 1.0), (0, 1, 1.0)];

#[test]
fn sensitivities_are_the_slopes_of_flights() {
    let tight = IntegrationOptions {
        method: Method::Dop853,
        ..IntegrationOptions::with_tolerance(1e-12)
    };
    let times = [0.0, 0.3, 1.1, 2.0];
    // Columns: start's second state, start's first, friction, stiffness, nothing, friction again.
    let columns: [(usize, usize); 6] = [(0, 1), (0, 0), (1, 1), (1, 0), (1, 2), (1, 1)];
    let mut pendulum = Pendulum(P);
    let mut both = Sensitivities::new(&mut pendulum, 2, &[1, 0, 2, 1]);
    let mut samples = vec![0.0; both.len() * times.len()];
    let start = both.initial_state(&X, &SWAPPED);
    integrate_at(
        &mut both,
        (0.0, &start),
        &times,
        &tight,
        &mut [],
        &mut samples,
    )
    .unwrap();

    let flown = |p: [f64; 3], x: [f64; 2]| {
        let mut samples = vec![0.0; 2 * times.len()];
        let mut d = rhs(&[], |t, x: &[f64; 2], dx: &mut [f64; 2]| {
            *dx = Pendulum::rate(&p, t, x);
        });
        integrate_at(&mut d, (0.0, &x), &times, &tight, &mut [], &mut samples).unwrap();
        samples
    };
    for (column, (of_constants, which)) in columns.into_iter().enumerate() {
        let moved = |by: f64| {
            let (mut p, mut x) = (P, X);
            if of_constants == 1 {
                p[which] += by;
            } else {
                x[which] += by;
            }
            flown(p, x)
        };
        let (up, down) = (moved(1e-4), moved(-1e-4));
        for (i, at_time) in samples.chunks(both.len()).enumerate() {
            for state in 0..2 {
                let slope = (up[2 * i + state] - down[2 * i + state]) / 2e-4;
                let found = both.layout().padded_row(at_time, state)[column];
                assert!(
                    (slope - found).abs() < 1e-6,
                    "column {column}, state {state} at {} s: {found}, not {slope}",
                    times[i]
                );
            }
        }
    }
}

#[test]
fn steps_are_those_of_the_state_alone() {
    let options = IntegrationOptions::with_tolerance(1e-6);
    let mut plain = rhs(&[], |t, x: &[f64; 2], dx: &mut [f64; 2]| {
        *dx = Pendulum::rate(&P, t, x);
    });
    let alone = integrate(&mut plain, (0.0, &X), 2.0, &options, &mut []).unwrap();
    let mut pendulum = Pendulum(P);
    let mut both = Sensitivities::new(&mut pendulum, 2, &[0, 1]);
    let start = both.initial_state(&X, &SWAPPED);
    let with = integrate(&mut both, (0.0, &start), 2.0, &options, &mut []).unwrap();
    assert_eq!(alone.steps(), with.steps());
    assert_eq!(
        alone.end_state,
        both.layout().state(&with.end_state),
        "the same bits"
    );
}

#[test]
fn an_error_names_states_alone() {
    let mut pendulum = Pendulum([f64::NAN; 3]);
    let mut both = Sensitivities::new(&mut pendulum, 2, &[]);
    let start = both.initial_state(&X, &SWAPPED);
    let error = integrate(
        &mut both,
        (0.0, &start),
        2.0,
        &IntegrationOptions::default(),
        &mut [],
    )
    .unwrap_err();
    insta::assert_snapshot!(error, @r#"
    integration failed at t = 0 s: the derivative of state 1 is NaN
      last state: state 0 = 1.2, state 1 = -0.7
    "#);
}

#[test]
fn what_is_shown_in_passing_is_what_is_written() {
    let options = IntegrationOptions::with_tolerance(1e-6);
    let times = [0.0, 0.0, 0.3, 1.1, 1.1, 2.0];
    let mut pendulum = Pendulum(P);
    let mut both = Sensitivities::new(&mut pendulum, 2, &[1, 0, 2, 1]);
    let start = both.initial_state(&X, &SWAPPED);
    let mut samples = vec![0.0; both.len() * times.len()];
    integrate_at(
        &mut both,
        (0.0, &start),
        &times,
        &options,
        &mut [],
        &mut samples,
    )
    .unwrap();
    let places = both.layout();
    let shown = [places.state_range(), places.row_range(1)];
    let mut next = 0;
    let from = (0.0, &start);
    integrate_with_callback(
        &mut both,
        from,
        &times,
        &options,
        &shown,
        |index, at_time| {
            assert_eq!(index, next);
            let written = &samples[index * start.as_ref().len()..][..start.as_ref().len()];
            for place in &shown {
                for (a, b) in at_time[place.clone()].iter().zip(&written[place.clone()]) {
                    assert!((a - b).abs() < 1e-14, "{a}, not {b}, at {} s", times[index]);
                }
            }
            next += 1;
        },
    )
    .unwrap();
    assert_eq!(next, times.len());
}
