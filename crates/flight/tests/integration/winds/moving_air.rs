//! Flights in air that moves: Galilei's principle, energy, momentum, drops and throws straight up.

use flight::release::{Release, Stop};
use flight::throw::{Motion, ThrownModel};
use flight::wind::{GUST_TERMS, gust_phases, gust_spectrum};
use flight::{CompiledModel, simulate};
use model_spec::model::Model;
use nalgebra::{DMatrix, Vector3};
use ode::Trajectory;

use super::{MODELS, compiled, model, released, throw, tight};

/// Velocity of the air in the test flights, m/s, in the inertial frame.
const W: [f64; 3] = [3.0, -2.0, 0.4];
const SECONDS: f64 = 1.2;
const GUSTS: &str = "[wind.gusts]\nmodel = \"dryden\"\nseed = 11\nheading = 20.0\nsd = [1.5, 1.2, 0.6]\nlength = [12.0, 15.0, 4.0]\n";

/// Converter between states and motions for a model; for `disc_appendix`, which declares no body, that of the model
/// `disc`, which has the same states.
fn motions(model: &Model) -> ThrownModel {
    let own = ThrownModel::new(model);
    own.unwrap_or_else(|_| ThrownModel::new(&super::model("disc")).expect("the disc"))
}

/// Copy of a release in which the velocity relative to the ground is changed by `by`, m/s.
fn moved(release: &Release, model: &Model, by: Vector3<f64>) -> Release {
    let (thrown, state) = (motions(model), release.state());
    let parameters = thrown.release_parameters(release);
    let rows = thrown.bind(&parameters).jacobian(&state).nrows();
    let mut wanted = DMatrix::zeros(rows, 1);
    wanted.view_mut((3, 0), (3, 1)).copy_from(&by);
    let change = thrown.bind(&parameters).states_moved(&state, &wanted);
    let mut moved = release.clone();
    for ((_, x), change) in moved.initial.iter_mut().zip(change.iter()) {
        *x += change;
    }
    moved
}

fn end(release: &Release, model: &Model) -> (Motion, Trajectory) {
    let flight = simulate(&compiled(model), release, &tight());
    let flight = flight.unwrap_or_else(|e| panic!("{}: {e}", model.name));
    let thrown = motions(model);
    let motion = thrown.motion(&flight.end_state, &thrown.release_parameters(release));
    (motion, flight)
}

/// Asserts, for the model `name`, that a flight in a constant wind equals the flight in still air, shifted with the
/// wind. `gusts` is the TOML text of gusts that are added in both cases; it may be empty.
fn is_carried(name: &str, gusts: &str) {
    let until = format!("duration = {SECONDS:?}");
    let text = throw(name, &until);
    let (calm, in_calm) = released(&format!("{text}\n{gusts}"));
    let (windy, in_wind) = released(&format!("{text}\n[wind]\nconstant = {W:?}\n{gusts}"));
    let wind = Vector3::from(W);
    let (still, _) = end(&calm, &in_calm);
    let (found, _) = end(&moved(&windy, &in_wind, wind), &in_wind);
    let place = (found.position - wind * SECONDS - still.position).norm();
    let velocity = (found.velocity - wind - still.velocity).norm();
    assert!(
        place < 1e-9 && velocity < 1e-8,
        "{name} {place:e} {velocity:e}"
    );
    if let (Some(found), Some(still)) = (found.turning, still.turning) {
        let axes = (found.axes - still.axes).norm();
        let rates = (found.rates - still.rates).norm();
        assert!(axes < 1e-8 && rates < 1e-6, "{name} {axes:e} {rates:e}");
    }
    // Without the wind the throw is another one.
    let (other, _) = end(&windy, &in_wind);
    assert!(
        (other.position - wind * SECONDS - still.position).norm() > 0.1,
        "{name}"
    );
}

#[test]
fn a_constant_wind_carries_the_flight_along() {
    MODELS.iter().for_each(|name| is_carried(name, ""));
}

#[test]
fn a_constant_wind_carries_flight_and_gusts_along() {
    MODELS.iter().for_each(|name| is_carried(name, GUSTS));
}

/// Values of the scalar auxiliary variable `name` along a flight, at `steps + 1` evenly spaced times.
fn along(
    (release, model, flight): (&Release, &Model, &Trajectory),
    name: &str,
    steps: u32,
) -> Vec<f64> {
    let observing = CompiledModel::observing(model, name, Vec::new()).expect(name);
    let bound = observing.bind(observing.release_parameters(release));
    let mut observer = bound.observer();
    let at = |k: u32| {
        let t = flight.end * f64::from(k) / f64::from(steps);
        observer.position(t, &flight.sample(t).expect("in the flight"), &[0.0; 3])[0]
    };
    (0..=steps).map(at).collect()
}

/// Integral of evenly spaced values over `seconds`, s, by Simpson's rule.
fn integral(values: &[f64], seconds: f64) -> f64 {
    let last = values.len() - 1;
    let weight = |k: usize| match k {
        k if k == 0 || k == last => 1.0,
        k if k % 2 == 1 => 4.0,
        _ => 2.0,
    };
    let sum: f64 = values.iter().enumerate().map(|(k, x)| weight(k) * x).sum();
    sum * seconds / last as f64 / 3.0
}

#[test]
fn energy_in_the_moving_air_changes_by_the_work_of_drag() {
    const STEPS: u32 = 3000;
    for name in MODELS {
        let until = format!("duration = {SECONDS:?}");
        let (release, model) = released(&format!(
            "{}\n[wind]\nconstant = {W:?}\n",
            throw(name, &until)
        ));
        let (last, flight) = end(&release, &model);
        let thrown = motions(&model);
        let first = thrown.motion(&release.state(), &thrown.release_parameters(&release));
        let parameters = compiled(&model).release_parameters(&release).constants;
        let layout = model_spec::Layout::new(&model);
        let constant = |name: &str| parameters[layout.parameter(name).expect(name).index()];
        let (m, g, wind) = (constant("m"), constant("g"), Vector3::from(W));
        let energy = |motion: &Motion, t: f64| {
            m * (0.5 * (motion.velocity - wind).norm_squared() + g * (motion.position.z - W[2] * t))
        };
        let change = energy(&last, SECONDS) - energy(&first, 0.0);
        let of = |quantity: &str| along((&release, &model, &flight), quantity, STEPS);
        let power: Vec<f64> = of("drag")
            .iter()
            .zip(of("V"))
            .map(|(drag, v)| -drag * v)
            .collect();
        let work = integral(&power, SECONDS);
        assert!(
            (change - work).abs() < 1e-7 * change.abs(),
            "{name} {change} {work}"
        );
        // In the frame of the ground the same drag does other work.
        let ground =
            |motion: &Motion| m * (0.5 * motion.velocity.norm_squared() + g * motion.position.z);
        assert!(
            (ground(&last) - ground(&first) - work).abs() > 1e-3 * change.abs(),
            "{name}"
        );
    }
}

#[test]
fn momentum_changes_by_drag_in_the_wind_of_the_formulae_and_weight() {
    const STEPS: u32 = 4000;
    let text = "model = \"ball\"\nduration = 1.0\n[throw]\nspeed = 12.0\nlaunch = 30.0\nheading = 10.0\nheight = 1.2\n[wind]\nprofile = \"log\"\nspeed = 5.0\ndirection = 70.0\nroughness = 0.05\n[wind.gusts]\nmodel = \"dryden\"\nseed = 3\nheight = 2.0\nsd = [1.5, 1.2, 0.6]\nlength = [12.0, 15.0, 4.0]\n";
    let (release, model) = released(text);
    let (last, flight) = end(&release, &model);
    let (m, g, rho, radius, drag): (f64, f64, f64, f64, f64) = (0.0027, 9.81, 1.2, 0.02, 0.45);
    let phases = gust_phases(3, 0);
    let law = |z: f64| {
        let form = |z: f64| (1.0 + (z.max(0.0) / 0.05).powi(2)).ln();
        let (sin, cos) = 70f64.to_radians().sin_cos();
        Vector3::new(cos, sin, 0.0) * (5.0 * form(z) / form(10.0))
    };
    // Along the heading of the throw.
    let (sin, cos) = 10f64.to_radians().sin_cos();
    let axes = [
        Vector3::new(cos, sin, 0.0),
        Vector3::new(-sin, cos, 0.0),
        Vector3::z(),
    ];
    let gust = |t: f64, place: Vector3<f64>| {
        let distance = (place - law(2.0) * t).dot(&axes[0]);
        let (sd, length) = ([1.5, 1.2, 0.6], [12.0, 15.0, 4.0]);
        let component = |k: usize| {
            let terms = gust_spectrum(k).into_iter().enumerate();
            let wave = terms.map(|(i, (wavenumber, a))| {
                a * (wavenumber * distance / length[k] + phases[k * GUST_TERMS + i].1).sin()
            });
            axes[k] * (sd[k] * wave.sum::<f64>())
        };
        component(0) + component(1) + component(2)
    };
    let force = |k: u32| {
        let t = f64::from(k) / f64::from(STEPS);
        let x = flight.sample(t).expect("in the flight");
        let (place, velocity) = (
            Vector3::new(x[0], x[1], x[2]),
            Vector3::new(x[3], x[4], x[5]),
        );
        let through = velocity - law(place.z) - gust(t, place);
        let area = std::f64::consts::PI * radius * radius;
        -through * (0.5 * rho * through.norm() * area * drag) - Vector3::z() * (m * g)
    };
    let forces: Vec<Vector3<f64>> = (0..=STEPS).map(force).collect();
    let start = release.state();
    for axis in 0..3 {
        let values: Vec<f64> = forces.iter().map(|f| f[axis]).collect();
        let change = m * (last.velocity[axis] - start[3 + axis]);
        let impulse = integral(&values, 1.0);
        assert!(
            (change - impulse).abs() < 1e-9 * 0.01,
            "{axis} {change} {impulse}"
        );
    }
}

#[test]
fn a_drop_without_spin_does_not_drift() {
    for name in MODELS {
        let (mut release, model) = released(&throw(name, "until = \"ground\""));
        let z = release
            .initial
            .iter()
            .position(|(state, _)| state == "z")
            .expect("a height");
        let quaternion = model.quaternions().next();
        for (k, (_, x)) in release.initial.iter_mut().enumerate() {
            // Level and at rest, 20 m up.
            *x = match quaternion {
                _ if k == z => 20.0,
                Some(states) if k == states[0] => 1.0,
                _ => 0.0,
            };
        }
        release.stop = Stop::Ground;
        let flight = simulate(&compiled(&model), &release, &tight()).expect(name);
        let position = motions(&model);
        let end = position
            .motion(&flight.end_state, &position.release_parameters(&release))
            .position;
        assert!(end.x.abs() < 1e-12 && end.y.abs() < 1e-12, "{name} {end:?}");
        assert!(
            end.z.abs() < 1e-9 && flight.end > 2.0,
            "{name} {end:?} {}",
            flight.end
        );
    }
}

#[test]
fn a_throw_straight_up_comes_down() {
    for name in ["ball", "disc", "discus", "plate"] {
        let own = model(name);
        let thrown = ThrownModel::new(&own).expect("a body");
        let (mut release, _) = released(&throw(name, "until = \"ground\""));
        let level = release.clone();
        let parameters = thrown.release_parameters(&level);
        // Level, without spin, upwards.
        let (speed, height) = (5.0, 1.5);
        for (_, x) in &mut release.initial {
            *x = 0.0;
        }
        let z = release
            .initial
            .iter()
            .position(|(state, _)| state == "z")
            .expect("a height");
        release.initial[z].1 = height;
        let release = moved(&release, &own, Vector3::new(0.0, 0.0, speed));
        let start = thrown.motion(&release.state(), &parameters);
        assert!(
            (start.velocity - Vector3::new(0.0, 0.0, speed)).norm() < 1e-12,
            "{name}"
        );
        let flight = simulate(&compiled(&own), &release, &tight()).expect(name);
        let end = thrown.motion(&flight.end_state, &parameters);
        assert!(end.position.xy().norm() < 1e-9, "{name} {:?}", end.position);
        assert!(
            end.position.z.abs() < 1e-9 && end.velocity.z < -1.0,
            "{name} {end:?}"
        );
        // It rises less than without air, and falls slower than it was thrown from there.
        let without_air = height + speed * speed / (2.0 * 9.78);
        let apex = (0..=1000).map(|k| flight.end * f64::from(k) / 1000.0);
        let apex = apex
            .filter_map(|t| Some(flight.sample(t)?[z]))
            .fold(0.0, f64::max);
        assert!(apex > height + 0.2 && apex < without_air, "{name} {apex}");
        assert!(
            end.velocity.norm() < (speed * speed + 2.0 * 9.82 * height).sqrt(),
            "{name}"
        );
    }
}
