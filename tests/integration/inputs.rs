//! Errors of inputs over time, hidden in flights by an integrator of the test's own: each is named, and none is where there is none.

use hyzer::{Dataset, DatasetBuilder, InputInterpolation, Model, Role};

const DRONE: &str = "
model drone;
param m = 0.5 kg;
param g = 9.81 m/s^2;
coefficient k = 8 N in 0 .. 20;
coefficient c = 0.1 N*s/m in 0 .. 5;
input throttle = 0.7;
input tilt: rad = 0;
frame N;
point drone { mass m; position (x, y, z) in N; velocity (vx, vy, vz) in N; }
force weight = -m*g*N.3;
force thrust = k*throttle^2*(cos(tilt)*N.3 + sin(tilt)*N.1);
force drag = -c*velocity;
marker mark in N;
observe mark = position + mark;
";

/// Commands of flight `number` at time `t`: throttle and tilt.
fn commands(number: f64, t: f64) -> (f64, f64) {
    let throttle = 0.75 + 0.1 * (5.0 * t + number).sin() + 0.05 * (13.0 * t - number).cos();
    let tilt = 0.2 * (4.0 * t + 2.0 * number).sin() + 0.1 * (9.0 * t).cos();
    (throttle, tilt)
}

/// Throttle that follows the commands with a lag of first order, `tau`: each sine of the commands is weaker and later.
fn lagging(number: f64, t: f64, tau: f64) -> f64 {
    let sine = |rate: f64, phase: f64| {
        (phase - (rate * tau).atan()).sin() / (1.0 + (rate * tau).powi(2)).sqrt()
    };
    let slow = sine(5.0, 5.0 * t + number);
    0.75 + 0.1 * slow + 0.05 * sine(13.0, 13.0 * t - number + std::f64::consts::FRAC_PI_2)
}

/// Number between -1 and 1 that depends on its arguments alone.
fn scatter(a: usize, b: usize) -> f64 {
    let mut hash = (a as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ (b as u64 + 7);
    for _ in 0..3 {
        hash ^= hash >> 29;
        hash = hash.wrapping_mul(0xbf58_476d_1ce4_e5b9);
    }
    (hash >> 11) as f64 / (1u64 << 52) as f64 - 1.0
}

/// Interval of held inputs, s.
const HELD: f64 = 0.05;

/// Commands that are held for [`HELD`].
fn held(number: f64, t: f64) -> (f64, f64) {
    commands(number, HELD * (t / HELD + 1e-6).floor())
}

/// Six flights, two of them held out, whose commands act as `acting` says of the recorded ones and the time.
fn flights(by: InputInterpolation, acting: impl Fn(f64, f64) -> (f64, f64)) -> Dataset {
    let mut made = DatasetBuilder::new("drone").marker("c", [0.0; 3]);
    let rate = |number: f64, t: f64, v: [f64; 3]| {
        let (throttle, tilt) = acting(number, t);
        let thrust = 9.0 * throttle * throttle;
        let drag = v.map(|v| 0.15 * v);
        [
            (thrust * tilt.sin() - drag[0]) / 0.5,
            -drag[1] / 0.5,
            (thrust * tilt.cos() - drag[2]) / 0.5 - 9.81,
        ]
    };
    for index in 0..6 {
        let number = index as f64;
        let (mut x, mut v) = ([0.0, 0.0, 5.0], [0.3 * number.sin(), 0.5, 0.0]);
        let (mut times, mut positions) = (Vec::new(), Vec::new());
        // Classical Runge-Kutta steps of 1 ms; a sample every 10 ms.
        for step in 0..3000 {
            let (t, h) = (f64::from(step) * 1e-3, 1e-3);
            if step % 10 == 0 {
                let noise = |axis: usize| {
                    let draw = |k| scatter(index * 3000 + step as usize, axis * 4 + k);
                    1e-3 * (0..4).map(draw).sum::<f64>() * 0.75_f64.sqrt()
                };
                times.push(t);
                positions.push(vec![Some([0, 1, 2].map(|k| x[k] + noise(k)))]);
            }
            let ahead = |v: [f64; 3], a: [f64; 3], h: f64| [0, 1, 2].map(|k| v[k] + h * a[k]);
            let a1 = rate(number, t, v);
            let v2 = ahead(v, a1, h / 2.0);
            let a2 = rate(number, t + h / 2.0, v2);
            let v3 = ahead(v, a2, h / 2.0);
            let a3 = rate(number, t + h / 2.0, v3);
            let v4 = ahead(v, a3, h);
            // Just before the next value of a held input.
            let a4 = rate(number, t + h - 1e-6, v4);
            x = [0, 1, 2].map(|k| x[k] + h / 6.0 * (v[k] + 2.0 * v2[k] + 2.0 * v3[k] + v4[k]));
            v = [0, 1, 2].map(|k| v[k] + h / 6.0 * (a1[k] + 2.0 * a2[k] + 2.0 * a3[k] + a4[k]));
        }
        let role = if index < 4 { Role::Fit } else { Role::HeldOut };
        made = made.flight(&format!("flight{index}"), role, &times, positions);
        let every = match by {
            InputInterpolation::Hold => HELD,
            _ => 0.01,
        };
        let last = (3.8 / every).round() as i32;
        let clock = (0..=last).map(|k| f64::from(k) * every - 0.4);
        let recorded: Vec<_> = clock.map(|t| (t, commands(number, t))).collect();
        let of = |pick: fn((f64, f64)) -> f64| -> Vec<(f64, f64)> {
            recorded.iter().map(|&(t, both)| (t, pick(both))).collect()
        };
        made = made
            .input("throttle", &of(|both| both.0), by)
            .input("tilt", &of(|both| both.1), by);
    }
    made.build().expect("a dataset")
}

/// Names of the effects that a diagnosis finds, and the first estimate.
fn found(
    by: InputInterpolation,
    acting: impl Fn(f64, f64) -> (f64, f64),
) -> (Vec<String>, Option<f64>) {
    let model = Model::parse("drone.hyz", DRONE).expect("a model");
    let told = hyzer::Diagnosis::of(&model)
        .run(&flights(by, acting))
        .expect("a diagnosis");
    let first = told.explanations().first();
    let effects = first.map(|own| &own.effects[..]).unwrap_or_default();
    let names = effects.iter().map(|effect| effect.name.clone()).collect();
    let estimate = effects
        .first()
        .and_then(|effect| effect.estimates.values().next());
    (names, estimate.map(|own| own.value))
}

type Acting = fn(f64, f64) -> (f64, f64);

#[test]
fn errors_of_inputs_are_named() {
    let (names, _) = found(InputInterpolation::Cubic, commands);
    assert!(names.is_empty(), "{names:?}");
    let cases: [(&str, f64, Acting); 4] = [
        ("delay-of-throttle", 0.03, |number, t| {
            (commands(number, t - 0.03).0, commands(number, t).1)
        }),
        ("lag-of-throttle", 0.03, |number, t| {
            (lagging(number, t, 0.03), commands(number, t).1)
        }),
        ("bias-of-tilt", 0.02, |number, t| {
            let (throttle, tilt) = commands(number, t);
            (throttle, tilt + 0.02)
        }),
        ("scale-of-tilt", 0.15, |number, t| {
            let (throttle, tilt) = commands(number, t);
            (throttle, 1.15 * tilt)
        }),
    ];
    for (name, size, acting) in cases {
        is_named(InputInterpolation::Cubic, name, size, acting);
    }
}

#[test]
fn errors_of_held_inputs_are_named() {
    let (names, _) = found(InputInterpolation::Hold, held);
    assert!(names.is_empty(), "{names:?}");
    let cases: [(&str, f64, Acting); 2] = [
        ("bias-of-throttle", 0.02, |number, t| {
            let (throttle, tilt) = held(number, t);
            (throttle + 0.02, tilt)
        }),
        ("scale-of-tilt", 0.1, |number, t| {
            let (throttle, tilt) = held(number, t);
            (throttle, 1.1 * tilt)
        }),
    ];
    for (name, size, acting) in cases {
        is_named(InputInterpolation::Hold, name, size, acting);
    }
}

fn is_named(by: InputInterpolation, name: &str, size: f64, acting: Acting) {
    let (names, estimate) = found(by, acting);
    assert_eq!(names, [name]);
    let estimate = estimate.expect("an estimate");
    assert!((estimate - size).abs() < 0.05 * size, "{name}: {estimate}");
}
