//! Fits that must not be relied on say so, and complete models are not doubted.

use std::cell::Cell;

use hyzer::{
    Dataset, DatasetBuilder, Diagnosis, Effect, Fit, Instrument, Model, Plan, Role, SensorKind,
    Verdict, synthesize,
};

/// Backhands of `model`, with the coefficients `set` at other values.
fn throws(model: &Model, set: &[(&str, f64)], flights: usize, seed: u64) -> Dataset {
    let mut release = model.release("backhand").unwrap();
    for (name, value) in set {
        release = release.with_coefficient(name, *value);
    }
    let plan = Plan {
        flights,
        duration: Some(0.8),
        seed,
        ..Plan::default()
    };
    synthesize(model, &[release], &plan).unwrap()
}

fn disc() -> Model {
    Model::load("disc").unwrap()
}

/// Whether the fit is unreliable, with one reason, which contains `word`.
fn is_doubted(fit: &Fit, word: &str) -> bool {
    !fit.is_reliable() && matches!(fit.cautions(), [only] if only.contains(word))
}

#[test]
fn fits_of_complete_models_are_reliable() {
    let disc = disc();
    for seed in 0..6 {
        let flights = 2 + 2 * (seed as usize % 3);
        let fit = Fit::of(&disc)
            .run(&throws(&disc, &[], flights, seed))
            .unwrap();
        assert!(fit.is_reliable(), "seed {seed}: {:?}", fit.cautions());
    }
}

#[test]
fn a_lack_of_fit_of_two_flights_is_seen() {
    let effect = "effect more_drag { site drag; coefficient C_D1 = 0 [1/rad]; replace C_D = previous + C_D1*alpha; }";
    let more = disc().with(&Effect::parse(effect).unwrap()).unwrap();
    let fit = Fit::of(&disc())
        .run(&throws(&more, &[("C_D1", 1.0)], 2, 1))
        .unwrap();
    assert!(is_doubted(&fit, "not noise"), "{:?}", fit.cautions());
}

/// Constants absorb a spin down that grows with the speed: the residuals are noise, and the estimates are wrong.
#[test]
fn a_coefficient_that_changes_during_the_flights_is_seen() {
    let effect = "effect more { site spin; coefficient C_Nv = 0 [N*s^2]; replace spin_down = previous + C_Nv*V*r; }";
    let more = disc().with(&Effect::parse(effect).unwrap()).unwrap();
    let data = throws(&more, &[("C_Nv", -6e-6)], 12, 1);
    let fit = Fit::of(&disc()).run(&data).unwrap();
    assert!(is_doubted(&fit, "changes with V"), "{:?}", fit.cautions());
    assert!(Fit::of(&more).run(&data).unwrap().is_reliable());
}

/// No coefficient of the model acts across its plane of symmetry.
#[test]
fn a_force_that_no_coefficient_can_absorb_is_seen() {
    let more = disc().with_effect("side_force").unwrap();
    let data = throws(&more, &[("side_a", 0.06)], 2, 1);
    let fit = Fit::of(&disc()).run(&data).unwrap();
    assert!(
        is_doubted(&fit, "der(v) lacks a constant term"),
        "{:?}",
        fit.cautions()
    );
    assert!(Fit::of(&more).run(&data).unwrap().is_reliable());
}

#[test]
fn an_estimate_at_its_bound_is_not_relied_on() {
    let text = disc().text();
    let bounded = text.replace("2.37 1/rad in -10 .. 10", "2 1/rad in -10 .. 2.3");
    assert_ne!(text, bounded);
    let model = Model::parse("disc", &bounded).unwrap();
    let fit = Fit::of(&model).run(&throws(&disc(), &[], 6, 2)).unwrap();
    assert!(fit.coefficient("C_La").unwrap().at_bound);
    assert!(
        fit.cautions()
            .iter()
            .any(|c| c.contains("C_La is at its bound 2.3")),
        "{:?}",
        fit.cautions()
    );
    let free = Fit::of(&model).unbounded();
    assert!(free.run(&throws(&disc(), &[], 6, 2)).unwrap().is_reliable());
}

#[test]
fn a_prior_that_the_data_contradict_is_named() {
    let data = throws(&disc(), &[], 6, 3);
    let fit = |mean: f64| {
        Fit::of(&disc())
            .prior("C_La", mean, 0.01)
            .run(&data)
            .unwrap()
    };
    assert!(fit(2.37).is_reliable());
    let contradicted = fit(2.0);
    let named = contradicted.cautions().iter();
    assert!(
        named
            .clone()
            .any(|c| c.contains("contradict the prior C_La = 2 ± 0.01")),
        "{:?}",
        contradicted.cautions()
    );
}

/// The prior is right; the model lacks a stall, for want of which its coefficients are biased.
#[test]
fn a_prior_that_a_missing_effect_contradicts_leaves_the_cause() {
    let stalling = disc().with_effect("stall").unwrap();
    let data = throws(&stalling, &[("C_Ls", 20.0)], 8, 4);
    let fit = Fit::of(&disc())
        .prior("C_La", 2.37, 0.02)
        .run(&data)
        .unwrap();
    let is_conflict = |caution: &String| caution.contains("contradict the prior C_La");
    assert!(
        fit.cautions().iter().any(is_conflict),
        "{:?}",
        fit.cautions()
    );
    let found = Diagnosis::of(&disc())
        .prior("C_La", 2.37, 0.02)
        .run(&data)
        .unwrap();
    assert_eq!(found.verdict(), Verdict::Identified, "{}", found.summary());
    assert_eq!(found.explanations()[0].effects[0].name, "stall");
}

/// Three backhands of `disc_quaternion` measured by a gyroscope and a pose sensor at 200 Hz; `rate` and `pose` are
/// what the sensors show.
fn sensed(rate: impl Fn([f64; 3]) -> [f64; 3], pose: impl Fn([f64; 4]) -> [f64; 4]) -> Dataset {
    let model = Model::load("disc_quaternion").unwrap();
    let times: Vec<f64> = (0..160).map(|i| f64::from(i) / 200.0).collect();
    let mut uniform = (1..).map(|i| ((f64::from(i) * 12.9898).sin() * 43758.5453).fract());
    let mut noise = |size: f64| size * uniform.next().unwrap();
    let gyroscope = SensorKind::Instrument(Instrument::Gyroscope);
    let mut data = DatasetBuilder::new("disc_quaternion")
        .sensor("tag", SensorKind::Pose, [0.0; 3])
        .sensor("imu", gyroscope, [0.0; 3]);
    for speed in [12, 14, 16] {
        let text = format!(
            "model = \"disc_quaternion\"\nduration = 0.8\n[throw]\nspeed = {speed}\nlaunch = 8\nnose = 5\nhyzer = 10\nspin = 700\nwobble = 3"
        );
        let release = model.parse_release("backhand", &text).unwrap();
        let flight = model.fly(&release).unwrap();
        let mut state =
            |name: &str, t: f64, size: f64| flight.state(name, t).unwrap() + noise(size);
        let mut rates = Vec::new();
        let mut poses = Vec::new();
        for &t in &times {
            let own = ["p", "q", "r"].map(|name| state(name, t, 0.1));
            rates.push(Some(rate(own)));
            let position = ["x", "y", "z"].map(|name| state(name, t, 0.003));
            let turn = ["q0", "q1", "q2", "q3"].map(|name| state(name, t, 0.003));
            let norm = turn.iter().map(|q| q * q).sum::<f64>().sqrt();
            poses.push(Some((position, pose(turn.map(|q| q / norm)))));
        }
        let none = vec![Vec::new(); times.len()];
        data = data
            .flight(&format!("throw{speed}"), Role::Fit, &times, none)
            .poses("tag", &poses)
            .readings("imu", &rates);
    }
    data.build().unwrap()
}

#[test]
fn units_conventions_and_saturation_of_sensors_are_named() {
    let model = Model::load("disc_quaternion").unwrap();
    let fit = |data: &Dataset| Fit::of(&model).run(data);
    let (same, unturned) = (|rate: [f64; 3]| rate, |turn: [f64; 4]| turn);
    let right = fit(&sensed(same, unturned)).unwrap();
    assert_eq!(right.data_faults(), []);
    let refused = |data: Dataset, expected: &str| {
        let error = fit(&data)
            .err()
            .expect("a fault of all flights")
            .to_string();
        assert!(error.contains(expected), "{error}");
    };
    let degrees = |rate: [f64; 3]| rate.map(f64::to_degrees);
    refused(
        sensed(degrees, unturned),
        "state `angular_rate = \"deg/s\"`",
    );
    // Radians that were stated to be degrees.
    let radians = |rate: [f64; 3]| rate.map(f64::to_radians);
    refused(
        sensed(radians, unturned),
        "remove `angular_rate = \"deg/s\"`",
    );
    let conjugate = |[w, x, y, z]: [f64; 4]| [w, -x, -y, -z];
    refused(sensed(same, conjugate), "attitude = \"inertial_to_body\"");
    let last = |[w, x, y, z]: [f64; 4]| [x, y, z, w];
    refused(
        sensed(same, last),
        "if the quaternions have the scalar part last, ",
    );
    let both = |[w, x, y, z]: [f64; 4]| [-x, -y, -z, w];
    let told =
        "if the quaternions have the scalar part last and turn inertial to body components, ";
    refused(sensed(same, both), told);
    let first_axis_up = |[w, x, y, z]: [f64; 4]| {
        [w + x + y + z, x + z - w - y, x + y - w - z, y + z - w - x].map(|own| 0.5 * own)
    };
    let told = "state `body_up = \"+x\"` in [recording], or turn the body axes";
    refused(sensed(same, first_axis_up), told);
    let clipped = |rate: [f64; 3]| rate.map(|own| own.clamp(-34.9, 34.9));
    refused(sensed(clipped, unturned), "imu_z is saturated");
    let (count, kept) = (Cell::new(0), Cell::new([0.0; 3]));
    let stuck = |is_fresh: fn(i32) -> bool| {
        let (count, kept) = (&count, &kept);
        move |rate: [f64; 3]| {
            if is_fresh(count.replace(count.get() + 1) % 160) {
                kept.set(rate);
            }
            kept.get()
        }
    };
    let frozen = stuck(|sample| !(40..60).contains(&sample));
    let during = "imu stays at the same reading from t = 0.195 s to 0.295 s";
    refused(sensed(frozen, unturned), during);
    let held = stuck(|sample| sample % 2 == 0);
    refused(
        sensed(held, unturned),
        "imu repeats its readings in 78 of 157",
    );
    let dropped = |rate: [f64; 3]| match count.replace(count.get() + 1) % 10 {
        3 => [0.0; 3],
        _ => rate,
    };
    refused(
        sensed(dropped, unturned),
        "imu is exactly zero in 16 samples",
    );
}

#[test]
fn the_unit_of_a_speed_is_named_by_the_path() {
    let model = Model::load("ball").unwrap();
    let release = model.release("serve").unwrap();
    let flight = model.fly(&release).unwrap();
    let times: Vec<f64> = (0..60).map(|i| f64::from(i) / 150.0).collect();
    let state = |names: [&str; 3], t: f64| names.map(|name| flight.state(name, t).unwrap());
    let seen = |t: &f64| vec![Some(state(["x", "y", "z"], *t))];
    let positions: Vec<_> = times.iter().map(seen).collect();
    let said = |unit: f64| {
        let speed = |t: &f64| {
            let norm = state(["vx", "vy", "vz"], *t)
                .iter()
                .map(|v| v * v)
                .sum::<f64>()
                .sqrt();
            // The last digit changes as noise does.
            Some([norm / unit * (1.0 + 1e-3 * (1e4 * t).sin()), 0.0, 0.0])
        };
        let speeds: Vec<_> = times.iter().map(speed).collect();
        let radar = SensorKind::Instrument(Instrument::Speed);
        let data = DatasetBuilder::new("ball")
            .marker("m1", [0.0; 3])
            .sensor("radar", radar, [0.0; 3])
            .flight("serve", Role::Fit, &times, positions.clone())
            .readings("radar", &speeds)
            .build()
            .unwrap();
        match Fit::of(&model).run(&data) {
            Ok(fit) => fit.cautions().join(" "),
            Err(error) => error.to_string(),
        }
    };
    assert!(!said(1.0).contains("speed ="), "{}", said(1.0));
    for (name, unit) in [
        ("km/h", 1.0 / 3.6),
        ("mph", 0.44704),
        ("ft/s", 0.3048),
        ("kn", 0.51444),
    ] {
        let named = format!("state `speed = \"{name}\"`");
        assert!(said(unit).contains(&named), "{}", said(unit));
    }
}

/// Twenty turns of a body whose gyroscope and accelerometer, 3 cm off the axis, state what a spin of 60 rad/s demands, in
/// `unit` m/s².
fn spun(unit: f64) -> Dataset {
    let times: Vec<f64> = (0..200).map(|k| 0.01 * f64::from(k)).collect();
    let rates: Vec<_> = times.iter().map(|_| Some([0.0, 0.0, 60.0])).collect();
    let forces = times.iter().map(|t| {
        let (sin, cos) = (60.0 * t).sin_cos();
        Some([cos - 108.0, sin, 8.0].map(|force| force / unit))
    });
    let none = vec![Vec::new(); times.len()];
    DatasetBuilder::new("disc_quaternion")
        .sensor(
            "gyro",
            SensorKind::Instrument(Instrument::Gyroscope),
            [0.0; 3],
        )
        .sensor(
            "acc",
            SensorKind::Instrument(Instrument::Accelerometer),
            [0.03, 0.0, 0.0],
        )
        .flight("spun", Role::Fit, &times, none)
        .readings("gyro", &rates)
        .readings("acc", &forces.collect::<Vec<_>>())
        .build()
        .unwrap()
}

#[test]
fn an_accelerometer_in_g_is_named_by_the_rates_of_a_gyroscope() {
    let model = Model::load("disc_quaternion").unwrap();
    let said = |unit| match Fit::of(&model).run(&spun(unit)) {
        Ok(fit) => fit.cautions().join(" "),
        Err(error) => error.to_string(),
    };
    let found = said(9.80665);
    assert!(found.contains("acceleration = \"g\""), "{found}");
    let found = said(1.0);
    assert!(!found.contains("acceleration ="), "{found}");
}
