//! Gyroscope and accelerometer of any body: compiled code against the oracle's tree, and against the motion of a point on the
//! body that carries them.

use flight::CompiledModel;
use model_spec::compose::Instrument;
use model_spec::load::{from_text, load};
use model_spec::model::{Model, Shape};
use nalgebra::{Matrix3, Vector3};
use oracle::{Point, Tree, derivatives};

const ALL: [Instrument; 3] = [
    Instrument::Gyroscope,
    Instrument::Accelerometer,
    Instrument::Speed,
];

/// Text of a test model of a body without inertial symmetry: its inertia tensor is constant only in the body-fixed
/// frame.
const GLIDER: &str = "model glider; param m = 0.4 kg; param g = 9.81 m/s^2; param I_1 = 0.01 kg*m^2; param I_2 = 0.02 kg*m^2; param I_3 = 0.025 kg*m^2; param lever = 0.02 m; frame N; frame B = N by quaternion (q0, q1, q2, q3);
    body glider { mass m; inertia diag(I_1, I_2, I_3) in B; fixed in B; position (x, y, z) in N;
      velocity (u, v, w) in N; angular velocity (p, q, r) in B; }
    force weight = -m*g*N.3;
    force drag = -(0.05 [kg/m])*norm(velocity)*velocity;
    let arm = (lever, 0.5*lever, 0 [m]) in B;
    moment damping = -(0.002 [N*m*s])*angular_velocity + cross(arm, in_B((-0.05 [kg/m])*norm(velocity)*velocity));
    marker mark in B; observe mark = position + in_N(mark);";

fn models() -> Vec<Model> {
    let built_in = ["disc", "disc_quaternion", "discus"].map(|name| load(name, &[]).expect(name));
    let own = from_text("glider.hyz", GLIDER, &[]).expect("the glider");
    let extended = load("disc", &["wind", "gravity"]).expect("an extended disc");
    let all = built_in.into_iter().chain([own, extended]);
    all.map(|model| model.with_instruments(&ALL).expect("a body"))
        .collect()
}

/// A point within the validity limits, at which states, coefficients and marker position differ from their defaults.
fn point(model: &Model) -> Point<f64> {
    let mut point = Point::defaults(model);
    for (index, value) in point.states.iter_mut().enumerate() {
        let wave = (1.7 * index as f64 + 0.3).sin();
        *value = match model.states[index].unit_text.as_str() {
            "m/s" => 12.0 * wave,
            "rad" => 0.6 * wave,
            "rad/s" => 20.0 * wave,
            _ => wave,
        };
    }
    for states in model.quaternions() {
        let norm = states
            .map(|i| point.states[i].powi(2))
            .iter()
            .sum::<f64>()
            .sqrt();
        states.into_iter().for_each(|i| point.states[i] /= norm);
    }
    for (index, value) in point.coefficients.iter_mut().enumerate() {
        *value += 0.01 * (index as f64 + 1.0).sin();
    }
    point.marker = Vector3::new(0.04, -0.02, 0.03);
    point
}

fn parameters(model: &Model, point: &Point<f64>) -> Vec<f64> {
    let inputs = point.inputs.iter().flat_map(|input| input.iter());
    let all = point.params.iter().chain(&point.coefficients).chain(inputs);
    assert_eq!(point.params.len(), model.params.len());
    all.copied().collect()
}

/// Value of the auxiliary variable `name`, which predicts an instrument's measurement, computed by the reference
/// simulator. A vector is given in the frame of its definition.
fn by_oracle(model: &Model, name: &str, point: &Point<f64>) -> Vec<f64> {
    let own = model
        .aux_variables
        .iter()
        .position(|own| own.name == name)
        .expect(name);
    let tree = Tree::new(model, point);
    match (
        tree.aux_variables[own],
        model.aux_variables[own].value.shape,
    ) {
        (oracle::Value::Vector(value), Shape::Vector(frame)) => {
            (tree.frames[frame].axes.transpose() * value)
                .iter()
                .copied()
                .collect()
        }
        (oracle::Value::Scalar(value), _) => vec![value],
        _ => unreachable!("a vector has a frame"),
    }
}

#[test]
fn compiled_instruments_are_the_oracle_s_and_so_are_their_derivatives() {
    for model in models() {
        let at = point(&model);
        let values = parameters(&model, &at);
        for instrument in ALL {
            let name = instrument.name();
            let all = (0..values.len()).collect();
            let compiled = CompiledModel::observing(&model, name, all).expect(name);
            let bound = compiled.bind(values.clone());
            let mut observer = bound.observer();
            let marker = [at.marker.x, at.marker.y, at.marker.z];
            let (y, jacobians) = observer.position_with_jacobians(0.0, &at.states, &marker);
            let expected = by_oracle(&model, name, &at);
            for (y, expected) in y.iter().zip(&expected) {
                let scale = expected.abs().max(1.0);
                assert!(
                    (y - expected).abs() < 1e-11 * scale,
                    "{} {name}: {y} {expected}",
                    model.name
                );
            }
            let (pattern, values) = (jacobians.by_state_pattern, jacobians.by_state);
            for direction in directions(&model, &at) {
                let moved = |step: f64| {
                    let mut moved = at.clone();
                    for (x, along) in moved.states.iter_mut().zip(&direction) {
                        *x += step * along;
                    }
                    by_oracle(&model, name, &moved)
                };
                let (after, before) = (moved(1e-5), moved(-1e-5));
                for (row, (after, before)) in after.iter().zip(&before).enumerate() {
                    let slope = (after - before) / 2e-5;
                    let entries = pattern.iter().zip(values);
                    let entries = entries.filter(|((at, _), _)| *at == row);
                    let found: f64 = entries.map(|((_, x), v)| v * direction[*x]).sum();
                    let scale = slope.abs().max(1.0);
                    let words = format!("{} {name} along {direction:?}", model.name);
                    assert!(
                        (slope - found).abs() < 1e-5 * scale,
                        "{words}: {slope} {found}"
                    );
                }
            }
        }
    }
}

/// Independent directions in state space: one for each state that is not a quaternion component, and one for each unit
/// quaternion, tangent to the unit sphere.
fn directions(model: &Model, point: &Point<f64>) -> Vec<Vec<f64>> {
    let quaternions: Vec<[usize; 4]> = model.quaternions().collect();
    let states = point.states.len();
    let is_free = |state: &usize| !quaternions.iter().any(|own| own.contains(state));
    let unit = |state: usize| {
        (0..states)
            .map(|k| f64::from(u8::from(k == state)))
            .collect()
    };
    let turned = quaternions.iter().map(|own| {
        let q = own.map(|state| point.states[state]);
        let mut direction = vec![0.0; states];
        for (state, along) in own.iter().zip([-q[1], q[0], q[3], -q[2]]) {
            direction[*state] = along;
        }
        direction
    });
    (0..states)
        .filter(is_free)
        .map(unit)
        .chain(turned)
        .collect()
}

/// Point reached after the time `dt`, s, which may be negative, by one Runge–Kutta step.
fn moved(model: &Model, point: &Point<f64>, dt: f64) -> Point<f64> {
    let rate = |at: &Point<f64>| derivatives(model, at).expect("it flies");
    let plus = |k: &[f64], h: f64| {
        let mut moved = point.clone();
        moved
            .states
            .iter_mut()
            .zip(k)
            .for_each(|(x, k)| *x += h * k);
        moved
    };
    let k1 = rate(point);
    let k2 = rate(&plus(&k1, dt / 2.0));
    let k3 = rate(&plus(&k2, dt / 2.0));
    let k4 = rate(&plus(&k3, dt));
    let mean: Vec<f64> = (0..k1.len())
        .map(|i| (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]) / 6.0)
        .collect();
    plus(&mean, dt)
}

#[test]
fn an_accelerometer_feels_the_acceleration_of_its_place_less_gravity() {
    for model in models() {
        let at = point(&model);
        let place = |at: &Point<f64>| {
            Tree::new(&model, at).vector(&model.observation.as_ref().expect("observed").value)
        };
        let dt = 1e-4;
        let (before, after) = (
            place(&moved(&model, &at, -dt)),
            place(&moved(&model, &at, dt)),
        );
        let acceleration = (after + before - 2.0 * place(&at)) / (dt * dt);
        let tree = Tree::new(&model, &at);
        let body = model.body.as_ref().expect("a body");
        let weights = model.forces.iter().filter(|load| load.is_weight());
        let weight: Vector3<f64> = weights.map(|load| tree.vector(&load.value)).sum();
        let felt = acceleration - weight / tree.scalar(&body.mass);
        let frame = model.marker.as_ref().expect("a marker").frame;
        let axes: Matrix3<f64> = tree.frames[frame].axes;
        let expected = axes.transpose() * felt;
        let found = by_oracle(&model, "accelerometer", &at);
        for (found, expected) in found.iter().zip(expected.iter()) {
            assert!(
                (found - expected).abs() < 1e-4 * expected.abs().max(10.0),
                "{}: {found} {expected}",
                model.name
            );
        }
    }
}
