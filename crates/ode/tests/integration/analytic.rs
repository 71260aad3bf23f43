//! Problems with closed-form solutions or literature values: solution, sensitivities and events.

use crate::rhs;
use ode::{
    DifferentiableRhs, Event, IntegrationOptions, Method, RhsProperties, Sensitivities, integrate,
    integrate_at,
};

/// Harmonic oscillator x'' = -k x, with its Jacobians by (x, v) and by the stiffness k.
struct Oscillator {
    stiffness: f64,
}

impl DifferentiableRhs for Oscillator {
    fn states(&self) -> usize {
        2
    }
    fn jacobian_pattern(&self) -> &[(usize, usize)] {
        &[(0, 1), (1, 0)]
    }
    fn parameter_jacobian_pattern(&self) -> &[(usize, usize)] {
        &[(1, 0)]
    }
    fn derivative_with_jacobians(
        &mut self,
        _: f64,
        x: &[f64],
        dx: &mut [f64],
        jacobian: &mut [f64],
        parameter_jacobian: &mut [f64],
    ) {
        dx.copy_from_slice(&[x[1], -self.stiffness * x[0]]);
        jacobian.copy_from_slice(&[1.0, -self.stiffness]);
        parameter_jacobian[0] = -x[0];
    }
}

impl RhsProperties for Oscillator {}

#[test]
fn sensitivities_of_an_oscillator_equal_their_closed_form() {
    let (stiffness, x0, v0) = (6.25_f64, 1.3, -0.4);
    let frequency = stiffness.sqrt();
    let times: Vec<f64> = (0..=40).map(|i| 0.1 * f64::from(i)).collect();
    for method in [Method::Tsit5, Method::Dop853] {
        let options = IntegrationOptions {
            method,
            ..IntegrationOptions::with_tolerance(1e-12)
        };
        let mut rhs = Oscillator { stiffness };
        let mut augmented = Sensitivities::new(&mut rhs, 2, &[0]);
        let start = augmented.initial_state(&[x0, v0], &[(0, 0, 1.0), (1, 1, 1.0)]);
        let layout = augmented.layout();
        let mut states = vec![0.0; augmented.len() * times.len()];
        let from = (0.0, &start);
        integrate_at(&mut augmented, from, &times, &options, &mut [], &mut states).unwrap();
        for (&t, state) in times.iter().zip(states.chunks(augmented.len())) {
            let (sin, cos) = (frequency * t).sin_cos();
            let by_frequency = -x0 * t * sin + v0 * (t * cos - sin / frequency) / frequency;
            let expected = [cos, sin / frequency, by_frequency / (2.0 * frequency)];
            let x = x0 * cos + v0 * sin / frequency;
            assert!((layout.state(state)[0] - x).abs() < 1e-9);
            for (found, expected) in layout.padded_row(state, 0).iter().zip(expected) {
                assert!(
                    (found - expected).abs() < 1e-9,
                    "{method:?} at t = {t}: {found}, expected {expected}"
                );
            }
        }
    }
}

#[test]
fn the_limit_cycle_of_van_der_pol_has_the_period_of_the_literature() {
    // Period for a damping of 1 (Andersen & Geer, SIAM J. Appl. Math. 42, 1982, among others).
    const PERIOD: f64 = 6.663_286_859_323_13;
    let mut rhs = rhs(&["x", "v"], |_, x: &[f64; 2], dx: &mut [f64; 2]| {
        *dx = [x[1], (1.0 - x[0] * x[0]) * x[1] - x[0]];
    });
    for method in [Method::Tsit5, Method::Dop853] {
        let options = IntegrationOptions {
            method,
            ..IntegrationOptions::with_tolerance(1e-12)
        };
        let mut events = [Event::falls_to("zero", 0, 0.0)];
        let solution = integrate(&mut rhs, (0.0, &[2.0, 0.0]), 80.0, &options, &mut events);
        let crossings = solution.unwrap().events;
        let [.., before, last] = &crossings[..] else {
            panic!("{} crossings", crossings.len())
        };
        let period = last.time - before.time;
        assert!((period - PERIOD).abs() < 1e-9, "{method:?}: {period}");
    }
}

#[test]
fn work_is_counted_and_does_not_grow() {
    // Two turns of a circle: counters catch a slower integrator without a clock.
    let mut evaluations = 0;
    let mut rhs = ode::rhs_from_fn(&[], |_, x: &[f64; 2], dx: &mut [f64; 2]| {
        evaluations += 1;
        *dx = [x[1], -x[0]];
    });
    let t_end = 4.0 * std::f64::consts::PI;
    let mut counted = Vec::new();
    for method in [Method::Tsit5, Method::Dop853] {
        let options = IntegrationOptions {
            method,
            ..IntegrationOptions::with_tolerance(1e-6)
        };
        let solution = integrate(&mut rhs, (0.0, &[1.0, 0.0]), t_end, &options, &mut []).unwrap();
        let stats = solution.stats;
        counted.push((stats.steps, stats.rejected, stats.evaluations));
    }
    let total: usize = counted.iter().map(|(_, _, evaluations)| evaluations).sum();
    assert_eq!(total, evaluations, "every evaluation is counted");
    assert_eq!(counted, [(45, 0, 272), (13, 0, 197)]);
}
