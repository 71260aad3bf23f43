//! General effects on models that are not built in: every check of effects holds, and each load is what its text says, by
//! vectors written here.

use crate::support::{QUICK, row};
use model_spec::compose::{ModelTree, known_effects};
use model_spec::load::{Loaded, inspect};
use model_spec::model::Model;
use nalgebra::Vector3;
use oracle::{Point, derivatives};
use verify::Options;
use verify::checks::{derivatives as compiled, effects, metamorphic, reference, singular};
use verify::report::Verdict;

type V = Vector3<f64>;

const OWN: [&str; 6] = [
    "shuttlecock",
    "pendulum",
    "spinning_ball",
    "quaternion_dart",
    "glider",
    "kite",
];

fn path(name: &str) -> String {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../studies/models");
    format!("{folder}/{name}.hyz")
}

fn candidates(name: &str) -> Vec<String> {
    let model = ModelTree::load(&path(name)).unwrap().check().unwrap();
    let known = known_effects(&model).into_iter();
    let offered = known.filter(|known| known.refused.is_none());
    offered
        .map(|known| known.effect.name().to_owned())
        .collect()
}

fn with(name: &str, effects: &[&str]) -> Loaded {
    inspect(&path(name), effects).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn every_check_of_effects_holds_of_models_that_are_not_built_in() {
    let options = Options { cases: 8, ..QUICK };
    for name in OWN {
        let effects = candidates(name);
        let effects: Vec<&str> = effects.iter().map(String::as_str).collect();
        let report = verify::run(&with(name, &effects), &options);
        for check in [reference::TREE, effects::EFFECTS, compiled::CHECKS[2]] {
            let row = row(&report, check);
            assert_eq!(
                row.verdict,
                Verdict::Holds,
                "{name} {check}\n{}",
                report.table()
            );
        }
    }
}

/// Acceleration of the mass centre, m/s², that the effect `effect` adds to the shuttlecock model in still air if its
/// coefficient has the value 1.
fn added(effect: &str, coefficient: &str) -> V {
    let at = |value: f64| {
        let model = with("shuttlecock", &[effect]).model.unwrap();
        let mut point = flying(&model);
        let index = model
            .coefficients
            .iter()
            .position(|c| c.name == coefficient)
            .unwrap();
        point.coefficients[index] = value;
        acceleration(&model, &point)
    };
    at(1.0) - at(0.0)
}

const POSITION: V = V::new(1.0, 2.0, 3.0);
const VELOCITY: V = V::new(6.0, 8.0, 5.0);

fn flying(model: &Model) -> Point<f64> {
    let mut point = Point::defaults(model);
    for (k, value) in POSITION.iter().chain(VELOCITY.iter()).enumerate() {
        point.states[k] = *value;
    }
    point
}

fn acceleration(model: &Model, point: &Point<f64>) -> V {
    let rates = derivatives(model, point).unwrap();
    V::new(rates[3], rates[4], rates[5])
}

#[test]
fn forces_act_where_they_say() {
    let (v, speed) = (VELOCITY, VELOCITY.norm());
    let along = v / speed;
    // Level and to the left of (6, 8).
    let left = V::new(-0.8, 0.6, 0.0);
    let up = along.cross(&left);
    assert!(up.z > 0.0);
    let down = V::new(0.0, 0.0, -9.80665);
    for (effect, coefficient, expected) in [
        ("drag_force", "drag_a", -along),
        ("lift_force", "lift_a", up),
        ("side_force", "side_a", left),
        ("drag_by_speed", "drag_c", -v),
        ("drag_by_speed_squared", "drag_k", -v * speed),
        ("lift_by_speed_squared", "lift_k", up * speed * speed),
        (
            "side_force_by_speed_squared",
            "side_k",
            left * speed * speed,
        ),
        (
            "drag_by_log_speed",
            "drag_log",
            -v * speed * (speed / 10.0).ln(),
        ),
        ("drag_by_height", "drag_z", -v * speed * POSITION.z),
        ("missing_gravity", "gravity_error", down),
        ("level_force", "level_y", V::y()),
    ] {
        let error = (added(effect, coefficient) - expected).norm();
        assert!(error < 1e-12 * speed.powi(3), "{effect}: {error:e}");
    }
}

#[test]
fn a_wind_is_a_velocity_that_the_stream_lacks() {
    for (effect, coefficient, wind) in [
        ("stream_wind", "stream_x", V::x()),
        ("stream_wind", "stream_y", V::y()),
        ("updraught", "updraught_z", V::z()),
        (
            "stream_wind_by_height",
            "stream_shear_y",
            V::y() * POSITION.z,
        ),
    ] {
        let model = with("shuttlecock", &[]).model.unwrap();
        let mut blown = flying(&model);
        let input = model
            .inputs
            .iter()
            .position(|input| input.name == "wind")
            .unwrap();
        let still = acceleration(&model, &blown);
        blown.inputs[input] = wind;
        let expected = acceleration(&model, &blown) - still;
        assert!(expected.norm() > 0.1);
        let error = (added(effect, coefficient) - expected).norm();
        assert!(error < 1e-12, "{effect}: {error:e}");
    }
}

/// Angular acceleration, rad/s², in the body frame, that the effect `effect` adds to the dart model if its coefficient
/// has the value `value`. Position and attitude have their default values.
fn added_turn(effect: &str, coefficient: &str, value: f64) -> V {
    let at = |value: f64| {
        let model = with("quaternion_dart", &[effect]).model.unwrap();
        let mut point = Point::defaults(&model);
        for (name, value) in [
            ("vx", 6.0),
            ("vy", 8.0),
            ("vz", 5.0),
            ("p", 3.0),
            ("q", 0.5),
            ("r", -0.2),
        ] {
            let index = model.states.iter().position(|s| s.name == name).unwrap();
            point.states[index] = value;
        }
        let index = model
            .coefficients
            .iter()
            .position(|c| c.name == coefficient)
            .unwrap();
        point.coefficients[index] = value;
        let rates = derivatives(&model, &point).unwrap();
        let rate = |name: &str| rates[model.states.iter().position(|s| s.name == name).unwrap()];
        V::new(rate("p"), rate("q"), rate("r"))
    };
    at(value) - at(0.0)
}

#[test]
fn moments_act_about_the_axes_they_say() {
    let squared = VELOCITY.norm_squared();
    let left = V::new(-0.8, 0.6, 0.0);
    let (thin, thick) = (4e-7, 4.2e-5);
    for (effect, coefficient, expected) in [
        ("axis_1_moment", "moment_1_a", V::x()),
        ("axis_2_moment", "moment_2_a", V::y()),
        ("axis_3_moment", "moment_3_a", V::z()),
        (
            "axis_2_moment_by_speed_squared",
            "moment_2_k",
            V::y() * squared,
        ),
        ("axis_1_damping", "damping_1", V::x() * -3.0),
        ("axis_2_damping", "damping_2", V::y() * -0.5),
        ("axis_3_damping", "damping_3", V::z() * 0.2),
        // The body's axes are the inertial ones.
        (
            "moment_up_across_stream",
            "stream_pitch_k",
            V::new(left.x * thick / thin, left.y, left.z) * squared,
        ),
        (
            "moment_along_stream",
            "stream_roll_k",
            V::new(0.6, 0.8 * thin / thick, 0.5 * thin / thick) * VELOCITY.norm() * 10.0,
        ),
    ] {
        let error = (added_turn(effect, coefficient, 1.0) - expected).norm();
        assert!(error < 1e-9 * expected.norm(), "{effect}: {error:e}");
    }
}

#[test]
fn inertia_that_is_unequal_turns_the_torque_free_dart_as_euler_says() {
    // A small change of the moment about axis 2: p' = (I_2 - I_3) q r / I_1, and so with it.
    let share = 1e-3;
    let added = added_turn("unequal_inertia", "inertia_2_error", share);
    let expected = 4.2e-5 * share * (0.5 * -0.2) / 4e-7;
    assert!(
        (added.x / expected - 1.0).abs() < 1e-9,
        "{added} {expected}"
    );
    // A product of inertia of axes 1 and 2 couples the rates.
    assert!(added_turn("tilted_inertia", "product_12", 1e-3).norm() > 1e-6);
}

#[test]
fn a_model_that_claims_no_law_is_not_refuted_by_a_side_force() {
    let text = model_spec::load::inspect(&path("shuttlecock"), &["side_force"]);
    let written = text.unwrap().file.to_string();
    let loaded = model_spec::load::inspect_text("extended.hyz", &written, &[]).unwrap();
    let report = verify::run(&loaded, &QUICK);
    assert!(report.holds(), "{}", report.table());
    let broken = &row(&report, metamorphic::METAMORPHIC).detail;
    assert!(broken.contains("it breaks: mirror image"), "{broken}");
}

#[test]
fn points_that_a_stated_limit_excludes_refute_nothing() {
    // Its path angle has no rate at rest.
    let report = verify::run(&with("glider", &[]), &QUICK);
    assert_eq!(row(&report, singular::SINGULAR).verdict, Verdict::Holds);
    assert!(row(&report, singular::SINGULAR).cases > 0);
}
