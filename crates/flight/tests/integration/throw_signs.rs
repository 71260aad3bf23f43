//! Signs of a throw's numbers, by the oracle: the motion at release as it reads the states, and where its flights go.

use flight::CompiledModel;
use flight::throw::{Throw, ThrownModel};
use model_spec::model::Model;
use nalgebra::Vector3;
use oracle::{Chart, Physical, Point, derivatives};

/// Names of models with different states: a disc with attitude by three angles, a disc with a quaternion, and a discus.
const MODELS: [&str; 3] = ["disc", "disc_quaternion", "discus"];

fn model(name: &str) -> Model {
    model_spec::load::load(name, &[]).unwrap_or_else(|e| panic!("{e}"))
}

fn backhand() -> Throw {
    Throw {
        launch: 8.0,
        height: 1.5,
        nose: Some(2.0),
        spin: Some(700.0),
        ..Throw::at_speed(20.0)
    }
}

fn state(model: &Model, throw: &Throw) -> Vec<f64> {
    let thrown = ThrownModel::new(model).expect("a body");
    let parameters = CompiledModel::new(model).layout().default_parameters();
    let state = thrown.state(throw, [0.0; 2], &parameters);
    state.unwrap_or_else(|e| panic!("{e}"))
}

/// Physical state of the body at the given model states, by the independent evaluation of models in the crate `oracle`.
fn body(model: &Model, states: &[f64]) -> Physical<f64> {
    Chart::declared(model).expect("a chart").physical(states)
}

/// Physical state of the body at the given times of a flight, s. The flight is computed with the reference evaluation
/// of the crate `oracle` and the classic Runge-Kutta method.
fn flown(name: &str, throw: &Throw, times: &[f64]) -> Vec<Physical<f64>> {
    const STEP: f64 = 5e-4;
    let model = model(name);
    let mut point = Point::defaults(&model);
    point.states = state(&model, throw);
    let mut at = |states: &[f64]| {
        point.states = states.to_vec();
        derivatives(&model, &point).expect("derivatives")
    };
    let along = |x: &[f64], d: &[f64], h: f64| -> Vec<f64> {
        x.iter().zip(d).map(|(x, d)| x + h * d).collect()
    };
    let (mut x, mut now) = (state(&model, throw), 0.0);
    let to = times.iter().map(|time| {
        while now < time - STEP / 2.0 {
            let k1 = at(&x);
            let k2 = at(&along(&x, &k1, STEP / 2.0));
            let k3 = at(&along(&x, &k2, STEP / 2.0));
            let k4 = at(&along(&x, &k3, STEP));
            for (i, x) in x.iter_mut().enumerate() {
                *x += STEP / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
            }
            now += STEP;
        }
        body(&model, &x)
    });
    to.collect()
}

#[test]
fn each_number_has_its_sign_at_release() {
    for name in MODELS {
        let model = model(name);
        let of = |throw: Throw| body(&model, &state(&model, &throw));
        let flat = of(Throw {
            nose: Some(0.0),
            launch: 0.0,
            ..backhand()
        });
        let forward = flat.attitude.carry(Vector3::x());
        assert!((forward - Vector3::x()).norm() < 1e-9, "{name}: {forward}");
        assert!((flat.position - Vector3::new(0.0, 0.0, 1.5)).norm() < 1e-9);
        // Clockwise from above: the left edge moves forward.
        let left = Vector3::y();
        let edge = flat.angular_velocity.cross(&left);
        assert!(
            (edge.x - 700.0 * std::f64::consts::PI / 30.0).abs() < 1e-6,
            "{name}: {edge}"
        );
        let headed = of(Throw {
            heading: 30.0,
            ..backhand()
        });
        assert!(headed.velocity.y > 0.0, "{name}");
        let launched = of(Throw {
            launch: 20.0,
            ..backhand()
        });
        assert!((launched.velocity.z - 20.0 * 20f64.to_radians().sin()).abs() < 1e-9);
        let nose_up = of(Throw {
            nose: Some(10.0),
            launch: 0.0,
            ..backhand()
        });
        let nose = nose_up.attitude.carry(Vector3::x());
        assert!(
            (nose.z - 10f64.to_radians().sin()).abs() < 1e-9,
            "{name}: {nose}"
        );
        let hyzer = of(Throw {
            hyzer: Some(20.0),
            nose: Some(0.0),
            launch: 0.0,
            ..backhand()
        });
        let edge = hyzer.attitude.carry(Vector3::y());
        assert!(
            (edge.z + 20f64.to_radians().sin()).abs() < 1e-9,
            "{name}: {edge}"
        );
    }
}

#[test]
fn a_backhand_with_hyzer_goes_left_and_with_anhyzer_right() {
    for name in ["disc", "disc_quaternion"] {
        let aside = |hyzer| {
            let throw = Throw {
                hyzer: Some(hyzer),
                ..backhand()
            };
            flown(name, &throw, &[1.0])[0].position.y
        };
        let (hyzer, flat, anhyzer) = (aside(20.0), aside(0.0), aside(-20.0));
        assert!(
            hyzer > flat + 1.0 && flat > anhyzer + 1.0,
            "{name}: {hyzer} {flat} {anhyzer}"
        );
        assert!(hyzer > 0.0 && anhyzer < 0.0, "{name}: {hyzer} {anhyzer}");
    }
}

#[test]
fn nose_up_climbs() {
    for name in MODELS {
        let height = |nose| {
            let throw = Throw {
                nose: Some(nose),
                ..backhand()
            };
            flown(name, &throw, &[0.5])[0].position.z
        };
        assert!(height(12.0) > height(2.0) + 0.1, "{name}");
    }
}

#[test]
fn a_left_handed_throw_is_the_mirror_image() {
    for name in MODELS {
        let right = flown(
            name,
            &Throw {
                hyzer: Some(15.0),
                ..backhand()
            },
            &[0.8],
        )[0];
        let throw = Throw {
            hyzer: Some(-15.0),
            spin: Some(-700.0),
            ..backhand()
        };
        let left = flown(name, &throw, &[0.8])[0];
        let mirrored = Vector3::new(left.position.x, -left.position.y, left.position.z);
        assert!((right.position - mirrored).norm() < 1e-6, "{name}");
    }
}
