//! Prints the time per integration: `cargo run --release -p hyzer-ode --example integration_speed`.

#[path = "../tests/integration/disc/mod.rs"]
mod disc;

use ode::{DifferentiableRhs, RhsProperties, Sensitivities};
use ode::{Event, IntegrationOptions, Method, OdeRhs, integrate, integrate_at, integrate_to_end};
use std::hint::black_box;
use std::time::Instant;

fn microseconds(mut f: impl FnMut()) -> f64 {
    let rounds = (0..200).map(|_| {
        let start = Instant::now();
        for _ in 0..20 {
            f();
        }
        start.elapsed().as_secs_f64() * 1e6 / 20.0
    });
    rounds.fold(f64::INFINITY, f64::min)
}

/// Disc model whose Jacobians with respect to states and parameters have 55 and 40 entries. All entries are constants,
/// which cost nothing to evaluate, so that the timing shows the cost that the variational equations add.
struct Entries([(usize, usize); 55], [(usize, usize); 40]);

impl DifferentiableRhs for Entries {
    fn states(&self) -> usize {
        12
    }
    fn jacobian_pattern(&self) -> &[(usize, usize)] {
        &self.0
    }
    fn parameter_jacobian_pattern(&self) -> &[(usize, usize)] {
        &self.1
    }
    fn derivative_with_jacobians(
        &mut self,
        _: f64,
        x: &[f64],
        dx: &mut [f64],
        j: &mut [f64],
        jp: &mut [f64],
    ) {
        let (x, dx) = (x.try_into().unwrap(), dx.try_into().unwrap());
        disc::rate(x, &disc::DISC, &disc::AIR, dx);
        j.fill(1e-3);
        jp.fill(1e-3);
    }
}

impl RhsProperties for Entries {}

fn sensitivities() {
    let mut entries = Entries(
        std::array::from_fn(|i| (i * 12 / 55, i * 5 % 12)),
        std::array::from_fn(|i| (3 + i % 9, i / 5)),
    );
    let mut both = Sensitivities::new(&mut entries, 12, &[0, 1, 2, 3, 4, 5, 6, 7]);
    let unit: [_; 12] = std::array::from_fn(|state| (state, state, 1.0));
    let start = both.initial_state(&disc::THROW, &unit);
    let times: Vec<f64> = (0..=180).map(|i| f64::from(i) / 120.0).collect();
    let mut samples = vec![0.0; both.len() * times.len()];
    for tolerance in [1e-4, 1e-6] {
        let options = IntegrationOptions::with_tolerance(tolerance);
        let mut work = None;
        let us = microseconds(|| {
            work = integrate_at(
                &mut both,
                (0.0, &start),
                &times,
                &options,
                &mut [],
                &mut samples,
            )
            .ok()
            .map(|end| end.stats);
        });
        println!("with 20 sensitivities at {tolerance:.0e}, 181 times: {us:.0} µs, {work:?}");
    }
}

fn main() {
    sensitivities();
    let mut d = disc::disc();
    let mut dx = [0.0; 12];
    let ns = microseconds(|| {
        (0..100).for_each(|_| d.derivative(0.0, black_box(&disc::THROW), black_box(&mut dx)));
    }) * 10.0;
    println!("rate of change: {ns:.1} ns");

    let tight = IntegrationOptions {
        method: Method::Dop853,
        ..IntegrationOptions::with_tolerance(1e-13)
    };
    let truth = integrate(&mut d, (0.0, &disc::THROW), 1.5, &tight, &mut []).unwrap();
    let times: Vec<f64> = (0..=180).map(|i| f64::from(i) / 120.0).collect();
    let mut samples = vec![0.0; 12 * times.len()];
    for method in [Method::Tsit5, Method::Dop853] {
        for tolerance in [1e-3, 1e-4, 1e-6, 1e-8, 1e-10] {
            let options = IntegrationOptions {
                method,
                ..IntegrationOptions::with_tolerance(tolerance)
            };
            let end =
                integrate_to_end(&mut d, (0.0, &disc::THROW), 1.5, &options, &mut []).unwrap();
            let worst = (0..3)
                .map(|i| (end.state[i] - truth.end_state[i]).abs())
                .fold(0.0, f64::max);
            let flight = integrate(&mut d, (0.0, &disc::THROW), 1.5, &options, &mut []).unwrap();
            let along = flight.at_rate(1000.0).map(|(t, x)| {
                let exact = truth.sample(t).unwrap();
                (0..3).map(|i| (x[i] - exact[i]).abs()).fold(0.0, f64::max)
            });
            let along = along.fold(0.0, f64::max);
            let plain = microseconds(|| {
                _ = black_box(integrate_to_end(
                    &mut d,
                    (0.0, black_box(&disc::THROW)),
                    1.5,
                    &options,
                    &mut [],
                ));
            });
            let kept = microseconds(|| {
                _ = black_box(integrate(
                    &mut d,
                    (0.0, black_box(&disc::THROW)),
                    1.5,
                    &options,
                    &mut [],
                ));
            });
            let ground = microseconds(|| {
                let ground = Event::falls_to("ground", 2, 0.0).terminal();
                let apex = Event::peak_of("apex", 2);
                _ = black_box(integrate_to_end(
                    &mut d,
                    (0.0, black_box(&disc::THROW)),
                    1.5,
                    &options,
                    &mut [ground, apex],
                ));
            });
            let sampled = microseconds(|| {
                _ = black_box(integrate_at(
                    &mut d,
                    (0.0, black_box(&disc::THROW)),
                    &times,
                    &options,
                    &mut [],
                    &mut samples,
                ));
            });
            let own = (plain * 1e3 - end.stats.evaluations as f64 * ns) / end.stats.steps as f64;
            println!(
                "{method:?} {tolerance:.0e}: {plain:.2} µs to the end ({kept:.2} with curve, {ground:.2} with events, {sampled:.2} at 181 times), {:?}; \
                 besides the model {own:.0} ns a step; position within {worst:.1e} m at the end, {along:.1e} m along the curve",
                end.stats
            );
        }
    }
}
