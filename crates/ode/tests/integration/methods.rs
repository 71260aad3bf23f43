//! The methods do what their orders promise.

use crate::{disc, rhs};
use ode::{IntegrationOptions, Method, integrate, integrate_at, integrate_to_end};
use proptest::prelude::*;

/// Options for steps of one length: the tolerances are so large that the error test never rejects a step.
fn even(method: Method, step: f64) -> IntegrationOptions {
    IntegrationOptions {
        method,
        rtol: 1e3,
        atol: 1e3,
        max_step: step,
        first_step: Some(step),
        ..IntegrationOptions::default()
    }
}

/// Right-hand side of a driven pendulum with friction: nonlinear, smooth and dependent on time.
fn pendulum(t: f64, x: &[f64; 2], dx: &mut [f64; 2]) {
    *dx = [
        x[1],
        -9.0 * x[0].sin() - 0.03 * x[1].powi(3) + (2.0 * t).cos(),
    ];
}

/// Errors of an integration of the pendulum with the given number of equal steps, relative to an integration with a
/// tight tolerance. Returns the error at the final time, and the maximum error of the dense output over time.
fn errors(method: Method, steps: u32) -> (f64, f64) {
    let tight = IntegrationOptions {
        method: Method::Dop853,
        ..IntegrationOptions::with_tolerance(1e-14)
    };
    let x = [1.0, 0.5];
    let exact = integrate(&mut rhs(&[], pendulum), (0.0, &x), 0.6, &tight, &mut []).unwrap();
    let found = integrate(
        &mut rhs(&[], pendulum),
        (0.0, &x),
        0.6,
        &even(method, 0.6 / f64::from(steps)),
        &mut [],
    )
    .unwrap();
    let apart = |t: f64| {
        let (a, b) = (exact.sample(t).unwrap(), found.sample(t).unwrap());
        (a[0] - b[0]).abs().max((a[1] - b[1]).abs())
    };
    assert_eq!(found.stats.steps, steps as usize);
    (
        apart(0.6),
        (0..=997)
            .map(|i| apart(f64::from(i) * 0.6 / 997.0))
            .fold(0.0, f64::max),
    )
}

fn order(coarse: f64, fine: f64, ratio: f64) -> f64 {
    (coarse / fine).ln() / ratio.ln()
}

#[test]
fn errors_shrink_by_the_order_of_the_method_and_its_curve() {
    for (method, steps, at_end, along) in
        [(Method::Tsit5, 16, 5.0, 5.0), (Method::Dop853, 4, 8.0, 7.6)]
    {
        let (coarse, fine) = (errors(method, steps), errors(method, 2 * steps));
        let (end, curve) = (order(coarse.0, fine.0, 2.0), order(coarse.1, fine.1, 2.0));
        // A curve of order p within a step is p + 1 in its error.
        assert!(end > at_end - 0.4, "{method:?}: order {end} at the end");
        assert!(
            curve > along - 0.4,
            "{method:?}: order {curve} along the curve"
        );
        assert!(fine.1 < 30.0 * fine.0.max(1e-9), "{method:?}: {fine:?}");
    }
}

#[test]
fn polynomials_in_time_are_exact() {
    // A quadrature of t^k is exact for k below the order, a curve for k below its own.
    for (method, quadrature, curve) in [(Method::Tsit5, 4, 3), (Method::Dop853, 7, 6)] {
        for power in 0..=quadrature {
            let mut d = rhs(&[], |t: f64, _: &[f64; 1], dx: &mut [f64; 1]| {
                dx[0] = t.powi(power);
            });
            let integral = |t: f64| t.powi(power + 1) / f64::from(power + 1);
            let flight =
                integrate(&mut d, (0.0, &[0.0]), 1.0, &even(method, 1.0), &mut []).unwrap();
            assert!(
                (flight.end_state[0] - integral(1.0)).abs() < 1e-14,
                "{method:?} t^{power}"
            );
            if power <= curve {
                for t in [0.1, 0.37, 0.5, 0.93] {
                    assert!(
                        (flight.sample(t).unwrap()[0] - integral(t)).abs() < 1e-14,
                        "{method:?} t^{power} at {t}"
                    );
                }
            }
        }
    }
}

#[test]
fn the_two_methods_and_both_kinds_of_storage_agree_on_a_disc() {
    let tight = |method| IntegrationOptions {
        method,
        ..IntegrationOptions::with_tolerance(1e-12)
    };
    let a = integrate_to_end(
        &mut disc::disc(),
        (0.0, &disc::THROW),
        1.5,
        &tight(Method::Tsit5),
        &mut [],
    )
    .unwrap();
    let b = integrate_to_end(
        &mut disc::disc(),
        (0.0, &disc::THROW),
        1.5,
        &tight(Method::Dop853),
        &mut [],
    )
    .unwrap();
    for i in 0..12 {
        assert!(
            (a.state[i] - b.state[i]).abs() < 1e-9,
            "{}: {} and {}",
            disc::NAMES[i],
            a.state[i],
            b.state[i]
        );
    }
    #[allow(clippy::borrowed_box)] // the storage is the box
    let mut boxed = rhs(&disc::NAMES, |_, x: &Box<[f64]>, dx: &mut Box<[f64]>| {
        let to: &mut [f64; 12] = (&mut **dx).try_into().unwrap();
        disc::rate((&**x).try_into().unwrap(), &disc::DISC, &disc::AIR, to);
    });
    let x: Box<[f64]> = disc::THROW.into();
    let c = integrate_to_end(&mut boxed, (0.0, &x), 1.5, &tight(Method::Tsit5), &mut []).unwrap();
    assert_eq!(a.state[..], c.state[..], "the same bits in a box");
}

#[test]
fn a_tolerance_is_kept_and_costs_no_more_than_it_must() {
    let tight = IntegrationOptions {
        method: Method::Dop853,
        ..IntegrationOptions::with_tolerance(1e-13)
    };
    let exact = integrate(&mut disc::disc(), (0.0, &disc::THROW), 1.5, &tight, &mut []).unwrap();
    for (tolerance, most) in [(1e-4, 520), (1e-6, 960), (1e-8, 2300)] {
        for method in [Method::Tsit5, Method::Dop853] {
            let options = IntegrationOptions {
                method,
                ..IntegrationOptions::with_tolerance(tolerance)
            };
            let flight = integrate(
                &mut disc::disc(),
                (0.0, &disc::THROW),
                1.5,
                &options,
                &mut [],
            )
            .unwrap();
            for (t, x) in flight.at_rate(500.0) {
                let exact = exact.sample(t).unwrap();
                for i in 0..3 {
                    assert!(
                        (x[i] - exact[i]).abs() < tolerance,
                        "{method:?} at {tolerance}: {} at {t} s",
                        disc::NAMES[i]
                    );
                }
            }
            let of_curve = if method == Method::Dop853 {
                3 * flight.stats.steps
            } else {
                0
            };
            assert!(
                flight.stats.evaluations - of_curve < most,
                "{method:?} at {tolerance}: {:?}",
                flight.stats
            );
        }
    }
}

#[test]
fn a_free_rigid_body_keeps_its_energy_and_angular_momentum() {
    let inertia = [1.0, 2.0, 3.5];
    // Quaternion of the attitude, then the angular velocity in the body.
    let mut body = rhs(&[], |_, x: &[f64; 7], dx: &mut [f64; 7]| {
        let [q0, q1, q2, q3, p, q, r] = *x;
        dx[0] = 0.5 * (-q1 * p - q2 * q - q3 * r);
        dx[1] = 0.5 * (q0 * p + q2 * r - q3 * q);
        dx[2] = 0.5 * (q0 * q + q3 * p - q1 * r);
        dx[3] = 0.5 * (q0 * r + q1 * q - q2 * p);
        dx[4] = (inertia[1] - inertia[2]) * q * r / inertia[0];
        dx[5] = (inertia[2] - inertia[0]) * r * p / inertia[1];
        dx[6] = (inertia[0] - inertia[1]) * p * q / inertia[2];
    });
    let invariants = |x: &[f64]| {
        let [q0, q1, q2, q3] = [x[0], x[1], x[2], x[3]];
        let h = [inertia[0] * x[4], inertia[1] * x[5], inertia[2] * x[6]];
        let rows = [
            [
                q0 * q0 + q1 * q1 - q2 * q2 - q3 * q3,
                2.0 * (q1 * q2 - q0 * q3),
                2.0 * (q1 * q3 + q0 * q2),
            ],
            [
                2.0 * (q1 * q2 + q0 * q3),
                q0 * q0 - q1 * q1 + q2 * q2 - q3 * q3,
                2.0 * (q2 * q3 - q0 * q1),
            ],
            [
                2.0 * (q1 * q3 - q0 * q2),
                2.0 * (q2 * q3 + q0 * q1),
                q0 * q0 - q1 * q1 - q2 * q2 + q3 * q3,
            ],
        ];
        let h_n = rows.map(|row| row[0] * h[0] + row[1] * h[1] + row[2] * h[2]);
        let energy = 0.5 * (x[4] * h[0] + x[5] * h[1] + x[6] * h[2]);
        [energy, h_n[0], h_n[1], h_n[2]]
    };
    // About the middle axis, which tumbles.
    let start = [1.0, 0.0, 0.0, 0.0, 0.01, 3.0, 0.02];
    let before = invariants(&start);
    for method in [Method::Tsit5, Method::Dop853] {
        let options = IntegrationOptions {
            method,
            ..IntegrationOptions::with_tolerance(1e-11)
        };
        let flight = integrate(&mut body, (0.0, &start), 20.0, &options, &mut []).unwrap();
        for (t, x) in flight.at_rate(10.0) {
            for (a, b) in before.iter().zip(invariants(&x)) {
                assert!(
                    (a - b).abs() < 2e-8,
                    "{method:?}: {before:?}, but {:?} at {t} s",
                    invariants(&x)
                );
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..Default::default() })]

    #[test]
    fn samples_are_the_same_however_they_are_taken(a in -3.0..3.0_f64, b in -3.0..3.0_f64, times in prop::collection::vec(0.0..2.0_f64, 1..30)) {
        let mut times = times;
        times.sort_by(f64::total_cmp);
        let end = *times.last().unwrap();
        for method in [Method::Tsit5, Method::Dop853] {
            let options = IntegrationOptions { method, ..IntegrationOptions::default() };
            let mut samples = vec![0.0; 2 * times.len()];
            let finish = integrate_at(&mut rhs(&[], pendulum), (0.0, &[a, b]), &times, &options, &mut [], &mut samples).unwrap();
            prop_assert_eq!(finish.time, end);
            prop_assume!(end > 0.0);
            let flight = integrate(&mut rhs(&[], pendulum), (0.0, &[a, b]), end, &options, &mut []).unwrap();
            for (t, x) in times.iter().zip(samples.chunks(2)) {
                let kept = flight.sample(*t).unwrap();
                prop_assert!((kept[0] - x[0]).abs() < 1e-12 && (kept[1] - x[1]).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn an_oscillator_is_within_tolerance(frequency in 0.1..50.0_f64, size in 1e-3..1e3_f64, tolerance in -9.0..-3.0_f64) {
        let tolerance = 10_f64.powf(tolerance);
        let options = IntegrationOptions { atol: tolerance * size, ..IntegrationOptions::with_tolerance(tolerance) };
        let mut d = rhs(&[], |_, x: &[f64; 2], dx: &mut [f64; 2]| *dx = [frequency * x[1], -frequency * x[0]]);
        let end = integrate_to_end(&mut d, (0.0, &[size, 0.0]), 2.0, &options, &mut []).unwrap();
        let exact = size * (frequency * 2.0).cos();
        prop_assert!((end.state[0] - exact).abs() < 30.0 * tolerance * size * (1.0 + frequency));
    }
}

#[test]
fn a_pendulum_is_where_another_program_says() {
    // By mpmath's Taylor series in 25 digits.
    let reference = [
        (0.6, [0.212_298_498_294_956_64, -2.580_972_443_582_915_8]),
        (2.0, [0.280_209_713_157_328_23, 1.809_022_099_111_152]),
        (5.0, [-0.246_046_954_120_336_8, -1.548_034_288_287_535]),
    ];
    for method in [Method::Tsit5, Method::Dop853] {
        let options = IntegrationOptions {
            method,
            ..IntegrationOptions::with_tolerance(1e-13)
        };
        let flight = integrate(
            &mut rhs(&[], pendulum),
            (0.0, &[1.0, 0.5]),
            5.0,
            &options,
            &mut [],
        )
        .unwrap();
        for (t, x) in reference {
            let found = flight.sample(t).unwrap();
            for (found, x) in found.iter().zip(x) {
                assert!(
                    (found - x).abs() < 1e-11,
                    "{method:?} at {t} s: {found}, not {x}"
                );
            }
        }
    }
}
