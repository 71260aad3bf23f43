//! Throws: throw to state and back in models of several kinds, known states, the cone of the wobble, refusals, `[throw]` in
//! release files.

use flight::release::{self, Release, Vocabulary, read_named};
use flight::throw::{FIELDS, Throw, ThrowError, ThrownModel};
use flight::{CompiledModel, simulate};
use model_spec::load::load;
use model_spec::model::Model;
use ode::Trajectory;
use proptest::prelude::*;

/// Source text of a user's model of a rigid body, with other names, another order of rotations, velocities in body
/// axes, and three principal moments of inertia.
const OWN: &str = "model slab;
param mass = 0.3 kg;
param J_1 = 1e-3 kg*m^2;
param J_2 = 1.5e-3 kg*m^2;
param J_3 = 2e-3 kg*m^2;
param g = 9.81 m/s^2;
frame N;
frame E = N turned yaw about 3;
frame F = E turned pitch about 2;
frame S = F turned roll about 1;
body slab {
  mass mass;
  inertia diag(J_1, J_2, J_3) in S;
  fixed in S;
  position (north, west, up) in N;
  velocity (vf, vl, vu) in S;
}
force weight = -mass*g*N.3;
";

/// Source text of a slender body with the axes that `AXES` stands for.
const DART: &str = "model dart;
param m = 0.02 kg;
param J_1 = 1e-6 kg*m^2;
param J_2 = 4e-4 kg*m^2;
frame N;
frame C = N by quaternion (q0, q1, q2, q3);
body dart {
  mass m;
  inertia diag(J_1, J_2, J_2) in C;
  fixed in C;
  AXES
  position (x, y, z) in N;
  velocity (vx, vy, vz) in N;
  angular velocity (p, q, r) in C;
}
force weight = -m*9.81 [m/s^2]*N.3;
";

fn model(name: &str) -> Model {
    match name {
        "slab" => model_spec::load::from_text("slab", OWN, &[]),
        name if name.contains("C.") => {
            model_spec::load::from_text("dart", &DART.replace("AXES", name), &[])
        }
        name => model_spec::load::load(name, &[]),
    }
    .unwrap_or_else(|e| panic!("{e}"))
}

fn throw() -> impl Strategy<Value = Throw> {
    let angles = (-180.0..180.0, -70.0..70.0, -40.0..40.0, -50.0..50.0);
    let spin = prop_oneof![-1500.0..-100.0, 100.0..1500.0];
    (5.0..40.0, angles, spin, 0.0..3.0, 0.0..20.0).prop_map(
        |(speed, (heading, launch, nose, hyzer), spin, height, wobble)| Throw {
            speed,
            heading,
            launch,
            height,
            nose: Some(nose),
            hyzer: Some(hyzer),
            spin: Some(spin),
            wobble: Some(wobble),
        },
    )
}

fn returns(thrown: &ThrownModel, parameters: &[f64], throw: Throw) -> Result<(), TestCaseError> {
    let state = thrown.state(&throw, [1.0, -2.0], parameters);
    // The chart of three angles ends where its middle angle is a right angle.
    if let Err(ThrowError::NoState { .. }) = state {
        return Err(TestCaseError::reject("beyond the limits"));
    }
    let back = thrown.throw(&state.expect("a state"), parameters);
    for (name, ..) in FIELDS {
        let (was, is) = (throw.field(name), back.field(name));
        let near = match (was, is) {
            (Some(was), Some(is)) => (was - is).abs() < 1e-6,
            (was, is) => was == is,
        };
        prop_assert!(near, "{name}: {was:?} became {is:?} in {throw:?}");
    }
    Ok(())
}

fn round_trips(name: &str, cases: u32) {
    let model = model(name);
    let thrown = ThrownModel::new(&model).expect("a body");
    let parameters = CompiledModel::new(&model).layout().default_parameters();
    let has_attitude = thrown.has_attitude();
    let config = ProptestConfig {
        cases,
        failure_persistence: None,
        ..ProptestConfig::default()
    };
    let mut runner = proptest::test_runner::TestRunner::new(config);
    let test = |mut throw: Throw| {
        if !has_attitude {
            (throw.nose, throw.hyzer) = (None, None);
            (throw.spin, throw.wobble) = (None, None);
        }
        returns(&thrown, &parameters, throw)
    };
    runner
        .run(&throw(), test)
        .unwrap_or_else(|e| panic!("{name}: {e}"));
}

#[test]
fn throws_of_the_disc_return() {
    round_trips("disc", 64);
}

#[test]
fn throws_of_the_disc_by_quaternion_return() {
    round_trips("disc_quaternion", 64);
}

#[test]
fn throws_of_the_discus_return() {
    round_trips("discus", 32);
}

#[test]
fn throws_of_bodies_that_state_their_axes_return() {
    round_trips("axis C.1; forward C.1;", 32);
    round_trips("axis C.1; forward -C.1;", 32);
    round_trips("axis -C.3; forward C.1;", 32);
    round_trips("axis C.2;", 32);
}

/// A throw of an arrow: its first axis points along the velocity but for the nose angle, and its spin is about it.
#[test]
fn a_body_that_flies_along_its_axis_is_thrown_along_it() {
    let thrown = ThrownModel::new(&model("axis C.1; forward C.1;")).expect("a body");
    let throw = Throw {
        launch: 30.0,
        nose: Some(5.0),
        spin: Some(600.0),
        ..Throw::at_speed(50.0)
    };
    let parameters = [0.02, 1e-6, 4e-4];
    let state = thrown
        .state(&throw, [0.0; 2], &parameters)
        .expect("a state");
    let turning = thrown.motion(&state, &parameters).turning.expect("a body");
    let (sin, cos) = 35f64.to_radians().sin_cos();
    let ahead = nalgebra::Vector3::new(cos, 0.0, sin);
    let axes = thrown.frame_axes(&turning);
    assert!((axes.column(0) - ahead).norm() < 1e-9, "{axes}");
    // Clockwise, seen from behind.
    let rate = 600.0 * std::f64::consts::PI / 30.0;
    assert!(
        (turning.rates - ahead * rate).norm() < 1e-6,
        "{}",
        turning.rates
    );
    let wing = ThrownModel::new(&model("axis -C.3; forward C.1;")).expect("a body");
    let state = wing.state(&throw, [0.0; 2], &parameters).expect("a state");
    let turning = wing.motion(&state, &parameters).turning.expect("a body");
    let axes = wing.frame_axes(&turning);
    assert!((axes.column(0) - ahead).norm() < 1e-9, "{axes}");
    assert!(axes.column(2).z < 0.0, "{axes}");
}

#[test]
fn throws_of_a_point_mass_return() {
    round_trips("ball", 64);
}

#[test]
fn throws_of_a_body_of_ones_own_return() {
    round_trips("slab", 64);
}

/// Tests the conversion of throws for a model without a declared body, whose claim block states that its equations
/// describe a point mass. The states follow from the position and velocity in the claim block.
#[test]
fn a_throw_of_a_claimed_point_returns() {
    let text = "model glider;\nparam m = 3 g;\nframe N;\nstate range = 0 m;\nstate height = 2 m;\nstate V = 4 m/s;\n\
        state gamma = 0 rad;\nlimit V > 0.2 m/s \"it hangs in the air\";\nder(range) = V*cos(gamma);\n\
        der(height) = V*sin(gamma);\nder(V) = -1 [/s]*V;\nder(gamma) = 0;\n\
        claim point glider { mass m; position (range, 0, height) in N;\n\
        velocity V*((cos(gamma), 0, sin(gamma)) in N); force -1 [/s]*m*V*((cos(gamma), 0, sin(gamma)) in N); }\n";
    let model = model_spec::load::from_text("glider", text, &[]).unwrap_or_else(|e| panic!("{e}"));
    let thrown = ThrownModel::new(&model).expect("a claim");
    let throw = Throw {
        launch: -20.0,
        height: 3.0,
        ..Throw::at_speed(7.0)
    };
    let state = thrown.state(&throw, [1.0, 0.0], &[0.003]).expect("a state");
    let expected = [1.0, 3.0, 7.0, -20f64.to_radians()];
    for (is, expected) in state.iter().zip(expected) {
        assert!((is - expected).abs() < 1e-9, "{state:?}");
    }
    // It does not fly sideways.
    let aside = Throw {
        heading: 30.0,
        ..throw
    };
    let refusal = thrown.state(&aside, [1.0, 0.0], &[0.003]).unwrap_err();
    assert!(matches!(refusal, ThrowError::NoState { .. }), "{refusal}");
}

#[test]
fn a_flat_throw_along_x_has_the_states_of_the_disc_by_name() {
    let model = model("disc");
    let thrown = ThrownModel::new(&model).unwrap();
    let parameters = CompiledModel::new(&model).layout().default_parameters();
    let throw = Throw {
        nose: Some(10.0),
        spin: Some(600.0),
        height: 1.5,
        ..Throw::at_speed(20.0)
    };
    let state = thrown.state(&throw, [0.0; 2], &parameters).unwrap();
    let (sin, cos) = 10f64.to_radians().sin_cos();
    let rate = -20.0 * std::f64::consts::PI;
    // Nose up is a turn by a negative theta; the air comes from below, w < 0.
    let expected = [
        0.0,
        0.0,
        1.5,
        20.0 * cos,
        0.0,
        -20.0 * sin,
        0.0,
        -10f64.to_radians(),
        0.0,
        0.0,
        0.0,
        rate,
    ];
    for (k, (is, expected)) in state.iter().zip(expected).enumerate() {
        assert!((is - expected).abs() < 1e-9, "state {k}: {is} {expected}");
    }
}

/// Tests that the axis of a disc without aerodynamic loads describes a cone of the half angle `wobble`, whose axis is
/// ahead of the body's axis at first.
#[test]
fn the_wobble_is_half_the_angle_of_the_cone() {
    let text = "model = \"disc_quaternion\"\nduration = 0.2\n[parameters]\nrho = 0\n[coefficients]\nC_Nr = 0\n\
        [throw]\nspeed = 20\nnose = 5\nspin = 700\nwobble = 7\n";
    let model = model("disc_quaternion");
    let read = release::read("r.toml", text, |_| Ok(Vocabulary::of(&model)));
    let release = read.unwrap_or_else(|e| panic!("{e}"));
    let flight = simulate(&CompiledModel::new(&model), &release, &Default::default()).unwrap();
    let axis = |state: &[f64]| {
        let [q0, q1, q2, q3] = [6, 7, 8, 9].map(|k| state[k]);
        [
            2.0 * (q1 * q3 + q0 * q2),
            2.0 * (q2 * q3 - q0 * q1),
            1.0 - 2.0 * (q1 * q1 + q2 * q2),
        ]
    };
    let first = axis(&release.state());
    let greatest = (0..=2000)
        .filter_map(|k| flight.sample(f64::from(k) * 1e-4))
        .map(|state| {
            let there = axis(&state);
            let dot: f64 = first.iter().zip(there).map(|(a, b)| a * b).sum();
            dot.min(1.0).acos().to_degrees()
        })
        .fold(0.0, f64::max);
    assert!((greatest - 14.0).abs() < 1e-3, "{greatest}");
    // Opposite to the release the axis has gone ahead: the disc, nose-up at 5 degrees, dips to -9.
    let lowest = (0..=2000)
        .filter_map(|k| flight.sample(f64::from(k) * 1e-4))
        .map(|state| axis(&state)[0])
        .fold(f64::MIN, f64::max);
    assert!((lowest - 9f64.to_radians().sin()).abs() < 1e-3, "{lowest}");
}

#[test]
fn what_a_point_mass_cannot_have_is_refused() {
    let thrown = ThrownModel::new(&model("ball")).unwrap();
    let parameters = CompiledModel::new(&model("ball"))
        .layout()
        .default_parameters();
    for name in ["nose", "hyzer", "spin", "wobble"] {
        let mut throw = Throw::at_speed(20.0);
        throw.set(name, 0.0);
        let refusal = thrown.state(&throw, [0.0; 2], &parameters).unwrap_err();
        assert!(
            refusal.to_string().contains(&format!("found {name}")),
            "{refusal}"
        );
        assert!(refusal.to_string().contains("point mass"), "{refusal}");
    }
}

#[test]
fn a_bullet_leaves_the_barrel() {
    let bullet = Throw {
        spin: Some(-300_000.0),
        ..Throw::at_speed(900.0)
    };
    assert_eq!(bullet.check(), Ok(()));
}

fn read(table: &str) -> Result<Release, release::ReleaseError> {
    let text = format!("model = \"disc\"\nuntil = \"ground\"\n{table}");
    release::read("r.toml", &text, |_| Ok(Vocabulary::of(&model("disc"))))
}

#[test]
fn each_fault_of_a_throw_is_named_with_its_place() {
    let cases = [
        (
            "[throw]\nlaunch = 3\n",
            "r.toml:3:1: found no speed in [throw]; expected one, as in speed = 20.0 (m/s)",
        ),
        (
            "[throw]\nspeed = 0\n",
            "r.toml:4:9: speed is 0; expected a number above 0 and up to 2000 m/s",
        ),
        (
            "[throw]\nspeed = -3\n",
            "r.toml:4:9: speed is -3; expected a number above 0 and up to 2000 m/s",
        ),
        (
            "[throw]\nspeed = 20\nlaunch = 91\n",
            "r.toml:5:10: launch is 91; expected a number from -90 to 90 deg",
        ),
        (
            "[throw]\nspeed = 20\nhyser = 1\n",
            "r.toml:5:1: unknown key \"hyser\" in [throw]; did you mean \"hyzer\"?",
        ),
        (
            "[throw]\nspeed = \"fast\"\n",
            "r.toml:4:9: speed is the text \"fast\"; expected a number",
        ),
        (
            "[throw]\nspeed = nan\n",
            "r.toml:4:9: speed is NaN; expected a finite number",
        ),
        (
            "[throw]\nspeed = 20\nwobble = 2\n",
            "r.toml:5:10: found wobble without spin; expected a spin other than 0, about which the axis can turn",
        ),
        (
            "[throw]\nspeed = 20\n[initial]\nx = 0\n",
            "r.toml:3:1: found both [throw] and [initial]; expected one of the two",
        ),
        (
            "[throw]\nspeed = 20\nnose = 90\nspin = 600\n",
            "r.toml:3:1: no state of the model disc within its limits has this motion; expected a throw that it can have, as by another nose or hyzer",
        ),
    ];
    for (table, expected) in cases {
        match read(table) {
            Ok(release) => panic!("{table}: {release:?}"),
            Err(refusal) => assert_eq!(refusal.to_string(), expected),
        }
    }
    let two = read("[throw]\nlaunch = 91\nspeed = 9000\n").unwrap_err();
    assert_eq!(two.faults.len(), 2, "{two}");
}

#[test]
fn a_model_without_a_body_is_refused() {
    let text = "model fall;\nframe N;\nstate z = 1 m;\nstate vz = 0 m/s;\nder(z) = vz;\nder(vz) = -9.81 [m/s^2];\n";
    let model = model_spec::load::from_text("fall", text, &[]).unwrap_or_else(|e| panic!("{e}"));
    let refusal = ThrownModel::new(&model).err().expect("no body");
    assert!(
        refusal.to_string().contains("neither a body nor a claim"),
        "{refusal}"
    );
}

/// Flight of a release whose file, for a model beside it, has `text`.
fn flown_from_file(model: &str, text: &str) -> Result<Trajectory, String> {
    let folder = tempfile::tempdir().expect("a folder");
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text);
    write("stone.hyz", model).expect("a model");
    write("stone.toml", text).expect("a release");
    let file = folder.path().join("stone.toml");
    let load = |name: &str| load(name, &[]).map(|model| Vocabulary::of(&model));
    let (release, vocabulary) =
        read_named(&file.to_string_lossy(), true, load).map_err(|e| e.to_string())?;
    let model = vocabulary.model.expect("the model beside the release");
    let flight = simulate(&CompiledModel::new(&model), &release, &Default::default());
    flight.map_err(|e| e.to_string())
}

#[test]
fn what_is_no_z_but_the_height_of_a_body_falls_to_the_ground() {
    let head = "model stone;\nparam m = 0.4 kg;\nframe N;\n";
    let declared = "point stone { mass m; position (px, py, pz) in N; velocity (vx, vy, vz) in N; }\n\
        state z = 1 m;\nder(z) = 0;\nforce weight = -m*(10 [m/s^2])*N.3;\n";
    let claimed = "state X = 0 m;\nstate H = 0 m;\nstate vx = 1 m/s;\nstate vh = 0 m/s;\nder(X) = vx;\nder(H) = vh;\n\
        der(vx) = 0;\nder(vh) = -10 [m/s^2];\nclaim point stone { mass m; position (X, 0, H) in N;\n\
        velocity (vx, 0, vh) in N; force -m*(10 [m/s^2])*N.3; }\n";
    let release = "model = \"stone.hyz\"\nuntil = \"ground\"\n[throw]\nspeed = 3.0\nheight = 5.0\n";
    for body in [declared, claimed] {
        let flight =
            flown_from_file(&format!("{head}{body}"), release).unwrap_or_else(|e| panic!("{e}"));
        assert!((flight.end - 1.0).abs() < 1e-9, "{}", flight.end);
    }
}
